// The manual page exsect(1), from what --help says.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace exsect::cli {

/// The page in the macros of man(7), version without a date: equal programs give equal pages.
std::string manual_page(const CLI::App& app, const std::string& version);

}  // namespace exsect::cli

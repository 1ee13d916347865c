// Completion of exsect's command line for bash, from what --help says.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace exsect::cli {

/// A script that bash reads: commands, the options of each, and files, where an option or a command takes
/// one.
std::string bash_completion(const CLI::App& app);

}  // namespace exsect::cli

// What the manual page and the shell completion say of an option. Internal to cli/manual/.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace exsect::cli {

/// Given by its place and not by a name: the input files of a command.
inline bool is_positional(const CLI::Option& option) { return option.get_lnames().empty(); }

/// Takes no value.
inline bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

/// "FILE", "NUMBER", ...; "" for a flag and for an input file.
inline std::string value_name(const CLI::Option& option) {
  return is_flag(option) || is_positional(option) ? "" : option.get_type_name();
}

}  // namespace exsect::cli

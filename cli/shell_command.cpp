#include "cli/shell_command.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace exsect::cli {
namespace {

/// Options with a value that leave the result as it is.
constexpr std::array<std::string_view, 10> places = {
    "--json", "--svg", "--report", "--certificate", "--obj", "--ply", "--vtp", "--csv", "--mesh", "--grid"};

bool is_place(std::string_view option) { return std::ranges::find(places, option) != places.end(); }

std::string quoted(std::string_view argument) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=,:+-@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string_view::npos)
    return std::string(argument);
  std::string text = "'";
  for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string shell_command(int argc, const char* const* argv) {
  std::string text = "exsect";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--quiet") continue;
    if (is_place(argument))
      ++i;
    else if (!is_place(argument.substr(0, argument.find('='))))
      text += " " + quoted(argument);
  }
  return text;
}

}  // namespace exsect::cli

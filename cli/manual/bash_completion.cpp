#include "cli/manual/bash_completion.h"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "cli/manual/option_words.h"

namespace exsect::cli {
namespace {

std::string words(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return fmt::format("{}", fmt::join(names, " "));
}

/// The options of all commands whose value is a file, or those whose value is something else.
std::set<std::string> options_with(const CLI::App& app, bool file) {
  std::set<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    for (const CLI::Option* option : command->get_options()) {
      if (value_name(*option).empty() || (value_name(*option) == "FILE") != file) continue;
      for (const std::string& name : option->get_lnames()) names.insert("--" + name);
      for (const std::string& name : option->get_snames()) names.insert("-" + name);
    }
  }
  return names;
}

constexpr const char* script = R"(# Completion of exsect for bash.
_exsect() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} options=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{commands} help --help --version' -- "$word")
    return
  fi
  case $before in
    {values}) return ;;
    {files}) mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
  esac
  case ${{COMP_WORDS[1]}} in
{options}    help) options='{commands}' ;;
  esac
  if [[ $word == -* || ${{COMP_WORDS[1]}} == help ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -o filenames -F _exsect exsect
)";

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string options;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
    options += fmt::format("    {}) options='{}' ;;\n", command->get_name(), words(*command));
  }
  return fmt::format(script, fmt::arg("commands", fmt::format("{}", fmt::join(names, " "))),
                     fmt::arg("values", fmt::format("{}", fmt::join(options_with(app, false), " | "))),
                     fmt::arg("files", fmt::format("{}", fmt::join(options_with(app, true), " | "))),
                     fmt::arg("options", options));
}

}  // namespace exsect::cli

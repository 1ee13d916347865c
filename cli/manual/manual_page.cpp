#include "cli/manual/manual_page.h"

#include <fmt/format.h>

#include <sstream>

#include "cli/manual/option_words.h"

namespace exsect::cli {
namespace {

/// Text as troff shows it unchanged: backslashes and hyphens are escaped, and a line that would be a request.
std::string escaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if ((c == '.' || c == '\'') && (i == 0 || text[i - 1] == '\n')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result;
}

/// Lines as they are.
std::string verbatim(const std::string& text) { return ".nf\n" + escaped(text) + "\n.fi\n"; }

std::string option_paragraph(const CLI::Option& option) {
  std::string text = ".TP\n\\fB" + escaped(option.get_name(false, true)) + "\\fR";
  const std::string value = value_name(option);
  if (!value.empty()) text += " \\fI" + escaped(value) + "\\fR";
  text += "\n" + escaped(option.get_description());
  if (!option.get_default_str().empty()) text += escaped(" (without it: " + option.get_default_str() + ")");
  return text + "\n";
}

std::string synopsis(const CLI::App& command) {
  std::string text = "\\fBexsect " + escaped(command.get_name()) + "\\fR";
  for (const CLI::Option* option : command.get_options())
    if (is_positional(*option)) text += " \\fI" + escaped(option->get_name()) + "\\fR";
  return text + " [\\fIOPTIONS\\fR]\n";
}

std::string command_section(const CLI::App& command) {
  std::string text = ".SS " + escaped(command.get_name()) + "\n" + synopsis(command) + ".PP\n" +
                     escaped(command.get_description()) + ".\n";
  for (const CLI::Option* option : command.get_options()) text += option_paragraph(*option);
  return command.get_footer().empty() ? text : text + ".PP\n" + verbatim(command.get_footer());
}

}  // namespace

std::string manual_page(const CLI::App& app, const std::string& version) {
  std::string text = fmt::format(".TH EXSECT 1 \"\" \"exsect {}\" \"User Commands\"\n", escaped(version)) +
                     ".SH NAME\nexsect \\- exact, proved intersection of surface patches\n.SH SYNOPSIS\n";
  for (const CLI::App* command : app.get_subcommands({})) text += synopsis(*command) + ".br\n";
  text += ".SH DESCRIPTION\n" + verbatim(app.get_description()) + ".SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands({})) text += command_section(*command);
  return text + ".SH EXIT STATUS\n" + verbatim(app.get_footer());
}

}  // namespace exsect::cli

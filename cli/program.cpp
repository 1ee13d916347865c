#include "cli/program.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/text_file.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/nearest_word.h"
#include "cli/patch_choice.h"
#include "cli/shell_command.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// An option with an empty value would look as if it were not given.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::App* sub : app.get_subcommands()) {
    for (const CLI::Option* option : sub->get_options()) {
      for (const std::string& value : option->results()) {
        if (value.empty()) throw UsageError(option->get_name() + ": empty value");
      }
    }
  }
}

/// Runs a command on a patch file; where a control point is beyond the range of doubles the refusal says
/// which.
template <class Command>
ExitStatus run_on_patches(const Command& command, const Streams& streams) {
  try {
    return run(command, streams);
  } catch (const BeyondDoubles& error) {
    refuse_beyond_doubles(command.file, error.what());
    throw;
  }
}

ExitStatus run_chosen(const CLI::App& app, const Commands& commands, const Streams& streams) {
  if (app.got_subcommand("intersect")) return run_on_patches(commands.intersect, streams);
  if (app.got_subcommand("line")) return run_on_patches(commands.line, streams);
  if (app.got_subcommand("ray")) return run(commands.ray, streams);
  if (app.got_subcommand("self")) return run_on_patches(commands.self, streams);
  if (app.got_subcommand("compare")) return run_on_patches(commands.compare, streams);
  if (app.got_subcommand("verify")) return run_on_patches(commands.verify, streams);
  if (app.got_subcommand("implicitize")) return run_on_patches(commands.implicitize, streams);
  if (app.got_subcommand("revolve")) return run(commands.revolve, streams);
  if (app.got_subcommand("batch")) return run(commands.batch, streams);
  if (app.got_subcommand("batch-merge")) return run(commands.batch_merge, streams);
  return run(commands.check, streams);
}

/// "exsect help" and "exsect help COMMAND" are "exsect --help" and "exsect COMMAND --help".
std::vector<const char*> with_help(int argc, const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  if (argc < 2 || std::string_view(argv[1]) != "help") return words;
  words.erase(words.begin() + 1);
  words.insert(words.begin() + std::min<std::ptrdiff_t>(2, std::ssize(words)), "--help");
  return words;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Throws UsageError unless the first word is a command or an option.
void require_command(const CLI::App& app, const std::vector<const char*>& words) {
  const std::vector<std::string> names = command_names(app);
  const std::string word = words.size() < 2 ? "" : words[1];
  if (word.starts_with("-") || std::ranges::find(names, word) != names.end()) return;
  const std::string all = ": " + joined(names, ", ") + " (see exsect --help)";
  if (words.size() < 2) throw UsageError("a command is needed" + all);
  const std::string near = nearest_word(word, names);
  throw UsageError(near.empty()
                       ? "\"" + word + "\" is no command; these are" + all
                       : "\"" + word + "\" is no command; did you mean " + near + "? (see exsect --help)");
}

/// What a misspelt option of the program or of its command may have meant, as a question; "" where nothing is
/// near.
std::string meant_option(const CLI::App& app) {
  std::vector<const CLI::App*> places = {&app};
  for (const CLI::App* command : app.get_subcommands()) places.push_back(command);
  for (const CLI::App* place : places) {
    std::vector<std::string> names;
    for (const CLI::Option* option : place->get_options())
      for (const std::string& name : option->get_lnames()) names.push_back(name);
    for (const std::string& word : place->remaining()) {
      if (!word.starts_with("--")) continue;
      const std::string near = nearest_word(word.substr(2, word.find('=') - 2), names);
      if (!near.empty()) return "; did you mean --" + near + "?";
    }
  }
  return "";
}

/// Where to read on: the help of the command that is named, or that of the program.
std::string see_help(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return " (see exsect " + (commands.empty() ? "" : commands.front()->get_name() + " ") + "--help)";
}

ExitStatus dispatch(int argc, const char* const* argv, const Streams& streams) {
  CLI::App app("", "exsect");
  Commands commands;
  add_commands(app, commands);
  const std::vector<const char*> words = with_help(argc, argv);
  require_command(app, words);
  try {
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0)
      throw UsageError(printable(error.what()) + meant_option(app) + see_help(app));
    app.exit(error, streams.out, streams.err);
    return ExitStatus::complete;
  }
  if (app.get_subcommands().empty()) throw UsageError("a command is needed (see exsect --help)");
  refuse_empty_values(app);
  for (OutputFiles* output : {&commands.intersect.output, &commands.line.output, &commands.ray.output,
                              &commands.self.output, &commands.compare.output, &commands.verify.output,
                              &commands.implicitize.output, &commands.revolve.output})
    output->line = shell_command(argc, argv);
  return run_chosen(app, commands, streams);
}

ExitStatus fail(const Streams& streams, const std::string& message) {
  streams.err << "exsect: " << printable(message) << std::endl;
  return ExitStatus::failed;
}

ExitStatus guarded(int argc, const char* const* argv, const Streams& streams) {
  try {
    const ExitStatus status = dispatch(argc, argv, streams);
    if (!streams.out.flush()) return fail(streams, "the standard output cannot be written");
    return status;
  } catch (const UsageError& error) {
    return fail(streams, error.what());
  } catch (const InputError& error) {
    return fail(streams, error.what());
  } catch (const OutputError& error) {
    return fail(streams, error.what());
  } catch (const std::invalid_argument& error) {
    return fail(streams, error.what());
  } catch (const std::bad_alloc&) {
    return fail(streams, "out of memory");
  } catch (const std::logic_error& error) {
    fail(streams, std::string("not decided: ") + error.what());
    return ExitStatus::incomplete;
  } catch (const std::exception& error) {
    return fail(streams, error.what());
  } catch (...) {
    return fail(streams, "an exception of unknown type");
  }
}

}  // namespace

int run(int argc, const char* const* argv, const Streams& streams) {
  return in_nearest_rounding([&] { return static_cast<int>(guarded(argc, argv, streams)); });
}

}  // namespace exsect::cli

#include "implicitize_command.h"

#include <exsect/geometry/curve_file.h>
#include <exsect/geometry/patch_file.h>

#include <stdexcept>

#include "implicit_json.h"
#include "implicit_summary.h"
#include "implicit_svg.h"
#include "implicitize_options.h"
#include "patch_choice.h"
#include "patch_implicit_output.h"
#include "space_implicit_output.h"
#include "terminal_text.h"

namespace exsect::cli {
namespace {

/// What a run shows.
struct Shown {
  bool is_complete;
  std::string summary;
  std::string json;
  std::string svg;
};

/// Bad curves and options are the user's: the statement that they violate, with the file's name.
template <class Solve>
auto blaming(const std::string& file, Solve solve) {
  try {
    return solve();
  } catch (const std::invalid_argument& error) {
    throw InputError(file, "", error.what());
  } catch (const std::domain_error& error) {
    throw InputError(file, "", error.what());
  }
}

Shown planar(const ImplicitizeCommand& command, const CurveFile& file) {
  const PlanarOptions options = planar_options(command);
  const std::vector<std::string> variables = variable_names(command, {"x", "y"});
  const PlanarImplicit result = blaming(command.file, [&] { return implicitize(file.curve, options); });
  const std::string subtitle = planar_subtitle(result, options);
  return {statements(result).is_complete(), planar_implicit_summary(result, options, variables),
          command.output.json.empty() ? "" : json_text(planar_implicit_json(result, options, variables)),
          command.output.svg.empty()
              ? ""
              : planar_implicit_svg(result, file.curve, subtitle, variables, file.title)};
}

Shown spatial(const ImplicitizeCommand& command, const CurveFile& file) {
  const SpaceOptions options = space_options(command);
  const SpaceImplicit result = blaming(command.file, [&] { return implicitize_space(file.curve, options); });
  return {is_complete(result), space_implicit_summary(result, options),
          command.output.json.empty() ? "" : json_text(space_implicit_json(result, options)),
          command.output.svg.empty() ? "" : space_implicit_svg(result, file.curve, file.title)};
}

Shown patch(const ImplicitizeCommand& command, const ChosenPatch& chosen) {
  const PatchOptions options = patch_options(command);
  const PatchImplicit result =
      blaming(command.file, [&] { return implicitize_patch(chosen.patch.patch, options); });
  return {true, patch_implicit_summary(result, options),
          command.output.json.empty() ? "" : json_text(patch_implicit_json(result, options)), ""};
}

}  // namespace

ExitStatus run(const ImplicitizeCommand& command, const Streams& streams) {
  check(command.output, command.file);
  const std::string text = read_text_file(command.file, max_curve_file_bytes);
  const std::string version = file_version(text, command.file);
  std::string title;
  Shown shown;
  if (version == "patches/1") {
    if (!command.output.svg.empty()) throw UsageError("--svg: there is no picture of a patch's equation");
    const ChosenPatch chosen = read_patch(command.file, command.patch);
    title = chosen.title;
    shown = patch(command, chosen);
  } else if (version == "curve/1") {
    const CurveFile file = parse_curve(text, command.file);
    title = file.title;
    shown = file.curve.dimension() == 2 ? planar(command, file) : spatial(command, file);
  } else {
    throw InputError(command.file, "$.exsect", "must be \"curve/1\" or \"patches/1\"");
  }
  if (!command.output.json.empty() && !command.output.json_to_stdout())
    write_file_atomically(command.output.json, shown.json);
  if (!command.output.svg.empty()) write_file_atomically(command.output.svg, shown.svg);
  if (command.output.json_to_stdout())
    streams.out << shown.json;
  else if (!command.quiet)
    streams.out << heading(command.file, title) << shown.summary;
  return shown.is_complete ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli

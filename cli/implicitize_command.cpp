#include "cli/implicitize_command.h"

#include <exsect/geometry/bpt_file.h>
#include <exsect/geometry/curve_file.h>
#include <exsect/geometry/file_form.h>
#include <exsect/geometry/patch_file.h>

#include <stdexcept>

#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "output/drawing/implicit_svg.h"
#include "output/drawing/space_implicit_svg.h"
#include "output/options/implicitize_options.h"
#include "output/report/method_reports.h"
#include "output/text/implicit_json.h"
#include "output/text/implicit_summary.h"
#include "output/text/patch_implicit_output.h"
#include "output/text/space_implicit_output.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// What a run shows.
struct Shown {
  bool is_complete;
  std::string summary;
  std::string json;
  std::string svg;
  std::string report;
};

/// Of a result as JSON and its picture, those that are asked for.
Shown shown(const ImplicitizeCommand& command, const std::string& title, bool is_complete,
            std::string summary, const Json& json, const ImplicitSubject& subject) {
  return {is_complete, std::move(summary), command.output.json.empty() ? "" : json_text(json), subject.svg,
          command.output.report.empty()
              ? ""
              : implicit_report_html(json, subject, origin_of(title, command.output.line, {command.file}))};
}

bool has_picture(const OutputFiles& output) { return !output.svg.empty() || !output.report.empty(); }

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
  ImplicitSubject subject;
  if (has_picture(command.output))
    subject.svg = planar_implicit_svg(result, file.curve, subtitle, variables, file.title);
  return shown(command, file.title, statements(result).is_complete(),
               planar_implicit_summary(result, options, variables),
               planar_implicit_json(result, options, variables), subject);
}

Shown spatial(const ImplicitizeCommand& command, const CurveFile& file) {
  const SpaceOptions options = space_options(command);
  const SpaceImplicit result = blaming(command.file, [&] { return implicitize_space(file.curve, options); });
  ImplicitSubject subject{"", file.curve, std::nullopt};
  if (has_picture(command.output)) subject.svg = space_implicit_svg(result, file.curve, file.title);
  return shown(command, file.title, is_complete(result), space_implicit_summary(result, options),
               space_implicit_json(result, options), subject);
}

Shown patch(const ImplicitizeCommand& command, const ChosenPatch& chosen) {
  const PatchOptions options = patch_options(command);
  const PatchImplicit result =
      blaming(command.file, [&] { return implicitize_patch(chosen.patch.patch, options); });
  return shown(command, chosen.title, true, patch_implicit_summary(result, options),
               patch_implicit_json(result, options), {"", std::nullopt, chosen.patch});
}

}  // namespace

ExitStatus run(const ImplicitizeCommand& command, const Streams& streams) {
  check(command.output, command.file);
  const std::string text = input_text(command.file, max_curve_file_bytes);
  const std::string version =
      is_bpt(command.file) ? "patches/1" : file_version(text, input_name(command.file));
  std::string title;
  Shown result;
  if (version == "patches/1") {
    if (!command.output.svg.empty()) throw UsageError("--svg: there is no picture of a patch's equation");
    const ChosenPatch chosen = read_patch(command.file, command.patch);
    title = chosen.title;
    result = patch(command, chosen);
  } else if (version == "curve/1") {
    const CurveFile file = parse_curve(text, input_name(command.file));
    title = file.title;
    result = file.curve.dimension() == 2 ? planar(command, file) : spatial(command, file);
  } else {
    throw InputError(input_name(command.file), "$.exsect", wrong_form(version, "curve/1 or patches/1"));
  }
  if (!command.output.json.empty() && !command.output.json_to_stdout())
    write_file_atomically(command.output.json, result.json);
  if (!command.output.svg.empty()) write_file_atomically(command.output.svg, result.svg);
  if (!command.output.report.empty()) write_file_atomically(command.output.report, result.report);
  if (command.output.json_to_stdout())
    streams.out << result.json;
  else if (!command.quiet)
    streams.out << heading(input_name(command.file), title) << result.summary;
  return result.is_complete ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli

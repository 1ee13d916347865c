#include "cli/intersect_command.h"

#include <exsect/geometry/text_file.h>
#include <exsect/solver/intersect_equations.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>
#include <fmt/format.h>

#include "certificate/certificate_text.h"
#include "cli/export_files.h"
#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "cli/progress.h"
#include "output/drawing/intersection_svg.h"
#include "output/drawing/surfaces_svg.h"
#include "output/options/option_values.h"
#include "output/report/report_html.h"
#include "output/text/chart_json.h"
#include "output/text/intersection_json.h"
#include "output/text/intersection_summary.h"
#include "output/text/node_csv.h"
#include "output/text/surfaces_output.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

IntersectOptions options(const IntersectCommand& command) {
  IntersectOptions options;
  options.turning = parameter_list("--turning", command.turning);
  options.tolerance = positive_value("--tolerance", command.tolerance);
  if (!command.max_seconds.empty())
    options.max_seconds = positive_value("--max-seconds", command.max_seconds);
  options.exact = command.exact;
  return options;
}

/// The two patches, where all methods take them: polynomial, of bidegree at most (2,2).
struct BiquadraticPair {
  BezierPatch x;
  BezierPatch y;
};

std::optional<BiquadraticPair> biquadratic(const RationalPair& pair) {
  const std::optional<BezierPatch> x = pair.x.patch.biquadratic(), y = pair.y.patch.biquadratic();
  if (!x || !y) return std::nullopt;
  return BiquadraticPair{*x, *y};
}

/// intersect() of two patches, of a surface given by its equation and a patch, or of two such surfaces.
template <class First, class Second>
auto solve(const IntersectCommand& command, const First& first, const Second& second,
           IntersectOptions options, const Streams& streams) {
  Progress progress(streams.err, streams.watched && !command.quiet);
  options.progress = [&](double fraction, const char* step) { progress.report(fraction, step); };
  try {
    return intersect(first, second, options);
  } catch (const NotSupported& error) {
    throw InputError(input_name(command.file), "", error.what());
  }
}

/// What --certificate writes of two patches, or of a surface given by its equation and a patch; empty where
/// it is not given, or, with a message, where there is no certificate.
template <class First>
std::string certificate(const IntersectCommand& command, const First& first, const RationalPatch& second,
                        const PatchNames& names, const IntersectResult& result, const Streams& streams) {
  if (command.output.certificate.empty()) return "";
  try {
    return certificate_text(first, second, names, result);
  } catch (const NoCertificate& reason) {
    streams.err << "exsect: no certificate: " << printable(reason.what()) << std::endl;
    return "";
  }
}

template <class Result>
ExitStatus status_of(const Result& result) {
  return result.status == Status::complete ? ExitStatus::complete : ExitStatus::incomplete;
}
/// Incomplete as well where a certificate was asked for and `proof` is none.
ExitStatus status_of(const IntersectCommand& command, const IntersectResult& result,
                     const std::string& proof) {
  if (proof.empty() && !command.output.certificate.empty()) return ExitStatus::incomplete;
  return status_of(result);
}

/// A certificate there is only where one of the two is a patch.
void refuse_certificate(const IntersectCommand& command, const SurfacePair& pair) {
  if (command.output.certificate.empty()) return;
  throw InputError(input_name(command.file), "",
                   fmt::format("\"{}\" and \"{}\": not supported yet with --certificate: two surfaces given "
                               "by their equations",
                               printable(pair.x.name), printable(pair.y.name)));
}

ExitStatus run_with_equations(const IntersectCommand& command, const SurfacePair& pair,
                              const IntersectOptions& options, const Streams& streams) {
  refuse_certificate(command, pair);
  const int cells = grid_cells(command.output.exports);
  const ImplicitSurface &first = *pair.x.equation(), &second = *pair.y.equation();
  const SurfaceNames names = {pair.x.name, pair.y.name, name(first.kind()), name(second.kind())};
  const SurfaceIntersection result = solve(command, first, second, options, streams);
  const DrawnSurfaces drawn = {result, first, second, names};
  std::string json;
  if (!command.output.json.empty()) {
    Json tree = surfaces_json(result, names);
    add_charts(tree, result, first, second);
    json = json_text(tree);
  }
  write_exports(
      command.output.exports, [&] { return surfaces_scene(drawn, pair.title, cells); },
      [&] { return space_node_csv(result); });
  if (!command.output.svg.empty()) write_file_atomically(command.output.svg, surfaces_svg(drawn, pair.title));
  if (!command.output.report.empty())
    write_file_atomically(
        command.output.report,
        surfaces_report_html(drawn, origin_of(pair.title, command.output.line, {command.file})));
  if (!command.output.json.empty() && !command.output.json_to_stdout())
    write_file_atomically(command.output.json, json);
  if (command.output.json_to_stdout())
    streams.out << json;
  else if (!command.quiet)
    streams.out << heading(input_name(command.file), pair.title)
                << surfaces_summary(result, names, command.verbose);
  return status_of(result);
}

ExitStatus run_with_equation(const IntersectCommand& command, const PatchAndEquation& pair,
                             const IntersectOptions& options, const Streams& streams) {
  const int cells = grid_cells(command.output.exports);
  const PatchNames names = {pair.patch.name, pair.surface, one_patch_names, name(pair.equation.kind())};
  const IntersectResult result = solve(command, pair.equation, pair.patch.patch, options, streams);
  std::string json;
  if (!command.output.json.empty()) {
    Json tree = intersection_json(result, names);
    add_charts(tree, result.graph, pair.patch.patch, pair.equation);
    json = json_text(tree);
  }
  const std::string proof = certificate(command, pair.equation, pair.patch.patch, names, result, streams);
  write_exports(
      command.output.exports,
      [&] { return surface_scene(result, pair.patch.patch, names, pair.title, cells); },
      [&] { return node_csv(result.graph, one_patch_names); });
  if (!command.output.json.empty() && !command.output.json_to_stdout())
    write_file_atomically(command.output.json, json);
  if (!proof.empty()) write_file_atomically(command.output.certificate, proof);
  if (!command.output.svg.empty())
    write_file_atomically(command.output.svg, intersection_svg(result, names, pair.title));
  if (!command.output.report.empty())
    write_file_atomically(command.output.report,
                          equation_report_html(result, pair.patch.patch, pair.equation, names,
                                               origin_of(pair.title, command.output.line, {command.file})));
  if (command.output.json_to_stdout())
    streams.out << json;
  else if (!command.quiet)
    streams.out << heading(input_name(command.file), pair.title)
                << intersection_summary(result, names, pair.patch.patch, command.verbose);
  return status_of(command, result, proof);
}

ExitStatus run_with_patches(const IntersectCommand& command, const RationalPair& pair,
                            const IntersectOptions& options, const Streams& streams) {
  const int cells = grid_cells(command.output.exports);
  const std::optional<BiquadraticPair> biquadratic_pair = biquadratic(pair);
  const PatchNames names = {pair.x.name, pair.y.name};
  const IntersectResult result = solve(command, pair.x.patch, pair.y.patch, options, streams);
  const std::string json = command.output.json.empty() ? "" : json_text(intersection_json(result, names));
  const std::string proof = certificate(command, pair.x.patch, pair.y.patch, names, result, streams);
  write_exports(
      command.output.exports,
      [&] { return intersection_scene(result, pair.x.patch, pair.y.patch, names, pair.title, cells); },
      [&] { return node_csv(result.graph, pair_names); });
  if (!command.output.json.empty() && !command.output.json_to_stdout()) {
    write_file_atomically(command.output.json, json);
  }
  if (!proof.empty()) write_file_atomically(command.output.certificate, proof);
  if (!command.output.svg.empty()) {
    write_file_atomically(command.output.svg, intersection_svg(result, names, pair.title));
  }
  if (!command.output.report.empty()) {
    write_file_atomically(command.output.report,
                          report_html(result, biquadratic_pair ? biquadratic_pair->x : pair.x.patch,
                                      biquadratic_pair ? biquadratic_pair->y : pair.y.patch, names,
                                      origin_of(pair.title, command.output.line, {command.file})));
  }
  if (command.output.json_to_stdout()) {
    streams.out << json;
  } else if (!command.quiet) {
    streams.out << heading(input_name(command.file), pair.title)
                << intersection_summary(result, names, pair.x.patch, pair.y.patch, command.verbose);
  }
  return status_of(command, result, proof);
}

}  // namespace

ExitStatus run(const IntersectCommand& command, const Streams& streams) {
  const IntersectOptions checked = options(command);
  check(command.output, command.file);
  if (!command.output.certificate.empty() && checked.turning.size() != 4)
    throw UsageError("--certificate: needs all turning points, --turning u,v,r,s");
  const SurfacePair pair = read_surface_pair(command.file, command.first, command.second);
  if (const std::optional<PatchAndEquation> mixed = patch_and_equation(pair))
    return run_with_equation(command, *mixed, checked, streams);
  if (pair.x.patch() == nullptr) return run_with_equations(command, pair, checked, streams);
  return run_with_patches(command,
                          {{pair.x.name, *pair.x.patch()}, {pair.y.name, *pair.y.patch()}, pair.title},
                          checked, streams);
}

}  // namespace exsect::cli

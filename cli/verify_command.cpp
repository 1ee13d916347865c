#include "cli/verify_command.h"

#include <exsect/verify/verify_equation.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "cli/progress.h"
#include "output/options/option_values.h"
#include "output/report/verdict_picture.h"
#include "output/report/verdict_report.h"
#include "output/text/terminal_text.h"
#include "output/text/verdict_json.h"
#include "output/text/verdict_summary.h"

namespace exsect::cli {
namespace {

/// The patches that the options name, else those that the candidate names.
SurfacePair chosen_pair(const VerifyCommand& command, const Candidate& candidate) {
  if (!command.first.empty() || !command.second.empty())
    return read_surface_pair(command.file, command.first, command.second);
  return read_surface_pair(command.file, candidate.patches[0], candidate.patches[1],
                           "the candidate's patches");
}

/// Whether the file is JSON that says to hold patches.
bool is_patch_file(const std::string& path) {
  try {
    return file_version(input_text(path, max_patch_file_bytes), path) == "patches/1";
  } catch (const InputError&) {
    return false;
  }
}

Candidate candidate_of(const VerifyCommand& command) {
  if (command.candidate == "-" && command.file == "-")
    throw UsageError("CANDIDATE and FILE cannot both be the standard input");
  try {
    return input_candidate(command.candidate);
  } catch (const InputError&) {
    if (is_patch_file(command.candidate))
      throw UsageError(input_name(command.candidate) +
                       " holds patches, not a candidate: are CANDIDATE and FILE the other way round?");
    throw;
  }
}

/// verify() of two patches, of a surface given by its equation and a patch, or of two such surfaces.
template <class First, class Second>
auto solve_candidate(const First& first, const Second& second, const Candidate& candidate,
                     VerifyOptions options, const Streams& streams, bool quiet) {
  Progress progress(streams.err, streams.watched && !quiet);
  options.progress = [&](double fraction, const char* step) { progress.report(fraction, step); };
  return verify(candidate, first, second, options);
}

ExitStatus status(Agreement agreement) {
  if (agreement == Agreement::agrees) return ExitStatus::complete;
  return agreement == Agreement::disagrees ? ExitStatus::negative : ExitStatus::incomplete;
}

/// What the forms of a verdict need of the pair.
struct JudgedPair {
  std::array<const RationalPatch*, 2> patches;  // nullptr for a surface given by its equation
  PatchNames names;
  std::string title;
  std::function<std::string()> svg;
  std::function<std::string(const ReportOrigin&)> report;
};

ExitStatus write_verdict(const VerifyCommand& command, const Candidate& candidate, const Verification& result,
                         const JudgedPair& pair, const Streams& streams) {
  const std::string json =
      command.output.json.empty() ? "" : json_text(verdict_json(result, candidate, pair.names));
  if (!command.output.json.empty() && !command.output.json_to_stdout())
    write_file_atomically(command.output.json, json);
  if (!command.output.report.empty())
    write_file_atomically(command.output.report, pair.report(origin_of(pair.title, command.output.line,
                                                                       {command.candidate, command.file})));
  if (!command.output.svg.empty()) write_file_atomically(command.output.svg, pair.svg());
  if (command.output.json_to_stdout())
    streams.out << json;
  else if (!command.quiet)
    streams.out << heading(input_name(command.candidate), pair.title)
                << verdict_summary(result, candidate, command.tolerance, pair.patches);
  return status(result.verdict.agreement);
}

ExitStatus judge_with_equation(const VerifyCommand& command, const Candidate& given,
                               const PatchAndEquation& pair, bool patch_is_second,
                               const VerifyOptions& options, const Streams& streams) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(input_name(command.file), "$.patches",
                     fmt::format("\"{}\" is given by its equation: {}", printable(pair.surface), what));
  };
  const Candidate candidate = patch_is_second ? exchanged(given) : given;
  const auto has_second = [](const auto& claim) { return claim.second.has_value(); };
  if (std::ranges::any_of(candidate.curves, has_second) || std::ranges::any_of(candidate.points, has_second))
    refuse("it has no parameters, but the candidate states some");
  const RationalPatch& patch = pair.patch.patch;
  const Verification result =
      solve_candidate(pair.equation, patch, candidate, options, streams, command.quiet);
  const PatchNames names = {pair.patch.name, pair.surface, one_patch_names, name(pair.equation.kind())};
  return write_verdict(command, candidate, result,
                       {{&patch, nullptr},
                        names,
                        pair.title,
                        [&] { return verdict_svg(result, candidate, names, pair.title); },
                        [&](const ReportOrigin& origin) {
                          return verdict_report_html(result, candidate, patch, pair.equation, names, origin);
                        }},
                       streams);
}

/// Two surfaces given by their equations; what the library refuses of them is said of the file.
ExitStatus judge_equations(const VerifyCommand& command, const Candidate& candidate, const SurfacePair& pair,
                           const VerifyOptions& options, const Streams& streams) {
  const auto refusal = [&](const std::string& what) {
    return InputError(input_name(command.file), "$.patches",
                      fmt::format("\"{}\" and \"{}\" are given by their equations: {}",
                                  printable(pair.x.name), printable(pair.y.name), what));
  };
  const ImplicitSurface &first = *pair.x.equation(), &second = *pair.y.equation();
  const SurfaceNames names = {pair.x.name, pair.y.name, name(first.kind()), name(second.kind())};
  try {
    const EquationsVerification result =
        solve_candidate(first, second, candidate, options, streams, command.quiet);
    const DrawnSurfaces drawn = {result.surfaces, first, second, names};
    return write_verdict(
        command, candidate, result,
        {{nullptr, nullptr},
         {pair.x.name, pair.y.name},
         pair.title,
         [&] { return verdict_svg(result, candidate, drawn, pair.title); },
         [&](const ReportOrigin& origin) { return verdict_report_html(result, candidate, drawn, origin); }},
        streams);
  } catch (const NotComparable& error) {
    throw refusal(error.what());
  }
}

}  // namespace

ExitStatus run(const VerifyCommand& command, const Streams& streams) {
  VerifyOptions options;
  options.tolerance = positive_value("--tolerance", command.tolerance);
  if (!command.max_seconds.empty())
    options.max_seconds = positive_value("--max-seconds", command.max_seconds);
  check(command.output, command.file);
  check(command.output, command.candidate);
  const Candidate candidate = candidate_of(command);
  const SurfacePair chosen = chosen_pair(command, candidate);
  if (const std::optional<PatchAndEquation> mixed = patch_and_equation(chosen))
    return judge_with_equation(command, candidate, *mixed, chosen.x.patch() == nullptr, options, streams);
  if (chosen.x.patch() == nullptr) return judge_equations(command, candidate, chosen, options, streams);
  const RationalPair pair = patches_only(chosen, command.file);
  const PatchNames names = {pair.x.name, pair.y.name};
  const Verification result =
      solve_candidate(pair.x.patch, pair.y.patch, candidate, options, streams, command.quiet);
  return write_verdict(command, candidate, result,
                       {{&pair.x.patch, &pair.y.patch},
                        names,
                        pair.title,
                        [&] { return verdict_svg(result, candidate, names, pair.title); },
                        [&](const ReportOrigin& origin) {
                          return verdict_report_html(result, candidate, pair.x.patch, pair.y.patch, names,
                                                     origin);
                        }},
                       streams);
}

}  // namespace exsect::cli

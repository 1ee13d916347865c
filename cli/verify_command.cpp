#include "cli/verify_command.h"

#include <exsect/verify/verify.h>

#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "cli/progress.h"
#include "output/options/option_values.h"
#include "output/report/verdict_picture.h"
#include "output/text/terminal_text.h"
#include "output/text/verdict_json.h"
#include "output/text/verdict_summary.h"

namespace exsect::cli {
namespace {

/// The patches that the options name, else those that the candidate names.
RationalPair chosen_pair(const VerifyCommand& command, const Candidate& candidate) {
  if (!command.first.empty() || !command.second.empty())
    return read_rational_pair(command.file, command.first, command.second);
  return read_rational_pair(command.file, candidate.patches[0], candidate.patches[1],
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

Verification solve_candidate(const RationalPair& pair, const Candidate& candidate, VerifyOptions options,
                             const Streams& streams, bool quiet) {
  Progress progress(streams.err, streams.watched && !quiet);
  options.progress = [&](double fraction, const char* step) { progress.report(fraction, step); };
  return verify(candidate, pair.x.patch, pair.y.patch, options);
}

ExitStatus status(Agreement agreement) {
  if (agreement == Agreement::agrees) return ExitStatus::complete;
  return agreement == Agreement::disagrees ? ExitStatus::negative : ExitStatus::incomplete;
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
  const RationalPair pair = chosen_pair(command, candidate);
  const PatchNames names = {pair.x.name, pair.y.name};
  const Verification result = solve_candidate(pair, candidate, options, streams, command.quiet);
  const std::string json =
      command.output.json.empty() ? "" : json_text(verdict_json(result, candidate, names));
  if (!command.output.json.empty() && !command.output.json_to_stdout())
    write_file_atomically(command.output.json, json);
  if (!command.output.svg.empty())
    write_file_atomically(command.output.svg, verdict_svg(result, candidate, names, pair.title));
  if (!command.output.report.empty())
    write_file_atomically(
        command.output.report,
        verdict_report_html(result, candidate, pair.x.patch, pair.y.patch, names,
                            origin_of(pair.title, command.output.line, {command.candidate, command.file})));
  if (command.output.json_to_stdout())
    streams.out << json;
  else if (!command.quiet)
    streams.out << heading(input_name(command.candidate), pair.title)
                << verdict_summary(result, candidate, command.tolerance, pair.x.patch, pair.y.patch);
  return status(result.verdict.agreement);
}

}  // namespace exsect::cli

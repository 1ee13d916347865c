#include "cli/check_command.h"

#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/number.h>
#include <exsect/geometry/text_file.h>
#include <fmt/format.h>

#include "cli/input_file.h"
#include "output/options/output_files.h"
#include "output/text/json_forms.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// Certificates longer than this, in bytes, are refused.
constexpr std::size_t max_certificate_bytes = std::size_t{256} << 20;

Json summary_json(const checker::Report& report) {
  const checker::Summary& summary = report.summary;
  if (report.fixed) return {{"points", summary.claims[3]}};
  return {{"components", summary.components}, {"closed", summary.closed},        {"open", summary.open},
          {"branched", summary.branched},     {"boundary", summary.boundary},    {"turning", summary.turning},
          {"isolated", summary.isolated},     {"tangential", summary.tangential}};
}

Json accepted_json(const checker::Report& report) {
  const auto& claims = report.summary.claims;
  return {{"exsect", "check/1"},
          {"status", "complete"},
          {"accepted", true},
          {"summary", summary_json(report)},
          {"claims",
           {{"factors", claims[0]},
            {"stars", claims[1]},
            {"overlaps", claims[6]},
            {"tubes", claims[2]},
            {"nodes", claims[3]},
            {"arcs", claims[4]},
            {"cells_in_tubes", report.covered},
            {"cells_excluded", report.exclusions}}}};
}

std::string accepted_text(const checker::Report& report) {
  const auto& claims = report.summary.claims;
  const std::string cells =
      fmt::format("{} cells in tubes, {} cells without a solution", report.covered, report.exclusions);
  if (report.fixed)
    return fmt::format("accepted: the solutions with {} = {} are {} points\nreplayed: {} points, {}\n",
                       "uvrs"[report.fixed->parameter], to_string(report.fixed->value), claims[3], claims[3],
                       cells);
  const checker::Summary& summary = report.summary;
  const std::string branched =
      summary.branched > 0 ? fmt::format(", and {} with crossings", summary.branched) : "";
  const std::string isolated =
      summary.isolated > 0 ? fmt::format(", and {} isolated points", summary.isolated) : "";
  const std::string overlaps =
      claims[6] > 0 ? fmt::format(", and {} overlap{}", claims[6], claims[6] > 1 ? "s" : "") : "";
  const std::string tangential =
      summary.tangential > 0
          ? fmt::format("; along {} of {} arcs the patches touch", summary.tangential, claims[4])
          : "";
  return fmt::format(
      "accepted: the whole {} is {} closed and {} open curves{}{}{}{}\n"
      "replayed: {} nodes, {} stars, {} arcs, {} tubes, {} factors, {}\n",
      report.self ? "self-intersection" : "intersection", summary.closed, summary.open, branched, isolated,
      overlaps, tangential, claims[3], claims[1], claims[4], claims[2], claims[0], cells);
}

}  // namespace

ExitStatus run(const CheckCommand& command, const Streams& streams) {
  OutputFiles files;
  files.json = command.json;
  check(files, command.file);
  const std::string certificate = input_text(command.file, max_certificate_bytes);
  Json json;
  std::string text;
  ExitStatus status = ExitStatus::complete;
  try {
    const checker::Report report = checker::check_certificate(certificate);
    json = accepted_json(report);
    text = accepted_text(report);
  } catch (const checker::Unreadable& unreadable) {
    throw InputError(input_name(command.file), "", unreadable.what());
  } catch (const checker::Rejected& rejected) {
    status = ExitStatus::negative;
    json = {{"exsect", "check/1"},       {"status", "complete"},          {"accepted", false},
            {"place", rejected.place()}, {"kind", name(rejected.kind())}, {"reason", rejected.what()}};
    if (rejected.needed()) json["needed"] = *rejected.needed();
    text = fmt::format("rejected: {}: {}\n", rejected.place(), rejected.what());
  }
  if (files.json_to_stdout()) {
    streams.out << json_text(json);
  } else {
    if (!command.json.empty()) write_file_atomically(command.json, json_text(json));
    if (!command.quiet) streams.out << text;
  }
  return status;
}

}  // namespace exsect::cli

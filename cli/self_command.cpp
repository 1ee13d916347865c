#include "cli/self_command.h"

#include <exsect/geometry/text_file.h>
#include <exsect/solver/intersect_rational.h>

#include "certificate/certificate_text.h"
#include "cli/export_files.h"
#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "cli/progress.h"
#include "output/drawing/intersection_svg.h"
#include "output/options/option_values.h"
#include "output/report/report_html.h"
#include "output/text/intersection_json.h"
#include "output/text/intersection_summary.h"
#include "output/text/node_csv.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

IntersectOptions self_options(const SelfCommand& command) {
  IntersectOptions options;
  options.turning = parameter_list("--turning", command.turning, self_names);
  options.tolerance = positive_value("--tolerance", command.tolerance);
  if (!command.max_seconds.empty())
    options.max_seconds = positive_value("--max-seconds", command.max_seconds);
  return options;
}

IntersectResult solve_self(const RationalPatch& x, IntersectOptions options, const Streams& streams,
                           bool quiet) {
  Progress progress(streams.err, streams.watched && !quiet);
  options.progress = [&](double fraction, const char* step) { progress.report(fraction, step); };
  return self_intersect(x, options);
}

/// What --certificate writes; empty where it is not given, or, with a message, where there is no certificate.
std::string self_certificate(const SelfCommand& command, const RationalPatch& x, const PatchNames& names,
                             const IntersectResult& result, const Streams& streams) {
  if (command.output.certificate.empty()) return "";
  try {
    return self_certificate_text(x, names, result);
  } catch (const NoCertificate& reason) {
    streams.err << "exsect: no certificate: " << printable(reason.what()) << std::endl;
    return "";
  }
}

}  // namespace

ExitStatus run(const SelfCommand& command, const Streams& streams) {
  const IntersectOptions checked = self_options(command);
  check(command.output, command.file);
  if (!command.output.certificate.empty() && checked.turning.size() != 4)
    throw UsageError("--certificate: needs all turning points, --turning u1,v1,u2,v2");
  const int cells = grid_cells(command.output.exports);
  const ChosenRationalPatch chosen = read_rational_patch(command.file, command.patch);
  const PatchNames names = {chosen.patch.name, chosen.patch.name, self_names};
  const IntersectResult result = solve_self(chosen.patch.patch, checked, streams, command.quiet);
  const std::string json = command.output.json.empty() ? "" : json_text(self_json(result, chosen.patch.name));
  const std::string proof = self_certificate(command, chosen.patch.patch, names, result, streams);
  write_exports(
      command.output.exports,
      [&] { return self_scene(result, chosen.patch.patch, chosen.patch.name, chosen.title, cells); },
      [&] { return node_csv(result.graph, self_names); });
  if (!command.output.json.empty() && !command.output.json_to_stdout()) {
    write_file_atomically(command.output.json, json);
  }
  if (!proof.empty()) write_file_atomically(command.output.certificate, proof);
  if (!command.output.svg.empty()) {
    write_file_atomically(command.output.svg, intersection_svg(result, names, chosen.title));
  }
  if (!command.output.report.empty()) {
    write_file_atomically(command.output.report,
                          self_report_html(result, chosen.patch.patch, chosen.patch.name,
                                           origin_of(chosen.title, command.output.line, {command.file})));
  }
  if (command.output.json_to_stdout()) {
    streams.out << json;
  } else if (!command.quiet) {
    streams.out << heading(input_name(command.file), chosen.title)
                << intersection_summary(result, names, chosen.patch.patch, chosen.patch.patch,
                                        command.verbose);
  }
  if (proof.empty() && !command.output.certificate.empty()) return ExitStatus::incomplete;
  return result.status == Status::complete ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli

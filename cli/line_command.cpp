#include "cli/line_command.h"

#include <exsect/geometry/text_file.h>
#include <exsect/solver/line_patch.h>

#include <optional>

#include "certificate/line.h"
#include "cli/export_files.h"
#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "output/drawing/line_svg.h"
#include "output/options/option_values.h"
#include "output/report/report_html.h"
#include "output/text/line_json.h"
#include "output/text/line_summary.h"
#include "output/text/node_csv.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

LineQuery query(const LineCommand& command) {
  std::optional<LineQuery> query;
  for (Parameter p : all_parameters) {
    const std::string& text = command.fixed[index(p)];
    if (text.empty()) continue;
    if (query) throw UsageError("give only one of --u, --v, --r, --s");
    query = LineQuery{p, parameter_value(std::string("--") + name(p), text)};
  }
  if (!query) throw UsageError("give one of --u, --v, --r, --s");
  return *query;
}

/// What --certificate writes; empty where it is not given, or, with a message, where there is no certificate.
std::string line_certificate(const LineCommand& command, const RationalPair& pair,
                             const LineIntersection& line, const Streams& streams) {
  if (command.output.certificate.empty()) return "";
  try {
    return certificate_text(pair.x.patch, pair.y.patch, {pair.x.name, pair.y.name}, line);
  } catch (const NoCertificate& reason) {
    streams.err << "exsect: no certificate: " << printable(reason.what()) << std::endl;
    return "";
  }
}

}  // namespace

ExitStatus run(const LineCommand& command, const Streams& streams) {
  const LineQuery asked = query(command);
  check(command.output, command.file);
  const int cells = grid_cells(command.output.exports);
  const RationalPair pair = read_rational_pair(command.file, command.first, command.second);
  const LineIntersection line = intersect_line(pair.x.patch, pair.y.patch, asked);
  const std::string json = command.output.json.empty() ? "" : json_text(line_json(line, pair.x.patch));
  const std::string proof = line_certificate(command, pair, line, streams);
  if (!proof.empty()) write_file_atomically(command.output.certificate, proof);
  write_exports(
      command.output.exports,
      [&] {
        return line_scene(line, pair.x.patch, pair.y.patch, {pair.x.name, pair.y.name}, pair.title, cells);
      },
      [&] { return point_csv(line, pair.x.patch); });
  if (!command.output.json.empty() && !command.output.json_to_stdout()) {
    write_file_atomically(command.output.json, json);
  }
  if (!command.output.svg.empty()) {
    write_file_atomically(command.output.svg, line_svg(line, pair.x.patch, pair.title));
  }
  if (!command.output.report.empty()) {
    write_file_atomically(command.output.report,
                          line_report_html(line, pair.x.patch, pair.y.patch, {pair.x.name, pair.y.name},
                                           origin_of(pair.title, command.output.line, {command.file})));
  }
  if (command.output.json_to_stdout()) {
    streams.out << json;
  } else if (!command.quiet) {
    streams.out << heading(input_name(command.file), pair.title)
                << line_summary(line, pair.x.patch, pair.y.patch, command.verbose);
  }
  const bool unproved = proof.empty() && !command.output.certificate.empty();
  return unproved || line.solution.incomplete ? ExitStatus::incomplete : ExitStatus::complete;
}

}  // namespace exsect::cli

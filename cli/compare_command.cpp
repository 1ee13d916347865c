#include "cli/compare_command.h"

#include <exsect/geometry/text_file.h>
#include <fmt/format.h>

#include "cli/input_file.h"
#include "cli/patch_choice.h"
#include "output/drawing/comparison_svg.h"
#include "output/options/implicitize_options.h"
#include "output/report/method_reports.h"
#include "output/text/comparison_json.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

ComparisonOptions compare_options(const CompareCommand& command) {
  ComparisonOptions result;
  result.lines = integer_value("--lines", command.lines, 1, 10000);
  result.pieces = integer_value("--pieces", command.pieces, 0, 3);
  if (command.fit != "conics" && command.fit != "dokken") throw UsageError("--fit: must be conics or dokken");
  result.fit = command.fit == "conics" ? PatchFit::conics : PatchFit::dokken;
  if (command.plane != "u,r" && command.plane != "v,s") throw UsageError("--plane: must be u,r or v,s");
  if (command.plane == "v,s") result.plane = ResultantPlane::v_s;
  return result;
}

std::string number(const std::optional<std::size_t>& n) { return n ? std::to_string(*n) : "-"; }

std::string comparison_table(const Comparison& comparison) {
  std::vector<std::vector<std::string>> rows;
  for (const MethodRow& row : comparison.rows)
    rows.push_back({row.method, row.detail,
                    fmt::format("{} ({}/{})", row.components, number(row.open), number(row.closed)),
                    fmt::format("{}/{}", number(row.phantom_branches), row.phantoms_removed),
                    fmt::format("{}/{}", row.certified, row.points), std::to_string(row.missed),
                    fmt::format("{}/{}", row.phantom_points, row.phantom_points_removed),
                    fmt::format("{:.0f}", row.milliseconds),
                    row.peak_kib ? fmt::format("{:.1f}", static_cast<double>(*row.peak_kib) / 1024) : "-"});
  std::string text = table({"method", "", "found (open/closed)", "phantoms met/removed", "certified",
                            "missed", "phantom points met/removed", "ms", "MiB"},
                           rows);
  for (const MethodRow& row : comparison.rows)
    text += fmt::format("{} ({}): {}\n", row.method, row.detail, row.answer);
  return text +
         fmt::format(
             "certified, missed, phantom points: on {} lines u = const{}, against their exact points\n",
             comparison.lines,
             comparison.plane == ResultantPlane::v_s ? ", for the resultant v = const" : "");
}

}  // namespace

ExitStatus run(const CompareCommand& command, const Streams& streams) {
  const ComparisonOptions checked = compare_options(command);
  check(command.output, command.file);
  const PatchPair pair = read_pair(command.file, command.first, command.second);
  const PatchNames names = {pair.x.name, pair.y.name};
  const Comparison comparison = compare(pair.x.patch, pair.y.patch, checked);
  const std::string json = command.output.json.empty() ? "" : json_text(comparison_json(comparison, names));
  if (!command.output.json.empty() && !command.output.json_to_stdout()) {
    write_file_atomically(command.output.json, json);
  }
  if (!command.output.svg.empty()) {
    write_file_atomically(command.output.svg, comparison_svg(comparison, pair.title));
  }
  if (!command.output.report.empty()) {
    write_file_atomically(command.output.report,
                          comparison_report_html(comparison, pair.x.patch, pair.y.patch, names,
                                                 origin_of(pair.title, command.output.line, {command.file})));
  }
  if (command.output.json_to_stdout()) {
    streams.out << json;
  } else if (!command.quiet) {
    streams.out << heading(input_name(command.file), pair.title) << comparison_table(comparison);
  }
  return comparison.is_complete() ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli

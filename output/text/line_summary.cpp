#include "output/text/line_summary.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include "output/text/json_forms.h"
#include "output/text/shown_line.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

std::string line_headline(const LineIntersection& line) {
  const std::string value = to_string(line.query.value);
  std::string text = fmt::format(
      "{} = {}: {}, {}", name(line.query.fixed),
      value.size() <= 40 ? value : fmt::format("{:.17g}", to_double(line.query.value)),
      line.solution.incomplete ? "incomplete" : "complete", counted(line.solution.points.size(), "point"));
  if (!line.solution.on_patch.empty()) {
    text += ", " + counted(line.solution.on_patch.size(), "piece") + " of the line on the other patch";
  }
  return text + "\n";
}

std::string bidegree(const BivariatePolynomial& f) {
  return f.is_zero() ? "zero" : fmt::format("({},{})", f.degree_r(), f.degree_s());
}

std::string construction(const LineIntersection& line) {
  std::string text = fmt::format("  line       {}\n", name(line.shape));
  if (line.forms) {
    text += fmt::format("  pull-back  plane {}, cylinder {}\n", bidegree(line.pullback.plane),
                        bidegree(line.pullback.cylinder()));
  }
  if (!line.eliminant.is_zero()) {
    text +=
        fmt::format("  eliminant  degree {} in {}\n", line.eliminant.degree(), name(line.eliminant_variable));
  }
  return text;
}

std::string interval_text(const FeasibleInterval& interval) {
  return fmt::format("{}{}, {}{}", interval.from_closed ? '[' : '(', decimal(interval.from.to_double()),
                     decimal(interval.to.to_double()), interval.to_closed ? ']' : ')');
}

std::string feasible_text(const LineIntersection& line) {
  std::string text;
  for (const FeasibleBranch& branch : line.feasible) {
    std::vector<std::string> intervals;
    for (const FeasibleInterval& interval : branch.intervals) intervals.push_back(interval_text(interval));
    text += fmt::format("  branch {}   {} in {}\n", branch.branch, name(line.eliminant_variable),
                        intervals.empty() ? "the empty set" : joined(intervals, ", "));
  }
  return text;
}

std::string points_text(const LineIntersection& line, const BezierPatch& x) {
  std::vector<std::vector<std::string>> rows;
  for (const ShownPoint& shown : shown_points(line.solution, x)) {
    std::vector<std::string> row;
    for (double parameter : shown.parameters) row.push_back(fmt::format("{:.15f}", parameter));
    std::vector<std::string> sides;
    for (Side side : shown.point.sides()) sides.push_back(side_name(side));
    row.insert(row.end(),
               {std::to_string(shown.point.multiplicity()),
                shown.point.branch() == 0 ? "-" : std::to_string(shown.point.branch()), joined(sides, " ")});
    rows.push_back(std::move(row));
  }
  const std::string text = table({"u", "v", "r", "s", "multiplicity", "branch", "on"}, rows);
  return text.empty() ? "" : "\n" + text;
}

std::string on_patch_text(const LineIntersection& line) {
  std::string text;
  for (const AlgebraicInterval& interval : line.solution.on_patch) {
    text += fmt::format("  on the other patch for {} in [{}, {}]\n", name(partner(line.query.fixed)),
                        decimal(interval.from.to_double()), decimal(interval.to.to_double()));
  }
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string line_summary(const LineIntersection& line, const BezierPatch& x) {
  const std::string why =
      line.solution.incomplete ? "\nNot decided: " + printable(*line.solution.incomplete) + "\n" : "";
  return line_headline(line) + construction(line) + feasible_text(line) + points_text(line, x) +
         on_patch_text(line) + why;
}

}  // namespace exsect::cli

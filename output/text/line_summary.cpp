#include "output/text/line_summary.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include "output/text/json_forms.h"
#include "output/text/node_place.h"
#include "output/text/proved_decimal.h"
#include "output/text/shown_line.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

std::string line_headline(const LineIntersection& line) {
  const std::string value = to_string(line.query.value);
  std::string text = fmt::format(
      "{} = {}: {}, proved: {}", name(line.query.fixed),
      value.size() <= 40 ? value
                         : proved_decimal({line.query.value, line.query.value}, -shown_decimals(true)),
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
  if (!line.cubic.empty()) {
    std::vector<std::string> bidegrees;
    for (const BivariatePolynomial& f : line.cubic) bidegrees.push_back(bidegree(f));
    text +=
        line.shape == LineShape::plane_cubic
            ? fmt::format("  pull-back  plane {}, cubic {}\n", bidegree(line.pullback.plane), bidegrees[0])
            : fmt::format("  pull-back  quadrics {}\n", joined(bidegrees, ", "));
  }
  if (!line.eliminant.is_zero()) {
    text +=
        fmt::format("  eliminant  degree {} in {}\n", line.eliminant.degree(), name(line.eliminant_variable));
  }
  return text;
}

std::string end_text(const RealAlgebraic& end, bool verbose) {
  return proved_decimal(end.refined_to(shown_width()).interval(), -shown_decimals(verbose));
}

std::string feasible_interval_text(const FeasibleInterval& interval, bool verbose) {
  return fmt::format("{}{}, {}{}", interval.from_closed ? '[' : '(', end_text(interval.from, verbose),
                     end_text(interval.to, verbose), interval.to_closed ? ']' : ')');
}

std::string feasible_text(const LineIntersection& line, bool verbose) {
  std::string text;
  for (const FeasibleBranch& branch : line.feasible) {
    std::vector<std::string> intervals;
    for (const FeasibleInterval& interval : branch.intervals)
      intervals.push_back(feasible_interval_text(interval, verbose));
    text += fmt::format("  branch {}   {} in {}\n", branch.branch, name(line.eliminant_variable),
                        intervals.empty() ? "the empty set" : joined(intervals, ", "));
  }
  return text;
}

std::string points_text(const LineIntersection& line, const RationalPatch& x, const RationalPatch& y,
                        bool verbose) {
  const std::vector<ShownPoint> shown = shown_points(line.solution, x);
  std::vector<ParameterBox> boxes;
  for (const ShownPoint& point : shown) boxes.push_back(point.point.box());
  auto rows = place_rows(boxes, x, y, shown_decimals(verbose));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const CertifiedPoint& point = shown[i].point;
    std::vector<std::string> sides;
    for (Side side : point.sides()) sides.push_back(side_name(side));
    rows[i].insert(rows[i].end(),
                   {std::to_string(point.multiplicity()),
                    point.branch() == 0 ? "-" : std::to_string(point.branch()), joined(sides, " ")});
  }
  const std::string text = table({"u", "v", "r", "s", "x", "y", "z", "multiplicity", "branch", "on"}, rows);
  return text.empty() ? "" : "\n" + text;
}

std::string on_patch_text(const LineIntersection& line, bool verbose) {
  std::string text;
  for (const AlgebraicInterval& interval : line.solution.on_patch) {
    text += fmt::format("  on the other patch for {} in [{}, {}]\n", name(partner(line.query.fixed)),
                        end_text(interval.from, verbose), end_text(interval.to, verbose));
  }
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string line_summary(const LineIntersection& line, const RationalPatch& x, const RationalPatch& y,
                         bool verbose) {
  const std::string why =
      line.solution.incomplete ? "\nNot decided: " + printable(*line.solution.incomplete) + "\n" : "";
  return line_headline(line) + construction(line) + feasible_text(line, verbose) +
         points_text(line, x, y, verbose) + on_patch_text(line, verbose) + why;
}

}  // namespace exsect::cli

#include "output/drawing/line_svg.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <vector>

#include "output/drawing/svg_legend.h"
#include "output/drawing/svg_square.h"
#include "output/text/shown_line.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr double line_margin = 70;
constexpr double square_top = 62;
constexpr double picture_width = SvgSquare::size + 2 * line_margin;
constexpr int curve_cells = 200;

/// A bivariate polynomial in doubles, scaled so that its largest coefficient is 1; s runs to the right, r
/// upwards.
class LineShade {
 public:
  explicit LineShade(const BivariatePolynomial& f) {
    Rational largest = 0;
    for (int i = 0; i <= f.degree_r(); ++i) {
      for (const Rational& c : f.coefficient(i).coefficients()) largest = std::max<Rational>(largest, abs(c));
    }
    for (int i = 0; i <= f.degree_r(); ++i) {
      std::vector<double> row;
      for (const Rational& c : f.coefficient(i).coefficients()) row.push_back(to_double(c / largest));
      rows_.push_back(std::move(row));
    }
  }

  double operator()(PlanePoint p) const {
    double value = 0;
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      double inner = 0;
      for (auto c = row->rbegin(); c != row->rend(); ++c) inner = inner * p[0] + *c;
      value = value * p[1] + inner;
    }
    return value;
  }

 private:
  std::vector<std::vector<double>> rows_;
};

std::vector<PlanePolyline> curves(const BivariatePolynomial& f) {
  return f.is_zero() ? std::vector<PlanePolyline>{} : zero_set(LineShade(f), curve_cells);
}

void draw(SvgSquare& square, const std::vector<PlanePolyline>& drawn, const Stroke& stroke) {
  for (const PlanePolyline& polyline : drawn) square.polyline(polyline, stroke);
}

/// The curve P = 0, cut where 2 A r + B changes sign: negative on branch 1, positive on branch 2 (9.16).
/// Where P is not quadratic in r, all of it is the first.
struct Branches {
  std::vector<PlanePolyline> first;
  std::vector<PlanePolyline> second;
};

Branches branches(const BivariatePolynomial& plane) {
  Branches result;
  if (plane.is_zero()) return result;
  const LineShade slope(plane.derivative_r());
  const bool single = plane.degree_r() != 2;
  for (const PlanePolyline& polyline : curves(plane)) {
    bool was_second = false;
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
      const PlanePoint middle = {(polyline[i][0] + polyline[i + 1][0]) / 2,
                                 (polyline[i][1] + polyline[i + 1][1]) / 2};
      const bool second = !single && slope(middle) > 0;
      std::vector<PlanePolyline>& branch = second ? result.second : result.first;
      if (i == 0 || second != was_second) branch.push_back({polyline[i]});
      branch.back().push_back(polyline[i + 1]);
      was_second = second;
    }
  }
  return result;
}

const Stroke second_surface = {"#9a9a9a", 1.2};
const Stroke lower_end = {"#009e73", 1.6, "6 4"};
const Stroke upper_end = {"#cc79a7", 1.6, "2 4"};

Stroke branch_stroke(int branch) { return {palette(branch == 1 ? 0 : 1), 2.4}; }

/// A bar on the axis per interval, one row per branch; a single parameter is a dot.
void draw_feasible(SvgPicture& picture, const SvgSquare& square, const LineIntersection& line) {
  for (const FeasibleBranch& branch : line.feasible) {
    const double y = square.y(0) - (branch.branch == 1 ? 4 : 11);
    for (const FeasibleInterval& interval : branch.intervals) {
      const double from = square.x(interval.from.to_double());
      const double to = square.x(interval.to.to_double());
      const double end = std::max(to, from + 0.1);
      picture.element(
          fmt::format(R"(<path d="M{:.2f},{:.2f}H{:.2f}" stroke="{}" stroke-width="5" stroke-linecap="{}"/>)",
                      from, y, end, branch_stroke(branch.branch).colour, from == to ? "round" : "butt"));
    }
  }
}

void draw_points(SvgPicture& picture, SvgSquare& square, const LineIntersection& line,
                 const RationalPatch& x) {
  const std::size_t across = index(line.eliminant_variable);
  const std::size_t upwards = index(partner(line.eliminant_variable));
  for (const ShownPoint& shown : shown_points(line.solution, x)) {
    const PlanePoint at = {shown.parameters[across], shown.parameters[upwards]};
    picture.line(square.x(at[0]), square.y(at[1]), square.x(at[0]), square.y(0), {"#000000", 0.8, "1 3"});
    square.mark(Mark::dot, at, "#000000");
  }
}

/// What is drawn of a line besides its points: curves of the unit square.
struct LineCurves {
  Branches plane;
  std::vector<PlanePolyline> second_surface;
  std::vector<PlanePolyline> lower_end;
  std::vector<PlanePolyline> upper_end;
};

LineCurves line_curves(const LineIntersection& line) {
  const PullBack& pullback = line.pullback;
  LineCurves result = {branches(pullback.plane), curves(line.forms ? pullback.cylinder() : pullback.m),
                       curves(pullback.l), curves(pullback.l - pullback.u)};
  for (const BivariatePolynomial& f : line.cubic)
    std::ranges::move(curves(f), std::back_inserter(result.second_surface));
  return result;
}

const char* second_surface_name(const LineIntersection& line) {
  if (line.shape == LineShape::plane_cubic) return "cubic";
  if (line.shape == LineShape::twisted_cubic) return "quadrics through the line";
  return line.forms ? "cylinder Z = 0" : "second plane";
}

/// Only what is seen in the picture.
SvgLegend line_legend(const LineIntersection& line, const LineCurves& drawn) {
  SvgLegend legend;
  const auto add = [&](const std::vector<PlanePolyline>& curve, const Stroke& stroke,
                       const std::string& text) {
    if (!curve.empty()) legend.add(stroke, text);
  };
  const std::string along = name(partner(line.query.fixed));
  const bool folded = line.shape == LineShape::folded;
  add(drawn.plane.first, branch_stroke(1),
      line.pullback.plane.degree_r() > 2 ? "plane P = 0" : "plane P = 0, branch 1");
  add(drawn.plane.second, branch_stroke(2), "plane P = 0, branch 2");
  add(drawn.second_surface, second_surface, second_surface_name(line));
  add(drawn.lower_end, lower_end, folded ? "one end of the line" : along + " = 0");
  add(drawn.upper_end, upper_end, folded ? "other end of the line" : along + " = 1");
  for (const FeasibleBranch& branch : line.feasible) {
    if (branch.intervals.empty()) continue;
    legend.add({branch_stroke(branch.branch).colour, 5},
               fmt::format("feasible {}, branch {}", name(line.eliminant_variable), branch.branch));
  }
  if (!line.solution.points.empty()) legend.add(Mark::dot, "#000000", "intersection point");
  return legend;
}

std::string subtitle(const LineIntersection& line) {
  const std::string value = to_string(line.query.value);
  std::string text =
      fmt::format("{} = {}: {}", name(line.query.fixed),
                  value.size() <= 20 ? value : fmt::format("{:.12g}", to_double(line.query.value)),
                  counted(line.solution.points.size(), "point"));
  if (!line.solution.on_patch.empty()) {
    text += ", " + counted(line.solution.on_patch.size(), "piece") + " on the other patch";
  }
  return text + (line.solution.incomplete ? " (incomplete)" : "");
}

}  // namespace

std::string line_svg(const LineIntersection& line, const RationalPatch& x, const std::string& title) {
  const LineCurves drawn = line_curves(line);
  const SvgLegend entries = line_legend(line, drawn);
  const double legend_top = square_top + SvgSquare::size + 54;
  const double legend_width = picture_width - 2 * 30;
  SvgPicture picture(picture_width, legend_top + entries.height(legend_width) + 14);
  picture.element("<g fill=\"#000000\">");
  const double title_size = text_width(title, 15) <= picture_width - 30 ? 15 : 12;
  picture.text(picture_width / 2, 26, fitted(title, title_size, picture_width - 30), title_size,
               TextAnchor::middle);
  picture.text(picture_width / 2, 48, fitted(subtitle(line), 13, picture_width - 30), 13, TextAnchor::middle);
  picture.element("</g>");
  SvgSquare square(picture, line_margin, square_top, name(line.eliminant_variable),
                   name(partner(line.eliminant_variable)));
  draw(square, drawn.second_surface, second_surface);
  draw(square, drawn.lower_end, lower_end);
  draw(square, drawn.upper_end, upper_end);
  draw(square, drawn.plane.first, branch_stroke(1));
  draw(square, drawn.plane.second, branch_stroke(2));
  draw_feasible(picture, square, line);
  draw_points(picture, square, line, x);
  entries.draw(picture, 30, legend_top, legend_width);
  return picture.document();
}

}  // namespace exsect::cli

#include "output/drawing/implicit_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace exsect::cli {
namespace {

constexpr double panel_margin = 76;
constexpr double panel_top = 62;
constexpr int zero_set_cells = 240;

/// A polynomial in doubles, scaled so that its largest coefficient is 1.
using Table = std::vector<std::vector<double>>;

Rational largest_coefficient(const BivariatePolynomial& f) {
  Rational largest = 0;
  for (int i = 0; i <= f.degree_r(); ++i)
    for (const Rational& c : f.coefficient(i).coefficients()) largest = std::max<Rational>(largest, abs(c));
  return largest;
}

Table in_doubles(const BivariatePolynomial& f, const Rational& scale) {
  Table table;
  for (int i = 0; i <= f.degree_r(); ++i) {
    table.emplace_back();
    for (const Rational& c : f.coefficient(i).coefficients())
      table.back().push_back(to_double(scale == 0 ? c : Rational(c / scale)));
  }
  return table;
}

double value(const Table& table, PlanePoint p) {
  double sum = 0;
  for (auto row = table.rbegin(); row != table.rend(); ++row) {
    double inner = 0;
    for (auto c = row->rbegin(); c != row->rend(); ++c) inner = inner * p[1] + *c;
    sum = sum * p[0] + inner;
  }
  return sum;
}

std::vector<double> in_doubles(const std::vector<Rational>& values) {
  std::vector<double> result;
  for (const Rational& q : values) result.push_back(to_double(q));
  return result;
}

/// The interval of the breaks that holds t; its index is beyond the last one if there is none.
std::size_t interval_of(const std::vector<double>& breaks, double t) {
  if (!(t >= breaks.front() && t <= breaks.back())) return breaks.size();
  std::size_t k = 0;
  while (k + 2 < breaks.size() && breaks[k + 1] <= t) ++k;
  return k;
}

std::function<double(PlanePoint)> drawn_spline(const PlanarFunction& f) {
  auto tables = std::make_shared<std::vector<std::vector<Table>>>();
  for (const auto& row : f.cells()) {
    tables->emplace_back();
    for (const auto& cell : row) tables->back().push_back(cell ? in_doubles(*cell, 1) : Table());
  }
  const auto x = in_doubles(f.grid().breaks_x), y = in_doubles(f.grid().breaks_y);
  const bool squared = f.grid().squared;
  return [=](PlanePoint p) {
    const std::size_t i = interval_of(x, squared ? p[0] * p[0] : p[0]), j = interval_of(y, p[1]);
    if (i >= tables->size() || j >= (*tables)[i].size() || (*tables)[i][j].empty())
      return std::numeric_limits<double>::quiet_NaN();
    return value((*tables)[i][j], p);
  };
}

double distance(const PlanePoint& p, const PlanePolyline& polyline) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const PlanePoint& a = polyline[i];
    const double dx = polyline[i + 1][0] - a[0], dy = polyline[i + 1][1] - a[1];
    const double square = dx * dx + dy * dy;
    const double t = square > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square : 0;
    const double s = std::clamp(t, 0.0, 1.0);
    least = std::min(least, std::hypot(p[0] - a[0] - s * dx, p[1] - a[1] - s * dy));
  }
  return least;
}

PlaneView view_of(const PlanarBox& box) {
  return {{to_double(box.x.lower), to_double(box.x.upper)}, {to_double(box.y.lower), to_double(box.y.upper)}};
}

double near_distance(const PlanarImplicit& implicit, const PlaneView& view) {
  const double size = std::max(view.across[1] - view.across[0], view.upwards[1] - view.upwards[0]);
  const auto& bound = implicit.bounds.one_sided.distance;
  return std::max(0.008 * size, bound ? 2 * to_double(*bound) : 0.03 * size);
}

const Stroke curve_stroke = {"#56b4e9", 6};
const Stroke zero_stroke = {"#000000", 1.6};
const Stroke further_stroke = {"#d55e00", 1.6, "6 3"};

}  // namespace

std::function<double(PlanePoint)> drawn_function(const PlanarFunction& f) {
  if (!f.is_polynomial()) return drawn_spline(f);
  const Table table = in_doubles(f.polynomial(), largest_coefficient(f.polynomial()));
  return [table](PlanePoint p) { return value(table, p); };
}

PlanePolyline drawn_curve(const BezierCurve& curve) {
  const HomogeneousCurve reduced = homogeneous(curve);
  constexpr int steps = 200;
  PlanePolyline polyline;
  for (int k = 0; k <= steps; ++k) {
    const Rational t(k, steps);
    const Rational w = reduced.denominator(t);
    polyline.push_back({to_double(Rational(reduced.numerators[0](t) / w)),
                        to_double(Rational(reduced.numerators[1](t) / w))});
  }
  return polyline;
}

DrawnZeroSet drawn_zero_set(const PlanarFunction& f, const PlanePolyline& curve, double near,
                            const PlaneView& view) {
  DrawnZeroSet result;
  for (const PlanePolyline& polyline : zero_set_in(drawn_function(f), view, zero_set_cells)) {
    bool was_near = false;
    for (std::size_t i = 0; i < polyline.size(); ++i) {
      const bool is_near = distance(polyline[i], curve) <= near;
      std::vector<PlanePolyline>& part = is_near ? result.following : result.further;
      if (i == 0 || is_near != was_near) {
        part.emplace_back();
        if (i > 0) part.back().push_back(polyline[i - 1]);
      }
      part.back().push_back(polyline[i]);
      was_near = is_near;
    }
  }
  return result;
}

namespace {

/// A drawn frame with its curve; what the legend needs to know.
struct Panel {
  PlaneView view;
  PlanePolyline curve;
  DrawnZeroSet zero;
  std::vector<std::string> variables;
};

Panel panel_of(const PlanarImplicit& implicit, const BezierCurve& curve,
               const std::vector<std::string>& variables) {
  const PlaneView view = view_of(implicit.box);
  PlanePolyline drawn = drawn_curve(curve);
  DrawnZeroSet zero = drawn_zero_set(implicit.function, drawn, near_distance(implicit, view), view);
  return {view, std::move(drawn), std::move(zero), variables};
}

/// The panels side by side under a title, with a legend.
std::string picture_of(const std::vector<Panel>& panels, const std::string& title,
                       const std::string& subtitle) {
  double width = panel_margin, height = 0;
  bool follows = false, elsewhere = false;
  for (const Panel& panel : panels) {
    width += SvgPlane::width(panel.view) + panel_margin;
    height = std::max(height, SvgPlane::height(panel.view));
    follows = follows || !panel.zero.following.empty();
    elsewhere = elsewhere || !panel.zero.further.empty();
  }
  const double shift = std::max(0.0, 450 - width) / 2;
  width = std::max(width, 450.0);
  SvgLegend legend;
  legend.add(curve_stroke, "curve");
  if (follows) legend.add(zero_stroke, "zero set");
  if (elsewhere) legend.add(further_stroke, "zero set elsewhere");
  const double legend_top = panel_top + height + 54;
  SvgPicture picture(width, legend_top + legend.height(width - 60) + 14);
  picture.element("<g fill=\"#000000\">");
  picture.text(width / 2, 26, fitted(title, 15, width - 30), 15, TextAnchor::middle);
  picture.text(width / 2, 48, fitted(subtitle, 13, width - 30), 13, TextAnchor::middle);
  picture.element("</g>");
  double left = panel_margin + shift;
  for (const Panel& panel : panels) {
    SvgPlane plane(picture, left, panel_top, panel.view, panel.variables[0], panel.variables[1]);
    plane.polyline(panel.curve, curve_stroke);
    for (const PlanePolyline& polyline : panel.zero.further) plane.polyline(polyline, further_stroke);
    for (const PlanePolyline& polyline : panel.zero.following) plane.polyline(polyline, zero_stroke);
    left += SvgPlane::width(panel.view) + panel_margin;
  }
  legend.draw(picture, 30, legend_top, width - 60);
  return picture.document();
}

}  // namespace

std::string planar_implicit_svg(const PlanarImplicit& implicit, const BezierCurve& curve,
                                const std::string& subtitle, const std::vector<std::string>& variables,
                                const std::string& title) {
  return picture_of({panel_of(implicit, curve, variables)}, title, subtitle);
}

std::string planar_pair_svg(const PlanarImplicit& f, const BezierCurve& curve_f,
                            const std::vector<std::string>& variables_f, const PlanarImplicit& g,
                            const BezierCurve& curve_g, const std::vector<std::string>& variables_g,
                            const std::string& title) {
  return picture_of({panel_of(f, curve_f, variables_f), panel_of(g, curve_g, variables_g)}, title,
                    "both projections");
}

}  // namespace exsect::cli

#include "lift/plane_section.h"

#include <exsect/algebra/quadratic_sign.h>

#include <algorithm>
#include <utility>

#include "lift/conjugate_conics.h"
#include "lift/line_square.h"
#include "lift/plane_conic.h"

namespace exsect {
namespace {

using Kind = SpaceCurveKind;

SpaceCurve of_kind(Kind kind) { return {0, kind, {}, false, 1}; }

/// All of the parts are curves like this one.
NamedParts parts_like(SpaceCurve curve, std::function<int(const LiftedArc&)> part) {
  return {std::move(part), [curve = std::move(curve)](int) { return curve; }};
}
NamedParts one_curve(SpaceCurve curve) {
  return parts_like(std::move(curve), [](const LiftedArc&) { return 0; });
}

Point at(const SurfaceChart& chart, const Rational& u, const Rational& v, const Rational& y) {
  return chart.origin + u * chart.along_u + v * chart.along_v + y * chart.along_y;
}

Rational squared(const Point& a) { return dot(a, a); }

int sign_inside(const BivariatePolynomial& f, const LiftedCurve& curve, const LiftedArc& arc) {
  return f.is_zero() ? 0 : sign_at(f.exchanged(), curve.below.arcs[arc.below].inside);
}

/// The position among the roots of f of one coordinate of the arc's inner point; f is squarefree in it alone.
int which_root(const std::vector<RealAlgebraic>& roots, const LiftedCurve& curve, const LiftedArc& arc) {
  TriangularPoint p = curve.below.arcs[arc.below].inside;
  for (Rational width = power_of_two(-20);; width *= width) {
    const RationalInterval v = p.r_interval();
    int found = -1, count = 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const RationalInterval at = roots[i].refined_to(width).interval();
      if (at.upper < v.lower || v.upper < at.lower) continue;
      found = static_cast<int>(i);
      ++count;
    }
    if (count == 1) return found;
    p = p.refined_to(width);
  }
}

/// A section u = const of a surface of revolution about an axis along u.
NamedParts circles(const LiftedCurve& curve, const ShadowFactor& factor) {
  SpaceCurve circle = of_kind(Kind::circle);
  circle.direction = curve.chart.along_u;
  if (factor.factor.degree_r() == 1) {
    const SurfaceChart& chart = curve.chart;
    const Rational u = -factor.factor.coefficient(0, 0) / factor.factor.coefficient(1, 0);
    const Polynomial over = chart.radicand.at_r(u);
    const Rational v = -over.coefficient(1) / (2 * over.coefficient(2));
    circle.point = at(chart, u, v, 0);
    circle.radius_squared = over(v) * squared(chart.along_y);
  }
  return parts_like(circle, [&curve](const LiftedArc& arc) {
    const RealAlgebraic& u = curve.below.arcs[arc.below].inside.s();
    const auto& values = curve.below.values;
    return static_cast<int>(std::find(values.begin(), values.end(), u) - values.begin());
  });
}

/// The lines of a cylinder over v = const.
NamedParts rulings(const LiftedCurve& curve, const ShadowFactor& factor) {
  SpaceCurve line = of_kind(Kind::line);
  line.direction = curve.chart.along_u;
  const std::vector<RealAlgebraic> roots = real_roots(factor.factor.at_r(0), 0, 1);
  return parts_like(line, [&curve, roots](const LiftedArc& arc) {
    return 3 * which_root(roots, curve, arc) + arc.sheet + 1;
  });
}

/// y^2 along the line (u0,v0) + t (du,dv).
Polynomial along_line(const BivariatePolynomial& y2, const std::array<Rational, 2>& p,
                      const std::array<Rational, 2>& d) {
  const Polynomial u{p[0], d[0]}, v{p[1], d[1]};
  return Polynomial(y2.coefficient(2, 0)) * u * u + Polynomial(y2.coefficient(0, 2)) * v * v +
         Polynomial(y2.coefficient(1, 0)) * u + Polynomial(y2.coefficient(0, 1)) * v +
         Polynomial(y2.coefficient(0, 0));
}

/// Above a rational line of the shadow: a section by a plane along y, or lines of one.
NamedParts above_line(const LiftedCurve& curve, const BivariatePolynomial& g) {
  const SurfaceChart& chart = curve.chart;
  const Rational gu = g.coefficient(1, 0), gv = g.coefficient(0, 1), g0 = g.coefficient(0, 0);
  const std::array<Rational, 2> d = {gv, -gu};
  const std::array<Rational, 2> p =
      gu != 0 ? std::array<Rational, 2>{-g0 / gu, 0} : std::array<Rational, 2>{0, -g0 / gv};
  const Point along = d[0] * chart.along_u + d[1] * chart.along_v;
  const Polynomial y2 = along_line(chart.radicand, p, d);
  const Rational k2 = y2.coefficient(2), k1 = y2.coefficient(1), k0 = y2.coefficient(0);
  if (k2 < 0 || k1 * k1 != 4 * k2 * k0) {  // a conic
    SpaceCurve conic = of_kind(k2 < 0 ? Kind::ellipse : k2 == 0 ? Kind::parabola : Kind::hyperbola);
    conic.direction = cross(along, chart.along_y);
    if (k2 != 0) {
      const Rational t = -k1 / (2 * k2);
      conic.point = at(chart, p[0] + t * d[0], p[1] + t * d[1], 0);
      if (k2 < 0 && -k2 * squared(chart.along_y) == squared(along)) {
        conic.kind = Kind::circle;
        conic.radius_squared = y2(t) * squared(chart.along_y);
      }
    }
    return one_curve(std::move(conic));
  }
  SpaceCurve line = of_kind(Kind::line);
  if (k2 == 0) {
    line.direction = along;
    if (k0 == 0) line.point = at(chart, p[0], p[1], 0);
    return parts_like(line, [](const LiftedArc& arc) { return arc.sheet; });
  }
  const Rational t = -k1 / (2 * k2);  // y = +- sqrt(k2) (t' - t)
  const std::array<Rational, 2> middle = {p[0] + t * d[0], p[1] + t * d[1]};
  line.point = at(chart, middle[0], middle[1], 0);
  const BivariatePolynomial side = BivariatePolynomial::constant(d[0]) *
                                       (BivariatePolynomial::r() - BivariatePolynomial::constant(middle[0])) +
                                   BivariatePolynomial::constant(d[1]) *
                                       (BivariatePolynomial::s() - BivariatePolynomial::constant(middle[1]));
  return parts_like(
      line, [&curve, side](const LiftedArc& arc) { return arc.sheet * sign_inside(side, curve, arc); });
}

/// Above two lines of the shadow that are conjugate over a quadratic field.
std::optional<NamedParts> above_conjugate_lines(const LiftedCurve& curve, const ShadowFactor& factor) {
  const BivariatePolynomial& y2 = curve.chart.radicand;
  const auto [x, z, delta] = conjugate_lines(factor.factor);
  const auto which = [&curve, x, z](const LiftedArc& arc) {
    return sign_inside(x, curve, arc) * sign_inside(z, curve, arc);
  };
  if (factor.in_common == 0 || vanishes_on(y2, factor.factor)) return parts_like(of_kind(Kind::line), which);
  if (y2.coefficient(2, 0) < 0) {  // a sphere
    return parts_like(of_kind(Kind::circle), which);
  }
  // The square of y along the lines x = +- sqrt(delta) z: alpha +- beta sqrt(delta).
  const Rational xr = x.coefficient(1, 0), xs = x.coefficient(0, 1), zr = z.coefficient(1, 0),
                 zs = z.coefficient(0, 1), in_r = y2.coefficient(2, 0), in_s = y2.coefficient(0, 2);
  const Rational alpha = in_r * (xs * xs + delta * zs * zs) + in_s * (xr * xr + delta * zr * zr),
                 beta = -2 * (in_r * xs * zs + in_s * xr * zr);
  const auto kind_above = [](int sign_of_square) {
    return sign_of_square < 0 ? Kind::ellipse : sign_of_square == 0 ? Kind::parabola : Kind::hyperbola;
  };
  const Kind first = kind_above(quadratic_sign(alpha, beta, delta));
  const Kind second = kind_above(quadratic_sign(alpha, -beta, delta));
  const bool is_cone = y2.coefficient(2, 0) != 0;
  const Rational u0 = is_cone ? Rational(-y2.coefficient(1, 0) / (2 * y2.coefficient(2, 0))) : Rational(0);
  const Rational v0 = -y2.coefficient(0, 1) / (2 * y2.coefficient(0, 2));
  if (is_cone && x(u0, v0) == 0 && z(u0, v0) == 0) {  // planes through the apex
    SpaceCurve line = of_kind(Kind::line);
    line.point = at(curve.chart, u0, v0, 0);
    return parts_like(line, [&curve, which, z](const LiftedArc& arc) {
      return 2 * which(arc) + arc.sheet * sign_inside(z, curve, arc);
    });
  }
  return NamedParts{which, [first, second](int part) { return of_kind(part > 0 ? first : second); }};
}

/// Above two conics of the shadow that are conjugate over a quadratic field, where y is a function.
std::optional<NamedParts> above_conjugate_conics(const LiftedCurve& curve, const BivariatePolynomial& g,
                                                 const SheetFunction& f) {
  const auto pair = conjugate_conics(g);
  if (!pair) return std::nullopt;
  const auto first = conic_above(curve.chart, *pair, 1, f), second = conic_above(curve.chart, *pair, -1, f);
  if (!first || !second) return std::nullopt;
  const auto part = [&curve, n = pair->n, m = pair->m](const LiftedArc& arc) {
    return sign_inside(n, curve, arc) * sign_inside(m, curve, arc);
  };
  return NamedParts{part, [one = *first, other = *second](int side) { return side > 0 ? one : other; }};
}

/// Above a conic g with points of both signs of y: two conics that are mirrored, in the planes l = +- sqrt(k)
/// y, as Y = k^-1 l^2 modulo g for a line l.
std::optional<NamedParts> mirrored_conics(const LiftedCurve& curve, const BivariatePolynomial& g) {
  const BivariatePolynomial& y2 = curve.chart.radicand;
  for (const LineSquare& square : line_squares(symmetric_matrix(y2, BivariatePolynomial::constant(-1) * g))) {
    if (square.factor <= 0) continue;
    const BivariatePolynomial line = square.line;
    const auto part = [&curve, line](const LiftedArc& arc) {
      return arc.sheet * sign_inside(line, curve, arc);
    };
    const std::optional<Rational> root = rational_root(square.factor, 2);
    if (!root) return parts_like(mirrored_conic(curve.chart, PlaneConic(g), line, square.factor), part);
    const auto plane = [line, root = *root](int side) {
      return PlaneAbove{side * line.coefficient(1, 0) / root, side * line.coefficient(0, 1) / root,
                        side * line.coefficient(0, 0) / root};
    };
    const SurfaceChart& chart = curve.chart;
    return NamedParts{part, [&chart, plane, conic = PlaneConic(g)](int side) {
                        return conic_in_plane(chart, conic, plane(side));
                      }};
  }
  return std::nullopt;
}

}  // namespace

std::optional<NamedParts> named_parts(const LiftedCurve& curve, const ShadowFactor& factor) {
  const BivariatePolynomial& g = factor.factor;
  const BivariatePolynomial& y2 = curve.chart.radicand;
  const bool is_flat = curve.chart.is_flat();
  if (!is_flat && g.degree_s() == 0) return circles(curve, factor);
  if (!is_flat && g.degree_r() == 0 && y2.degree_r() == 0) return rulings(curve, factor);
  if (g.total_degree() == 1)
    return is_flat ? one_curve(line_in_plane(curve.chart, g, {0, 0, 0})) : above_line(curve, g);
  const SheetFunction flat = {{}, BivariatePolynomial::constant(1)};
  if (g.total_degree() == 4 && (is_flat || factor.in_common == 0))
    return above_conjugate_conics(curve, g, is_flat ? flat : curve.shadow.rest);
  if (g.total_degree() != 2) return std::nullopt;
  const PlaneConic conic(g);
  if (conic.is_degenerate()) return above_conjugate_lines(curve, factor);
  const bool in_symmetry_plane = is_flat || vanishes_on(y2, g);
  if (in_symmetry_plane) return one_curve(conic_in_plane(curve.chart, conic, {0, 0, 0}));
  if (factor.in_common > 0) return mirrored_conics(curve, g);
  const auto plane = plane_through(curve.shadow.rest, g);
  if (!plane) return std::nullopt;
  return one_curve(conic_in_plane(curve.chart, conic, *plane));
}

}  // namespace exsect

#include "lift/plane_section.h"

#include <exsect/algebra/quadratic_sign.h>
#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <map>
#include <utility>

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

/// Coefficients of a u^2 + b u v + c v^2 + d u + e v + f.
struct Conic {
  Rational a, b, c, d, e, f;

  explicit Conic(const BivariatePolynomial& g)
      : a(g.coefficient(2, 0)),
        b(g.coefficient(1, 1)),
        c(g.coefficient(0, 2)),
        d(g.coefficient(1, 0)),
        e(g.coefficient(0, 1)),
        f(g.coefficient(0, 0)) {}

  Rational discriminant() const { return b * b - 4 * a * c; }
  bool is_degenerate() const { return 4 * a * c * f + b * e * d - a * e * e - c * d * d - f * b * b == 0; }
  Kind kind() const {
    const int s = sign(discriminant());
    return s < 0 ? Kind::ellipse : s == 0 ? Kind::parabola : Kind::hyperbola;
  }
};

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

/// A rational line of the curve in a plane.
SpaceCurve line_in_plane(const SurfaceChart& chart, const BivariatePolynomial& g) {
  const Rational gu = g.coefficient(1, 0), gv = g.coefficient(0, 1), g0 = g.coefficient(0, 0);
  SpaceCurve line = of_kind(Kind::line);
  line.direction = gv * chart.along_u - gu * chart.along_v;
  line.point = gu != 0 ? at(chart, -g0 / gu, 0, 0) : at(chart, 0, -g0 / gv, 0);
  return line;
}

/// The remainder of f modulo g by the monomial of g of greatest total degree, greatest in r.
std::map<std::pair<int, int>, Rational> remainder(const BivariatePolynomial& f,
                                                  const BivariatePolynomial& g) {
  using Monomial = std::pair<int, int>;
  const auto greater = [](const Monomial& p, const Monomial& q) {
    return p.first + p.second != q.first + q.second ? p.first + p.second > q.first + q.second : p > q;
  };
  std::map<Monomial, Rational, decltype(greater)> left(greater);
  const auto terms_of = [](const BivariatePolynomial& h, const auto& take) {
    for (int i = 0; i <= h.degree_r(); ++i)
      for (int j = 0; j <= h.degree_s(); ++j)
        if (h.coefficient(i, j) != 0) take(Monomial{i, j}, h.coefficient(i, j));
  };
  Monomial lead{0, 0};
  Rational leading;
  terms_of(g, [&](const Monomial& m, const Rational& c) {
    if (leading == 0 || greater(m, lead)) lead = m, leading = c;
  });
  terms_of(f, [&](const Monomial& m, const Rational& c) { left[m] = c; });
  std::map<Monomial, Rational> result;
  while (!left.empty()) {
    const auto [m, c] = *left.begin();
    left.erase(left.begin());
    if (c == 0) continue;
    if (m.first < lead.first || m.second < lead.second) {
      result[m] = c;
      continue;
    }
    terms_of(g, [&, c = c, m = m](const Monomial& n, const Rational& b) {
      if (n != lead)
        left[{m.first - lead.first + n.first, m.second - lead.second + n.second}] -= c * b / leading;
    });
  }
  return result;
}

/// Above two lines of the shadow that are conjugate over a quadratic field.
std::optional<NamedParts> above_conjugate_lines(const LiftedCurve& curve, const ShadowFactor& factor) {
  const BivariatePolynomial& y2 = curve.chart.radicand;
  const bool swapped = Conic(factor.factor).a == 0;
  const Conic g(swapped ? factor.factor.exchanged() : factor.factor);
  if (g.a == 0) return std::nullopt;
  // 4 a g = x^2 - (delta z^2 or its constant)
  const Rational delta = g.discriminant();
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  const auto number = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  BivariatePolynomial x = number(2 * g.a) * r + number(g.b) * s + number(g.d);
  BivariatePolynomial z = delta == 0 ? number(1) : s + number((g.b * g.d - 2 * g.a * g.e) / delta);
  if (swapped) {
    x = x.exchanged();
    z = z.exchanged();
  }
  const auto which = [&curve, x, z](const LiftedArc& arc) {
    return sign_inside(x, curve, arc) * sign_inside(z, curve, arc);
  };
  if (factor.in_common == 0 || remainder(y2, factor.factor).empty())
    return parts_like(of_kind(Kind::line), which);
  if (y2.coefficient(2, 0) < 0) {  // a sphere
    return parts_like(of_kind(Kind::circle), which);
  }
  // The square of y along (du,dv) = (-b +- sqrt(delta), 2 a): alpha + beta sqrt(delta), for both signs.
  const Rational in_r = swapped ? y2.coefficient(0, 2) : y2.coefficient(2, 0);
  const Rational in_s = swapped ? y2.coefficient(2, 0) : y2.coefficient(0, 2);
  const Rational alpha = in_r * (g.b * g.b + delta) + in_s * 4 * g.a * g.a, beta = -2 * in_r * g.b;
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

/// y = alpha u + beta v + gamma on the curve above g.
std::optional<std::array<Rational, 3>> plane_through(const LiftedCurve& curve, const BivariatePolynomial& g) {
  const SheetFunction& f = curve.shadow.rest;
  const std::array<BivariatePolynomial, 4> columns = {f.a, BivariatePolynomial::r() * f.b,
                                                      BivariatePolynomial::s() * f.b, f.b};
  std::map<std::pair<int, int>, std::array<Rational, 4>> rows;
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& [monomial, c] : remainder(columns[k], g)) rows[monomial][k] = c;
  RationalMatrix matrix(rows.size(), 4);
  std::size_t i = 0;
  for (const auto& [monomial, row] : rows) {
    for (std::size_t k = 0; k < 4; ++k) matrix(i, k) = row[k];
    ++i;
  }
  for (const std::vector<Integer>& v : null_space(matrix))
    if (v[0] != 0) {
      const Rational first(v[0]);
      return std::array<Rational, 3>{Rational(v[1]) / first, Rational(v[2]) / first, Rational(v[3]) / first};
    }
  return std::nullopt;
}

/// The conic above a conic of the shadow, in the plane y = alpha u + beta v + gamma.
SpaceCurve conic_in_plane(const SurfaceChart& chart, const Conic& g, const std::array<Rational, 3>& plane) {
  const auto& [alpha, beta, gamma] = plane;
  SpaceCurve conic = of_kind(g.kind());
  const Point along_u = chart.along_u + alpha * chart.along_y, along_v = chart.along_v + beta * chart.along_y;
  conic.direction = cross(along_u, along_v);
  const Rational delta = g.discriminant();
  if (delta == 0) return conic;
  const Rational u = (2 * g.c * g.d - g.b * g.e) / delta, v = (2 * g.a * g.e - g.b * g.d) / delta;
  conic.point = at(chart, u, v, alpha * u + beta * v + gamma);
  const Rational uu = squared(along_u), uv = dot(along_u, along_v), vv = squared(along_v);
  if (delta < 0 && g.a * vv == g.c * uu && g.b * uu == 2 * g.a * uv) {
    conic.kind = Kind::circle;
    conic.radius_squared = -(g.d * u / 2 + g.e * v / 2 + g.f) / g.a * uu;
  }
  return conic;
}

/// f = kappa (n^2 - d m^2), n a circle and m linear, for an irreducible f of total degree 4 on a plane: two
/// circles that are conjugate over Q(sqrt(d)).
std::optional<NamedParts> conjugate_circles(const LiftedCurve& curve, const BivariatePolynomial& f) {
  const auto number = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s();
  const Rational uu = squared(curve.chart.along_u), vv = squared(curve.chart.along_v);
  if (f.total_degree() != 4 || f.coefficient(4, 0) == 0) return std::nullopt;
  const BivariatePolynomial scaled = number(uu * uu / f.coefficient(4, 0)) * f;
  const BivariatePolynomial n = number(uu) * u * u + number(vv) * v * v +
                                number(scaled.coefficient(3, 0) / (2 * uu)) * u +
                                number(scaled.coefficient(0, 3) / (2 * vv)) * v;
  const BivariatePolynomial rest = scaled - n * n;
  if (rest.total_degree() > 2) return std::nullopt;
  // The matrix of rest - 2 c n - c^2 as a polynomial in c: of rank 1 for the constant c of n.
  const Polynomial c = Polynomial::variable();
  const auto entry = [&](int i, int j, int share) {
    const Rational part(1, share);
    return Polynomial{part * rest.coefficient(i, j), -2 * part * n.coefficient(i, j)};
  };
  const std::array<std::array<Polynomial, 3>, 3> m = {
      {{entry(2, 0, 1), entry(1, 1, 2), entry(1, 0, 2)},
       {entry(1, 1, 2), entry(0, 2, 1), entry(0, 1, 2)},
       {entry(1, 0, 2), entry(0, 1, 2), entry(0, 0, 1) - c * c}}};
  Polynomial common;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      common = gcd(common, m[i][j] * m[(i + 1) % 3][(j + 1) % 3] - m[i][(j + 1) % 3] * m[(i + 1) % 3][j]);
  if (common.degree() < 1) return std::nullopt;
  for (const PolynomialPower& power : irreducible_factors(common)) {
    if (power.factor.degree() != 1) continue;
    const Rational value = -power.factor.coefficient(0) / power.factor.coefficient(1);
    for (std::size_t i = 0; i < 3; ++i) {
      if (m[i][i](value) >= 0) continue;
      const BivariatePolynomial line =
          number(m[i][0](value)) * u + number(m[i][1](value)) * v + number(m[i][2](value));
      const BivariatePolynomial circle = n + number(value);
      SpaceCurve named = of_kind(Kind::circle);
      named.direction = cross(curve.chart.along_u, curve.chart.along_v);
      return parts_like(named, [&curve, line, circle](const LiftedArc& arc) {
        return sign_inside(line, curve, arc) * sign_inside(circle, curve, arc);
      });
    }
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
  if (g.total_degree() == 1) return is_flat ? one_curve(line_in_plane(curve.chart, g)) : above_line(curve, g);
  if (is_flat && g.total_degree() == 4) return conjugate_circles(curve, g);
  if (g.total_degree() != 2) return std::nullopt;
  const Conic conic(g);
  if (conic.is_degenerate()) return above_conjugate_lines(curve, factor);
  const bool in_symmetry_plane = is_flat || remainder(y2, g).empty();
  if (in_symmetry_plane) return one_curve(conic_in_plane(curve.chart, conic, {0, 0, 0}));
  if (factor.in_common > 0) return std::nullopt;
  const auto plane = plane_through(curve, g);
  if (!plane) return std::nullopt;
  return one_curve(conic_in_plane(curve.chart, conic, *plane));
}

}  // namespace exsect

#include "lift/plane_conic.h"

#include <exsect/algebra/rational_matrix.h>

#include <map>
#include <utility>
#include <vector>

namespace exsect {
namespace {

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

Point point_above(const SurfaceChart& chart, const std::array<Rational, 2>& p, const PlaneAbove& plane) {
  const Rational y = plane[0] * p[0] + plane[1] * p[1] + plane[2];
  return chart.origin + p[0] * chart.along_u + p[1] * chart.along_v + y * chart.along_y;
}

/// Scalar products of two directions with themselves and each other.
struct Gram {
  Rational uu, uv, vv;
};

/// The kind of the conic with the equation g in coordinates along such directions, and a circle's radius.
SpaceCurve shaped(const PlaneConic& g, const Gram& along) {
  SpaceCurve conic{0, g.kind(), {}, false, 1};
  if (g.discriminant() < 0 && g.a * along.vv == g.c * along.uu && g.b * along.uu == 2 * g.a * along.uv) {
    const auto [u, v] = g.centre();
    conic.kind = SpaceCurveKind::circle;
    conic.radius_squared = -(g.d * u / 2 + g.e * v / 2 + g.f) / g.a * along.uu;
  }
  return conic;
}

}  // namespace

PlaneConic::PlaneConic(const BivariatePolynomial& g)
    : a(g.coefficient(2, 0)),
      b(g.coefficient(1, 1)),
      c(g.coefficient(0, 2)),
      d(g.coefficient(1, 0)),
      e(g.coefficient(0, 1)),
      f(g.coefficient(0, 0)) {}

std::array<Rational, 2> PlaneConic::centre() const {
  return {(2 * c * d - b * e) / discriminant(), (2 * a * e - b * d) / discriminant()};
}

SpaceCurveKind PlaneConic::kind() const {
  const int s = sign(discriminant());
  return s < 0 ? SpaceCurveKind::ellipse : s == 0 ? SpaceCurveKind::parabola : SpaceCurveKind::hyperbola;
}

ConjugateLines conjugate_lines(const BivariatePolynomial& conic) {
  const bool swapped = conic.coefficient(2, 0) == 0;
  const PlaneConic g(swapped ? conic.exchanged() : conic);
  // 4 a g = x^2 - (delta z^2 or its constant)
  const Rational delta = g.discriminant();
  const auto number = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
  ConjugateLines lines = {number(2 * g.a) * r + number(g.b) * s + number(g.d),
                          delta == 0 ? number(1) : s + number((g.b * g.d - 2 * g.a * g.e) / delta), delta};
  if (swapped) lines = {lines.x.exchanged(), lines.z.exchanged(), delta};
  return lines;
}

bool vanishes_on(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  return remainder(f, g).empty();
}

std::vector<std::vector<Integer>> relations_on(const std::vector<std::vector<BivariatePolynomial>>& columns,
                                               const BivariatePolynomial& g) {
  std::map<std::pair<std::size_t, std::pair<int, int>>, std::vector<Rational>> rows;  // by component
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t i = 0; i < columns[k].size(); ++i)
      for (const auto& [monomial, c] : remainder(columns[k][i], g)) {
        std::vector<Rational>& row = rows[{i, monomial}];
        row.resize(columns.size());
        row[k] = c;
      }
  RationalMatrix matrix(rows.size(), columns.size());
  std::size_t i = 0;
  for (const auto& [place, row] : rows) {
    for (std::size_t k = 0; k < columns.size(); ++k) matrix(i, k) = row[k];
    ++i;
  }
  return null_space(matrix);
}

std::optional<PlaneAbove> plane_through(const SheetFunction& f, const BivariatePolynomial& g) {
  const std::vector<std::vector<BivariatePolynomial>> columns = {
      {f.a}, {BivariatePolynomial::r() * f.b}, {BivariatePolynomial::s() * f.b}, {f.b}};
  for (const std::vector<Integer>& v : relations_on(columns, g))
    if (v[0] != 0) {
      const Rational first(v[0]);
      return PlaneAbove{Rational(v[1]) / first, Rational(v[2]) / first, Rational(v[3]) / first};
    }
  return std::nullopt;
}

SpaceCurve conic_in_plane(const SurfaceChart& chart, const PlaneConic& g, const PlaneAbove& plane) {
  const Point along_u = chart.along_u + plane[0] * chart.along_y,
              along_v = chart.along_v + plane[1] * chart.along_y;
  SpaceCurve conic = shaped(g, {dot(along_u, along_u), dot(along_u, along_v), dot(along_v, along_v)});
  conic.direction = cross(along_u, along_v);
  if (g.discriminant() != 0) conic.point = point_above(chart, g.centre(), plane);
  return conic;
}

SpaceCurve mirrored_conic(const SurfaceChart& chart, const PlaneConic& g, const BivariatePolynomial& line,
                          const Rational& square) {
  const Rational a = line.coefficient(1, 0), b = line.coefficient(0, 1),
                 yy = dot(chart.along_y, chart.along_y) / square;
  return shaped(g, {dot(chart.along_u, chart.along_u) + a * a * yy, a * b * yy,
                    dot(chart.along_v, chart.along_v) + b * b * yy});
}

SpaceCurve line_in_plane(const SurfaceChart& chart, const BivariatePolynomial& g, const PlaneAbove& plane) {
  const Rational gu = g.coefficient(1, 0), gv = g.coefficient(0, 1), g0 = g.coefficient(0, 0);
  SpaceCurve line{0, SpaceCurveKind::line, {}, false, 1};
  line.direction = gv * chart.along_u - gu * chart.along_v + (plane[0] * gv - plane[1] * gu) * chart.along_y;
  line.point = gu != 0 ? point_above(chart, {-g0 / gu, 0}, plane) : point_above(chart, {0, -g0 / gv}, plane);
  return line;
}

}  // namespace exsect

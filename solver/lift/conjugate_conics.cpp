#include "lift/conjugate_conics.h"

#include <exsect/algebra/bivariate_factors.h>
#include <exsect/algebra/quadratic_sign.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace exsect {
namespace {

using Bivariate = BivariatePolynomial;

Bivariate number(const Rational& q) { return Bivariate::constant(q); }
/// A polynomial in r.
Bivariate in_r(const Polynomial& f) { return (number(1) * f).exchanged(); }

/// The monic polynomial with f = c root^2 for a number c; empty if there is none.
std::optional<Polynomial> even_root(const Polynomial& f) {
  Polynomial root = 1;
  for (const PolynomialPower& power : squarefree_factors(f)) {
    if (power.multiplicity % 2 != 0) return std::nullopt;
    for (int i = 0; i < power.multiplicity; i += 2)
      root *= power.factor * Polynomial(1 / power.factor.leading_coefficient());
  }
  return root;
}

/// With n = s^2 + b s + c, where x = delta b1^2, y = delta b1 c1 and z = delta c1^2 for m = b1 s + c1.
std::optional<ConjugateConics> pair_with(Bivariate n, const Polynomial& x, const Polynomial& y,
                                         const Polynomial& z) {
  const Polynomial& square = x.is_zero() ? z : x;
  const std::optional<Polynomial> root = even_root(square);
  if (!root || square.is_zero()) return std::nullopt;
  const Rational delta = square.leading_coefficient();
  Bivariate m = in_r(*root);
  if (!x.is_zero()) {
    const Division rest = divide(y, Polynomial(delta) * *root);
    if (!rest.remainder.is_zero()) return std::nullopt;
    m = m * Bivariate::s() + in_r(rest.quotient);
  }
  if (delta <= 0 || n.total_degree() > 2 || m.total_degree() > 2) return std::nullopt;
  return ConjugateConics{std::move(n), std::move(m), delta};
}

/// A number p(0) + p(1) w of the field with w^2 = delta.
using FieldNumber = Polynomial;

class QuadraticField {
 public:
  explicit QuadraticField(const Rational& delta) : delta_(delta) {}

  int sign(const FieldNumber& p) const {
    const FieldNumber q = reduced(p);
    return quadratic_sign(q.coefficient(0), q.coefficient(1), delta_);
  }
  bool is_rational(const FieldNumber& p) const { return reduced(p).degree() < 1; }

 private:
  FieldNumber reduced(const FieldNumber& p) const { return divide(p, Polynomial{-delta_, 0, 1}).remainder; }
  Rational delta_;
};

/// y = alpha u + beta v + gamma on the points with a + b y = 0 above n = w m: a + (alpha u + beta v + gamma)
/// b is a multiple of n - w m, so times n + w m one of the quartic.
std::optional<std::array<FieldNumber, 3>> plane_above(const ConjugateConics& pair, const SheetFunction& f) {
  const auto& [n, m, delta] = pair;
  const auto times = [&](const Bivariate& g) { return std::vector<Bivariate>{g * n, g * m}; };
  std::vector<std::vector<Bivariate>> columns = {times(f.a)};
  for (const Bivariate& coordinate : {Bivariate::r(), Bivariate::s(), number(1)}) {
    columns.push_back(times(coordinate * f.b));
    columns.push_back({number(delta) * columns.back()[1], columns.back()[0]});  // times w
  }
  for (const std::vector<Integer>& c : relations_on(columns, n * n - number(delta) * m * m)) {
    if (c[0] == 0) continue;
    const auto part = [&](std::size_t i) {
      return FieldNumber{Rational(c[i]) / Rational(c[0]), Rational(c[i + 1]) / Rational(c[0])};
    };
    return std::array{part(1), part(3), part(5)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<ConjugateConics> conjugate_conics(const BivariatePolynomial& quartic) {
  const Rational leading = quartic.coefficient(0, 4);
  if (quartic.total_degree() != 4 || leading == 0) return std::nullopt;
  const Bivariate by_s = (number(1 / leading) * quartic).exchanged();
  const Polynomial half = Polynomial(Rational(1, 2));
  const Polynomial b = half * by_s.coefficient(3), p2 = by_s.coefficient(2), p1 = half * by_s.coefficient(1),
                   p0 = by_s.coefficient(0);
  // (17.6a) with c in the place of s
  const Bivariate c = Bivariate::s();
  const auto x = [&](const Bivariate& at) { return in_r(b * b - p2) + number(2) * at; };
  const auto y = [&](const Bivariate& at) { return in_r(b) * at - in_r(p1); };
  const auto z = [&](const Bivariate& at) { return at * at - in_r(p0); };
  for (const BivariatePower& power : irreducible_factors(x(c) * z(c) - y(c) * y(c))) {
    const Bivariate factor = power.factor.exchanged();
    if (factor.degree_r() != 1 || factor.coefficient(1).degree() != 0) continue;
    const Polynomial at = factor.coefficient(0) * Polynomial(-1 / factor.coefficient(1, 0));
    const auto value = [&](const Bivariate& of) { return of.exchanged().coefficient(0); };
    const Bivariate in = in_r(at);
    if (auto pair = pair_with(c * c + in_r(b) * c + in, value(x(in)), value(y(in)), value(z(in))))
      return pair;
  }
  return std::nullopt;
}

std::optional<SpaceCurve> conic_above(const SurfaceChart& chart, const ConjugateConics& pair, int side,
                                      const SheetFunction& f) {
  const auto plane = plane_above(pair, f);
  if (!plane) return std::nullopt;
  const QuadraticField field(pair.delta);
  const auto of_side = [&](const FieldNumber& p) { return p.compose(Polynomial{0, side}); };
  const auto coefficient = [&](int i, int j) {
    return of_side(FieldNumber{pair.n.coefficient(i, j), -pair.m.coefficient(i, j)});
  };
  const FieldNumber a = coefficient(2, 0), b = coefficient(1, 1), c = coefficient(0, 2),
                    d = coefficient(1, 0), e = coefficient(0, 1), g = coefficient(0, 0),
                    four = FieldNumber(4);
  const FieldNumber discriminant = b * b - four * a * c;
  if (field.sign(four * a * c * g + b * e * d - a * e * e - c * d * d - g * b * b) == 0) return std::nullopt;
  const int bend = field.sign(discriminant);
  SpaceCurve conic{0,
                   bend < 0    ? SpaceCurveKind::ellipse
                   : bend == 0 ? SpaceCurveKind::parabola
                               : SpaceCurveKind::hyperbola,
                   {},
                   false,
                   1};
  const FieldNumber alpha = of_side((*plane)[0]), beta = of_side((*plane)[1]);
  const auto product = [&](const Point& p, const FieldNumber& k, const Point& q, const FieldNumber& l) {
    const Point& up = chart.along_y;
    return FieldNumber(dot(p, q)) + k * FieldNumber(dot(up, q)) + l * FieldNumber(dot(p, up)) +
           k * l * FieldNumber(dot(up, up));
  };
  const FieldNumber uu = product(chart.along_u, alpha, chart.along_u, alpha),
                    uv = product(chart.along_u, alpha, chart.along_v, beta),
                    vv = product(chart.along_v, beta, chart.along_v, beta);
  if (bend < 0 && field.sign(a * vv - c * uu) == 0 && field.sign(b * uu - FieldNumber(2) * a * uv) == 0)
    conic.kind = SpaceCurveKind::circle;
  if (field.is_rational(alpha) && field.is_rational(beta))
    conic.direction = cross(chart.along_u + alpha.coefficient(0) * chart.along_y,
                            chart.along_v + beta.coefficient(0) * chart.along_y);
  return conic;
}

}  // namespace exsect

#include "shape/special_cusps.h"

#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <utility>

namespace exsect {
namespace {

using PolynomialVector = std::array<Polynomial, 3>;

Polynomial common_divisor(const PolynomialVector& f) { return gcd(gcd(f[0], f[1]), f[2]); }

/// The coefficient of u^i as a polynomial in v.
PolynomialVector coefficient_of_u(const ControlNet& power, std::size_t i) {
  PolynomialVector result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = Polynomial(std::vector<Rational>{power[i][0][k], power[i][1][k], power[i][2][k]});
  return result;
}

/// Zero at the v of the cuspidal points on the line u = value.
Polynomial cuspidal_on(const BezierPatch& x, const Rational& value) {
  const ControlNet power = x.restricted_to(value, value + 1, 0, 1).power_basis();
  const PolynomialVector along = coefficient_of_u(power, 0);
  const PolynomialVector x_v = {along[0].derivative(), along[1].derivative(), along[2].derivative()};
  return common_divisor(cross_over(coefficient_of_u(power, 1), x_v));
}

std::optional<int> end_of(const BivariatePolynomial& f, const TriangularPoint& at) {
  for (const int value : {0, 1})
    if (sign_at(f - BivariatePolynomial::constant(value), at) == 0) return value;
  return std::nullopt;
}

}  // namespace

std::vector<FoldedLine> folded_lines(const BezierPatch& x) {
  const ControlNet power = x.power_basis();
  const PolynomialVector c1 = coefficient_of_u(power, 1);
  const PolynomialVector c2 = coefficient_of_u(power, 2);
  const Polynomial straight = common_divisor(cross_over(c1, c2));
  std::vector<FoldedLine> result;
  if (straight.is_zero()) return result;
  for (const RealAlgebraic& v : real_roots(straight, 0, 1)) {
    const auto k = std::ranges::find_if(c2, [&](const Polynomial& f) { return sign_at(f, v) != 0; });
    if (k == c2.end()) continue;
    // c1 is parallel to c2 at v, so that one coordinate of x_u = c1 + 2 u c2 decides.
    const BivariatePolynomial turn({c1[static_cast<std::size_t>(k - c2.begin())], Polynomial(2) * *k});
    for (const TriangularPoint& at : roots_at(turn, v, 0, 1))
      result.push_back({at, {end_of(BivariatePolynomial::r(), at), end_of(BivariatePolynomial::s(), at)}});
  }
  return result;
}

bool has_folded_line(const BezierPatch& x) {
  const ControlNet power = x.power_basis();
  const PolynomialVector c2 = coefficient_of_u(power, 2);
  if (common_divisor(cross_over(coefficient_of_u(power, 1), c2)).is_zero())
    return !common_divisor(c2).is_zero();
  return std::ranges::any_of(folded_lines(x), [](const FoldedLine& line) { return !line.side[0]; });
}

std::vector<RealAlgebraic> collapsed_lines(const BezierPatch& x) {
  const ControlNet power = x.power_basis();
  return real_roots(
      gcd(common_divisor(coefficient_of_u(power, 1)), common_divisor(coefficient_of_u(power, 2))), 0, 1);
}

std::optional<std::array<Rational, 2>> rational_turn(const FoldedLine& line) {
  if (!line.turn.s().is_rational()) return std::nullopt;
  const Rational& v = line.turn.s().rational();
  const Polynomial linear = line.turn.g().at_s(v);  // x_u
  return std::array<Rational, 2>{-linear.coefficient(0) / linear.coefficient(1), v};
}

std::vector<SideCusp> side_cusps(const BezierPatch& x) {
  std::vector<SideCusp> result;
  for (const int side : {0, 1}) {
    const Polynomial cuspidal = cuspidal_on(x, side);
    if (cuspidal.is_zero()) continue;
    for (const RealAlgebraic& v : real_roots(cuspidal, 0, 1)) result.push_back({side, v});
  }
  return result;
}

std::optional<std::size_t> cuspidal_points_on(const BezierPatch& x, const Rational& value,
                                              const RationalInterval& range) {
  const Polynomial cuspidal = cuspidal_on(x, value);
  if (cuspidal.is_zero()) return std::nullopt;
  return real_roots(cuspidal, range.lower, range.upper).size();
}

SpecialCusps special_cusps(const BezierPatch& x) {
  const BezierPatch exchanged = x.exchanged();
  return {{folded_lines(x), folded_lines(exchanged)}, {side_cusps(x), side_cusps(exchanged)}};
}

}  // namespace exsect

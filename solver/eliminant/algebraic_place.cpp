#include "eliminant/algebraic_place.h"

#include <exsect/algebra/integer_relation.h>
#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <vector>

#include "curve/plane_curve.h"
#include "eliminant/critical_values.h"

namespace exsect {

namespace {

constexpr int kBits = bits_of_places - 20;  // to which parameters are known, whatever their last digits
constexpr int kHighestDegree = 8;
constexpr int kBitsOfInterval = 120;
const Rational kWidth = power_of_two(-bits_of_places);  // of the enclosures of parameters

std::vector<Rational> powers(const Rational& a, int degree) {
  std::vector<Rational> result = {1};
  for (int i = 0; i < degree; ++i) result.push_back(result.back() * a);
  return result;
}

/// The real number near the middle of the range that is a root of a short polynomial, if one is shorter than
/// those of any number of this precision would be.
std::optional<RealAlgebraic> short_number(const RationalInterval& range) {
  int bits = 0;
  while (bits < kBits && range.width() * power_of_two(bits) < 1) ++bits;
  for (int degree = 1; degree <= 4; ++degree) {
    const auto relation = integer_relation(powers(range.midpoint(), degree), bits);
    if (!relation) continue;
    const Polynomial f(std::vector<Rational>(relation->begin(), relation->end()));
    const std::vector<RealAlgebraic> roots = real_roots(f, range.lower, range.upper);
    if (roots.size() == 1) return roots[0];
  }
  return std::nullopt;
}

/// The parameter, if it is exact, the only turning value in its interval, or a short number.
std::optional<RealAlgebraic> parameter_in(const BezierPatch& x, const BezierPatch& y, Parameter p,
                                          const RationalInterval& range) {
  if (range.lower == range.upper) return range.lower;
  std::vector<RealAlgebraic> inside;
  if (const auto turning = turning_values(x, y, p))
    for (const TurningValue& turn : turning->values)
      if (turn.value.compare(range.lower) >= 0 && turn.value.compare(range.upper) <= 0)
        inside.push_back(turn.value);
  return inside.size() == 1 ? inside[0] : short_number(range);
}

/// x(u,v) = y(r,s) modulo the polynomial.
bool is_solution(const BezierPatch& x, const BezierPatch& y, const AlgebraicPlace& place) {
  const auto times = [&](const Polynomial& a, const Polynomial& b) {
    return divide(a * b, place.modulus).remainder;
  };
  const std::array<ControlNet, 2> power = {x.power_basis(), y.power_basis()};
  for (std::size_t d = 0; d < 3; ++d) {
    Polynomial sum;
    for (std::size_t n = 0; n < 2; ++n) {
      const Polynomial& first = place.at[2 * n];
      const Polynomial& second = place.at[2 * n + 1];
      Polynomial value;  // by Horner's rule
      for (std::size_t i = 3; i-- > 0;) {
        Polynomial row;
        for (std::size_t j = 3; j-- > 0;) row = times(row, second) + power[n][i][j][d];
        value = times(value, first) + row;
      }
      sum = n == 0 ? value : sum - value;
    }
    if (!divide(sum, place.modulus).remainder.is_zero()) return false;
  }
  return true;
}

/// The polynomial of these coefficients, divided by -`by`.
Polynomial quotient(const std::vector<Integer>& coefficients, std::size_t count, const Integer& by) {
  std::vector<Rational> c;
  for (std::size_t i = 0; i < count; ++i) c.push_back(-Rational(coefficients[i]) / by);
  return Polynomial(c);
}

/// The parameters near these numbers as polynomials in a, near the number given.
std::optional<AlgebraicPlace> place_over(const Rational& a, const std::array<Rational, 4>& near) {
  std::optional<std::vector<Integer>> minimal;
  int degree = 0;
  while (!minimal && degree < kHighestDegree) minimal = integer_relation(powers(a, ++degree), kBits);
  if (!minimal || minimal->back() == 0) return std::nullopt;
  AlgebraicPlace place;
  place.modulus = -quotient(*minimal, minimal->size(), minimal->back());
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<Rational> values = powers(a, degree - 1);
    values.push_back(near[i]);
    const auto relation = integer_relation(values, kBits);
    if (!relation || relation->back() == 0) return std::nullopt;
    place.at[i] = quotient(*relation, relation->size() - 1, relation->back());
  }
  const Rational scaled = a * power_of_two(kBitsOfInterval);
  const Rational below(Integer(numerator(scaled) / denominator(scaled)));
  place.between = {(below - 1) * power_of_two(-kBitsOfInterval),
                   (below + 2) * power_of_two(-kBitsOfInterval)};
  return place;
}

/// A place with these parameters, each known to 2^-bits_of_places, that is a solution.
std::optional<AlgebraicPlace> place_near(const std::array<Rational, 4>& near,
                                         const std::function<bool(const AlgebraicPlace&)>& is_solution) {
  std::vector<std::array<int, 4>> generators;
  for (std::size_t i = 0; i < 4; ++i) generators.emplace_back()[i] = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::array<int, 4>& sum = generators.emplace_back();
      sum[i] = sum[j] = 1;
    }
  }
  generators.push_back({1, 2, 3, 5});
  for (const auto& [a, b, c, d] : generators) {
    const auto place = place_over(a * near[0] + b * near[1] + c * near[2] + d * near[3], near);
    if (place && is_solution(*place)) return place;
  }
  return std::nullopt;
}

/// The curve, every irreducible factor once, vanishes at the place with its derivatives.
bool is_singular(const std::vector<BivariatePolynomial>& curve, const AlgebraicPlace& place) {
  return std::all_of(curve.begin(), curve.end(), [&](const BivariatePolynomial& f) {
    Polynomial value;  // by Horner's rule
    for (int i = f.degree_r(); i >= 0; --i) {
      Polynomial row;
      for (int j = f.degree_s(); j >= 0; --j)
        row = divide(row * place.at[1], place.modulus).remainder + f.coefficient(i, j);
      value = divide(value * place.at[0] + row, place.modulus).remainder;
    }
    return divide(value, place.modulus).remainder.is_zero();
  });
}

}  // namespace

std::optional<AlgebraicPlace> algebraic_place(const BezierPatch& x, const BezierPatch& y,
                                              const ParameterBox& box) {
  return in_nearest_rounding([&]() -> std::optional<AlgebraicPlace> {
    std::array<Rational, 4> near;
    for (const Parameter p : all_parameters) {
      const auto value = parameter_in(x, y, p, box[index(p)]);
      if (!value) return std::nullopt;
      near[index(p)] = value->refined_to(kWidth).interval().lower;
    }
    return place_near(near, [&](const AlgebraicPlace& place) { return is_solution(x, y, place); });
  });
}

std::optional<AlgebraicPlace> algebraic_place(const std::array<Rational, 4>& near,
                                              const std::function<bool(const AlgebraicPlace&)>& is_solution) {
  return in_nearest_rounding([&] { return place_near(near, is_solution); });
}

std::optional<AlgebraicPlace> algebraic_place(const BivariatePolynomial& f, const ParameterBox& box) {
  if (f.is_zero() || box[2].width() > 0 || box[3].width() > 0) return std::nullopt;
  return in_nearest_rounding([&]() -> std::optional<AlgebraicPlace> {
    const BivariatePolynomial g = squarefree(f);
    const std::vector<BivariatePolynomial> curve = {g, g.derivative_r(), g.derivative_s()};
    for (const TriangularPoint& point : common_zeros(curve).points) {
      const TriangularPoint at = point.refined_to(kWidth);
      const std::array<Rational, 4> near = {at.r_interval().lower, at.s().interval().lower, box[2].lower,
                                            box[3].lower};
      const auto is_near = [&](std::size_t i) {
        return box[i].lower <= near[i] + kWidth && near[i] <= box[i].upper;
      };
      if (is_near(0) && is_near(1))
        return place_near(near, [&](const AlgebraicPlace& place) { return is_singular(curve, place); });
    }
    return std::nullopt;
  });
}

}  // namespace exsect

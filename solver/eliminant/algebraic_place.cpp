#include "eliminant/algebraic_place.h"

#include <exsect/algebra/integer_relation.h>
#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <vector>

#include "eliminant/critical_values.h"

namespace exsect {

namespace {

constexpr int kBits = 1200;  // to which parameters are known
constexpr int kHighestDegree = 8;
constexpr int kBitsOfInterval = 120;

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

}  // namespace

std::optional<AlgebraicPlace> algebraic_place(const BezierPatch& x, const BezierPatch& y,
                                              const ParameterBox& box) {
  return in_nearest_rounding([&]() -> std::optional<AlgebraicPlace> {
    std::array<Rational, 4> near;
    for (const Parameter p : all_parameters) {
      const auto value = parameter_in(x, y, p, box[index(p)]);
      if (!value) return std::nullopt;
      near[index(p)] = value->refined_to(power_of_two(-kBits - 20)).interval().lower;
    }
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
      if (place && is_solution(x, y, *place)) return place;
    }
    return std::nullopt;
  });
}

}  // namespace exsect

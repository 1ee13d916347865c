#include "self/known_pinches.h"

#include <exsect/algebra/bernstein.h>

#include <cmath>
#include <optional>
#include <utility>

namespace exsect {
namespace {

using HomogeneousCurve4 = std::array<Polynomial, 4>;

/// With these control vectors.
HomogeneousCurve4 curve_of(const std::vector<HomogeneousPoint>& row) {
  HomogeneousCurve4 curve;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Rational> coefficients;
    for (const HomogeneousPoint& p : row) coefficients.push_back(p[k]);
    curve[k] = from_bernstein(coefficients);
  }
  return curve;
}

/// The 2 by 2 minors are all 0 where this is.
Polynomial dependent(const HomogeneousCurve4& a, const HomogeneousCurve4& b) {
  Polynomial common;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) common = gcd(common, a[i] * b[j] - a[j] * b[i]);
  return common;
}

/// The same for three vectors.
Polynomial dependent(const HomogeneousCurve4& a, const HomogeneousCurve4& b, const HomogeneousCurve4& c) {
  Polynomial common;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const std::size_t i = left_out == 0 ? 1 : 0, j = left_out <= 1 ? 2 : 1, k = left_out == 3 ? 2 : 3;
    common = gcd(common, a[i] * (b[j] * c[k] - b[k] * c[j]) + a[j] * (b[k] * c[i] - b[i] * c[k]) +
                             a[k] * (b[i] * c[j] - b[j] * c[i]));
  }
  return common;
}

/// All of them on the line; x_u and x_v are dependent where X, X_u and X_v are.
std::vector<KnownPinch> pinches_on(const RationalPatch& patch, std::size_t fixed, const Rational& value) {
  const RationalPatch turned = fixed == 0 ? patch : patch.transposed();
  const RationalPatch piece = turned.restricted_to(value, value == 1 ? 0 : 1, 0, 1);
  std::vector<HomogeneousPoint> line, next;
  for (int j = 0; j <= piece.degree_v(); ++j) {
    line.push_back(piece.homogeneous(0, j));
    next.push_back(piece.homogeneous(1, j));
  }
  const HomogeneousCurve4 x = curve_of(line), y = curve_of(next);
  HomogeneousCurve4 along;
  for (std::size_t k = 0; k < 4; ++k) along[k] = x[k].derivative();
  HomogeneousCurve4 bend;
  for (std::size_t k = 0; k < 4; ++k) bend[k] = along[k].derivative();
  const bool is_straight = dependent(x, along, bend).is_zero();  // (14.73a)
  const Polynomial common = dependent(x, y, along);
  if (common.is_zero()) return {};
  std::array<Polynomial, 2> resting;  // X is parallel to its derivative
  resting[fixed] = dependent(x, y);
  resting[1 - fixed] = dependent(x, along);
  std::vector<KnownPinch> found;
  for (const RealAlgebraic& at : real_roots(common, 0, 1))
    found.push_back(
        {fixed, value, at, {sign_at(resting[0], at) == 0, sign_at(resting[1], at) == 0}, is_straight});
  return found;
}

constexpr double kNear = 0x1p-30;
constexpr int kGreatestDenominator = 1024;

/// The simple number that t may stand for, inside of [0,1].
std::optional<Rational> simple_value(double t) {
  const Rational value = simplest_between(from_double(t - kNear), from_double(t + kNear));
  if (value <= 0 || value >= 1 || denominator(value) > kGreatestDenominator) return std::nullopt;
  return value;
}

}  // namespace

std::vector<KnownPinch> known_pinches(const RationalPatch& patch,
                                      const std::vector<std::array<double, 2>>& places) {
  std::vector<KnownPinch> found;
  for (const std::size_t fixed : {0U, 1U}) {
    for (const int value : {0, 1})
      for (KnownPinch& pinch : pinches_on(patch, fixed, value)) found.push_back(std::move(pinch));
    for (const std::array<double, 2>& place : places)
      if (const auto value = simple_value(place[fixed]))
        for (KnownPinch& pinch : pinches_on(patch, fixed, *value))
          if (pinch.rests[0] || pinch.rests[1]) found.push_back(std::move(pinch));
  }
  return found;
}

bool contains(const ParameterRectangle& where, const KnownPinch& pinch) {
  const RationalInterval& across = pinch.fixed == 0 ? where.u : where.v;
  const RationalInterval& along = pinch.fixed == 0 ? where.v : where.u;
  return across.lower <= pinch.value && across.upper >= pinch.value && pinch.at.compare(along.lower) >= 0 &&
         pinch.at.compare(along.upper) <= 0;
}

}  // namespace exsect

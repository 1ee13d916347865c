#include "curve/positivity.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/bernstein_box.h>

#include <algorithm>

namespace exsect {
namespace {

std::optional<RationalInterval> not_positive(const std::vector<Rational>& bernstein,
                                             const RationalInterval& t, int depth) {
  if (std::all_of(bernstein.begin(), bernstein.end(), [](const Rational& b) { return b > 0; }))
    return std::nullopt;
  if (depth == 0 || bernstein.front() <= 0 || bernstein.back() <= 0) return t;
  const BernsteinHalves halves = split_bernstein(bernstein, Rational(1, 2));
  if (auto left = not_positive(halves.left, {t.lower, t.midpoint()}, depth - 1)) return left;
  return not_positive(halves.right, {t.midpoint(), t.upper}, depth - 1);
}

/// s is divided at every third level.
std::optional<RationalInterval> not_positive(const BernsteinBox& f, const RationalInterval& t, int depth) {
  const int sign = f.sign();
  if (sign > 0) return std::nullopt;
  if (sign < 0 || depth == 0) return t;
  if (depth % 3 == 0) {
    const auto [below, above] = f.split_r();
    if (auto part = not_positive(below, t, depth - 1)) return part;
    return not_positive(above, t, depth - 1);
  }
  const auto [left, right] = f.split_s();
  if (auto part = not_positive(left, {t.lower, t.midpoint()}, depth - 1)) return part;
  return not_positive(right, {t.midpoint(), t.upper}, depth - 1);
}

}  // namespace

std::optional<RationalInterval> not_positive(const Polynomial& f, const RationalInterval& t) {
  return not_positive(bernstein_coefficients(f, std::max(f.degree(), 0), t.lower, t.upper), t, 16);
}

std::optional<RationalInterval> not_positive(const BivariatePolynomial& f, const Rational& d,
                                             const RationalInterval& t) {
  return not_positive(BernsteinBox(f, {-d, d}, t), t, 11);
}

Rational positive_lower_bound(const Polynomial& f, const RationalInterval& t) {
  const std::vector<Rational> b = bernstein_coefficients(f, std::max(f.degree(), 0), t.lower, t.upper);
  const Rational least = *std::min_element(b.begin(), b.end());
  if (least > 0) return least;
  return std::min(positive_lower_bound(f, {t.lower, t.midpoint()}),
                  positive_lower_bound(f, {t.midpoint(), t.upper}));
}

}  // namespace exsect

#include "lift/root_interval.h"

#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <utility>

namespace exsect {
namespace {

/// An integer n with |q| <= 2^n < 4 |q|; requires q != 0.
long exponent_above(const Rational& q) {
  return static_cast<long>(msb(abs(numerator(q)))) + 1 - static_cast<long>(msb(denominator(q)));
}

/// The least and the greatest real root of each polynomial that has one.
std::vector<RealAlgebraic> extreme_roots(const std::vector<Polynomial>& polynomials) {
  std::vector<RealAlgebraic> extreme;
  for (const Polynomial& f : polynomials) {
    if (f.degree() < 1) continue;
    const Rational beyond = above_all_roots(f);
    const std::vector<RealAlgebraic> roots = real_roots(f, -beyond, beyond);
    if (roots.empty()) continue;
    extreme.push_back(roots.front());
    extreme.push_back(roots.back());
  }
  return extreme;
}

RationalInterval interval_beyond(const std::vector<RealAlgebraic>& roots, std::vector<Rational> others,
                                 const Rational& room) {
  for (const RealAlgebraic& root : roots) {
    const RationalInterval at = root.refined_to(room / 16).interval();
    others.push_back(at.lower);
    others.push_back(at.upper);
  }
  if (others.empty()) others = {0};
  const auto [least, most] = std::minmax_element(others.begin(), others.end());
  const Rational width = std::max<Rational>((*most - *least) / 2, room);
  return {simplest_between(*least - width, *least - width / 2),
          simplest_between(*most + width / 2, *most + width)};
}

}  // namespace

Rational above_all_roots(const Polynomial& f) {
  // |z| >= 2 m with m^k >= |a_(n-k) / a_n| for all k makes the other terms smaller than a_n z^n.
  const int n = f.degree();
  long greatest = 0;
  bool is_power = true;
  for (int k = 1; k <= n; ++k) {
    if (f.coefficient(n - k) == 0) continue;
    const long bits = exponent_above(f.coefficient(n - k) / f.leading_coefficient());
    const long root = bits > 0 ? (bits + k - 1) / k : -(-bits / k);
    greatest = is_power ? root : std::max(greatest, root);
    is_power = false;
  }
  return power_of_two(greatest + 1);
}

RationalInterval interval_around(const std::vector<Polynomial>& polynomials, std::vector<Rational> others,
                                 const Rational& room) {
  return interval_beyond(extreme_roots(polynomials), std::move(others), room);
}

RationalInterval fitted_interval(const std::vector<Polynomial>& polynomials) {
  const std::vector<RealAlgebraic> roots = extreme_roots(polynomials);
  const Rational least = power_of_two(-120);
  for (Rational room = 1; room > least; room /= 1024) {
    const RationalInterval interval = interval_beyond(roots, {}, room);
    if (interval.width() > 4 * room) return interval;
  }
  return interval_beyond(roots, {}, 1);
}

}  // namespace exsect

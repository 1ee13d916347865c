#include "shape/monotone_quadratic.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace exsect {

namespace {

Integer floor(const Rational& q) {
  Integer result;
  mpz_fdiv_q(result.backend().data(), numerator(q).backend().data(), denominator(q).backend().data());
  return result;
}

/// Exact for squares of rationals, else of the width 2^-bits.
RationalInterval enclosed_root(const Rational& q, long bits) {
  const Rational exact(sqrt(numerator(q)), sqrt(denominator(q)));
  if (exact * exact == q) return {exact, exact};
  const Rational unit = power_of_two(-bits);
  const Rational below = Rational(sqrt(floor(q / (unit * unit)))) * unit;
  return {below, below + unit};
}

RationalInterval on_grid(const RationalInterval& i, const Rational& unit) {
  return {floor(i.lower / unit) * unit, -floor(-i.upper / unit) * unit};
}

}  // namespace

MonotoneQuadratic::MonotoneQuadratic(const Rational& t) : t_(t), t_rounded_(to_double(t)) {
  if (t < 0 || t >= Rational(1, 2)) throw std::invalid_argument("no increasing quadratic map of [0,1]");
}

Rational MonotoneQuadratic::operator()(const Rational& r) const { return (2 * t_ + (1 - 2 * t_) * r) * r; }

double MonotoneQuadratic::inverse(double q) const {
  if (q <= 0) return 0;
  const double root = std::sqrt(t_rounded_ * t_rounded_ + (1 - 2 * t_rounded_) * q);
  return std::min(1.0, q / (t_rounded_ + root));
}

/// r = q / (t + sqrt(t² + (1 - 2t) q)).
RationalInterval MonotoneQuadratic::enclosed_inverse(const Rational& q, long bits) const {
  if (q == 0) return {0, 0};
  const RationalInterval root = enclosed_root(t_ * t_ + (1 - 2 * t_) * q, bits);
  if (root.width() == 0) return {q / (t_ + root.lower), q / (t_ + root.lower)};
  if (t_ + root.lower == 0) return {0, 1};
  return on_grid({q / (t_ + root.upper), q / (t_ + root.lower)}, power_of_two(-bits));
}

std::vector<RationalInterval> MonotoneQuadratic::inverse(
    const std::vector<RationalInterval>& intervals) const {
  std::map<Rational, RationalInterval> ends = {{0, {}}, {1, {}}};
  for (const RationalInterval& i : intervals) ends.insert({{i.lower, {}}, {i.upper, {}}});
  const auto overlaps = [](const auto& a, const auto& b) { return a.second.upper >= b.second.lower; };
  long bits = 64;
  do {
    bits *= 2;
    for (auto& [q, r] : ends) r = enclosed_inverse(q, bits);
  } while (std::adjacent_find(ends.begin(), ends.end(), overlaps) != ends.end());
  std::vector<RationalInterval> result;
  for (const RationalInterval& i : intervals) result.push_back({ends[i.lower].lower, ends[i.upper].upper});
  return result;
}

}  // namespace exsect

#include "special/unit_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace exsect {
namespace {

/// The sign of w(p) - value, for 0 <= value <= 1.
int compared(const UnitMap& map, const Rational& p, const Rational& value) {
  const Rational a = (1 - p) * (1 + map.start * p), b = p * (1 + map.end * (1 - p));
  return sign(Rational(b * (1 - value) - a * value));
}

/// The greatest multiple of 2^-bits with w <= value.
Rational greatest_below(const UnitMap& map, const Rational& value, int bits) {
  Rational at = 0, step = 1;
  if (compared(map, 1, value) <= 0) return 1;
  for (int i = 0; i < bits; ++i) {
    step /= 2;
    if (compared(map, at + step, value) <= 0) at += step;
  }
  return at;
}

}  // namespace

RationalInterval preimage(const UnitMap& map, const RationalInterval& values, int bits) {
  if (map.is_identity()) return values;
  return {greatest_below(map, values.lower, bits),
          std::min<Rational>(greatest_below(map, values.upper, bits) + power_of_two(-bits), 1)};
}

// The root p > 0 of k p^2 + h p = value for which the left side increases.
double approximate_preimage(const UnitMap& map, double value) {
  if (map.is_identity()) return value;
  const double start = to_double(map.start), end = to_double(map.end), rest = 1 - value;
  const double k = value * start - rest * end, h = rest * (1 + end) + value * (1 - start);
  const double root = std::sqrt(std::max(h * h + 4 * k * value, 0.0));
  const double p = h > 0 ? 2 * value / (h + root) : (root - h) / (2 * k);
  return p > 0 ? std::min(p, 1.0) : 0;
}

// a = 1 + (start - 1) p - start p^2 and b = (1 + end) p - end p^2; b(p) a(q) - a(p) b(q) is p - q times the
// polynomial (1 + end) - end (p + q) + k p q with k = (start - 1)(-end) + start (1 + end).
Conjugation conjugation(const UnitMap& map) {
  return {-(1 + map.end), map.end, -map.end, map.start + map.end};
}

VectorPolynomial at_conjugate(const Conjugation& other, const VectorPolynomial& y) {
  int m = 0;
  for (const BivariatePolynomial& f : y) m = std::max(m, f.degree_r());
  const auto linear = [](const Rational& c, const Rational& k) {
    return BivariatePolynomial::constant(c) + BivariatePolynomial::constant(k) * BivariatePolynomial::r();
  };
  const BivariatePolynomial over = linear(other[0], other[1]), under = linear(other[2], other[3]);
  VectorPolynomial result;
  std::vector<BivariatePolynomial> powers(1, BivariatePolynomial::constant(1));
  for (int i = 0; i < m; ++i) powers.push_back(powers.back() * under);
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (int i = 0; i <= m; ++i) {
    const BivariatePolynomial factor = power * powers[static_cast<std::size_t>(m - i)];
    for (std::size_t k = 0; k < y.size(); ++k) result[k] += factor * y[k].coefficient(i);
    power = power * over;
  }
  return result;
}

}  // namespace exsect

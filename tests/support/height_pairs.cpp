#include "support/height_pairs.h"

namespace exsect::height_pairs {
namespace {

using random_pairs::integer;

Rational sixteenths(Generator& generator, long largest) {
  return Rational(integer(generator, -largest, largest), 16);
}

Terms random_terms(Generator& generator, int degree) {
  Terms f;
  const auto most = static_cast<std::size_t>(degree);
  for (std::size_t i = 0; i <= most; ++i)
    for (std::size_t j = 0; i + j <= most; ++j) f[{i, j}] = sixteenths(generator, 3);
  return f;
}

Rational turn(Generator& generator) { return Rational(2 * integer(generator, -2, 1) + 1, 8); }

}  // namespace

Terms linear(const Rational& c, const Rational& a, const Rational& b) {
  return Terms{{{0, 0}, c}, {{1, 0}, a}, {{0, 1}, b}};
}
Terms times(const Rational& factor, const Terms& h) { return Terms{{{0, 0}, factor}} * h; }

Heights heights(const Terms& f, const Terms& h, int degree, const Rational& p, const Rational& q,
                const std::array<Rational, 2>& at) {
  const Rational half(1, 2);
  const Terms first = linear(half - half * p + half * q, p, -q);
  const Terms second = linear(half - half * p - half * q, q, p);
  Terms turned;
  for (const auto& [i, value] : f) {
    Terms product{{{0, 0}, value}};
    for (std::size_t k = 0; k < i.first; ++k) product = product * first;
    for (std::size_t k = 0; k < i.second; ++k) product = product * second;
    turned = turned + product;
  }
  const Terms a = linear(0, 1, 0);
  const Terms b = linear(0, 0, 1);
  const Rational da = at[0] - half;
  const Rational db = at[1] - half;
  const Rational size = p * p + q * q;
  return {testing::power_patch({a, b, f + h}, degree),
          testing::power_patch({first, second, turned}, degree),
          testing::power_patch({a, b, h}, degree),
          {at[0], at[1], half + (p * da + q * db) / size, half + (p * db - q * da) / size}};
}

Heights with_double_point(Generator& generator, int sign, int degree, const Rational& moved) {
  const Rational a = Rational(1, 2) + sixteenths(generator, 3);
  const Rational b = Rational(1, 2) + sixteenths(generator, 3);
  const Rational slope(2 * integer(generator, -4, 3) + 1, 16);
  const Terms first = linear(-a - slope * b, 1, slope);
  const Terms second = linear(-b + slope * a, -slope, 1);
  Terms h = first * first + times(Rational(sign * integer(generator, 4, 15), 16), second * second);
  if (degree == 3)
    h = h + times(sixteenths(generator, 6), first * first * first) +
        times(sixteenths(generator, 6), first * second * second);
  h[{0, 0}] += moved;
  const Terms f = random_terms(generator, degree);
  return heights(f, h, degree, Rational(3, 2), turn(generator), {a, b});
}

Heights with_two_double_points(Generator& generator, const Rational& factor) {
  const Terms product = linear(Rational(-1, 4), 1, 0) * linear(Rational(-3, 4), 0, 1);
  const Terms diagonal = linear(0, 1, -1);
  const Terms h = product * product + times(factor, diagonal * diagonal);
  const Rational quarter(1, 4);
  return heights(random_terms(generator, 2), h, 2, Rational(3, 2), turn(generator), {quarter, quarter});
}

}  // namespace exsect::height_pairs

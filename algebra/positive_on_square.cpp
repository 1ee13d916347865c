#include "positive_on_square.h"

#include <array>

#include "bernstein_box.h"
#include "real_algebraic.h"
#include "resultant.h"
#include "triangular_point.h"

namespace exsect {
namespace {

const RationalInterval unit = {0, 1};

RationalInterval narrow(const RealAlgebraic& t) {
  static const Rational width = power_of_two(-60);
  return t.is_rational() ? RationalInterval{t.rational(), t.rational()} : t.refined_to(width).interval();
}

/// The first zero of f on the segment from (0,0), where f > 0, to a point where f <= 0.
NotPositive zero_towards(const BivariatePolynomial& f, const Rational& r, const Rational& s) {
  if (f(r, s) == 0) return {{r, r}, {s, s}, 0};
  Polynomial on_segment;
  Polynomial power = 1;
  const Polynomial in_t{0, r};
  for (int i = 0; i <= f.degree_r(); ++i) {
    on_segment += power * f.coefficient(i).compose(Polynomial{0, s});
    power *= in_t;
  }
  const RationalInterval t = narrow(real_roots(on_segment, 0, 1).front());
  return {{t.lower * r, t.upper * r}, {t.lower * s, t.upper * s}, 0};
}

/// What the subdivision of a box has shown.
struct Subdivided {
  bool positive;                              // on the whole box
  std::optional<std::array<Rational, 2>> at;  // a corner of a part where f <= 0
};

Subdivided subdivided(const BivariatePolynomial& f, const BernsteinBox& part, const RationalInterval& r,
                      const RationalInterval& s, int depth) {
  if (part.sign() > 0) return {true, std::nullopt};
  for (const Rational& a : {r.lower, r.upper})
    for (const Rational& b : {s.lower, s.upper})
      if (f(a, b) <= 0) return {false, {{a, b}}};
  if (depth == 0) return {false, std::nullopt};
  const bool in_r = depth % 2 == 0;
  const auto [low, high] = in_r ? part.split_r() : part.split_s();
  const RationalInterval& divided = in_r ? r : s;
  const RationalInterval below = {divided.lower, divided.midpoint()},
                         above = {divided.midpoint(), divided.upper};
  const Subdivided first = subdivided(f, low, in_r ? below : r, in_r ? s : below, depth - 1);
  if (first.at) return first;
  const Subdivided second = subdivided(f, high, in_r ? above : r, in_r ? s : above, depth - 1);
  if (second.at) return second;
  return {first.positive && second.positive, std::nullopt};
}

std::optional<NotPositive> zero_on_sides(const BivariatePolynomial& f) {
  for (const Rational& side : {Rational(0), Rational(1)}) {
    const auto in_s = real_roots(f.at_r(side), 0, 1);
    if (!in_s.empty()) return NotPositive{{side, side}, narrow(in_s.front()), 0};
    const auto in_r = real_roots(f.at_s(side), 0, 1);
    if (!in_r.empty()) return NotPositive{narrow(in_r.front()), {side, side}, 0};
  }
  return std::nullopt;
}

/// A zero of f inside the square, f without zeros on its sides. A component of the curve of zeros is compact
/// then; where r is greatest on it, h = h_s = 0 for the squarefree part h.
std::optional<NotPositive> zero_inside(const BivariatePolynomial& f) {
  const BivariatePolynomial multiple = gcd(f, gcd(f.derivative_r(), f.derivative_s()));
  const BivariatePolynomial h = exact_quotient(f, multiple);
  if (h.degree_s() < 1) return std::nullopt;
  for (const RealAlgebraic& r : real_roots(resultant_s(h, h.derivative_s()), 0, 1)) {
    const auto in_s = roots_at(h.exchanged(), r, 0, 1);
    if (in_s.empty()) continue;
    static const Rational width = power_of_two(-60);
    return NotPositive{narrow(r), in_s.front().refined_to(width).r_interval(), 0};
  }
  return std::nullopt;
}

}  // namespace

std::optional<NotPositive> not_positive_on_square(const BivariatePolynomial& f) {
  const Rational at_origin = f(0, 0);
  if (at_origin <= 0) return NotPositive{{0, 0}, {0, 0}, sign(at_origin)};
  constexpr int depth = 12;
  const Subdivided found = subdivided(f, BernsteinBox(f, unit, unit), unit, unit, depth);
  if (found.positive) return std::nullopt;
  if (found.at) return zero_towards(f, (*found.at)[0], (*found.at)[1]);
  if (auto zero = zero_on_sides(f)) return zero;
  return zero_inside(f);
}

}  // namespace exsect

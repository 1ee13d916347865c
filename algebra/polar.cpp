#include "polar.h"

#include <algorithm>
#include <stdexcept>

#include "flint.h"

namespace exsect {
namespace {

constexpr long kRootBits = 128;

void enclose(FlintBall& ball, const RationalInterval& interval) {
  FlintBall upper;
  arb_set_fmpq(ball.value, FlintRational(interval.lower).value, kRootBits);
  arb_set_fmpq(upper.value, FlintRational(interval.upper).value, kRootBits);
  arb_union(ball.value, ball.value, upper.value, kRootBits);
}

RationalInterval interval_of(const FlintBall& ball) {
  arf_t lower, upper;
  arf_init(lower);
  arf_init(upper);
  arb_get_interval_arf(lower, upper, ball.value, kRootBits + 32);
  RationalInterval result = {to_rational(lower), to_rational(upper)};
  arf_clear(lower);
  arf_clear(upper);
  return result;
}

Rational end_of_root(const Rational& q, bool upper) {
  if (q <= 0) return 0;
  FlintBall ball;
  enclose(ball, {q, q});
  arb_sqrt(ball.value, ball.value, kRootBits);
  const RationalInterval root = interval_of(ball);
  return upper ? root.upper : std::max<Rational>(root.lower, 0);
}

bool holds_zero(const RationalInterval& q) { return q.lower <= 0 && q.upper >= 0; }

/// Of a box that does not meet the half line of x <= 0: in ]-1/2,1/2[ up to rounding.
RationalInterval turn_off_the_cut(const RationalInterval& x, const RationalInterval& y) {
  FlintBall a, b, turn;
  enclose(a, x);
  enclose(b, y);
  arb_atan2(turn.value, b.value, a.value, kRootBits);
  arb_const_pi(a.value, kRootBits);
  arb_div(turn.value, turn.value, a.value, kRootBits);
  arb_mul_2exp_si(turn.value, turn.value, -1);
  return interval_of(turn);
}

}  // namespace

RationalInterval root_of(const RationalInterval& q) {
  if (q.upper < 0) throw std::domain_error("root_of: the interval is negative");
  return {end_of_root(q.lower, false), end_of_root(q.upper, true)};
}

std::optional<RationalInterval> turn_of(const RationalInterval& x, const RationalInterval& y) {
  if (holds_zero(x) && holds_zero(y)) return std::nullopt;
  if (holds_zero(y) && x.lower > 0) return turn_off_the_cut(x, y);
  if (holds_zero(y)) {
    const RationalInterval turn = turn_off_the_cut({-x.upper, -x.lower}, {-y.upper, -y.lower});
    return RationalInterval{turn.lower + Rational(1, 2), turn.upper + Rational(1, 2)};
  }
  RationalInterval turn = turn_off_the_cut(x, y);
  if (y.upper < 0) turn = {turn.lower + 1, turn.upper + 1};
  return RationalInterval{std::max<Rational>(turn.lower, 0), std::min<Rational>(turn.upper, 1)};
}

}  // namespace exsect

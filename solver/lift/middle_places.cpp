#include "lift/middle_places.h"

#include <exsect/algebra/interruption.h>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_place.h"

namespace exsect {

const Rational& fine_width() {
  static const Rational width = power_of_two(-80);
  return width;
}

int DrawnArc::sign_below() const {
  return -sign_at(curve.below.swept.exchanged().derivative_r(), branch().inside);
}

std::optional<RationalInterval> DrawnArc::over(const Rational& u, const RationalInterval& range) const {
  const std::vector<RealAlgebraic> zeros = real_roots(curve.below.swept.at_r(u), range.lower, range.upper);
  if (zeros.size() == 1) return zeros[0].refined_to(fine_width()).interval();
  return arc_over(curve.below, lifted().below, u, fine_width());
}

std::optional<RationalInterval> MiddlePlaces<RationalInterval>::between(const RationalInterval& a,
                                                                        const RationalInterval& b,
                                                                        double share) const {
  const bool up = a.upper < b.lower;
  const Rational lower = up ? a.upper : b.upper, upper = up ? b.lower : a.lower;
  if (!(lower < upper)) throw ProofFailure(whole_domain(), "nodes of an arc in space are not apart");
  const Rational width = upper - lower, at = from_double(up ? share : 1 - share);
  const Rational room = at * (1 - at) * Rational(2, 3);
  const Rational middle = simplest_between(lower + (at - room) * width, lower + (at + room) * width);
  return RationalInterval{middle, middle};
}

std::optional<std::array<RationalInterval, 2>> MiddlePlaces<RationalInterval>::on_arc(
    const RationalInterval& u, const RationalInterval& range, const RationalInterval& end) const {
  for (Rational at = u.lower;; at = (at + end.lower) / 2) {
    interruption_point();
    if (const auto v = arc_.over(at, range)) return {{RationalInterval{at, at}, *v}};
  }
}

std::optional<DoubleBall> MiddlePlaces<DoubleBall>::between(const DoubleBall& a, const DoubleBall& b,
                                                            double share) const {
  const double from = a.approximation(), to = b.approximation(), at = from + (to - from) * share;
  const DoubleBall middle(at);
  const int side = (middle - a).certain_sign();
  if (side == 0 || (b - middle).certain_sign() != side) return std::nullopt;
  return middle;
}

std::optional<std::array<DoubleBall, 2>> MiddlePlaces<DoubleBall>::on_arc(const DoubleBall& u,
                                                                          const DoubleBall& range) const {
  if (const auto v = swept_.only_zero(u, range, below_)) return {{u, *v}};
  return nearest_on_arc(u, range);
}

std::optional<std::array<DoubleBall, 2>> MiddlePlaces<DoubleBall>::beside(const DoubleBall& v,
                                                                          const DoubleBall& range) const {
  const auto u = exchanged_.only_zero(v, range);
  if (!u) return std::nullopt;
  return {{*u, v}};
}

std::optional<std::array<DoubleBall, 2>> MiddlePlaces<DoubleBall>::nearest_on_arc(
    const DoubleBall& u, const DoubleBall& range) const {
  if (!swept_in_pairs_) swept_in_pairs_.emplace(arc_.curve.below.swept);
  if (below_ == 0) below_ = arc_.sign_below();
  const DoubleDoubleBall at(u.approximation()), among(range.approximation(), range.radius());
  if (const auto v = swept_in_pairs_->only_zero(at, among, below_, 0x1p-80))
    return {{u, DoubleBall::enclosing(v->interval())}};
  const auto v = arc_.over(from_double(u.approximation()), range.interval());
  if (!v) return std::nullopt;
  return {{u, DoubleBall::enclosing(*v)}};
}

}  // namespace exsect

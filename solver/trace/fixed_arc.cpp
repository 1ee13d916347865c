#include "trace/fixed_arc.h"

#include <exsect/algebra/rounding_bounds.h>

namespace exsect {

template <class Ball>
bool is_fixed(const ExchangingSymmetry& symmetry, const Tube<Ball>& tube) {
  const auto centre = [&](std::size_t j) { return tube.centre[j].interval().lower; };
  // A fixed point over the tube's centre: one parameter of x is given, the other one is a zero of the
  // section.
  const std::size_t partner = symmetry.partner[tube.axis];
  const std::size_t given = tube.axis < 2 ? tube.axis : partner;
  const std::size_t other = 1 - given;
  const RationalInterval middle = {centre(tube.axis), centre(tube.axis)};
  const Rational room = from_double(tube.halfwidth[other]) / 2;
  std::array<RationalInterval, 4> at;
  at[given] = tube.axis < 2 ? middle : symmetry.partner_range(tube.axis, middle);
  at[other] = {centre(other) - room, centre(other) + room};
  const auto value = [&](const Rational& t) {
    return given == 0 ? symmetry.section(at[0].lower, t) : symmetry.section(t, at[1].lower);
  };
  if (!(value(at[other].lower) * value(at[other].upper) < 0)) return false;
  for (const std::size_t j : {0U, 1U}) at[symmetry.partner[j]] = symmetry.partner_range(j, at[j]);
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational width = j == tube.axis ? Rational(0) : from_double(tube.halfwidth[j]);
    if (at[j].lower < centre(j) - width || at[j].upper > centre(j) + width) return false;
  }
  const double sign = symmetry.reversed[tube.axis] ? -1 : 1;
  return sign * tube.slope[partner] > tube.slope_error[partner];
}

template bool is_fixed(const ExchangingSymmetry&, const Tube<DoubleBall>&);
template bool is_fixed(const ExchangingSymmetry&, const Tube<DoubleDoubleBall>&);
template bool is_fixed(const ExchangingSymmetry&, const Tube<ArbBall<256>>&);
template bool is_fixed(const ExchangingSymmetry&, const Tube<ArbBall<1024>>&);

}  // namespace exsect

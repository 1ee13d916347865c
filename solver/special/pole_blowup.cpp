#include "special/pole_blowup.h"

#include <exsect/geometry/vector_algebra.h>

#include <algorithm>

namespace exsect {

Blowup::Blowup(const RationalPatch& patch, const Point& p)
    : weight(patch.component(3)), direction(pole_directions(patch, p)) {}

const SideCell& Blowup::cell(int level, long i) {
  const auto [found, is_new] = cells.try_emplace({level, i});
  SideCell& result = found->second;
  if (!is_new) return result;
  const Rectangle on = over(dyadic(level, i));
  for (std::size_t c = 0; c < 3; ++c) result.d[c] = range_on(direction[c], on);
  result.square = dot_over(result.d, result.d);
  result.bend = range_on(height, on) * range_on(weight, on);
  return result;
}

RationalInterval Blowup::dyadic(int level, long i) {
  const Rational width = power_of_two(-level);
  return {i * width, (i + 1) * width};
}

bool Blowup::reaches_to(int level, long i) const {
  return range_bound(weight, over(dyadic(level, i))).lower > 0;
}

bool are_apart(const SideCell& x, const SideCell& y) {
  const EnclosedVector across = cross_over(x.d, y.d);
  return std::ranges::any_of(across, [](const DoubleBall& f) { return f.certain_sign() != 0; }) ||
         dot_over(x.d, y.d).certain_sign() < 0 || (x.bend * y.square - y.bend * x.square).certain_sign() != 0;
}

}  // namespace exsect

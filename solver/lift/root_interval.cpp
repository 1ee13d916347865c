#include "lift/root_interval.h"

#include <exsect/algebra/real_algebraic.h>

#include <algorithm>

namespace exsect {

Rational above_all_roots(const Polynomial& f) {
  Rational greatest = 0;
  for (const Rational& c : f.coefficients()) greatest = std::max<Rational>(greatest, abs(c));
  return 1 + greatest / abs(f.leading_coefficient());
}

RationalInterval interval_around(const std::vector<Polynomial>& polynomials, std::vector<Rational> others,
                                 const Rational& room) {
  for (const Polynomial& f : polynomials) {
    if (f.degree() < 1) continue;
    const Rational beyond = above_all_roots(f);
    const std::vector<RealAlgebraic> roots = real_roots(f, -beyond, beyond);
    if (roots.empty()) continue;
    others.push_back(roots.front().refined_to(room / 16).interval().lower);
    others.push_back(roots.back().refined_to(room / 16).interval().upper);
  }
  if (others.empty()) others = {0};
  const auto [least, most] = std::minmax_element(others.begin(), others.end());
  const Rational width = std::max<Rational>((*most - *least) / 2, room);
  return {simplest_between(*least - width, *least - width / 2),
          simplest_between(*most + width / 2, *most + width)};
}

RationalInterval fitted_interval(const std::vector<Polynomial>& polynomials) {
  const Rational least = power_of_two(-120);
  for (Rational room = 1; room > least; room /= 1024) {
    const RationalInterval interval = interval_around(polynomials, {}, room);
    if (interval.width() > 4 * room) return interval;
  }
  return interval_around(polynomials, {}, 1);
}

}  // namespace exsect

#include "line/rational_line.h"

#include <algorithm>

#include "line/line_place.h"

namespace exsect {
namespace {

/// Where a factor of odd multiplicity vanishes, the point turns back.
bool turns_back(const HomogeneousCurve& straight) {
  for (const PolynomialPower& power : squarefree_factors(standstill_polynomial(straight))) {
    if (power.multiplicity % 2 == 0) continue;
    for (const RealAlgebraic& t : real_roots(power.factor, 0, 1))
      if (t.compare(0) > 0 && t.compare(1) < 0) return true;
  }
  return false;
}

}  // namespace

RationalLine rational_line(const RationalPatch& x, const RationalPatch& y, const LineQuery& query) {
  line_place(query);  // refuses a value outside [0,1]
  const bool of_x = query.fixed == Parameter::u || query.fixed == Parameter::v;
  const bool of_second = query.fixed == Parameter::v || query.fixed == Parameter::s;
  const RationalPatch own = of_x ? x : y, other = of_x ? y : x;
  const RationalPatch along = of_second ? own.transposed() : own;
  HomogeneousCurve curve;
  for (int k = 0; k < 4; ++k) curve[static_cast<std::size_t>(k)] = along.component(k).at_r(query.value);
  return {without_common_factor(curve), other.reduced()};
}

LineShape shape(const HomogeneousCurve& curve) {
  if (degree(curve) == 0) return LineShape::point;
  const std::size_t planes = moving_planes(curve, 0).size();
  if (planes == 2) return turns_back(curve) ? LineShape::folded : LineShape::straight;
  if (planes == 0) return LineShape::twisted_cubic;
  return degree(curve) == 2 ? LineShape::conic : LineShape::plane_cubic;
}

Polynomial standstill_polynomial(const HomogeneousCurve& curve) {
  Polynomial common;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      common = gcd(common, curve[i] * curve[j].derivative() - curve[i].derivative() * curve[j]);
  return common;
}

std::vector<RealAlgebraic> standstills(const HomogeneousCurve& curve) {
  return real_roots(standstill_polynomial(curve), 0, 1);
}

}  // namespace exsect

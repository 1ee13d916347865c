#include "line/line_point_source.h"

#include <exsect/algebra/fixed_point_interval.h>

#include <algorithm>
#include <utility>

namespace exsect {
namespace {

RationalInterval placed(const RationalInterval& x, const std::optional<int>& side, const Rational& width) {
  if (side) return {*side, *side};
  const RationalInterval rounded = rounded_outward(x, width);
  return {std::max(rounded.lower, Rational(0)), std::min(rounded.upper, Rational(1))};
}

}  // namespace

std::optional<int> side_of(const RealAlgebraic& s) {
  if (s.compare(0) == 0) return 0;
  if (s.compare(1) == 0) return 1;
  return std::nullopt;
}

std::vector<Side> global_sides(const LinePlace& place, const LocalSides& local) {
  std::vector<Side> sides;
  const auto add = [&](Parameter p, const std::optional<int>& value) {
    if (value) sides.push_back({p, *value});
  };
  add(place.roles.fixed, side_of(RealAlgebraic(place.value)));
  add(place.roles.line, local.t);
  add(place.roles.first, local.r);
  add(place.roles.second, local.s);
  std::ranges::sort(sides, {}, [](const Side& side) {
    return 2 * index(side.parameter) + static_cast<std::size_t>(side.value);
  });
  return sides;
}

int root_multiplicity(const Polynomial& f, const RealAlgebraic& s) {
  if (sign_at(f.derivative(), s) != 0) return 1;
  for (const PolynomialPower& power : squarefree_factors(f))
    if (sign_at(power.factor, s) == 0) return power.multiplicity;
  return 0;
}

int branch_from(int sign_of_derivative, bool linear) {
  if (sign_of_derivative == 0) return 0;
  return linear || sign_of_derivative < 0 ? 1 : 2;
}

ParameterBox LinePointSource::box(const Rational& width) const {
  const LocalBox local = local_box(width / 2);
  ParameterBox result;
  result[index(place_.roles.fixed)] = {place_.value, place_.value};
  result[index(place_.roles.line)] = placed(local.t, sides_.t, width);
  result[index(place_.roles.first)] = placed(local.r, sides_.r, width);
  result[index(place_.roles.second)] = placed(local.s, sides_.s, width);
  return result;
}

ExactParameters LinePointSource::in_place(TriangularPoint at, const Fraction& t, const Fraction& r,
                                          const Fraction& s) const {
  ExactParameters result{std::move(at), {}, {}};
  const auto put = [&](Parameter p, const Fraction& f) {
    result.numerator[index(p)] = f.numerator;
    result.denominator[index(p)] = f.denominator;
  };
  const BivariatePolynomial one = BivariatePolynomial::constant(1);
  put(place_.roles.fixed, {BivariatePolynomial::constant(place_.value), one});
  put(place_.roles.line, t);
  put(place_.roles.first, r);
  put(place_.roles.second, s);
  return result;
}

}  // namespace exsect

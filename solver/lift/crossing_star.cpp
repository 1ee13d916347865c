#include "lift/crossing_star.h"

#include <exsect/algebra/interruption.h>

#include <algorithm>
#include <utility>

#include "curve/no_zero.h"
#include "curve/short_rational.h"

namespace exsect {
namespace {

/// f at the centre of a rectangle, and a bound of how far its values there differ from that.
std::pair<Rational, Rational> spread_on(const BivariatePolynomial& f, const RationalInterval& u,
                                        const RationalInterval& v) {
  const auto moved = [](const BivariatePolynomial& g, const Rational& s) {
    std::vector<Polynomial> coefficients;
    for (int i = 0; i <= g.degree_r(); ++i)
      coefficients.push_back(g.coefficient(i).compose(Polynomial{s, 1}));
    return BivariatePolynomial(std::move(coefficients));
  };
  const BivariatePolynomial g = moved(moved(f, v.midpoint()).exchanged(), u.midpoint()).exchanged();
  Rational bound = 0, power_u = 1;
  for (int i = 0; i <= g.degree_r(); ++i, power_u *= u.width() / 2) {
    Rational power_v = power_u;
    for (int j = 0; j <= g.degree_s(); ++j, power_v *= v.width() / 2)
      if (i + j > 0) bound += abs(g.coefficient(i, j)) * power_v;
  }
  return {g.coefficient(0, 0), bound};
}

/// Above the moduli of all zeros of the shadow over an interval (Cauchy).
Rational reach_over(const BivariatePolynomial& shadow, const RationalInterval& u) {
  const Rational most = std::max<Rational>(abs(u.lower), abs(u.upper));
  Rational greatest = 0;
  for (int j = 0; j < shadow.degree_s(); ++j) {
    Rational sum = 0, power = 1;
    for (int i = 0; i <= shadow.degree_r(); ++i, power *= most) sum += abs(shadow.coefficient(i, j)) * power;
    greatest = std::max<Rational>(greatest, sum);
  }
  return 1 + greatest / abs(shadow.coefficient(0, shadow.degree_s()));
}

/// Around the value and inside `free`, no longer than 2 `width`.
RationalInterval window_in(const RationalInterval& free, const RealAlgebraic& value, const Rational& width) {
  const RationalInterval at = value.refined_to(width / 2).interval();
  return {std::max<Rational>(free.lower, simplest_between(at.lower - width / 2, at.lower - width / 4)),
          std::min<Rational>(free.upper, simplest_between(at.upper + width / 4, at.upper + width / 2))};
}

/// (17.15a): c0 + c1 y + c2 y^2 has one zero over the place, and the curve is singular there.
bool has_double_point(const SpaceProjection& projection, const TriangularPoint& below) {
  if (!projection.quadratic) return false;
  const auto& [c0, c1, c2] = projection.quadratic->c;
  const BivariatePolynomial four = BivariatePolynomial::constant(4);
  return sign_over(c2, below) != 0 && sign_over(c1 * c1 - four * c0 * c2, below) == 0 &&
         sign_over(projection.quadratic->along, below) == 0;
}

/// The middle of all y over the rectangle, and a bound of how far others are off; by the slope, or by the
/// quadratic.
std::optional<std::pair<Rational, Rational>> range_over(const SpaceProjection& projection,
                                                        const RationalInterval& u,
                                                        const RationalInterval& v) {
  const auto [slope, slope_bound] = spread_on(projection.slope, u, v);
  if (abs(slope) > slope_bound) {
    const Rational y = -projection.offset(u.midpoint(), v.midpoint()) / slope;
    // y - (the one at the centre) is (offset + slope y) / slope with this y (17.15).
    const auto [rest, rest_bound] =
        spread_on(projection.offset + BivariatePolynomial::constant(y) * projection.slope, u, v);
    return std::pair(y, Rational((abs(rest) + rest_bound) / (abs(slope) - slope_bound)));
  }
  if (!projection.quadratic) return std::nullopt;
  const auto& [c0, c1, c2] = projection.quadratic->c;
  const auto [leading, leading_bound] = spread_on(c2, u, v);
  if (abs(leading) <= leading_bound) return std::nullopt;
  const Rational y = -c1(u.midpoint(), v.midpoint()) / (2 * leading), least = abs(leading) - leading_bound;
  // The quadratic in y - (this one), whose zeros are at most |b1| + sqrt(|b0|) for a leading coefficient
  // of 1.
  const BivariatePolynomial at = BivariatePolynomial::constant(y);
  const auto [b0, b0_bound] = spread_on(c0 + at * c1 + at * at * c2, u, v);
  const auto [b1, b1_bound] = spread_on(c1 + BivariatePolynomial::constant(2) * at * c2, u, v);
  return std::pair(y, Rational((abs(b1) + b1_bound) / least + root_above((abs(b0) + b0_bound) / least)));
}

}  // namespace

int sign_over(const BivariatePolynomial& f, const TriangularPoint& below) {
  return f.is_zero() ? 0 : sign_at(f.exchanged(), below);
}

std::optional<std::vector<CrossingCentre>> centres_over(const SpaceProjection& projection,
                                                        const RealAlgebraic& u,
                                                        const std::vector<BivariatePolynomial>& bounds) {
  const BivariatePolynomial& shadow = projection.shadow;
  const BivariatePolynomial by_u = shadow.derivative_r(), by_v = shadow.derivative_s();
  const Rational reach = reach_over(shadow, u.interval());
  std::vector<CrossingCentre> centres;
  for (TriangularPoint& point : roots_at(shadow.exchanged(), u, -reach, reach)) {
    const bool is_simple = sign_over(by_v, point) != 0;
    if (is_simple &&
        std::ranges::none_of(bounds, [&](const auto& each) { return sign_over(each, point) == 0; }))
      continue;
    const bool is_double = sign_over(projection.slope, point) == 0;
    if (is_double && (!bounds.empty() || !has_double_point(projection, point))) return std::nullopt;
    const bool is_singular = is_double || (!is_simple && sign_over(by_u, point) == 0);
    centres.push_back({std::move(point), is_singular});
  }
  return centres;
}

std::optional<CrossingBox> box_over(const SpaceProjection& projection, const RationalInterval& u,
                                    const RationalInterval& v) {
  const auto range = range_over(projection, u, v);
  if (!range) return std::nullopt;
  const auto& [y, reach] = *range;
  const SpaceFrame& frame = projection.frame;
  const Point middle = frame.point(u.midpoint(), v.midpoint(), y);
  CrossingBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational spread = abs(frame.columns[0][k]) * u.width() / 2 +
                            abs(frame.columns[1][k]) * v.width() / 2 + abs(frame.columns[2][k]) * reach;
    box[k] = {middle[k] - spread, middle[k] + spread};
  }
  return box;
}

bool has_no_zero_on(const BivariatePolynomial& f, const RationalInterval& u, const RationalInterval& v) {
  const auto [value, bound] = spread_on(f, u, v);
  return abs(value) > bound;
}

CrossingStar crossing_star(const SpaceProjection& projection, const CrossingCentre& centre,
                           const RationalInterval& free, const Rational& size) {
  const BivariatePolynomial& shadow = projection.shadow;
  const RealAlgebraic& u = centre.below.s();
  for (Rational width = size;; width /= 16) {
    interruption_point();
    const RationalInterval v = centre.below.refined_to(width / 4).r_interval();
    const RationalInterval strip = {v.lower - width, v.upper + width};
    if (roots_at(shadow.exchanged(), u, strip.lower, strip.upper).size() != 1) continue;
    // Its ends are no zeros over u, and so over a window.
    const Polynomial below = shadow.at_s(strip.lower), above = shadow.at_s(strip.upper);
    if (sign_at(below, u) == 0 || sign_at(above, u) == 0) continue;
    RationalInterval window = free;
    for (Rational reach = std::min<Rational>(width, free.width());; reach /= 16) {
      interruption_point();
      window = window_in(free, u, reach);
      if (has_no_zero(below, window) && has_no_zero(above, window) &&
          is_squarefree(shadow.at_r(window.lower)) && is_squarefree(shadow.at_r(window.upper)))
        break;
    }
    const std::optional<CrossingBox> box = box_over(projection, window, strip);
    if (!box ||
        !std::ranges::all_of(*box, [&](const RationalInterval& side) { return side.width() <= size; }))
      continue;
    return {window, strip, *box};
  }
}

}  // namespace exsect

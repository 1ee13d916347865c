#include "filter/round_tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <limits>

namespace exsect {
namespace {

/// Above what places and offsets err by.
constexpr double kLeastWidth = 0x1p-32;
/// Of both coordinates from the centre, so that the differences of angles are known.
constexpr double kMostReach = 0.75;

/// The second derivative of f, or the first of one of its derivatives, along (1, slope) in the order axis,
/// other.
struct TubeJet {
  DoubleBall value, along, across;
  std::array<DoubleBall, 3> second;

  TubeJet(const RoundJet& f, std::size_t axis)
      : value(f.value),
        along(f.first[axis]),
        across(f.first[1 - axis]),
        second{f.second[2 * axis], f.second[1], f.second[2 - 2 * axis]} {}
};

DoubleBall second_along(const std::array<DoubleBall, 3>& second, const DoubleBall& slope) {
  return second[0] + (second[1] + second[1] + second[2] * slope) * slope;
}

/// About the other coordinate: how far the arc is from the line, by (5.2).
double width_guess(const TubeJet& at, double slope, double reach) {
  const double bend = second_along(at.second, DoubleBall(slope)).approximation() / at.across.approximation();
  return 0.8 * std::fabs(bend) * reach * reach + kLeastWidth;
}

}  // namespace

namespace {

/// The places of a ball without 0 of the given sign, from `least` on.
DoubleBall beyond(const DoubleBall& x, int sign, double least) {
  if (x.lower_magnitude() >= least) return x;
  const double most = larger_bound(x.upper_magnitude(), least);
  return DoubleBall::between(sign > 0 ? least : -most, sign > 0 ? most : -least);
}

/// Bounds of f on the places of a tube.
struct TubeBounds {
  TubeJet over;
  double off;         // of |f| on the line
  DoubleBall across;  // f_l
  double tilted;      // of |f_k + m f_l|, m the line's slope

  TubeBounds(const RoundChart& chart, const RoundBox& box, const TubeJet& at, std::size_t axis, double slope)
      : over(chart.jet(box), axis) {
    const double reach = box.reach[axis], side = box.reach[1 - axis];
    const DoubleBall m(slope), tilt = at.along + m * at.across;
    const double curved = second_along(over.second, m).upper_magnitude();
    off = at.value.upper_magnitude() + tilt.upper_magnitude() * reach + curved * reach * reach / 2;
    const double change = over.second[1].upper_magnitude() * reach + over.second[2].upper_magnitude() * side;
    across = at.across.widened(change * kSlack);
    tilted = (tilt.upper_magnitude() + (over.second[0] + m * over.second[1]).upper_magnitude() * reach +
              (over.second[1] + m * over.second[2]).upper_magnitude() * side) *
             kSlack;
  }

  double least() const { return across.lower_magnitude(); }
  /// (17.34)
  bool prove(double width) const { return off * kSlack + kUnderflowLoss < least() * width; }
};

RoundTube tube_of(const RoundChart& chart, const RoundBox& box, std::size_t axis, double width,
                  const TubeBounds& bounds, double slope, double gradient) {
  const std::size_t other = 1 - axis;
  const std::array<double, 2> speeds = chart.speeds(box);
  const double steep = DoubleBall(slope, bounds.tilted / bounds.least() * kSlack).upper_magnitude();
  const double deviation = (bounds.across - DoubleBall(gradient)).upper_magnitude();
  return {&chart,
          box.centre,
          axis,
          slope,
          box.reach[axis],
          width,
          bounds.least(),
          bounds.across.certain_sign(),
          gradient,
          deviation / std::fabs(gradient) * kSlack,
          steep,
          speeds[other],
          (speeds[axis] + steep * speeds[other]) * kSlack};
}

}  // namespace

std::optional<RoundTube> round_tube(const RoundChart& chart, const RoundPlace& centre, std::size_t axis,
                                    double reach) {
  const std::size_t other = 1 - axis;
  const TubeJet at(chart.jet(centre), axis);
  const double gradient = at.across.approximation(), slope = -at.along.approximation() / gradient;
  double width = width_guess(at, slope, reach);
  for (int attempt = 0; attempt < 2; ++attempt) {
    RoundBox box{centre, {}};
    box.reach[axis] = reach;
    box.reach[other] = (std::fabs(slope) * reach + width) * kSlack;
    if (!(reach < kMostReach)) return std::nullopt;
    if (!(other == 1 && !chart.is_closed()) && !(box.reach[other] < kMostReach)) return std::nullopt;
    const TubeBounds bounds(chart, box, at, axis, slope);
    if (bounds.prove(width)) return tube_of(chart, box, axis, width, bounds, slope, gradient);
    width = 1.5 * bounds.off / bounds.least();  // the centre bends less than the rest
  }
  return std::nullopt;
}

DoubleBall offset(const RoundTube& tube, const RoundBox& box) {
  return tube.chart->difference(tube.axis, box.centre, tube.centre).widened(box.reach[tube.axis]);
}

namespace {

/// The other coordinate without slope s.
DoubleBall lateral(const RoundTube& tube, const RoundBox& box, const DoubleBall& s) {
  const std::size_t other = 1 - tube.axis;
  return tube.chart->difference(other, box.centre, tube.centre).widened(box.reach[other]) -
         DoubleBall(tube.slope) * s;
}

}  // namespace

bool excludes(const RoundTube& tube, const RoundBox& box) {
  const std::size_t other = 1 - tube.axis;
  const double along = (tube.reach + box.reach[tube.axis]) * kSlack,
               across = (std::fabs(tube.slope) * tube.reach + tube.width + box.reach[other]) * kSlack;
  if (along < 1 && tube.chart->differ(tube.axis, box.centre, tube.centre, along)) return true;
  if (across < 1 && tube.chart->differ(other, box.centre, tube.centre, across)) return true;
  const DoubleBall s = offset(tube, box);
  if (std::isinf(s.radius())) return true;  // angles of more than kMostReach, and the box is small
  if (s.lower_magnitude() > tube.reach) return true;
  const DoubleBall d = lateral(tube, box, s);
  return std::isinf(d.radius()) || d.lower_magnitude() > tube.width;
}

bool contains(const RoundTube& tube, const RoundBox& box) {
  const DoubleBall s = offset(tube, box);
  return s.upper_magnitude() <= tube.reach && lateral(tube, box, s).upper_magnitude() <= tube.width;
}

namespace {

/// Quick, unless only the radius is more than `wanted`.
DoubleBall value_for(const RoundChart& chart, const RoundPlace& place, double wanted) {
  const DoubleBall f = chart.quick_value(place);
  const bool is_enough = std::fabs(f.approximation()) > 8 * f.radius() || f.upper_magnitude() < wanted / 2;
  return is_enough ? f : chart.value(place);
}

}  // namespace

NearCurve near_curve(const RoundTube& tube, double s, double guess, double wanted) {
  constexpr int most_steps = 12;
  const std::size_t other = 1 - tube.axis;
  const RoundPlace start = tube.chart->moved(tube.centre, tube.axis, s);
  const double line = tube.slope * s;
  double off = std::fabs(guess - line) < tube.width / 2 ? guess : line, before = 0, value_before = 0;
  NearCurve best{start, off, std::numeric_limits<double>::infinity()};
  for (int step = 0; step < most_steps && is_inside(tube, s, off); ++step) {
    const RoundPlace here = tube.chart->moved(start, other, off);
    const DoubleBall f = value_for(*tube.chart, here, wanted * tube.least);
    // The zero is at f / f_d(x) for some x between, and the next place at f / gradient.
    const double error = f.upper_magnitude() / tube.least * kSlack;
    const bool is_worse = !(error < best.error / 2);
    if (error < best.error) best = {here, off, error};
    if (error <= wanted || is_worse) break;
    const double next = off - f.approximation() / tube.gradient;
    const double left =
        (error * tube.contraction + f.radius() / std::fabs(tube.gradient)) * kSlack + kMoveError;
    if (left <= wanted && is_inside(tube, s, next))
      return {tube.chart->moved(start, other, next), next, left};
    const double secant = step > 0 ? (f.approximation() - value_before) / (off - before) : tube.gradient;
    before = off;
    value_before = f.approximation();
    off -= f.approximation() / (secant != 0 ? secant : tube.gradient);
  }
  return best;
}

namespace {

/// Requires a ball without 0; of infinite or NaN radius if it is not.
DoubleBall inverse(const DoubleBall& x) {
  const double middle = 1 / x.approximation();
  return {middle, (x.radius() / x.lower_magnitude() + 0x1p-52) * std::fabs(middle) * kSlack};
}

double length_bound(const std::array<DoubleBall, 3>& v) {
  return exsect::length_bound(v[0].upper_magnitude(), v[1].upper_magnitude(), v[2].upper_magnitude());
}

DoubleBall minor_of(const RoundMotion& motion, std::size_t i, std::size_t k) {
  return motion.velocity[i] * motion.acceleration[k] - motion.velocity[k] * motion.acceleration[i];
}

}  // namespace

RoundArc arc_near(const RoundTube& tube, const NearCurve& near, double reach) {
  const std::size_t other = 1 - tube.axis;
  const TubeJet at(tube.chart->quick_jet(near.place), tube.axis);
  const double slope = -at.along.approximation() / at.across.approximation();
  RoundBox box{near.place, {}};
  box.reach[tube.axis] = reach;
  const double rise = std::min(tube.steep * reach, std::fabs(tube.slope) * reach + 2 * tube.width);
  box.reach[other] = (rise + near.error) * kSlack;
  const TubeBounds bounds(*tube.chart, box, at, tube.axis, slope);
  // The box may be wider than the tube.
  const DoubleBall across = beyond(bounds.across, tube.sign, tube.least);
  const DoubleBall slopes(slope, bounds.tilted / across.lower_magnitude() * kSlack);
  const DoubleBall bends = -(second_along(bounds.over.second, slopes) * inverse(across));
  const RoundMotion motion = tube.chart->motion(box, tube.axis, slopes, bends);
  const auto& v = motion.velocity;
  const double least_speed =
      std::hypot(v[0].lower_magnitude(), std::hypot(v[1].lower_magnitude(), v[2].lower_magnitude())) *
      kReduced;
  const double acceleration = length_bound(motion.acceleration);
  const double normal =
      length_bound({minor_of(motion, 1, 2), minor_of(motion, 2, 0), minor_of(motion, 0, 1)}) / least_speed *
      kSlack;
  return {slope, bends.approximation(), acceleration, normal, least_speed};
}

}  // namespace exsect

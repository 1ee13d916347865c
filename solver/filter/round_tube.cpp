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

/// Bounds of f on the places of a tube.
struct TubeBounds {
  TubeJet over;
  double off;         // of |f| on the line
  DoubleBall across;  // f_l
  double turn;        // of the slope's distance from the line's

  TubeBounds(const RoundChart& chart, const RoundBox& box, const TubeJet& at, std::size_t axis, double slope)
      : over(chart.jet(box), axis) {
    const double reach = box.reach[axis], side = box.reach[1 - axis];
    const DoubleBall m(slope), tilt = at.along + m * at.across;
    const double curved = second_along(over.second, m).upper_magnitude();
    off = at.value.upper_magnitude() + tilt.upper_magnitude() * reach + curved * reach * reach / 2;
    const double change = over.second[1].upper_magnitude() * reach + over.second[2].upper_magnitude() * side;
    across = at.across.widened(change * kSlack);
    turn = (tilt.upper_magnitude() + (over.second[0] + m * over.second[1]).upper_magnitude() * reach +
            (over.second[1] + m * over.second[2]).upper_magnitude() * side) /
           least() * kSlack;
  }

  double least() const { return across.lower_magnitude(); }
  /// (17.34)
  bool prove(double width) const { return off * kSlack + kUnderflowLoss < least() * width; }
};

RoundTube tube_of(const RoundChart& chart, const RoundBox& box, std::size_t axis, double width,
                  const TubeBounds& bounds, double slope, double gradient) {
  const std::size_t other = 1 - axis;
  const DoubleBall slopes(slope, bounds.turn);
  const double bend = second_along(bounds.over.second, slopes).upper_magnitude() / bounds.least();
  const std::array<double, 2> speeds = chart.speeds(box);
  const std::array<double, 3> accelerations = chart.accelerations(box);
  const double steep = slopes.upper_magnitude();
  const double acceleration = accelerations[2 * axis] + 2 * accelerations[1] * steep +
                              accelerations[2 - 2 * axis] * steep * steep + speeds[other] * bend;
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
          acceleration * kSlack,
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

NearCurve near_curve(const RoundTube& tube, double s, double guess, double wanted) {
  constexpr int most_steps = 12;
  constexpr double rounding = 0x1p-46;  // of moved places
  const std::size_t other = 1 - tube.axis;
  const RoundPlace start = tube.chart->moved(tube.centre, tube.axis, s);
  const bool is_along = (std::fabs(s) + rounding) * kSlack <= tube.reach;
  double off = guess, before = 0, value_before = 0;
  NearCurve best{start, guess, std::numeric_limits<double>::infinity()};
  for (int step = 0; step < most_steps && is_along; ++step) {
    if (!((std::fabs(off - tube.slope * s) + rounding) * kSlack < tube.width)) break;
    const RoundPlace here = tube.chart->moved(start, other, off);
    const DoubleBall f = tube.chart->value(here);
    // The zero is at f / f_d(x) for some x between, and the next place at f / gradient.
    const double error = f.upper_magnitude() / tube.least * kSlack;
    const bool is_worse = !(error < best.error / 2);
    if (error < best.error) best = {here, off, error};
    if (error <= wanted || is_worse) break;
    const double next = off - f.approximation() / tube.gradient;
    const double left =
        (error * tube.contraction + f.radius() / std::fabs(tube.gradient)) * kSlack + 2 * rounding;
    if (left <= wanted && (std::fabs(next - tube.slope * s) + rounding) * kSlack < tube.width)
      return {tube.chart->moved(start, other, next), next, left};
    const double secant = step > 0 ? (f.approximation() - value_before) / (off - before) : tube.gradient;
    before = off;
    value_before = f.approximation();
    off -= f.approximation() / (secant != 0 ? secant : tube.gradient);
  }
  return best;
}

}  // namespace exsect

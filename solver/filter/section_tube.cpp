#include "filter/section_tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <limits>

namespace exsect {
namespace {

/// Above what places and offsets err by.
constexpr double kLeastTubeWidth = 0x1p-36;
constexpr double kPlaceRounding = 0x1p-50;  // of sums of numbers below 2

/// Of a ball without 0; NaN or infinite otherwise.
DoubleBall reciprocal(const DoubleBall& x) {
  const double middle = 1 / x.approximation();
  const double off = (x * DoubleBall(middle) - DoubleBall(1)).upper_magnitude();  // of x middle from 1
  return DoubleBall(middle).widened(off / x.lower_magnitude() * kSlack);
}

/// The derivatives of a function along the tube's axis and across it, of orders k and l.
struct TubeFrame {
  const LocalForm& f;
  std::size_t axis;
  double along_reach, across_reach;

  std::array<std::size_t, 2> order(std::size_t k, std::size_t l) const {
    return axis == 0 ? std::array{k, l} : std::array{l, k};
  }
  DoubleBall at(std::size_t k, std::size_t l) const {
    const auto [i, j] = order(k, l);
    return f.derivative(i, j);
  }
  DoubleBall over(std::size_t k, std::size_t l) const {
    const auto [i, j] = order(k, l);
    const double a = axis == 0 ? along_reach : across_reach, b = axis == 0 ? across_reach : along_reach;
    return f.derivative_over(i, j, a, b);
  }
};

/// Bounds of f on the places of a tube.
struct TubeRange {
  double off;            // of |f| on the line
  DoubleBall across;     // f_l
  DoubleBall slopes;     // of the arc
  DoubleBall curvature;  // f_kk + 2 t f_kl + t^2 f_ll for these slopes t

  TubeRange(const TubeFrame& frame, double slope) {
    const DoubleBall m(slope), tilt = frame.at(1, 0) + m * frame.at(0, 1);
    const DoubleBall kk = frame.over(2, 0), kl = frame.over(1, 1), ll = frame.over(0, 2);
    const double reach = frame.along_reach;
    const DoubleBall half(0.5), two(2);
    const double curved =
        (frame.at(2, 0) + two * m * frame.at(1, 1) + m * m * frame.at(0, 2)).upper_magnitude();
    const double side = std::fabs(slope) * reach * kSlack;
    const double rest =
        frame.axis == 0 ? frame.f.terms(0, 0, reach, side, 3) : frame.f.terms(0, 0, side, reach, 3);
    off = (frame.at(0, 0).upper_magnitude() + tilt.upper_magnitude() * reach + curved * reach * reach / 2 +
           rest) *
          kSlack;
    across = frame.over(0, 1);
    // The slope is m - (f_k + m f_l) / f_l.
    const double turned = (tilt.upper_magnitude() + (kk + m * kl).upper_magnitude() * reach +
                           (kl + m * ll).upper_magnitude() * frame.across_reach) /
                          across.lower_magnitude();
    slopes = m.widened(turned * kSlack);
    curvature = kk + two * slopes * kl + slopes * slopes * ll;
  }
};

/// About the other coordinate: how far the arc is from the line.
double likely_width(const TubeFrame& frame, double slope) {
  const double bend = frame.at(2, 0).approximation() + 2 * slope * frame.at(1, 1).approximation() +
                      slope * slope * frame.at(0, 2).approximation();
  return 0.8 * std::fabs(bend / frame.at(0, 1).approximation()) * frame.along_reach * frame.along_reach +
         kLeastTubeWidth;
}

}  // namespace

std::optional<SectionTube> section_tube(const SquareForm& f, const std::array<double, 2>& centre,
                                        std::size_t axis, double reach) {
  const std::size_t other = 1 - axis;
  if (!(std::fabs(centre[0]) <= SquareForm::reach && std::fabs(centre[1]) <= SquareForm::reach))
    return std::nullopt;
  const LocalForm local = f.about(centre[0], centre[1]);
  TubeFrame frame{local, axis, reach, 0};
  const double gradient = frame.at(0, 1).approximation();
  const double slope = -frame.at(1, 0).approximation() / gradient;
  double width = likely_width(frame, slope);
  for (int attempt = 0; attempt < 2; ++attempt) {
    frame.across_reach = (std::fabs(slope) * reach + width) * kSlack;
    if (!(std::fabs(centre[axis]) + reach < SquareForm::reach * kReduced) ||
        !(std::fabs(centre[other]) + frame.across_reach < SquareForm::reach * kReduced))
      return std::nullopt;
    const TubeRange range(frame, slope);
    const double least = range.across.lower_magnitude();
    if (range.off * kSlack + kUnderflowLoss < least * width)  // (17.34)
      return SectionTube{
          centre,
          axis,
          slope,
          reach,
          width,
          least,
          range.across.certain_sign(),
          gradient,
          (range.across - DoubleBall(gradient)).upper_magnitude() / std::fabs(gradient) * kSlack,
          range.slopes,
          -range.curvature * reciprocal(range.across)};
    width = 1.5 * range.off / least;  // the centre bends less than the rest
  }
  return std::nullopt;
}

DoubleBall offset(const SectionTube& tube, const SectionBox& box) {
  return (DoubleBall(box.centre[tube.axis]) - DoubleBall(tube.centre[tube.axis]))
      .widened(box.reach[tube.axis]);
}

namespace {

/// The other coordinate without slope s.
DoubleBall across_offset(const SectionTube& tube, const SectionBox& box, const DoubleBall& s) {
  const std::size_t other = 1 - tube.axis;
  return (DoubleBall(box.centre[other]) - DoubleBall(tube.centre[other])).widened(box.reach[other]) -
         DoubleBall(tube.slope) * s;
}

}  // namespace

bool excludes(const SectionTube& tube, const SectionBox& box) {
  const DoubleBall s = offset(tube, box);
  return s.lower_magnitude() > tube.reach || across_offset(tube, box, s).lower_magnitude() > tube.width;
}

bool contains(const SectionTube& tube, const SectionBox& box) {
  const DoubleBall s = offset(tube, box);
  return s.upper_magnitude() <= tube.reach && across_offset(tube, box, s).upper_magnitude() <= tube.width;
}

PlaceNearCurve place_near_curve(const SquareForm& f, const SectionTube& tube, double s, double guess,
                                double wanted) {
  constexpr int most_steps = 12;
  const std::size_t other = 1 - tube.axis;
  PlaceNearCurve best{tube.centre, guess, std::numeric_limits<double>::infinity()};
  best.place[tube.axis] += s;
  if (!((std::fabs(s) + kPlaceRounding) * kSlack <= tube.reach)) return best;
  double off = guess, before = 0, value_before = 0;
  for (int step = 0; step < most_steps; ++step) {
    if (!((std::fabs(off - tube.slope * s) + kPlaceRounding * (1 + std::fabs(tube.slope))) * kSlack <
          tube.width))
      break;
    std::array<double, 2> place = best.place;
    place[other] = tube.centre[other] + off;
    const double value = f(place[0], place[1]);
    const double error = (std::fabs(value) + f.error()) / tube.least * kSlack;
    const bool is_worse = !(error < best.error / 2);
    if (error < best.error) best = {place, off, error};
    if (error <= wanted || is_worse) break;
    // The zero is at value / f_d(x) for some x between, and the next place at value / gradient.
    const double next = off - value / tube.gradient;
    const double left =
        (error * tube.contraction + f.error() / std::fabs(tube.gradient)) * kSlack + 2 * kPlaceRounding;
    if (left <= wanted &&
        (std::fabs(next - tube.slope * s) + kPlaceRounding * (1 + std::fabs(tube.slope))) * kSlack <
            tube.width) {
      place[other] = tube.centre[other] + next;
      return {place, next, left};
    }
    const double secant = step > 0 ? (value - value_before) / (off - before) : tube.gradient;
    before = off;
    value_before = value;
    off -= value / (secant != 0 ? secant : tube.gradient);
  }
  return best;
}

namespace {

using SpaceBalls = std::array<DoubleBall, 3>;

double largest_length(const SpaceBalls& x) {
  return exsect::length_bound(x[0].upper_magnitude(), x[1].upper_magnitude(), x[2].upper_magnitude());
}

SpaceBalls vector_product(const SpaceBalls& a, const SpaceBalls& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The derivatives of the position on the places of a tube, along its axis and across it: from those of X = w
/// x, as w x_k = X_k - w_k x, and so on.
struct PatchRange {
  DoubleBall weight;
  double largest = 0;  // of the coordinates of positions
  std::array<SpaceBalls, 2> first;
  std::array<SpaceBalls, 3> second;  // kk, kl, ll

  PatchRange(const std::array<SquareForm, 4>& patch, const SectionTube& tube) {
    const double along = tube.reach, across = (std::fabs(tube.slope) * tube.reach + tube.width) * kSlack;
    const LocalForm w = patch[3].about(tube.centre[0], tube.centre[1]);
    const TubeFrame of_weight{w, tube.axis, along, across};
    weight = of_weight.over(0, 0);
    const std::array<DoubleBall, 5> weights = derivatives(of_weight);
    const DoubleBall inverse = reciprocal(weight), two(2);
    for (std::size_t k = 0; k < 3; ++k) {
      const LocalForm f = patch[k].about(tube.centre[0], tube.centre[1]);
      const TubeFrame frame{f, tube.axis, along, across};
      const DoubleBall position = frame.over(0, 0) * inverse;
      std::array<DoubleBall, 5> y = derivatives(frame);
      for (std::size_t i = 0; i < y.size(); ++i) y[i] -= weights[i] * position;
      first[0][k] = y[0] * inverse;
      first[1][k] = y[1] * inverse;
      second[0][k] = (y[2] - two * weights[0] * first[0][k]) * inverse;
      second[1][k] = (y[3] - weights[0] * first[1][k] - weights[1] * first[0][k]) * inverse;
      second[2][k] = (y[4] - two * weights[1] * first[1][k]) * inverse;
      largest = larger_bound(largest, position.upper_magnitude());
    }
  }

 private:
  static std::array<DoubleBall, 5> derivatives(const TubeFrame& frame) {
    return {frame.over(1, 0), frame.over(0, 1), frame.over(2, 0), frame.over(1, 1), frame.over(0, 2)};
  }
};

}  // namespace

SectionSpeeds section_speeds(const std::array<SquareForm, 4>& patch, const SectionTube& tube) {
  const PatchRange x(patch, tube);
  const DoubleBall &t = tube.slopes, two(2);
  SpaceBalls first, second;
  std::array<double, 3> least;
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = x.first[0][k] + t * x.first[1][k];
    second[k] =
        x.second[0][k] + two * t * x.second[1][k] + t * t * x.second[2][k] + tube.bends * x.first[1][k];
    least[k] = first[k].lower_magnitude();
  }
  SectionSpeeds result{};
  result.acceleration = largest_length(second);
  result.least_speed = std::hypot(least[0], least[1], least[2]) * kReduced;
  result.normal = largest_length(vector_product(first, second)) / result.least_speed * kSlack;
  result.rate = largest_length(first);
  result.speed = largest_length(x.first[1]);
  const double vector = exsect::length_bound(patch[0].error(), patch[1].error(), patch[2].error());
  const double weight = x.weight.lower_magnitude() * kReduced - patch[3].error();
  result.rounding =
      weight > 0
          ? ((vector + 2 * x.largest * patch[3].error()) / weight + 4 * x.largest * kUnitRoundoff) * kSlack +
                kUnderflowLoss
          : std::numeric_limits<double>::infinity();
  return result;
}

std::array<double, 3> section_point(const SectionForms& forms, const std::array<double, 2>& place) {
  const auto& [p, q] = place;
  const double weight = forms.has_no_weights ? 1 : forms.patch[3](p, q);
  return {forms.patch[0](p, q) / weight, forms.patch[1](p, q) / weight, forms.patch[2](p, q) / weight};
}

}  // namespace exsect

#include "filter/side_point.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "filter/algebraic_meeting.h"
#include "filter/curve_series.h"
#include "filter/exact_meeting.h"
#include "filter/tube_derivatives.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

/// Nearer than this to a side a parameter is asked to be at it.
constexpr double kNearSide = 0x1p-24;
/// The same of the place where a search has ended.
constexpr double kNearPlace = 0x1p-8;
/// Half lengths of the tube, the first that can be proved.
constexpr double kLongest = 0x1p-3;
constexpr double kShortest = 0x1p-20;
/// More than 1, so that the terms of the power series stay in the box.
constexpr double kRoom = 1.0625;

/// The sides that a solution next to the place is near; all zero if there are not two.
template <class K>
Vec4 sides_near(const PairOf<K>& pair, Vec4& place) {
  const auto distance = [&](std::size_t j) { return std::fabs(std::fabs(place[j]) - 0.5); };
  // Newton's method along the side that the curve crosses best.
  const Vec4 tangent = first_four<K>(linearise(pair, with_scale(pair, place)).tangent);
  std::size_t fixed = 4;
  for (std::size_t j = 0; j < 4; ++j) {
    if (distance(j) > kNearPlace) continue;
    if (fixed == 4 || std::fabs(tangent[j]) > std::fabs(tangent[fixed])) fixed = j;
  }
  if (fixed == 4) return {};
  place[fixed] = std::copysign(0.5, place[fixed]);
  Unknowns<K> at = with_scale(pair, place);
  // The second time because the last step of the first one is below 2^-16 only.
  if (!improve(pair, at, fixed, 20) || !improve(pair, at, fixed, 1)) return {};
  place = first_four<K>(at);
  Vec4 on{};
  int count = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    if (distance(j) > kNearSide) continue;
    on[j] = std::copysign(0.5, place[j]);
    ++count;
  }
  return count > 1 ? on : Vec4{};
}

/// A ball that contains the solution, with the scale. X_4 and Y_4, of size 1, change by 2 n at most along
/// each parameter.
template <class K>
std::optional<BallOf<K>> ball_around(const PairOf<K>& pair, const ExactMeeting& meeting) {
  BallOf<K> ball{with_scale(pair, meeting.at), meeting.radius};
  if constexpr (K::weighted) {
    const double scale = ball.middle[4];
    const double weight = value_at<K>(pair.y.power, meeting.at[2], meeting.at[3])[3];
    const double change = 4 * static_cast<double>(K::degree) * meeting.radius + 64 * kUnit +
                          pair.x_total_error + pair.y_total_error;
    const double least = kScaleUnit * (weight - change);
    if (!(least > kLeastWeight)) return std::nullopt;
    ball.radius = larger_bound(ball.radius, kSlack * 2 * change * (1 + kScaleUnit * scale) / least);
  }
  return ball;
}

template <class K>
class SidePointProof {
 public:
  SidePointProof(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                 const ExactMeeting& meeting, SidePointOf<K>& point)
      : x_(x), y_(y), pair_(pair), meeting_(meeting), point_(point) {}

  bool run() {
    const Linearisation<K> at = linearise(pair_, point_.ball.middle);
    const std::size_t axis = steepest(first_four<K>(at.tangent));
    if (!prepare(pair_, point_.ball.middle, axis, point_.tube)) return false;
    for (double reach = kLongest; reach >= kShortest; reach *= 0.5) {
      if (certify(pair_, point_.tube, -reach, reach, filled<K>(reach)) && is_inside() && leaves_sides()) {
        return true;
      }
    }
    return false;
  }

 private:
  /// The point is on the arc, and the parameters that are not at sides stay inside.
  bool is_inside() const {
    const TubeOf<K>& tube = point_.tube;
    for (std::size_t j = 0; j < 4; ++j) {
      if (point_.on[j] == 0 && !(std::fabs(tube.centre[j]) + tube.offset[j] < 0.5 - kPlacing)) return false;
    }
    return contains(tube, point_.ball);
  }

  /// Sign of a parameter, less its value in the point, on the arc ahead of the point and behind it; 0 if not
  /// proved.
  std::array<int, 2> signs(std::size_t j) {
    const TubeOf<K>& tube = point_.tube;
    if (std::fabs(tube.slope[j]) > tube.slope_error[j]) {
      const int sign = tube.slope[j] > 0 ? 1 : -1;
      return {sign, -sign};
    }
    if (!point_.still[j]) return {0, 0};
    if (std::fabs(tube.second[j]) > tube.second_error[j]) {
      const int sign = tube.second[j] > 0 ? 1 : -1;
      return {sign, sign};
    }
    return signs_by_series(j);
  }

  /// By the first term of the power series.
  std::array<int, 2> signs_by_series(std::size_t j) {
    if (!meeting_.exact) return {0, 0};
    if (!series_) series_ = CurveSeries::about<K>(x_, y_, *meeting_.exact, point_.tube.axis);
    const std::size_t order = series_ ? series_->order(j) : 0;
    if (order == 0) return {0, 0};
    std::array<double, 4> room;
    for (std::size_t i = 0; i < 4; ++i) room[i] = kRoom * (point_.tube.offset[i] + point_.ball.radius);
    const int sign = series_->sign_beside(room, kSlack * (point_.tube.upper + point_.ball.radius), j);
    return {sign, order % 2 == 0 ? sign : -sign};
  }

  /// Ahead of the point and behind it: all parameters at sides move inwards, or one outwards, whatever the
  /// others do; not all inwards on both ways.
  bool leaves_sides() {
    bound_derivatives(pair_, point_.tube);
    std::array<std::array<int, 2>, 4> sign;
    std::array<bool, 2> inside = {true, true};
    std::array<bool, 2> outside = {false, false};
    for (std::size_t j = 0; j < 4; ++j) {
      sign[j] = signs(j);
      if (point_.on[j] == 0) continue;
      for (std::size_t way = 0; way < 2; ++way) {
        const int inwards = point_.on[j] > 0 ? -sign[j][way] : sign[j][way];
        inside[way] = inside[way] && inwards > 0;
        outside[way] = outside[way] || inwards < 0;
      }
    }
    point_.enters = inside[0] || inside[1];
    for (std::size_t j = 0; j < 4; ++j) point_.rate[j] = inside[0] ? sign[j][0] : -sign[j][1];
    return has_leaving() && !(inside[0] && inside[1]) && (inside[0] || outside[0]) &&
           (inside[1] || outside[1]);
  }

  /// One of the parameters at sides, which crosses it where the arc enters.
  bool has_leaving() {
    const TubeOf<K>& tube = point_.tube;
    for (std::size_t j = 0; j < 4; ++j) {
      point_.leaving = j;
      const bool crosses = std::fabs(tube.slope[j]) > tube.slope_error[j];
      if (point_.on[j] != 0 && (crosses || !point_.enters)) return true;
    }
    return false;
  }

  const ExactPatch<K>& x_;
  const ExactPatch<K>& y_;
  const PairOf<K>& pair_;
  const ExactMeeting& meeting_;
  SidePointOf<K>& point_;
  std::optional<CurveSeries> series_;
};

/// The one at a solution on these sides.
template <class K>
std::optional<SidePointOf<K>> side_point_at(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                            const PairOf<K>& pair, const Vec4& on,
                                            const ExactMeeting& meeting) {
  const auto ball = ball_around<K>(pair, meeting);
  if (!ball || !(ball->radius < 0.25 * kEndMargin<K::width>)) return std::nullopt;
  SidePointOf<K> point{*ball, on, {}, false, 0, meeting.still};
  return SidePointProof<K>(x, y, pair, meeting, point).run() ? std::optional(point) : std::nullopt;
}

}  // namespace

template <class K>
std::optional<SidePointOf<K>> side_point_near([[maybe_unused]] const ExactPatch<K>& x,
                                              [[maybe_unused]] const ExactPatch<K>& y,
                                              [[maybe_unused]] const PairOf<K>& pair,
                                              [[maybe_unused]] const Vec4& place) {
  if constexpr (std::is_same_v<K, Biquadratic>) {
    return std::nullopt;
  } else {
    Vec4 near = place;
    const Vec4 on = sides_near<K>(pair, near);
    if (on == Vec4{}) return std::nullopt;
    const auto meeting = exact_meeting<K>(x, y, near, on);
    auto point = meeting ? side_point_at(x, y, pair, on, *meeting) : std::nullopt;
    if (point || (meeting && meeting->exact)) return point;
    const auto algebraic = algebraic_meeting(rational_patch(x), rational_patch(y), near, on);
    return algebraic ? side_point_at(x, y, pair, on, *algebraic) : std::nullopt;
  }
}

template <class K>
bool lies_in_region(const SidePointOf<K>& point, const Part& x, const Part& y) {
  const TubeOf<K>& tube = point.tube;
  Unknowns<K> lower, upper;  // from the centre
  for (std::size_t j = 0; j < 4; ++j) {
    const Part::Interval& range = (j < 2 ? x : y).range[j % 2];
    lower[j] = range.lower - 0.5 - tube.centre[j];
    upper[j] = range.upper - 0.5 - tube.centre[j];
  }
  if constexpr (K::weighted) {
    const RangeOfScale scale = range_of_scale(x, y);
    lower[4] = in_tube(tube, 4, scale.middle - tube.centre[4] - scale.half);
    upper[4] = in_tube(tube, 4, scale.middle - tube.centre[4] + scale.half);
  }
  const double from = lower[tube.axis], to = upper[tube.axis];
  const auto size = [](double a, double b) { return std::max(std::fabs(a), std::fabs(b)); };
  const double along = kSlack * (size(from, to) + kPlacing);
  // From the middle line of the tube; differences of doubles err by a few units of what is subtracted.
  const auto distance = [&](std::size_t j) {
    const double slope = tube.slope[j];
    const double rise = std::max(slope * from, slope * to), fall = std::min(slope * from, slope * to);
    const double rounding = 8 * kUnit * (size(lower[j], upper[j]) + std::fabs(slope) * along);
    return kSlack * (size(lower[j] - rise, upper[j] - fall) + kPlacing * (1 + std::fabs(slope)) + rounding);
  };
  return along <= tube.upper && -along >= tube.lower &&
         std::all_of(tube.others.begin(), tube.others.end(),
                     [&](std::size_t j) { return distance(j) <= tube.halfwidth[j]; });
}

#define EXSECT_INSTANTIATE(K)                                                                           \
  template std::optional<SidePointOf<K>> side_point_near<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                            const PairOf<K>&, const Vec4&);             \
  template bool lies_in_region<K>(const SidePointOf<K>&, const Part&, const Part&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "filter/round_vertices.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace exsect {
namespace {

using Two = double __attribute__((vector_size(2 * sizeof(double))));

constexpr double kLongestPart = 1;  // of both coordinates of a part's places from the first one

/// In a place over an offset within kMoveError of that asked for.
BoundedVertex bounded(const std::array<double, 3>& at, double radius, double error, const RoundTube& tube) {
  return {{{}, at}, (radius + error * tube.speed + kMoveError * tube.rate) * kSlack};
}

}  // namespace

BoundedVertex round_vertex(const RoundTube& tube, const NearCurve& near) {
  const auto [x, y, z] = tube.chart->quick_position(near.place);
  return bounded({x.approximation(), y.approximation(), z.approximation()},
                 length_bound(x.radius(), y.radius(), z.radius()), near.error, tube);
}

RoundPart::RoundPart(const RoundTube& tube, const RoundNode& a, const RoundNode& b, double wanted)
    : tube_(tube),
      from_(a.near),
      s_(a.s),
      length_(b.s - a.s),
      wanted_(wanted),
      value_error_(tube.chart->value_error({a.near.place, {kLongestPart, kLongestPart}})),
      position_error_(tube.chart->position_error({a.near.place, {kLongestPart, kLongestPart}})) {
  const double h = length_, first = a.arc.slope * h, second = a.arc.bend * h * h / 2;
  const double value = (b.near.off - a.near.off) - (first + second),
               slope = b.arc.slope * h - (first + 2 * second), bend = b.arc.bend * h * h - 2 * second;
  series_ = {0,
             first,
             second,
             10 * value - 4 * slope + bend / 2,
             -15 * value + 7 * slope - bend,
             6 * value - 3 * slope + bend / 2};
}

void RoundPart::evaluate(const Pair& part, Points& points) const {
  const RoundChart& chart = *tube_.chart;
  Two x;
  std::memcpy(&x, part.data(), sizeof x);
  const auto& c = series_;
  const Two side = x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))), along = length_ * x;
  const bool is_far =
      std::fabs(length_) > 0.25 || !(std::fabs(side[0]) <= 0.25 && std::fabs(side[1]) <= 0.25);
  std::array<std::array<Two, 2>, 2> at;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::array<Two, 2> start = {Two{} + from_.place.at[k][0], Two{} + from_.place.at[k][1]};
    const Two& move = k == tube_.axis ? along : side;
    if (k == 1 && !chart.is_closed())
      at[k] = {start[0] + move, start[1]};
    else
      at[k] = turned_by(start, move, is_far);
  }
  const RoundAngles<Two> angles{at[0], at[1]};
  const auto p = chart.doubles().point(angles);
  const Two off = from_.off + side, value = chart.doubles().value(angles, p);
  std::memcpy(points.off.data(), &off, sizeof off);
  std::memcpy(points.value.data(), &value, sizeof value);
  const std::array<Two, 3> position = chart.doubles().position(angles, p);
  for (std::size_t k = 0; k < 3; ++k) std::memcpy(points.at[k].data(), &position[k], sizeof position[k]);
}

BoundedVertex RoundPart::vertex(double s, const Points& points, std::size_t i) const {
  const double off = points.off[i], side = off - from_.off;
  const double error = (std::fabs(points.value[i]) + value_error_) / tube_.least * kSlack;
  const bool is_near = std::fabs(length_) <= kLongestPart && std::fabs(side) <= kLongestPart;
  if (!(error <= wanted_ && is_inside(tube_, s, off) && is_near))
    return round_vertex(tube_, near_curve(tube_, s, off, wanted_));
  return bounded({points.at[0][i], points.at[1][i], points.at[2][i]}, position_error_, error, tube_);
}

void RoundPart::add_vertices(int count, ArcPolyline& line) const {
  Points points;
  for (int first = 1; first < count; first += kLanes) {
    Pair part;
    for (std::size_t i = 0; i < kLanes; ++i)
      part[i] = static_cast<double>(first + static_cast<int>(i)) / count;
    evaluate(part, points);
    const int here = std::min(static_cast<int>(kLanes), count - first);
    for (std::size_t i = 0; i < static_cast<std::size_t>(here); ++i)
      line.add_vertex(vertex(s_ + length_ * part[i], points, i));
  }
}

}  // namespace exsect

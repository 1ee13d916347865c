#include "overlap/two_piece_landmarks.h"

#include <algorithm>

#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "self/near_cusps.h"
#include "shape/coincident_parameters.h"
#include "trace/enclose.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

/// The parameter (u or v) that is constant on the folded line through the cuspidal point.
template <class Ball>
std::size_t fixed_along(const CuspArc<Ball>& cusp) {
  return cusp.chart == Chart::first ? 1 : 0;
}

}  // namespace

template <class Ball>
void TwoPieceLandmarks<Ball>::run() {
  add_cusps();
  for (const CertifiedPoint& point : boundary_) {
    found_.landmarks.push_back(enclose<Ball>(point, width_));
  }
  found_.boundary_points = boundary_.size();
  for (const BallPoint<Ball>& gate : found_.near.landmarks) {
    found_.landmarks.push_back(from_common_(gate));
  }
  for (const CertifiedPoint& point : side_ends_) {
    found_.landmarks.push_back(enclose<Ball>(point, width_));
  }
  for (const CuspArc<Ball>& cusp : found_.near.leaving) {
    for (const int order : {1, -1}) {
      if (enters(cusp, order)) {
        add_side_gate(cusp, order);
      }
    }
  }
}

template <class Ball>
void TwoPieceLandmarks<Ball>::problem(const ParameterBox& where, const std::string& why) {
  found_.problems.push_back(left_open(where, why, stop_));
}

template <class Ball>
void TwoPieceLandmarks<Ball>::add_cusps() {
  const BezierPatch patch = pieces_.shared();
  ExactPlaces exact{};
  exact.cusps = special_cusps(patch);
  exact.coincident = coincident_parameters(patch, patch);
  found_.near = trace_near_cusps(shared_, exact, width_, stop_);
  for (const Incomplete& near : found_.near.problems) {
    ParameterBox where;
    for (std::size_t j = 0; j < 4; ++j) {
      where[j] = from_common_(near.where[j], j);
    }
    problem(where, near.why);
  }
}

/// A curve that leaves the common rectangle at once in one order, and enters the domain in the other: known
/// if it is the folded line along a side.
template <class Ball>
void TwoPieceLandmarks<Ball>::add_side_gate(const CuspArc<Ball>& cusp, int order) {
  if (cusp.place.folded && cusp.place.side[1]) {
    const auto at = point_at(cusp.tube, cusp.gate_w - cusp.tube.centre[3].approximation());
    const BallPoint<Ball> pair = pair_of(cusp.chart, at);
    side_gates_.push_back({found_.landmarks.size(), order, fixed_along(cusp)});
    found_.landmarks.push_back(from_common_(order > 0 ? pair : exchanged_pair(pair)));
    return;
  }
  std::array<double, 4> at = {cusp.cusp[0].approximation(), cusp.cusp[1].approximation(), 0, 0};
  if (cusp.chart == Chart::second) {
    std::swap(at[0], at[1]);
  }
  problem(around(from_common_({at[0], at[1], at[0], at[1]})), "a cuspidal point on a side");
}

/// The curve from a cuspidal point on a side of the common rectangle may enter the domain with order * (t,
/// m t) added in the first piece and taken away in the second one.
template <class Ball>
bool TwoPieceLandmarks<Ball>::enters(const CuspArc<Ball>& cusp, int order) const {
  for (std::size_t j = 0; j < 2; ++j) {
    const std::size_t k = cusp.chart == Chart::first ? j : 1 - j;  // u or v
    if (cusp.across[j] == 0) {
      continue;
    }
    const int side = *cusp.place.side[j];
    const int outward = side == 0 ? -1 : 1;
    const Rational value = pieces_.common[k](side);
    const Rational in_second = quotient(pieces_.copy.maps[k], {value, 1}).offset;
    const bool of_first = value == 0 || value == 1;
    const bool of_second = in_second == 0 || in_second == 1;
    if ((of_first && order * cusp.across[j] == outward) ||
        (of_second && -order * cusp.across[j] == outward)) {
      return false;
    }
  }
  return true;
}

template <class Ball>
std::optional<int> TwoPieceLandmarks<Ball>::direction_at(std::size_t landmark) const {
  const BallPoint<Ball> tangent = Expansion<Ball>(system_, found_.landmarks[landmark]).tangent();
  if (const SideGate* gate = side_gate(static_cast<int>(landmark))) {
    const int sign = tangent[1 - gate->fixed].certain_sign();  // u (v) grows in the order +1
    return sign == 0 ? std::nullopt : std::optional(gate->order * sign);
  }
  if (landmark >= boundary_.size()) {
    const auto gate = found_.near.gate(static_cast<int>(landmark - boundary_.size()));
    const ChartTrace<Ball>& trace = found_.near.chart_traces[gate->trace];
    for (std::size_t j = 0; j < 2; ++j) {  // u and v grow with the parameters of the charts
      const int along = trace.direction[gate->exchanged ? j + 2 : j];
      if (along != 0 && tangent[j].certain_sign() != 0) {
        return along * tangent[j].certain_sign();
      }
    }
    return std::nullopt;
  }
  return direction_from_boundary(landmark, tangent);
}

template <class Ball>
std::optional<int> TwoPieceLandmarks<Ball>::direction_from_boundary(std::size_t landmark,
                                                                    const BallPoint<Ball>& tangent) const {
  int direction = 0;
  bool entering = true;
  for (const Side& side : boundary_[landmark].sides()) {
    const int sign = tangent[index(side.parameter)].certain_sign();
    if (sign == 0) {
      return std::nullopt;
    }
    const int inward = side.value == 0 ? sign : -sign;
    entering = entering && (direction == 0 || direction == inward);
    direction = inward;
  }
  return entering ? direction : 0;
}

template <class Ball>
bool TwoPieceLandmarks<Ball>::is_side_end(std::size_t landmark) const {
  const std::size_t first = boundary_.size() + found_.near.landmarks.size();
  return landmark >= first && landmark < first + side_ends_.size();
}

template <class Ball>
std::optional<typename TwoPieceLandmarks<Ball>::AlongLine> TwoPieceLandmarks<Ball>::along_line(
    const Trace<Ball>& trace) const {
  for (const int end : {trace.start, trace.end}) {
    if (const SideGate* gate = side_gate(end)) {
      return AlongLine{gate->fixed, true};
    }
    const int first = static_cast<int>(boundary_.size());
    if (end < first || is_side_end(static_cast<std::size_t>(end))) {
      continue;
    }
    const ChartTrace<Ball>& from = found_.near.chart_traces[found_.near.gate(end - first)->trace];
    const CuspArc<Ball>& cusp = found_.near.cusps[static_cast<std::size_t>(from.start)];
    if (cusp.place.folded) {
      return AlongLine{fixed_along(cusp), cusp.place.side[1].has_value()};
    }
  }
  return std::nullopt;
}

template <class Ball>
const typename TwoPieceLandmarks<Ball>::SideGate* TwoPieceLandmarks<Ball>::side_gate(int landmark) const {
  const auto gate = std::find_if(side_gates_.begin(), side_gates_.end(),
                                 [&](const SideGate& g) { return static_cast<int>(g.landmark) == landmark; });
  return gate == side_gates_.end() ? nullptr : &*gate;
}

template class TwoPieceLandmarks<DoubleBall>;
template class TwoPieceLandmarks<ArbBall<256>>;

}  // namespace exsect

#include "self/directions.h"

#include <algorithm>

#include "self/folds.h"

namespace exsect {

template <class Ball>
LeavingDirections SelfDirections<Ball>::entering(std::size_t landmark) const {
  const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, found_.landmarks[landmark]).tangent();
  LeavingDirections result;
  for (const Side& side : boundary_.points[landmark].sides()) {
    const int sign = tangent[index(side.parameter)].certain_sign();
    if (sign != 0) {
      std::erase(result.signs, side.value == 0 ? -sign : sign);
      continue;
    }
    const std::size_t j = index(side.parameter);
    const int bend = bend_sign(system_.pair, found_.landmarks[landmark], j);
    if (bend == 0 || signs_at(static_cast<int>(landmark))[j] != 0) {
      result.certain = false;
    } else if ((bend > 0) != (side.value == 0)) {
      result.signs.clear();
    }
  }
  return result;
}

/// The direction of the tangent field in which the trace in the charts goes on at its gate; 0: unknown.
template <class Ball>
int SelfDirections<Ball>::leaving(const ChartTrace<Ball>& trace) const {
  const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, trace.gate).tangent();
  for (std::size_t j = 0; j < 4; ++j) {
    const int sign = trace.direction[j] * tangent[j].certain_sign();
    if (sign != 0) {
      return sign;
    }
  }
  return 0;
}

/// Away from the centre of the star.
template <class Ball>
LeavingDirections SelfDirections<Ball>::outward(std::size_t landmark) const {
  const auto& [star, number, exchanged] = *found_.port(static_cast<int>(landmark));
  const Port& port = exact_.stars[star].star.ports[number];
  const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, found_.landmarks[landmark]).tangent();
  const int sign = tangent[(index(port.across) + (exchanged ? 2 : 0)) % 4].certain_sign();
  return sign == 0 ? LeavingDirections{{1, -1}, false} : LeavingDirections{{sign * port.side}, true};
}

template <class Ball>
LeavingDirections SelfDirections<Ball>::at(std::size_t i) const {
  if (is_boundary(i)) {
    return entering(i);
  }
  if (found_.port(static_cast<int>(i)) != nullptr) {
    return outward(i);
  }
  const int direction = leaving(found_.chart_traces[found_.gate(static_cast<int>(i))->trace]);
  return direction == 0 ? LeavingDirections{{1, -1}, false} : LeavingDirections{{direction}, true};
}

template <class Ball>
TangentSigns SelfDirections<Ball>::signs_at(int landmark) const {
  if (landmark < 0) {
    return {};
  }
  const auto i = static_cast<std::size_t>(landmark);
  return tangent_signs(system_.pair, found_.landmarks[i], [&] {
    return is_boundary(i) ? exact_.zero_tangent(boundary_.points[i]) : std::array<bool, 4>{};
  });
}

template <class Ball>
std::size_t SelfDirections<Ball>::mate(std::size_t landmark) const {
  const std::size_t n = boundary_.points.size();
  return landmark < n ? boundary_.mate[landmark] : n + ((landmark - n) ^ 1U);
}

template <class Ball>
void SelfDirections<Ball>::start() {
  used_.assign(found_.landmarks.size(), {});
  for (const MultipleFold& fold : exact_.folds) use_ends(fold);
}

template <class Ball>
void SelfDirections<Ball>::use_ends(const MultipleFold& fold) {
  const auto use_both = [this](std::size_t landmark) {
    for (const int sign : {1, -1}) use(landmark, sign);
  };
  if (fold.end) use_both(*fold.end);
  for (std::size_t i = 0; i < found_.ports.size(); ++i) {
    const auto& port = found_.ports[i];
    if (lies_on(fold, exact_.stars[port.star], port.port)) use_both(found_.boundary_points + i);
  }
}

template <class Ball>
void SelfDirections<Ball>::use(std::size_t landmark, int sign) {
  used_[landmark].push_back(sign);
  used_[mate(landmark)].push_back(-sign);
}

template class SelfDirections<DoubleBall>;
template class SelfDirections<ArbBall<256>>;

}  // namespace exsect

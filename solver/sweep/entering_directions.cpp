#include "sweep/entering_directions.h"

#include "line/known_tangent.h"
#include "trace/landmark_tangent.h"

namespace exsect {

template <class Ball>
TangentSigns tangent_signs_at(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                              const SweepData& sweep, int landmark) {
  if (landmark < 0) {
    return {};
  }
  const auto i = static_cast<std::size_t>(landmark);
  return tangent_signs(system, landmarks[i], [&] {
    return known_zero_tangent(sweep.pair.x(), sweep.pair.y(), sweep.landmarks[i].point);
  });
}

namespace {

/// Where the curve is tangent to the side, exactly, its second derivative says whether it lies inside.
template <class Ball>
std::optional<bool> bends_inwards(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                                  const SweepData& sweep, std::size_t landmark, const Side& side) {
  const std::size_t j = index(side.parameter);
  const int bend = bend_sign(system, landmarks[landmark], j);
  if (bend == 0 || tangent_signs_at(system, landmarks, sweep, static_cast<int>(landmark))[j] != 0) {
    return std::nullopt;
  }
  return (bend > 0) == (side.value == 0);
}

}  // namespace

template <class Ball>
std::optional<std::vector<int>> entering_directions(const PairSystem<Ball>& system,
                                                    const Landmarks<Ball>& landmarks, const SweepData& sweep,
                                                    std::size_t landmark) {
  const LandmarkPoint& at = sweep.landmarks[landmark];
  const BallPoint<Ball> tangent = Expansion<Ball>(system, landmarks[landmark]).tangent();
  if (at.side != 0) {
    const int sign = tangent[index(at.across)].certain_sign();
    return sign == 0 ? std::nullopt : std::optional(std::vector{at.side * sign});
  }
  std::vector<int> directions = {1, -1};
  std::vector<Side> tangential;
  for (const Side& side : at.point.sides()) {
    const int sign = tangent[index(side.parameter)].certain_sign();
    if (sign == 0) {
      tangential.push_back(side);
    } else {
      std::erase(directions, side.value == 0 ? -sign : sign);
    }
  }
  for (const Side& side : tangential) {
    const std::optional<bool> inside =
        directions.empty() ? false : bends_inwards(system, landmarks, sweep, landmark, side);
    if (!inside) {
      return std::nullopt;
    }
    if (!*inside) {
      directions.clear();
    }
  }
  return directions;
}

#define EXSECT_INSTANTIATE_DIRECTIONS(Ball)                                                                 \
  template TangentSigns tangent_signs_at(const PairSystem<Ball>&, const Landmarks<Ball>&, const SweepData&, \
                                         int);                                                              \
  template std::optional<std::vector<int>> entering_directions(                                             \
      const PairSystem<Ball>&, const Landmarks<Ball>&, const SweepData&, std::size_t);

EXSECT_INSTANTIATE_DIRECTIONS(DoubleBall)
EXSECT_INSTANTIATE_DIRECTIONS(DoubleDoubleBall)
EXSECT_INSTANTIATE_DIRECTIONS(ArbBall<256>)
EXSECT_INSTANTIATE_DIRECTIONS(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_DIRECTIONS

}  // namespace exsect

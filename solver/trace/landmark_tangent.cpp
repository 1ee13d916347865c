#include "trace/landmark_tangent.h"

#include <algorithm>
#include <cmath>

#include "trace/tube_points.h"

namespace exsect {

template <class Ball>
TangentSigns tangent_signs(const PairSystem<Ball>& system, const BallPoint<Ball>& at,
                           const std::function<std::array<bool, 4>()>& zero) {
  const BallPoint<Ball> tangent = Expansion<Ball>(system, at).tangent();
  const bool unknown =
      std::any_of(tangent.begin(), tangent.end(), [](const Ball& t) { return t.certain_sign() == 0; });
  const std::array<bool, 4> vanishes = unknown && zero ? zero() : std::array<bool, 4>{};
  TangentSigns signs{};
  for (std::size_t j = 0; j < 4; ++j) {
    const int sign = tangent[j].certain_sign();
    signs[j] = vanishes[j] ? std::optional(0) : sign != 0 ? std::optional(sign) : std::nullopt;
  }
  return signs;
}

template <class Ball>
int bend_sign(const PairSystem<Ball>& system, const BallPoint<Ball>& at, std::size_t j) {
  const BallPoint<Ball> tangent = Expansion<Ball>(system, at).tangent();
  const std::size_t axis = steepest_axis(tangent);
  const auto tube = certify_tube(system, at, axis, 0x1p-30, 0x1p-40);
  if (axis == j || !tube || !contains(*tube, at) || !(std::fabs(tube->second[j]) > tube->second_error[j])) {
    return 0;
  }
  return tube->second[j] > 0 ? 1 : -1;
}

template <class Ball>
int arriving_direction(const Trace<Ball>& trace) {
  const Piece<Ball>& end = trace.pieces.back();
  return -end.tube.orientation * end.range.direction();
}

#define EXSECT_INSTANTIATE_TANGENT(Ball)                                                \
  template TangentSigns tangent_signs(const PairSystem<Ball>&, const BallPoint<Ball>&,  \
                                      const std::function<std::array<bool, 4>()>&);     \
  template int bend_sign(const PairSystem<Ball>&, const BallPoint<Ball>&, std::size_t); \
  template int arriving_direction(const Trace<Ball>&);

EXSECT_INSTANTIATE_TANGENT(DoubleBall)
EXSECT_INSTANTIATE_TANGENT(DoubleDoubleBall)
EXSECT_INSTANTIATE_TANGENT(ArbBall<256>)
EXSECT_INSTANTIATE_TANGENT(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TANGENT

}  // namespace exsect

#include "trace/bounded_vertex.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect {

template <class Ball>
BoundedVertex bounded_position(const BallVector<Ball>& position, const ModelFrame& frame) {
  BoundedVertex result{};
  std::array<double, 3> radius{};
  double rounding = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double scaled = position[c].approximation();
    radius[c] = std::ldexp((position[c] - Ball(scaled)).upper_magnitude(), static_cast<int>(frame.exponent));
    result.vertex.point[c] = frame.origin[c] + std::ldexp(scaled, static_cast<int>(frame.exponent));
    rounding += std::fabs(result.vertex.point[c]) * 2 * kUnitRoundoff;  // one sum of doubles
  }
  result.error = (length_bound(radius[0], radius[1], radius[2]) + rounding) * kSlack + kUnderflowLoss;
  return result;
}

template <class Ball>
BoundedVertex bounded_vertex(const BallPoint<Ball>& parameters, const BallVector<Ball>& position,
                             const ModelFrame& frame) {
  BoundedVertex result = bounded_position(position, frame);
  for (std::size_t j = 0; j < 4; ++j) {
    result.vertex.parameters[j] = std::clamp(parameters[j].approximation(), 0.0, 1.0);
  }
  return result;
}

template <class Ball>
double chord_bound(const PairSystem<Ball>& system, const ModelFrame& frame, const ParameterBox& box) {
  // About the middle of the box, so that it does not matter which parameter is inserted first.
  BallPoint<Ball> middle;
  std::array<double, 2> half{};
  for (std::size_t j = 0; j < 2; ++j) {
    const Ball range = Ball::enclosing(box[j]);
    middle[j] = range.midpoint();
    half[j] = range.radius();
  }
  const TaylorNet<Ball> x = system.taylor_x(middle);
  const std::array<double, 3> u = {1, half[0], half[0] * half[0]};
  const std::array<double, 3> v = {1, half[1], half[1] * half[1]};
  std::array<double, 3> radius{};
  double rounding = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    radius[c] = x[0][c].radius();
    for (std::size_t i = 1; i < 9; ++i) {
      radius[c] += x[i][c].upper_magnitude() * u[i / 3] * v[i % 3];
    }
    const double largest =
        std::ldexp(x[0][c].upper_magnitude() + radius[c], static_cast<int>(frame.exponent));
    rounding += (std::fabs(frame.origin[c]) + largest) * 8 * kUnitRoundoff;
  }
  // The ball's diameter, once more its radius for the vertices, which are in the ball up to rounding.
  return std::ldexp(3 * length_bound(radius[0], radius[1], radius[2]), static_cast<int>(frame.exponent)) *
             kSlack +
         rounding + kUnderflowLoss;
}

#define EXSECT_INSTANTIATE_BOUNDED_VERTEX(Ball)                                                              \
  template BoundedVertex bounded_position(const BallVector<Ball>&, const ModelFrame&);                       \
  template BoundedVertex bounded_vertex(const BallPoint<Ball>&, const BallVector<Ball>&, const ModelFrame&); \
  template double chord_bound(const PairSystem<Ball>&, const ModelFrame&, const ParameterBox&);

EXSECT_INSTANTIATE_BOUNDED_VERTEX(DoubleBall)
EXSECT_INSTANTIATE_BOUNDED_VERTEX(DoubleDoubleBall)
EXSECT_INSTANTIATE_BOUNDED_VERTEX(ArbBall<256>)
EXSECT_INSTANTIATE_BOUNDED_VERTEX(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_BOUNDED_VERTEX

}  // namespace exsect

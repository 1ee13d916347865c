#include "trace/landmark_node.h"

#include <cmath>

namespace exsect {

template <class Ball>
Node landmark_node(const PairSystem<Ball>& system, const ModelFrame& frame, const BallPoint<Ball>& ball,
                   const ParameterBox& box, const std::vector<Side>& sides) {
  Node node{};
  if (!sides.empty()) {
    node.kinds = {NodeKind::boundary};
  }
  std::size_t on_first = 0;
  for (const Side& side : sides) {
    on_first += index(side.parameter) < 2 ? 1 : 0;
  }
  if (on_first == 2 || sides.size() - on_first == 2) {
    node.kinds.push_back(NodeKind::corner);
  }
  node.on = sides;
  node.box = box;
  const TaylorNet<Ball> x = system.taylor_x(ball);
  for (std::size_t j = 0; j < 4; ++j) {
    node.approx[j] = to_double(box[j].midpoint());
  }
  for (std::size_t c = 0; c < 3; ++c) {
    node.point[c] = frame.origin[c] + std::ldexp(x[0][c].approximation(), static_cast<int>(frame.exponent));
  }
  return node;
}

#define EXSECT_INSTANTIATE_LANDMARK_NODE(Ball)                                                    \
  template Node landmark_node(const PairSystem<Ball>&, const ModelFrame&, const BallPoint<Ball>&, \
                              const ParameterBox&, const std::vector<Side>&);

EXSECT_INSTANTIATE_LANDMARK_NODE(DoubleBall)
EXSECT_INSTANTIATE_LANDMARK_NODE(DoubleDoubleBall)
EXSECT_INSTANTIATE_LANDMARK_NODE(ArbBall<256>)
EXSECT_INSTANTIATE_LANDMARK_NODE(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_LANDMARK_NODE

}  // namespace exsect

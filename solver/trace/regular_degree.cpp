#include "trace/regular_degree.h"

#include <algorithm>

#include "answer/model_scale.h"

namespace exsect {

namespace {

PairSystem<DoubleBall> scaled_system(const BezierPatch& x, const BezierPatch& y) {
  const ModelScale scale = model_scale(x, y);
  return {x, y, scale.origin, scale.frame.exponent};
}

}  // namespace

RegularDegree::RegularDegree(const BezierPatch& x, const BezierPatch& y) : system_(scaled_system(x, y)) {}

std::optional<int> RegularDegree::operator()(const Node& node) const {
  if (!node.free.empty()) return std::nullopt;
  BallPoint<DoubleBall> at;
  for (std::size_t i = 0; i < 4; ++i) at[i] = DoubleBall::enclosing(node.box[i]);
  const BallPoint<DoubleBall> tangent = Expansion<DoubleBall>(system_, at).tangent();
  if (std::none_of(tangent.begin(), tangent.end(), [](const DoubleBall& t) { return t.certain_sign() != 0; }))
    return std::nullopt;
  if (node.on.empty()) return 2;
  bool enters = false;
  bool leaves = false;
  for (const Side& side : node.on) {
    const int sign = tangent[index(side.parameter)].certain_sign();
    if (sign == 0) return std::nullopt;
    if ((sign > 0) == (side.value == 0))
      enters = true;
    else
      leaves = true;
  }
  return enters && leaves ? 0 : 1;
}

}  // namespace exsect

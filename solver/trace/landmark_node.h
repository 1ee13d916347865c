// The node of a point that is known by its box. Internal to solver/.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <vector>

#include "answer/model_scale.h"
#include "trace/pair_system.h"

namespace exsect {

/// The node of a point on the given sides (none: inside); `box` encloses its parameters.
template <class Ball>
Node landmark_node(const PairSystem<Ball>& system, const ModelFrame& frame, const BallPoint<Ball>& ball,
                   const ParameterBox& box, const std::vector<Side>& sides);

}  // namespace exsect

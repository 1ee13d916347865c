// Sides of two patches that are the same point of space. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/result.h>

#include <vector>

#include "answer/certified_point.h"

namespace exsect {

/// A side of x and a side of y, both mapped to one point: all pairs of their points are solutions, a square
/// of them.
struct CommonPole {
  Side of_x;
  Side of_y;
};

std::vector<CommonPole> common_poles(const BezierPatch& x, const BezierPatch& y);

/// Both parameter points are on the sides.
bool is_on(const CertifiedPoint& point, const CommonPole& pole);

/// The pair of the points at these values along the two sides, 0 <= along_x, along_y <= 1.
CertifiedPoint pair_on(const CommonPole& pole, const Rational& along_x, const Rational& along_y);

/// The node of the pole, with two free parameters; `at_inside` is that of a pair of inner points of the
/// sides.
Node pole_node(const CommonPole& pole, const CertifiedPoint& inside, const Node& at_inside);

}  // namespace exsect

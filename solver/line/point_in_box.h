// Points of a parameter line that are known by a box, and exactly when somebody asks.
#pragma once

#include <exsect/solver/line_query.h>

#include <memory>
#include <vector>

namespace exsect {

/// The question, kept for refining the points of its answer.
struct LineProblem {
  BezierPatch x;
  BezierPatch y;
  LineQuery query;
};

/// The only point of the line in the box, where line and patch cross transversally, on no side but that of
/// the line. Anything that the box does not tell comes from exact_line_points.
CertifiedPoint point_in_box(const std::shared_ptr<const LineProblem>& problem, const ParameterBox& box);

}  // namespace exsect

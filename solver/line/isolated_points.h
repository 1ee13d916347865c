// Isolated points of a part of a plane curve. Internal to solver/.
#pragma once

#include <functional>
#include <vector>

#include "line/line_curve.h"

namespace exsect {

/// A closed part of a curve in [0,1]^2: along the curve, `contains` changes only where one of the borders
/// vanishes, or at singular points of the curve.
struct CurvePart {
  std::vector<BivariatePolynomial> borders;
  std::function<bool(const TriangularPoint&)> contains;
};

/// The isolated points of the part of the curve f = 0, f squarefree.
std::vector<IsolatedPoint> isolated_points(const BivariatePolynomial& f, const CurvePart& part);

}  // namespace exsect

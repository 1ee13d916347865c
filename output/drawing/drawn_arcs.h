// Arcs of plane algebraic curves as polylines for pictures.
#pragma once

#include <exsect/solver/curve_arcs.h>

#include <vector>

#include "output/drawing/plane_curve.h"

namespace exsect::cli {

/// One polyline for each arc of curve_arcs(f): points of f = 0 rounded to doubles, u to the right.
std::vector<PlanePolyline> drawn_arcs(const BivariatePolynomial& f, const CurveArcs& curve);

}  // namespace exsect::cli

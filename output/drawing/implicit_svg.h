// Pictures of planar curves and their implicit functions.
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/planar_function.h>
#include <exsect/implicit/implicitize_curve.h>

#include <string>
#include <vector>

#include "output/drawing/svg_legend.h"
#include "output/drawing/svg_plane.h"

namespace exsect::cli {

/// f in doubles, nothing finite where it is not defined.
std::function<double(PlanePoint)> drawn_function(const PlanarFunction& f);

/// A planar curve as a polyline.
PlanePolyline drawn_curve(const BezierCurve& curve);

/// The zero set of f in the view: what follows the curve within `near`, and what does not.
struct DrawnZeroSet {
  std::vector<PlanePolyline> following;
  std::vector<PlanePolyline> further;
};
DrawnZeroSet drawn_zero_set(const PlanarFunction& f, const PlanePolyline& curve, double near,
                            const PlaneView& view);

/// The curve, the zero set along it, and further branches, over the box of the result.
std::string planar_implicit_svg(const PlanarImplicit& implicit, const BezierCurve& curve,
                                const std::string& subtitle, const std::vector<std::string>& variables,
                                const std::string& title);

/// The same for two curves side by side: the projections of a curve of space.
std::string planar_pair_svg(const PlanarImplicit& f, const BezierCurve& curve_f,
                            const std::vector<std::string>& variables_f, const PlanarImplicit& g,
                            const BezierCurve& curve_g, const std::vector<std::string>& variables_g,
                            const std::string& title);

}  // namespace exsect::cli

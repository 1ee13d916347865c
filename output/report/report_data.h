// The parts that the data of report pages have in common: the result as JSON, and what is drawn of it in
// doubles.
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_patch.h>

#include "output/report/report_html.h"

namespace exsect::cli {

/// {"command": .., "program": "exsect 0.1.0", "title": .., "file": .., "line": the command line, "inputs":
/// [{"file": .., "sha256": ..}], "result": ..}; the page of a command
/// shows what else is added.
Json report_data(const std::string& command, const ReportOrigin& origin, Json result);

/// {"name": .., "net": exact control points, "points": the same in doubles}; with weights also "weights",
/// exact, and as fourth coordinates of "points".
Json patch_data(const std::string& name, const RationalPatch& patch);

/// Of a surface given by its equation {"name": .., "kind": .., "terms": exact ones, "mesh": {"points": ..,
/// "faces": ..}}, sampled as far as `around` reaches, without a mesh where that cannot be.
Json equation_data(const std::string& name, const ImplicitSurface& surface, const SpacePoints& around);
/// Points of the patch, in doubles, for the surface beside it to be sampled around.
SpacePoints points_of(const RationalPatch& x);
/// Both surfaces, sampled as far as what is drawn reaches.
Json equations_data(const DrawnSurfaces& drawn);

/// {"result": the line as `exsect line` gives it, "forms": the pulled-back forms in doubles, "phantoms":
/// [..]}. Forms are lists of rows, power of r, of coefficients by the power of s, scaled so that the largest
/// of plane and the largest of u, l, m is 1. Phantoms are the real roots of the eliminant in [0,1] that
/// belong to no point. Exact polynomials of more than 8000 characters are left out of the result:
/// "polynomials" is then false.
Json fibre_data(const LineIntersection& line, const RationalPatch& x);

/// The page of the data, with a picture, an SVG document, that is seen without a script; or none.
std::string page_of(const Json& data, const std::string& picture);

}  // namespace exsect::cli

// Results as self-contained web pages: `--report` of the program, and for any other caller. Needs neither the
// program nor its options; link exsect_report.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_patch.h>
#include <exsect/solver/result.h>

#include <string>

#include "output/drawing/surfaces_scene.h"
#include "output/report/report_origin.h"
#include "output/text/intersection_json.h"

namespace exsect::cli {

/// The page of an intersection x(u,v) = y(r,s): both patches and the curve in space, both parameter squares,
/// the tables of nodes and arcs, the exact fibres of the lines u = 0, 1/40, ..., 1 (each as `exsect line`
/// gives it; only of polynomial patches of bidegree at most (2,2)), and what is proved. Holds the whole
/// "intersection/1" result. Deterministic but for the result's "work". Everything drawn is in doubles and
/// decides nothing.
std::string report_html(const IntersectResult& result, const RationalPatch& x, const RationalPatch& y,
                        const PatchNames& names, const ReportOrigin& origin);

/// The page of the intersection of a patch with a surface given by its equation: both in space (the surface
/// as output/drawing/sampled_equation.h samples it, whole where it is in a box), the curve, the parameter
/// square, the tables, and the whole "intersection/1" result. `names.second` is the surface.
std::string equation_report_html(const IntersectResult& result, const RationalPatch& x,
                                 const ImplicitSurface& surface, const PatchNames& names,
                                 const ReportOrigin& origin);

/// The page of the intersection of two surfaces given by their equations: both in space, the curves, which
/// stand in the place of components, the tables, and the whole "surfaces/1" result with the natural
/// parameters of its nodes. Throws BeyondDoubles.
std::string surfaces_report_html(const DrawnSurfaces& drawn, const ReportOrigin& origin);

/// The page of the self-intersection of x, with the whole "self/1" result. Its lines have no fibres: a line
/// of x lies on x.
std::string self_report_html(const IntersectResult& result, const RationalPatch& x, const std::string& name,
                             const ReportOrigin& origin);

/// The page of one parameter line against the other patch, with the whole "line/1" result.
std::string line_report_html(const LineIntersection& line, const RationalPatch& x, const RationalPatch& y,
                             const PatchNames& names, const ReportOrigin& origin);

}  // namespace exsect::cli

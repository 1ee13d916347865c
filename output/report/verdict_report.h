// A verdict on a candidate as a web page.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/verify/verify.h>

#include <string>

#include "output/report/report_html.h"

namespace exsect::cli {

/// The page of a verdict, with the whole "verdict/1" result and the exact intersection as "intersection/1";
/// differences are marked in space and in the squares.
std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                                const ReportOrigin& origin);
/// The same of a patch and a surface given by its equation, `names.second`.
std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const RationalPatch& x, const ImplicitSurface& surface,
                                const PatchNames& names, const ReportOrigin& origin);
/// The same of two surfaces given by their equations, with the exact intersection as "surfaces/1" and its
/// connected parts as components. Throws BeyondDoubles.
std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const DrawnSurfaces& drawn, const ReportOrigin& origin);

}  // namespace exsect::cli

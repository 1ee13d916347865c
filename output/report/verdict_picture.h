// A verdict on a candidate as a picture and as a web page.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/verify/verify.h>

#include <string>

#include "output/report/report_html.h"

namespace exsect::cli {

/// The parameter squares of the exact intersection with what the verdict says: gaps in thick light strokes,
/// the candidate's curves dashed where it states parameters, spurious parts and wrong points in red.
std::string verdict_svg(const Verification& verification, const Candidate& candidate, const PatchNames& names,
                        const std::string& title);

/// The page of a verdict, with the whole "verdict/1" result and the exact intersection as "intersection/1";
/// differences are marked in space and in the squares.
std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                                const ReportOrigin& origin);

}  // namespace exsect::cli

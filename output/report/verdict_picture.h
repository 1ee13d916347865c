// A verdict on a candidate as a picture.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/verify/verify.h>

#include <string>

#include "output/drawing/surfaces_scene.h"
#include "output/text/intersection_json.h"

namespace exsect::cli {

/// The parameter squares of the exact intersection with what the verdict says: gaps in thick light strokes,
/// the candidate's curves dashed where it states parameters, spurious parts and wrong points in red.
std::string verdict_svg(const Verification& verification, const Candidate& candidate, const PatchNames& names,
                        const std::string& title);
/// The same of two surfaces given by their equations, in space. Throws BeyondDoubles.
std::string verdict_svg(const Verification& verification, const Candidate& candidate,
                        const DrawnSurfaces& drawn, const std::string& title);

}  // namespace exsect::cli

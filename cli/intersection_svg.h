// Both parameter domains of an intersection as a picture, like Fig. 9.7 of the chapter.
#pragma once

#include <exsect/solver/result.h>

#include <string>

#include "intersection_json.h"

namespace exsect::cli {

/// The squares (u,v) and (r,s) side by side: arcs coloured by component, nodes marked by kind, undecided
/// regions in grey, and a legend. Polylines are simplified to `drawing_tolerance`.
std::string intersection_svg(const IntersectResult& result, const PatchNames& names,
                             const std::string& title);

}  // namespace exsect::cli

// Both parameter domains of an intersection as a picture, like Fig. 9.7 of the chapter.
#pragma once

#include <exsect/solver/result.h>

#include <string>

#include "output/drawing/plane_curve.h"
#include "output/drawing/svg_picture.h"
#include "output/text/intersection_json.h"

namespace exsect::cli {

/// The squares (u,v) and (r,s) side by side: arcs coloured by component, nodes marked by kind, undecided
/// regions in grey, and a legend; the square (u,v) alone beside a surface given by its equation. Polylines
/// are simplified to `drawing_tolerance`.
std::string intersection_svg(const IntersectResult& result, const PatchNames& names,
                             const std::string& title);

/// What is drawn besides the result, in square 0 or 1, below the arcs or above everything; and its legend.
struct SquareAdditions {
  struct Line {
    std::size_t square;
    PlanePolyline points;
    Stroke stroke;
  };
  struct Place {
    std::size_t square;
    PlanePoint at;
  };
  std::vector<Line> below;
  std::vector<Line> above;
  std::vector<Place> marks;  // red crosses
  std::vector<std::pair<Stroke, std::string>> legend;
};
std::string intersection_svg(const IntersectResult& result, const PatchNames& names, const std::string& title,
                             const SquareAdditions& additions);

}  // namespace exsect::cli

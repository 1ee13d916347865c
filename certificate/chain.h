// Arcs of curves as chains of tubes, in doubles: nothing here proves anything, as in search.h.
#pragma once

#include <optional>
#include <vector>

#include "certificate/search.h"

namespace exsect::cli {

struct TracedPoint {
  Parameters at;
  int vertex;                       // of the polyline, or -1
  std::optional<Place> exact = {};  // where doubles are too short
};
struct TracedPiece {
  std::size_t tube;
  std::size_t last;
};
/// An arc as a chain of tubes, from the tube of its first node to that of its last one.
struct TracedArc {
  std::vector<TracedPoint> points;
  std::vector<TracedPiece> pieces;
};
/// Adds the tubes it needs. `points`: the polyline's vertices, the first and the last one in the tubes given.
TracedArc chain(const Equation& equation, const std::vector<TracedPoint>& points, std::size_t first_tube,
                std::size_t last_tube, std::vector<Tube>& tubes);

}  // namespace exsect::cli

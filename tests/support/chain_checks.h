// Checks of the chains of overlaps.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <cstddef>
#include <vector>

namespace exsect {

/// Even-odd rule in the (u,v) square.
inline bool inside(const std::vector<Arc>& chain, double u, double v) {
  bool odd = false;
  for (const Arc& arc : chain)
    for (std::size_t k = 1; k < arc.polyline.size(); ++k) {
      const auto& a = arc.polyline[k - 1].parameters;
      const auto& b = arc.polyline[k].parameters;
      if ((a[1] > v) != (b[1] > v) && u < a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) odd = !odd;
    }
  return odd;
}

}  // namespace exsect

// Overlaps in certificates: regions where both patches are one surface.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include "certificate/events.h"
#include "certificate/factor.h"
#include "output/text/json_forms.h"

namespace exsect::cli {

struct FoundOverlap {
  int factor;  // of its plane
  Json edges;
};

/// The overlap on its plane. Throws NoCertificate if it is no polygon of a plane in
/// [0,1]^4, with short rational corners.
FoundOverlap overlap_at(Factors& factors, const IntersectionGraph& graph, const Overlap& overlap);

}  // namespace exsect::cli

// Overlaps in certificates: regions where both patches are one surface.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include "certificate_events.h"
#include "certificate_seam.h"
#include "json_forms.h"

namespace exsect::cli {

struct FoundOverlap {
  FoundSeam seam;
  Json edges;
};

/// The overlap with the seam around its plane. Throws NoCertificate if it is no polygon of a plane in
/// [0,1]^4, with short rational corners.
FoundOverlap overlap_at(const Patches& patches, const IntersectionGraph& graph, const Overlap& overlap);

}  // namespace exsect::cli

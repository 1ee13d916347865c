// What doubles have proved of a pair, and its drawing. Internal to solver/; docs/method-doubles.md,
// section 14.6.
#pragma once

#include "answer/run.h"
#include "filter/graph.h"
#include "filter/overlap.h"

namespace exsect::filter {

/// The contacts, curves and centres are the whole intersection, or the overlap is. It refers to nothing
/// else.
template <class K>
struct KnownPair {
  struct Exact {
    ExactPatch<K> x;
    ExactPatch<K> y;
  };
  std::optional<Exact> exact;  // of pairs with contacts or an overlap, which are drawn from it
  PairOf<K> pair;
  std::optional<OverlapOfPieces> overlap;
  ContactsOf<K> contacts;
  std::vector<BoundaryPointOf<K>> points;
  std::vector<CentreOf<K>> centres;
  std::vector<AnalysedTraceOf<K>> curves;
  std::array<std::size_t, 4> coincident;  // coincident[i] turns where i does
  bool finest_vertices;                   // as near to the curve as doubles can be
};

/// The complete result, with polylines within the tolerance of the run; those of patches that are not
/// biquadratic may be coarser. Empty if that is not proved, or the time is over.
template <class K>
std::optional<IntersectResult> drawn(const KnownPair<K>& known, const Run& run);

}  // namespace exsect::filter

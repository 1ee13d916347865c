// What two boxes of one surface share, in both orders.
#pragma once

#include <exsect/solver/intersect_equations.h>

#include "support/catch.h"

namespace exsect::shared_parts {

/// The connected parts of greatest dimension 2, 1, 0 that are in no part of a greater one.
struct Shared {
  bool is_same;
  int curves;
  int points;
  bool operator==(const Shared&) const = default;
};

inline Shared shared(const ImplicitSurface& a, const ImplicitSurface& b) {
  const SurfaceIntersection found = intersect(a, b), exchanged = intersect(b, a);
  for (const OpenQuestion& open : found.incomplete) UNSCOPED_INFO(open.why);
  CHECK(found.status == Status::complete);
  for (const SpaceArc& arc : found.arcs) {
    CHECK(arc.multiplicity == 0);
    CHECK_FALSE(arc.beside);
  }
  CHECK(exchanged.is_same == found.is_same);
  CHECK(exchanged.arcs.size() == found.arcs.size());
  CHECK(exchanged.nodes.size() == found.nodes.size());
  return {found.is_same, static_cast<int>(found.curves.size()), found.count(SpaceNodeKind::touch)};
}

}  // namespace exsect::shared_parts

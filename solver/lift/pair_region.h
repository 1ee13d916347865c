// What bounds two surfaces, in one region of space. Internal to solver/; docs/method-equations.md,
// section 17.12.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace exsect {

/// The points that the boxes and nappes of both surfaces leave. Invariant: the bounds of the first one come
/// first; those without a name are not told in results.
struct PairRegion {
  SurfaceRegion all;
  std::size_t of_first = 0;
};
PairRegion pair_region(const ImplicitSurface& first, const ImplicitSurface& second);

/// Further clauses, without names.
PairRegion within(PairRegion region, const SurfaceRegion& further);

/// Whether the regions are given by the same inequalities, in the same order.
bool are_equal(const SurfaceRegion& a, const SurfaceRegion& b);

/// The closed interval of t in which point + t along is in the region; -1 to 1 if it has no clauses. Empty if
/// there is none. Requires clauses of one linear bound each, not all constant on the line.
std::optional<RationalInterval> part_of_line(const PairRegion& region, const Point& point,
                                             const Point& along);

/// The bounds with a name that a point lies on.
std::vector<std::size_t> bounds_at(const PairRegion& region, const Point& point);

/// The names of bounds in these positions, by their surfaces, each once.
std::array<std::vector<std::string>, 2> names_of(const PairRegion& region,
                                                 const std::vector<std::size_t>& bounds);

}  // namespace exsect

// Parts of a surface that are cut out by polynomial inequalities: one nappe of a cone, boxes of chart
// parameters.
#pragma once

#include <exsect/geometry/space_polynomial.h>

#include <cstddef>
#include <string>
#include <vector>

namespace exsect {

/// Which chart parameter is constant on a bound: the turn about the axis, the height along it, the turn about
/// the circle of a torus's tube, or a multiple of a plane's side.
enum class BoundKind { other, sector, height, tube, side };

/// The inequality form >= 0. Points of the region with form = 0 lie on this bound if where >= 0 in them: the
/// plane of a sector's side holds two half planes.
struct SurfaceBound {
  std::string name;  // "sector=from"; empty: not told in results
  SpacePolynomial form;
  SpacePolynomial where;
  BoundKind kind = BoundKind::other;
};

/// The closed part of space in which, in each of the clauses, one at least of its bounds holds; the whole of
/// it without clauses. Invariant: clauses hold positions in `bounds`.
struct SurfaceRegion {
  std::vector<SurfaceBound> bounds;
  std::vector<std::vector<std::size_t>> clauses;

  bool contains(const Point& p) const;
};

}  // namespace exsect

// A second opinion on the intersection of two patches, in plain doubles, by another method than the solver's.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <string>
#include <vector>

namespace exsect::oracle {

/// The parameters (u,v,r,s).
using Vector4 = std::array<double, 4>;

struct Curve {
  bool closed;
  std::vector<Vector4> points;  // closed: the last one is the first one again
};

/// What subdivision and Newton's method find of x(u,v) = y(r,s) in [0,1]^4. `doubt` is empty, or says why the
/// answer may be wrong: a nearly singular or tangential situation, a point close to an edge of the domain.
/// Nothing here is proved; without doubt it is as good as doubles allow.
struct Intersection {
  std::vector<Curve> curves;
  std::vector<Vector4> boundary_points;
  std::string doubt;

  bool conclusive() const { return doubt.empty(); }
  int closed() const;
  int open() const;
};

Intersection intersect(const BezierPatch& x, const BezierPatch& y);

}  // namespace exsect::oracle

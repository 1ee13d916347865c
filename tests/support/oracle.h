// A second opinion on the intersection of two patches, in plain doubles, by another method than the solver's.
#pragma once

#include <exsect/geometry/rational_patch.h>

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

/// What subdivision and Newton's method find of x(u,v) = y(r,s) in [0,1]^4, for polynomial patches. `doubt`
/// is empty, or says why the answer may be wrong: a nearly singular or tangential situation, a point close to
/// an edge of the domain. Nothing here is proved; without doubt it is as good as doubles allow.
struct Intersection {
  std::vector<Curve> curves;
  std::vector<Vector4> boundary_points;
  std::string doubt;

  bool conclusive() const { return doubt.empty(); }
  int closed() const;
  int open() const;
};

Intersection intersect(const RationalPatch& x, const RationalPatch& y);

/// The solutions on one parameter line, by subdivision and Newton's method. Singular points elsewhere do no
/// harm, so that for an arbitrary value this is conclusive nearly always: it is what to ask about pairs in
/// special position. In doubt where the line touches the other patch or a solution lies close to an edge.
struct LinePoints {
  std::vector<Vector4> points;
  std::string doubt;

  bool conclusive() const { return doubt.empty(); }
};
/// Parameter i (0 to 3 for u, v, r, s) has this value, in [0,1].
LinePoints line_points(const RationalPatch& x, const RationalPatch& y, std::size_t i, double value);

}  // namespace exsect::oracle

// Whether two patches lie on one algebraic surface, and the pairs of parameters that say so. Internal to
// solver/; docs/method.md, section 6.3.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/symbolic_line.h>

#include <optional>

namespace exsect {

/// The union W of the two-dimensional parts of {x(u,v) = y(r,s)} in C^4: its projection to (u,r,s) is f = 0,
/// and f has positive degree in r or s.
class CommonSurface {
 public:
  /// Empty if there is no two-dimensional part. Requires that neither patch is a curve or a point.
  static std::optional<CommonSurface> of(const BezierPatch& x, const BezierPatch& y);

  /// True only if W has a real point with these u and s, with r and v in the closed intervals.
  bool has_point(const Rational& u, const Rational& s, const RationalInterval& r,
                 const RationalInterval& v) const;
  /// The same for a given r, and s in an interval.
  bool has_point_at_r(const Rational& u, const Rational& r, const RationalInterval& s,
                      const RationalInterval& v) const;
  /// Both patches lie in one plane.
  bool planar() const { return planar_; }

 private:
  CommonSurface(const BezierPatch& x, const BezierPatch& y, TrivariatePolynomial f);
  bool has_point(const BivariatePolynomial& f, const ParameterLine& line, const BezierPatch& y,
                 const Rational& s, const RationalInterval& r, const RationalInterval& v) const;

  BezierPatch x_;
  BezierPatch y_;
  TrivariatePolynomial f_;
  bool planar_;
  bool all_straight_;  // the lines u = constant of x
};

}  // namespace exsect

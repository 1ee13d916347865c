// Four patches that cover a torus, where it has rational points. Internal to solver/;
// docs/method-equations.md, section 17.10.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>

#include <optional>

namespace exsect {

/// The points centre + (major + minor cos b) (cos a across + sin a beside) + minor sin b along, with rational
/// orthogonal unit vectors.
struct TorusFrame {
  Point centre;
  Point across;
  Point beside;
  Point along;
  Rational major;
  Rational minor;
};

/// Empty unless both radii and the length of the axis as it is given are rational.
std::optional<TorusFrame> torus_frame(const SurfaceData& torus);

/// Cosine and sine.
struct UnitVector {
  Rational cosine;
  Rational sine;
};
/// Of the angle 2 arctan(h).
UnitVector turn_by(const Rational& half_tangent);
/// Of the sum of both angles.
UnitVector operator+(const UnitVector& a, const UnitVector& b);

/// Where the angles a and b of a frame are counted from.
struct TorusTurns {
  UnitVector around;  // a
  UnitVector across;  // b
};

/// The quarter of the torus with a and b within a quarter of a turn of `turns`, or of its opposite in a where
/// half_u = 1 and in b where half_v = 1: bidegree (2,2), tan of half the angle from the middle is 2u - 1 and
/// 2v - 1 (17.11).
RationalPatch torus_chart(const TorusFrame& frame, const TorusTurns& turns, int half_u, int half_v);

/// The curve f(u,v) = 0 of the patch with halves 0 in the parameters of another half of u, or of v: the
/// parameter t = 2u - 1 becomes -1/t.
BivariatePolynomial on_other_half(const BivariatePolynomial& f, bool in_u, bool in_v);

}  // namespace exsect

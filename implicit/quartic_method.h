// The intersection by approximate implicitization: quartics for the pieces of the second patch, composed with
// the first (chapter 9.4; docs/method-implicit.md, section 13).
#pragma once

#include <exsect/geometry/approximate_implicit_patch.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/check_lines.h>

#include <vector>

namespace exsect {

struct QuarticOptions {
  PatchFit fit = PatchFit::conics;
  int pieces = 2;  // y is divided into 2^pieces by 2^pieces pieces; 0, ..., 3
  int boxes = 6;   // the square of x into 2^boxes by 2^boxes; 3, ..., 8
};

/// Boxes (i,j) stand for [i,i+1] x [j,j+1] times 2^-boxes in (u,v).
struct QuarticPiece {
  RationalInterval r;
  RationalInterval s;
  /// q(x(u,v)), bidegree (8,8).
  BivariatePolynomial composed;
  /// |q| on the piece of y.
  Rational bound;
  /// Proved: every point of the intersection with (r,s) in the piece has its (u,v) in one of these boxes,
  /// outside of which |q(x)| exceeds the bound (13.2) or x is outside the box around the piece's control
  /// points.
  std::vector<std::array<int, 2>> boxes;
};

/// A connected group of boxes of the pieces.
struct QuarticRegion {
  std::vector<std::array<int, 2>> boxes;
  bool is_phantom;  // no exact point of a check line lies in it
};

/// What the approximate curve has on the check lines. A point of a piece's curve counts if it lies in the box
/// around the control points of the piece; near: within 2^-boxes in v. These numbers are measured in
/// floating point and prove nothing.
struct QuarticCheck {
  std::size_t points;        // exact
  std::size_t missed;        // exact, with no approximate point near
  std::size_t phantoms;      // approximate, with no exact point near
  double largest_deviation;  // in v, between an exact point and the nearest approximate one, if near
};

struct QuarticMethod {
  std::vector<QuarticPiece> pieces;
  /// Every point of the intersection has its (u,v) in one of these regions.
  std::vector<QuarticRegion> regions;
  QuarticCheck check;
};

/// Throws std::invalid_argument for options out of range, std::domain_error if the quartic of a piece cannot
/// be found (approximate_equation).
QuarticMethod intersect_by_quartics(const BezierPatch& x, const BezierPatch& y, const QuarticOptions& options,
                                    const std::vector<CheckLine>& lines);

}  // namespace exsect

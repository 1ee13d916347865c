// Equally spaced parameter lines with all their exact points: what methods are measured against.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/line_query.h>

#include <vector>

namespace exsect {

struct CheckLine {
  Rational u;
  std::vector<CertifiedPoint> points;
  /// Real roots in [0,1] of the line's eliminant, which are these points and phantoms.
  std::size_t eliminant_roots;
};

/// The lines u = (2 i + 1)/(2 n), i = 0..n-1, n >= 1 (else std::invalid_argument). Lines whose points are not
/// all known (a part of the line on y, or incomplete) are left out.
std::vector<CheckLine> check_lines(const BezierPatch& x, const BezierPatch& y, int n);

}  // namespace exsect

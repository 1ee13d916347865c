// Opposite sides of a patch that are glued, and the folded parameter line through the pair of them at which
// one parameter agrees. Internal to solver/; docs/method.md, section 7.8.
//
// Notation: x(1, c + k h) = x(0, c + k h) for h = 0 and x(1, c + h) = x(0, c + k h) for all h. The line v = c
// begins and ends in one point and turns at u = 1/2. For the pairs (a, c + h1), (1 - b, c + h2)
//   x(a, c + h1) - x(1 - b, c + h2) = (a - b) M1 + (h1 - k h2) M2 + b h2 M3.                        (7.16)
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>
#include <vector>

#include "self/star.h"

namespace exsect {

/// Sides u = 0 and 1 of the patch, or of the patch with exchanged parameters.
struct GluedFold {
  bool exchanged;
  Rational constant;  // c, 0 <= c <= 1
  Rational ratio;     // k, not 0 or 1
  ControlNet d;       // of u^i (v - c)^j
};

/// All with rational constants.
std::vector<GluedFold> glued_folds(const BezierPatch& x);

/// M1, M2, M3 of (7.16) over numbers or enclosures. Where their determinant is not 0 the pairs are those of
/// the sides and of the folded line, and no others.
template <class Scalar>
std::array<std::array<Scalar, 3>, 3> glued_fold_factors(const std::array<std::array<Scalar, 3>, 9>& d,
                                                        const Scalar& k, const Scalar& a, const Scalar& b,
                                                        const Scalar& h1, const Scalar& h2) {
  const Scalar one(1);
  std::array<std::array<Scalar, 3>, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto c = [&](std::size_t p, std::size_t q) -> const Scalar& { return d[3 * p + q][i]; };
    const auto turn = [&](const Scalar& h) -> Scalar {
      return (k - one) * (c(0, 1) + (k + one) * h * c(0, 2));
    };
    const Scalar second = c(2, 0) + h1 * (c(2, 1) + h1 * c(2, 2));
    const Scalar slope = c(2, 1) + (h1 + h2) * c(2, 2);
    const Scalar along = c(0, 1) + (h1 + k * h2) * c(0, 2);
    result[0][i] = h1 * turn(h1) - (one - a - b) * second;
    result[1][i] = along - b * (one - b) * slope + b * turn(h1);
    result[2][i] = k * turn(h1) + turn(h2) - (one - b) * (k - one) * slope;
  }
  return result;
}

/// The star around the pair (0,c), (1,c), `halfwidth` wide, without layers: its arcs are straight in the
/// parameters. Empty if the determinant cannot be told from 0 in a box of this size.
std::optional<SelfStar> glued_fold_star(const SelfStarProblem& problem, const GluedFold& fold,
                                        const Rational& halfwidth);

}  // namespace exsect

// Pairs of a self-intersection that may be singular, exactly: the centres of stars. Internal to solver/;
// docs/method.md, section 7.6.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/triangular_point.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <array>
#include <optional>
#include <vector>

#include "self/turning.h"

namespace exsect {

struct SelfCentre {
  CertifiedPoint point;
  std::array<RealAlgebraic, 4> value;   // its parameters
  bool cuspidal;                        // x_u x x_v = 0, the two points of the pair agree
  std::vector<std::size_t> sweeps;      // parameters (u: 0, v: 1) to be tried
  std::optional<std::size_t> landmark;  // the boundary point it is
  /// For an irrational value of the one sweep parameter: all pairs over it have one of these at the other
  /// point's other parameter, and only the centre has its own.
  std::optional<std::vector<TriangularPoint>> over_value;
};

/// The pair with these parameters; within 2^-100.
CertifiedPoint certified_pair(const std::array<RealAlgebraic, 4>& value);

/// Which of the boundary points of the patch the pair is, if any. They are all pairs on sides but those with
/// no side on which one point alone lies.
std::optional<std::size_t> boundary_point(const std::vector<CertifiedPoint>& boundary,
                                          const std::array<RealAlgebraic, 4>& value);

/// Requires SelfCentre::over_value: over the centre's value the box holds no other pair.
bool is_only_root(const SelfCentre& centre, const ParameterBox& box);

/// Candidates near the boxes: rational cuspidal points, points of folded lines u = c and v = c, c rational,
/// at which both tangent planes agree, rational boundary points, and rational points at which the tangent
/// field vanishes.
std::vector<SelfCentre> self_star_centres(const BezierPatch& x, const std::vector<CertifiedPoint>& boundary,
                                          const std::vector<ParameterBox>& where, const SelfValues& values);

}  // namespace exsect

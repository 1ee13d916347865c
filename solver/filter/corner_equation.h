// One equation in two parameters for the solutions near a common corner. Internal to solver/;
// docs/method-doubles.md, section 14.26.
#pragma once

#include <optional>
#include <vector>

#include "filter/lone_corner.h"
#include "filter/plane_series.h"

namespace exsect::filter {

/// The parameters, all counted from the corner, that are p and q, and the two others, which are functions of
/// these at solutions.
struct CornerSplit {
  std::array<std::size_t, 2> free;
  std::array<std::size_t, 2> bound;
};

/// All points next to the corner at which a parameter of x and one of y, `across`, are zero are solutions: a
/// common side, along which the patches touch if `touching`.
struct SideAtCorner {
  std::array<std::size_t, 2> across;
  bool touching;
};

/// For complex p, q: all solutions with |p|, |q| <= reach and the others of size `reach` at most have the
/// values `bound` of these, and the zeros of `normal` with such p and q are solutions, with these values. If
/// it is divided at sides, all solutions with p, q > 0 are its zeros.
struct CornerEquation {
  CornerSplit split;
  std::array<PlaneSeries, 2> bound;
  PlaneSeries normal;
};

/// With `normal` divided at common sides; empty if p is zero along one of them and q too, or none of both, or
/// the series has too few terms.
std::optional<CornerEquation> divided_at_sides(const CornerEquation& equation,
                                               const std::vector<SideAtCorner>& sides);

/// c[i][j] multiplies the powers i and j of the parameters counted from the corner.
ControlVectors power_coefficients(const CornerNet& net);

/// Two homogeneous patches about a common corner, as polynomials.
class CornerSystem {
 public:
  CornerSystem(const CornerNet& x, const CornerNet& y);

  /// The ways in which the derivatives of x - y by `bound` span those by all parameters, a plane: none where
  /// that is no plane.
  std::vector<CornerSplit> splits() const;
  /// The values of the bound parameters up to this order. Requires one of splits().
  std::array<PlaneSeries, 2> series(const CornerSplit& split, int order) const;
  /// With such values; empty if they are not proved to be unique, (14.122).
  std::optional<CornerEquation> equation(const CornerSplit& split, const std::array<PlaneSeries, 2>& series,
                                         const Rational& reach) const;

 private:
  using Rows = std::array<Point, 3>;  // of forms on space: those of the bound parameters, and the normal

  Rows rows(const CornerSplit& split) const;
  std::vector<PlaneSeries> values(const CornerSplit& split, const std::array<PlaneSeries, 2>& bound,
                                  const Rows& rows) const;
  Rational turning(const CornerSplit& split, const Rows& rows, const Rational& free_size,
                   const Rational& bound_size) const;

  ControlVectors x_, y_;
  std::array<Point, 4> slope_;  // of X Y_4 - Y X_4
};

}  // namespace exsect::filter

// Cuspidal points in special position, exactly: on a side of the square, or at the turn of a folded parameter
// line. Internal to solver/.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>
#include <vector>

namespace exsect {

/// A parameter line v = constant that is straight and turns back at one of its points, x_u = 0: r = u and s =
/// v of `turn`, in [0,1]^2. Isolated among such points.
struct FoldedLine {
  TriangularPoint turn;
  /// u and v of the turn, where they are 0 or 1 exactly.
  std::array<std::optional<int>, 2> side;
};

/// All of them, unless every line v = constant is straight (then none is listed).
std::vector<FoldedLine> folded_lines(const BezierPatch& x);

/// False only if x takes no value twice on any line v = constant that is not one point.
bool has_folded_line(const BezierPatch& x);

/// The v in [0,1] at which the line v = constant is one point. Requires that x depends on u.
std::vector<RealAlgebraic> collapsed_lines(const BezierPatch& x);

/// u and v of the turn; empty if the line is v = c with an irrational c.
std::optional<std::array<Rational, 2>> rational_turn(const FoldedLine& line);

/// A cuspidal point on the side u = `side`, x_u x x_v = 0, at v = `at` in [0,1]; isolated on the side.
struct SideCusp {
  int side;
  RealAlgebraic at;
};

/// All of them on the sides u = 0 and u = 1 that are not cuspidal as a whole.
std::vector<SideCusp> side_cusps(const BezierPatch& x);

/// The number of cuspidal points on the line u = value with v in the closed range; empty if it is cuspidal as
/// a whole.
std::optional<std::size_t> cuspidal_points_on(const BezierPatch& x, const Rational& value,
                                              const RationalInterval& range);

/// Both of them for x (index 0) and for x(v,u) (index 1).
struct SpecialCusps {
  std::array<std::vector<FoldedLine>, 2> folded;
  std::array<std::vector<SideCusp>, 2> on_side;
};
SpecialCusps special_cusps(const BezierPatch& x);

}  // namespace exsect

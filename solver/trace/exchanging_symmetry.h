// Symmetries of space that exchange two patches, and the part of their intersection that they fix. Internal
// to solver/; docs/method.md, section 5.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_patch.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "answer/parameter_box.h"
#include "trace/tracer.h"

namespace exsect {

/// An affine involution A with a plane of fixed points and y(r,s) = A x(u,v), where (r,s) is (u,v) up to
/// exchanged and reversed parameters. It exchanges the solutions; those with that (r,s) and `section`(u,v) =
/// 0 are fixed.
struct ExchangingSymmetry {
  std::array<std::size_t, 4> partner;  // of each parameter the one of the other patch, by index
  std::array<bool, 4> reversed;        // it is 1 minus this one
  BivariatePolynomial section;         // zero where A fixes x(u,v)

  /// The range of the partner of parameter j, by index, if that of j is `at`.
  RationalInterval partner_range(std::size_t j, const RationalInterval& at) const {
    return reversed[j] ? exsect::reversed(at) : at;
  }
};

/// One such symmetry, unless there is none or x lies in a plane.
std::optional<ExchangingSymmetry> exchanging_symmetry(const BezierPatch& x, const BezierPatch& y);

/// exchanging_symmetry() of a pair, computed when it is first asked for.
using SymmetryOf = std::function<const std::optional<ExchangingSymmetry>&()>;

/// True only if all points of the tube's arc are fixed: one is, and the direction there. On the arc, and on
/// its continuation, parameters turn together with their partners.
template <class Ball>
bool is_fixed(const ExchangingSymmetry& symmetry, const Tube<Ball>& tube);

/// As above, of some tube.
template <class Ball>
bool is_fixed(const ExchangingSymmetry& symmetry, const Trace<Ball>& trace) {
  return std::any_of(trace.pieces.begin(), trace.pieces.end(),
                     [&](const Piece<Ball>& piece) { return is_fixed(symmetry, piece.tube); });
}

}  // namespace exsect

// Symmetries of space that exchange two patches. Internal to solver/; docs/method.md, section 5.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <cstddef>
#include <optional>

#include "answer/parameter_box.h"

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

}  // namespace exsect

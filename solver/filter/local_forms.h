// The local equations of the intersection near a singular solution with exact parameters. Internal to
// solver/; docs/method-doubles.md, sections 14.9, 14.16 and 14.18.
#pragma once

#include <exsect/algebra/real_field.h>

#include <optional>

#include "filter/patch.h"

namespace exsect::filter {

/// Two rows and two columns.
using Matrix2 = std::array<std::array<double, 2>, 2>;
/// The coefficient of h^i k^j at index side i + j.
template <class K>
using ScalarTableOf = std::array<double, K::count>;
using ScalarTable = ScalarTableOf<Biquadratic>;
/// Indices of the quadratic terms.
template <class K>
inline constexpr std::array<std::size_t, 3> kQuadratic = {2 * K::side, K::side + 1, 2};

/// The equations (14.17), or (14.44) of weighted patches, at a solution p where x is regular and both tangent
/// planes agree, up to one rounding of each coefficient, all of which are below kGreatestCoefficient. With a
/// = S t, q is alpha² + beta² or, if `crossing`, alpha beta, t = (alpha,beta), apart from a form whose
/// coefficients have a sum below `rest`. The entries of S are at most 1, its determinant is not small.
template <class K>
struct LocalFormsOf {
  std::array<ScalarTableOf<K>, 2> x;  // of X: orders 2 and more
  std::array<ScalarTableOf<K>, 2> y;  // of Y, and B in order 1
  ScalarTableOf<K> normal_x;
  ScalarTableOf<K> normal_y;
  ScalarTableOf<K> weight_x = {};  // xi, of order 2, and upsilon: 0 unless the patches are weighted
  ScalarTableOf<K> weight_y = {};
  Matrix2 s;
  Matrix2 bs;                      // B S
  std::array<double, 2> bs_error;  // of each entry, by rows
  bool crossing;
  double rest;
};
using LocalForms = LocalFormsOf<Biquadratic>;

/// Empty if p is no such solution, or q is degenerate. p is inside the square.
template <class K>
std::optional<LocalFormsOf<K>> local_forms(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                           const std::array<FieldNumber, 4>& p);

}  // namespace exsect::filter

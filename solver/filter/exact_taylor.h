// Taylor coefficients of the exact patches. Internal to solver/.
#pragma once

#include "filter/exact_patch.h"

namespace exsect::filter {

/// Coefficients of (h,k) -> X(u + h, v + k), that of h^i k^j at index side i + j: of the homogeneous
/// coordinates if K::weighted, else of the coordinates.
template <class K>
using ExactTaylor = std::array<std::array<Rational, K::rows>, K::count>;
template <class K>
ExactTaylor<K> exact_taylor(const ExactPatch<K>& patch, const Rational& u, const Rational& v);

}  // namespace exsect::filter

// Taylor coefficients of the exact patches. Internal to solver/.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/real_field.h>
#include <exsect/geometry/point.h>

#include "filter/exact_patch.h"

namespace exsect::filter {

/// Enclosures to a thousand digits.
using LongBall = ArbBall<3456>;

/// Coefficients of (h,k) -> X(u + h, v + k), that of h^i k^j at index side i + j: of the homogeneous
/// coordinates if K::weighted, else of the coordinates. Numbers are Rational, FieldNumber, or LongBall, which
/// contains them.
template <class K, class Number>
using ExactTaylorOf = std::array<std::array<Number, K::rows>, K::count>;
template <class K>
using ExactTaylor = ExactTaylorOf<K, Rational>;
template <class K, class Number>
ExactTaylorOf<K, Number> exact_taylor(const ExactPatch<K>& patch, const Number& u, const Number& v);

}  // namespace exsect::filter

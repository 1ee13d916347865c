// What the proofs of rounding errors ask of the compiler and the machine: IEEE 754 doubles, every operation
// rounded on its own. Included by each header with arithmetic on doubles; docs/method-doubles.md,
// section 14.1.
#pragma once

#include <cfloat>
#include <limits>

// Any of these lets the compiler reorder or leave out roundings, infinities and NaN.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "exsect: bounds of rounding errors do not hold under -ffast-math or a part of it: compile without"
#endif

namespace exsect {

static_assert(std::numeric_limits<double>::is_iec559, "doubles are those of IEEE 754");
static_assert(std::numeric_limits<double>::radix == 2 && std::numeric_limits<double>::digits == 53);
static_assert(std::numeric_limits<double>::min_exponent == -1021 &&
                  std::numeric_limits<double>::max_exponent == 1024,
              "binary64, the format of 64 bits");
static_assert(std::numeric_limits<double>::denorm_min() > 0, "underflow is gradual");
static_assert(FLT_EVAL_METHOD == 0, "operations on doubles are rounded to doubles, not to longer registers");

}  // namespace exsect

// The floating-point arithmetic that the bounds of Enclosure are proved for. Internal to checker/.
#pragma once

#include <cfenv>
#include <cfloat>
#include <limits>

#ifdef __FAST_MATH__
#error "the checker's bounds hold for IEEE 754 arithmetic: compile without -ffast-math"
#endif

namespace exsect::checker {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "doubles are IEEE 754 binary64");
static_assert(FLT_EVAL_METHOD == 0, "doubles are computed as doubles");

/// Round to nearest, no exception traps, subnormal numbers kept (no flush to zero), whatever the caller has
/// set; the caller's environment comes back at the end. Not NearestRounding of algebra/: the checker shares
/// no code with what it checks.
class FloatingPoint {
 public:
  FloatingPoint() {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatingPoint() { std::fesetenv(&callers_); }
  FloatingPoint(const FloatingPoint&) = delete;
  FloatingPoint& operator=(const FloatingPoint&) = delete;

 private:
  std::fenv_t callers_;
};

}  // namespace exsect::checker

// The floating-point environment in which everything of exsect computes, whatever the caller's is.
#pragma once

#include <exsect/algebra/floating_point.h>

#include <cfenv>

namespace exsect {

/// While it lives, the thread rounds to nearest, underflows gradually (subnormal numbers are neither flushed
/// to zero nor read as zero) and does not trap. Its end brings the caller's environment back, also when an
/// exception passes. Some nanoseconds where nothing has to be changed. For each function that others call,
/// and each task of another thread; not for inner functions. Where the environment cannot be changed the
/// constructor throws std::runtime_error.
///
/// Compilers take arithmetic to be independent of the environment and may move it across a change: the work
/// has to be a call that is not inlined. `in_nearest_rounding` is both.
class NearestRounding {
 public:
  NearestRounding();
  ~NearestRounding();
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  std::fenv_t caller_;
  bool changed_;
};

namespace detail {

/// The empty statement reads and writes memory for all the compiler knows, so that the function is neither
/// pure nor constant and its call stays where it is.
template <class Work>
[[gnu::noinline]] decltype(auto) out_of_line(Work& work) {
  asm volatile("" ::: "memory");
  return work();
}

}  // namespace detail

/// work(), a call without arguments, in that environment.
template <class Work>
decltype(auto) in_nearest_rounding(Work work) {
  const NearestRounding guard;
  return detail::out_of_line(work);
}

}  // namespace exsect

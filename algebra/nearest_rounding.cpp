#include "nearest_rounding.h"

#include <cstdint>
#include <stdexcept>

namespace exsect {

namespace {

#if defined(__x86_64__)

/// Rounding (13, 14), flush to zero (15), subnormal operands as zero (6), masks of the exceptions (7 to 12).
constexpr std::uint32_t kControl = 0xffc0;
constexpr std::uint32_t kNearest = 0x1f80;
/// The same of the older unit, by whose rounding the C library reads and writes decimal numbers, with the
/// length of its registers: rounding (10, 11), precision (8, 9), masks (0 to 5).
constexpr std::uint16_t kOldControl = 0x0f3f;
constexpr std::uint16_t kOldNearest = 0x033f;

std::uint32_t control() {
  std::uint32_t value;
  asm volatile("stmxcsr %0" : "=m"(value));
  return value;
}

bool is_nearest() {
  std::uint16_t old;
  asm volatile("fnstcw %0" : "=m"(old));
  return (control() & kControl) == kNearest && (old & kOldControl) == kOldNearest;
}

void set_nearest() {
  std::fesetenv(FE_DFL_ENV);
  // Not every C library takes the treatment of subnormal numbers to be a part of the environment.
  const std::uint32_t value = (control() & ~kControl) | kNearest;
  asm volatile("ldmxcsr %0" : : "m"(value) : "memory");
}

#elif defined(__aarch64__)

/// Rounding (22, 23), flush to zero (24), default NaN (25), traps (8 to 12, 15), flushing of operands and of
/// results (0, 1).
constexpr std::uint64_t kControl = 0x03c09f03;

std::uint64_t control() {
  std::uint64_t value;
  asm volatile("mrs %0, fpcr" : "=r"(value));
  return value;
}

bool is_nearest() { return (control() & kControl) == 0; }

void set_nearest() {
  const std::uint64_t value = control() & ~kControl;
  asm volatile("msr fpcr, %0" : : "r"(value) : "memory");
}

#else

bool is_nearest() {
  const volatile double least = std::numeric_limits<double>::min();
  const volatile double half = least / 2;
  return std::fegetround() == FE_TONEAREST && half != 0;
}

void set_nearest() { std::fesetenv(FE_DFL_ENV); }

#endif

}  // namespace

NearestRounding::NearestRounding() : changed_(!is_nearest()) {
  if (!changed_) return;
  if (std::fegetenv(&caller_) == 0) {
    set_nearest();
    if (is_nearest()) return;
    std::fesetenv(&caller_);
  }
  throw std::runtime_error("exsect: this thread cannot be made to round to nearest without flushing to zero");
}

NearestRounding::~NearestRounding() {
  if (changed_) std::fesetenv(&caller_);
}

}  // namespace exsect

// Floating-point environments that a caller of the library may be in.
#pragma once

#include <array>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <string>
#include <vector>

namespace exsect {

/// A rounding mode, and whether subnormal results are flushed to zero (FTZ) and subnormal operands read as
/// zero (DAZ).
struct FloatEnvironment {
  int rounding = FE_TONEAREST;
  bool flushes_results = false;
  bool flushes_operands = false;

  friend bool operator==(const FloatEnvironment&, const FloatEnvironment&) = default;
};

namespace float_control {

#if defined(__x86_64__)
inline constexpr bool has_switches = true;
inline constexpr std::uint32_t results = 0x8000;
inline constexpr std::uint32_t operands = 0x0040;
inline std::uint32_t control() {
  std::uint32_t value;
  asm volatile("stmxcsr %0" : "=m"(value));
  return value;
}
inline void set_control(std::uint32_t value) { asm volatile("ldmxcsr %0" : : "m"(value) : "memory"); }
#elif defined(__aarch64__)
inline constexpr bool has_switches = true;
inline constexpr std::uint64_t results = 1ULL << 24;
inline constexpr std::uint64_t operands = 1ULL << 24;
inline std::uint64_t control() {
  std::uint64_t value;
  asm volatile("mrs %0, fpcr" : "=r"(value));
  return value;
}
inline void set_control(std::uint64_t value) { asm volatile("msr fpcr, %0" : : "r"(value) : "memory"); }
#else
inline constexpr bool has_switches = false;
inline constexpr std::uint32_t results = 0;
inline constexpr std::uint32_t operands = 0;
inline std::uint32_t control() { return 0; }
inline void set_control(std::uint32_t) {}
#endif

}  // namespace float_control

inline std::string text(const FloatEnvironment& environment) {
  const int mode = environment.rounding;
  return std::string(mode == FE_TONEAREST  ? "to nearest"
                     : mode == FE_UPWARD   ? "upwards"
                     : mode == FE_DOWNWARD ? "downwards"
                                           : "towards zero") +
         (environment.flushes_results ? ", FTZ" : "") + (environment.flushes_operands ? ", DAZ" : "");
}

/// All of them: four modes, with FTZ and DAZ where the processor has them (both or none where it has one
/// switch).
inline std::vector<FloatEnvironment> float_environments() {
  std::vector<FloatEnvironment> all;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    for (const bool flushes_results : {false, true}) {
      for (const bool flushes_operands : {false, true}) {
        const bool exists = float_control::has_switches ? float_control::results != float_control::operands ||
                                                              flushes_results == flushes_operands
                                                        : !flushes_results && !flushes_operands;
        if (exists) all.push_back({mode, flushes_results, flushes_operands});
      }
    }
  }
  return all;
}

/// Of this thread, as it is.
inline FloatEnvironment current_environment() {
  return {std::fegetround(), (float_control::control() & float_control::results) != 0,
          (float_control::control() & float_control::operands) != 0};
}

/// Changes it.
inline void enter(const FloatEnvironment& environment) {
  std::fesetround(environment.rounding);
  auto value = float_control::control();
  value &= ~(float_control::results | float_control::operands);
  if (environment.flushes_results) value |= float_control::results;
  if (environment.flushes_operands) value |= float_control::operands;
  float_control::set_control(value);
}

/// The bits of a number, which show the same in every environment.
inline std::string bits_of(double x) {
  constexpr std::array<char, 17> digits = {"0123456789abcdef"};
  const auto bits = std::bit_cast<std::uint64_t>(x);
  std::string result;
  for (int shift = 60; shift >= 0; shift -= 4) result += digits[bits >> shift & 15];
  return result;
}

}  // namespace exsect

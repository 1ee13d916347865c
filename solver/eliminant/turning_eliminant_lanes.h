// The turning eliminant modulo four primes at once, in vector registers.
#pragma once

#include <cstddef>

namespace exsect {

/// A pair of patches modulo four primes p, 2^47 < p < 2^48: an integer of each class, of modulus at most p/2,
/// for each prime. x[i][j][k]: coordinate k of the coefficient of the first parameter's power i times the
/// second's power j.
template <std::size_t coordinates>
struct LanePairOf {
  double primes[4];
  double x[3][3][coordinates][4];
  double y[3][3][coordinates][4];
};
using LanePair = LanePairOf<3>;
using WeightedLanePair = LanePairOf<4>;

/// The most points for interpolation.
inline constexpr std::size_t max_lane_points = 176;

/// For each prime the coefficients, constant term first, of the polynomial modulo p of degree below `points`
/// <= max_lane_points that takes the values E(u) (docs/method.md, equations (4.8) and (16.9)) at u = first,
/// first + 1,
/// ...: integers of modulus at most 0.61 p; |first| <= p/2. `defined` is false for a prime, and the
/// coefficients mean nothing, where a value has the denominator 0 (FibreResultants::value). Needs a processor
/// with AVX2 and FMA; exists only for x86-64 (__x86_64__).
void eliminant_in_lanes(const LanePair& pair, const double (&first)[4], std::size_t points,
                        double (*coefficients)[4], bool (&defined)[4]);
void eliminant_in_lanes(const WeightedLanePair& pair, const double (&first)[4], std::size_t points,
                        double (*coefficients)[4], bool (&defined)[4]);

/// Replaces values at first, first + 1, ... by the coefficients of the polynomial of degree below `points`;
/// all integers of modulus at most 0.61 p. As eliminant_in_lanes.
void interpolate_in_lanes(const double (&primes)[4], const double (&first)[4], std::size_t points,
                          double (*values)[4]);

}  // namespace exsect

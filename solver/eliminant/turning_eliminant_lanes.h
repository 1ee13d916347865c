// The turning eliminant modulo four primes at once, in vector registers.
#pragma once

#include "eliminant/eliminant_kinds.h"

namespace exsect {

/// A pair of patches modulo four primes p, 2^47 < p < 2^48: an integer of each class, of modulus at most p/2,
/// for each prime. x[i][j][k]: coordinate k of the coefficient of the first parameter's power i times the
/// second's power j.
template <class Kind>
struct LanePair {
  double primes[4];
  double x[Kind::u_degree + 1][Kind::v_degree + 1][Kind::coordinates][4];
  double y[Kind::r_degree + 1][Kind::s_degree + 1][Kind::coordinates][4];
};

/// `factor`: the coefficients of D, of a leading coefficient that is not zero.
template <class Whole, std::size_t degree>
struct LanePair<StrippedKind<Whole, degree>> : LanePair<Whole> {
  double factor[degree + 1][4];
};

/// The most points for interpolation.
inline constexpr std::size_t max_lane_points = 264;

/// For each prime the coefficients, constant term first, of the polynomial modulo p of degree below `points`
/// <= max_lane_points that takes the values E(u) ((4.8), (16.9), (16.16), (16.20)) at u = first, first + 1,
/// ...: integers of modulus at most 0.61 p; |first| <= p/2. `defined` is false for a prime, and the
/// coefficients mean nothing, where a value has the denominator 0 (FibreResultants::value). Needs a processor
/// with AVX2 and FMA; exists only for x86-64 (__x86_64__).
template <class Kind>
void eliminant_in_lanes(const LanePair<Kind>& pair, const double (&first)[4], std::size_t points,
                        double (*coefficients)[4], bool (&defined)[4]);

/// Replaces values at first, first + 1, ... by the coefficients of the polynomial of degree below `points`;
/// all integers of modulus at most 0.61 p. As eliminant_in_lanes.
void interpolate_in_lanes(const double (&primes)[4], const double (&first)[4], std::size_t points,
                          double (*values)[4]);

}  // namespace exsect

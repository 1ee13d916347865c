// Point-and-normal least squares: implicit functions near a curve (docs/method-implicit.md, 10.2).
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/planar_space.h>

#include <optional>
#include <vector>

namespace exsect {

/// A point of a planar curve and a normal vector there, of length 1 up to a relative error of 2^-40.
struct FitSample {
  Rational x;
  Rational y;
  Rational normal_x;  // both zero where the curve has no tangent
  Rational normal_y;
};

/// The points p(k/(count-1)), k = 0..count-1, of a planar curve with normals q (-y', x'), q =
/// floor(2^40/|p'|) 2^-40, so that 1 - |p'| 2^-40 < |normal| <= 1. Throws std::invalid_argument unless the
/// curve is planar, no point, and count >= 2.
std::vector<FitSample> fit_samples(const BezierCurve& curve, int count);

/// sum f(p_i)^2 + w1 sum |grad f(p_i) - n_i|^2 + w2 T(f) is minimised, T the tension (10.3).
struct FitWeights {
  Rational w1 = 1;  // > 0
  Rational w2 = 0;  // >= 0
};

enum class Arithmetic { exact, floating };

struct PlanarFit {
  std::vector<Rational> coefficients;  // of the functions of the space
  /// False if other functions of the space are as good: samples and weights do not determine it.
  bool is_unique;
};

/// A minimiser (10.2): exactly, by the normal equations over Q, or in floating point, for smooth polynomial
/// spaces by a QR decomposition and for splines by sparse normal equations. In floating point a space that
/// the samples do not determine gives the minimiser of least coefficients, and is_unique is a guess by
/// rounding. Throws std::invalid_argument for w1 <= 0, w2 < 0 or no samples; std::domain_error if the sparse
/// equations are singular in floating point.
PlanarFit fit_points_and_normals(const PlanarSpace& space, const std::vector<FitSample>& samples,
                                 const FitWeights& weights, Arithmetic arithmetic);

/// The coefficients rounded to multiples of 10^-digits.
std::vector<Rational> rounded_coefficients(const std::vector<Rational>& coefficients, int digits);

/// The least number of digits, from 6 to 60, for which rounding changes f at the samples by at most a 64th of
/// the largest |f(p_i)|; nothing if f vanishes at all samples.
std::optional<int> rounding_digits(const PlanarSpace& space, const std::vector<FitSample>& samples,
                                   const std::vector<Rational>& coefficients);

}  // namespace exsect

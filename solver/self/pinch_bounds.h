// Bounds of the curve of pairs next to a pinch point. Internal to solver/; docs/method-doubles.md,
// section 14.17.
#pragma once

#include <array>
#include <optional>

#include "self/local_derivatives.h"

namespace exsect {

/// a + t b.
BallVector<DoubleBall> plus(const BallVector<DoubleBall>& a, const DoubleBall& t,
                            const BallVector<DoubleBall>& b);

/// The kernel is nearer to the second parameter, at the point with these derivatives: pairs are asked for
/// with exchanged parameters.
bool is_exchanged(const AffineDerivatives& centre);

/// The slopes m of all pairs of one point of space, with a guess of that at the centre, (14.60).
struct Slopes {
  double guess;
  DoubleBall all;
};
/// Empty if a pair may have no slope. `d`: over all of the square.
std::optional<Slopes> slopes_of(const AffineDerivatives& centre, const AffineDerivatives& d);

/// Of the curve over q = t^2 <= 1/4 of y = (U,V,m) with H(y,q) = (x(w + t k) - x(w - t k)) / (2 t) = 0,
/// w = (U,V), k = (1,m): all enclosures are over the square, and over the slopes.
class CurveBounds {
 public:
  CurveBounds(const AffineDerivatives& d, const DoubleBall& slopes) : d_(d), m_(slopes) {}

  /// The columns of J, H by U, V and m (14.61).
  std::array<BallVector<DoubleBall>, 3> columns() const;
  /// H_q, so that J y' is its opposite.
  BallVector<DoubleBall> first() const;
  /// H_qq + 2 H_qy y' + H_yy y' y' with |y'| <= speed, so that J y'' is its opposite.
  BallVector<DoubleBall> second(const std::array<double, 3>& speed) const;
  /// Of |X''(q)|, X the point of space, with |y'| <= speed and |y''| <= change.
  double bend(const std::array<double, 3>& speed, const std::array<double, 3>& change) const;

 private:
  using Vector = BallVector<DoubleBall>;
  /// (d/du + m d/dv)^n of the derivative of order (i,j). Requires i + j + n < kLocalOrders.
  Vector along(std::size_t n, std::size_t i, std::size_t j) const;

  const AffineDerivatives& d_;
  DoubleBall m_;
};

}  // namespace exsect

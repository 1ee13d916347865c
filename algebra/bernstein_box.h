// Polynomials of two variables in the tensor Bernstein basis of a box, divided and divided again, exact.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <utility>
#include <vector>

namespace exsect {

/// f on the box r x s as sum b_ij B_i^m B_j^n, (m,n) the bidegree of f. On the box f lies between the least
/// and the greatest b_ij.
class BernsteinBox {
 public:
  /// Throws std::invalid_argument unless both intervals have positive length.
  BernsteinBox(const BivariatePolynomial& f, const RationalInterval& r, const RationalInterval& s);

  /// The least and the greatest coefficient: lower() <= f <= upper() on the closed box.
  Rational lower() const;
  Rational upper() const;
  /// +1 if all coefficients are positive, -1 if all are negative, else 0, which decides nothing.
  int sign() const;
  /// Of f in the corner at the lower or the upper ends.
  int sign_at_corner(bool upper_r, bool upper_s) const;

  /// The same polynomial on the lower and the upper half of the box.
  std::pair<BernsteinBox, BernsteinBox> split_r() const;
  std::pair<BernsteinBox, BernsteinBox> split_s() const;

 private:
  BernsteinBox() = default;
  BernsteinBox exchanged() const;

  // coefficients_[i][j] / denominator_ = b_ij, denominator_ > 0.
  std::vector<std::vector<Integer>> coefficients_;
  Integer denominator_;
};

}  // namespace exsect

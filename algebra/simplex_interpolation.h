// Polynomials in three variables of bounded total degree from their values modulo a prime.
#pragma once

#include <exsect/algebra/modular.h>

#include <cstddef>
#include <vector>

namespace exsect {

/// One element for each (i,j,k) with i + j + k <= degree: values at the points (i,j,k), or coefficients of
/// x^i y^j z^k.
class SimplexTable {
 public:
  explicit SimplexTable(int degree);

  int degree() const { return degree_; }
  /// Requires i, j, k >= 0 and i + j + k <= degree().
  Residue& operator()(int i, int j, int k) { return elements_[position(i, j, k)]; }
  Residue operator()(int i, int j, int k) const { return elements_[position(i, j, k)]; }
  /// In the order (0,0,0), (0,0,1), ..., lexicographic.
  const std::vector<Residue>& elements() const { return elements_; }

 private:
  std::size_t position(int i, int j, int k) const {
    return static_cast<std::size_t>(rows_[static_cast<std::size_t>(i * (degree_ + 1) + j)] + k);
  }

  int degree_;
  std::vector<int> rows_;  // position of (i,j,0)
  std::vector<Residue> elements_;
};

/// The coefficients of the polynomial of total degree at most values.degree() with these values. Throws
/// std::invalid_argument unless the prime is greater than the degree.
SimplexTable interpolate(const PrimeField& field, SimplexTable values);

}  // namespace exsect

// Bernstein tensors in three variables with integer coefficients, each up to a positive factor: signs are
// exact.
#pragma once

#include <exsect/algebra/rational.h>

#include <array>
#include <vector>

namespace exsect::exact_oracle {

/// Coefficient (i,j,k) at (i (n1+1) + j) (n2+1) + k, degrees n0, n1, n2.
struct Tensor {
  std::array<std::size_t, 3> degrees;
  std::vector<Integer> coefficients;

  std::size_t stride(std::size_t axis) const;
  /// The polynomial over [0,t] (end 0) or [t,1] (end 1) of the axis, t = p/q, q > 0, anywhere on the line.
  Tensor cut(std::size_t axis, long p, long q, int end) const;
  /// Over [-1/2, 3/2] of the axis.
  Tensor widened(std::size_t axis) const;
  /// The derivative along the axis, times n where it has the degree n; degrees[axis] >= 1.
  Tensor derivative(std::size_t axis) const;
  /// The coefficients with index 0 (end 0) or n (end 1) along the axis.
  std::vector<Integer> face(std::size_t axis, int end) const;
};

/// 1 or -1 if all have this sign, else 0.
int common_sign(const std::vector<Integer>& values);

/// Three functions on a box of three variables.
using System = std::array<Tensor, 3>;

/// Combinations of the functions, with integer coefficients that make the matrix of derivatives at the centre
/// nearly diagonal; the functions themselves where that is singular in doubles.
std::array<std::array<Integer, 3>, 3> preconditioner(const System& system);
System combined(const std::array<std::array<Integer, 3>, 3>& matrix, const System& system);

/// True only if the system has no zero in the box.
bool has_no_zero(const System& system);
/// True only if it has exactly one: opposite signs on opposite faces (Poincaré and Miranda), and matrices of
/// derivatives that are strictly diagonally dominant, so that the map is injective on the box.
bool has_one_zero(const System& system);

}  // namespace exsect::exact_oracle

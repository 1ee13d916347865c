// The equations F(u,v,r,s) = x(u,v) - y(r,s) = 0 in doubles: values, derivatives, Taylor bounds over a cell.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <cstddef>
#include <optional>

#include "support/oracle.h"

namespace exsect::oracle {

using Vector3 = std::array<double, 3>;

double dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
double dot(const Vector4& a, const Vector4& b);
/// a + t b.
Vector4 along(const Vector4& a, double t, const Vector4& b);
/// Largest |a_i - b_i|.
double distance(const Vector4& a, const Vector4& b);

/// Rows of a 3x3 matrix.
using Matrix3 = std::array<Vector3, 3>;
/// The inverse of the matrix with these columns; empty if it is singular to the eye of doubles.
std::optional<Matrix3> inverse_of_columns(const Vector3& a, const Vector3& b, const Vector3& c);

/// F at z and its Taylor coefficients there, so that the bounds below hold for the whole cell |z' - z|_i <=
/// w_i up to rounding.
class Expansion {
 public:
  Vector3 value;                  // F
  std::array<Vector3, 4> column;  // F_u, F_v, F_r, F_s
  /// Bound of |F(z') - F - sum column_i (z' - z)_i|, by component.
  Vector3 remainder(const Vector4& w) const;
  /// Bound of |column_i(z') - column_i|, by component.
  Vector3 deviation(std::size_t i, const Vector4& w) const;

 private:
  friend class System;
  using Taylor = std::array<std::array<Vector3, 4>, 4>;
  std::array<Taylor, 2> taylor_;  // of x at (u,v) and of y at (r,s)
  std::array<std::array<std::size_t, 2>, 2> degrees_;
};

class System {
 public:
  /// Polynomial patches.
  System(const RationalPatch& x, const RationalPatch& y);

  Expansion at(const Vector4& z) const;
  /// The unit tangent of the curve F = 0 at or near z, oriented by the determinants of the Jacobian, so that
  /// it varies continuously along the curve; empty where the Jacobian has no full rank.
  std::optional<Vector4> tangent(const Vector4& z) const;
  /// Newton's method from z for F = 0 in the hyperplane normal . z' = normal . z.
  std::optional<Vector4> newton(const Vector4& z, const Vector4& normal) const;
  /// The largest coordinate of a control point.
  double size() const { return size_; }

 private:
  std::array<Expansion::Taylor, 2> power_{};
  std::array<std::array<std::size_t, 2>, 2> degrees_{};
  double size_ = 0;
};

/// e_i.
Vector4 axis(std::size_t i);

}  // namespace exsect::oracle

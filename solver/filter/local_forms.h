// The intersection near a singular solution with rational parameters: its local equations, and how far they
// are from their leading terms. Internal to solver/; docs/method.md, section 14.9.
#pragma once

#include <optional>

#include "filter/patch.h"

namespace exsect::filter {

/// Two rows and two columns.
using Matrix2 = std::array<std::array<double, 2>, 2>;
/// The coefficient of h^i k^j at index 3 i + j.
using ScalarTable = std::array<double, 9>;

/// The equations (14.17) at a solution p where x is regular and both tangent planes agree, up to one rounding
/// of each coefficient, all of which are below kGreatestCoefficient. With a = S t, q is alpha² + beta² or, if
/// `crossing`, alpha beta, t = (alpha,beta), apart from a form whose coefficients have a sum below `rest`.
/// The entries of S are at most 1, its determinant is not small.
struct LocalForms {
  std::array<ScalarTable, 2> x;  // of X: orders 2 to 4
  std::array<ScalarTable, 2> y;  // of Y, and B in order 1
  ScalarTable normal_x;
  ScalarTable normal_y;
  Matrix2 s;
  Matrix2 bs;                      // B S
  std::array<double, 2> bs_error;  // of each entry, by rows
  bool crossing;
  double rest;
};

/// Empty if p is no such solution, or q is degenerate.
std::optional<LocalForms> local_forms(const BezierPatch& x, const BezierPatch& y,
                                      const std::array<Rational, 4>& p);

/// For |t| <= reach, |t| = max(|alpha|,|beta|): exactly one c with |c_i| <= k[i] reach satisfies the first
/// two equations, and |c_i| <= k[i] |t|.
struct LocalBounds {
  std::array<double, 2> k;
  std::array<double, 2> turn;  // |c_t - B S| <= turn[i] |t|, entry by entry
  double value;                // |g - q| <= value |t|³
  double slope;                // |g_t - q_t| <= slope |t|², for both components
};
/// Empty if `reach` is too large for that.
std::optional<LocalBounds> local_bounds(const LocalForms& forms, double reach);

}  // namespace exsect::filter

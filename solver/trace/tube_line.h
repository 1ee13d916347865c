// The centre line and the preconditioner of a tube, and bounds of the equations near the line. Internal to
// solver/; docs/method.md, section 5.
#pragma once

#include <array>
#include <optional>

#include "trace/preconditioned_newton.h"
#include "trace/tube_type.h"

namespace exsect {

/// A product loses at most 2^-1074 by underflow, times the factors that follow. A bound along the line is the
/// sum of fewer than 2^25 products, of at most 2^3 steps each: together 2^-1040, times the greatest factors.
inline constexpr double kUnderflow = 0x1p-1040;

/// Upper bounds of |g|, |dg/dtau| and |d²g/dtau²| over the tube for a polynomial g in sigma.
struct SeriesBound {
  double value = 0;
  double first = 0;
  double second = 0;

  /// The bounds of sigma^k; `ratio` = reach / scale <= 1, the scale a power of two.
  static SeriesBound of_power(std::size_t k, double ratio, double scale);
  /// Adds a multiple of a polynomial.
  void add_multiple(double magnitude, const SeriesBound& g) {
    value += magnitude * g.value;
    first += magnitude * g.first;
    second += magnitude * g.second;
  }
  /// Adds the product of two polynomials.
  void add_product(const SeriesBound& f, const SeriesBound& g);
};

/// Bounds along the centre line l: of C F, by rows; of the coefficients g_ij of C x(p + l + e) and -C y(p + l
/// + e) by powers of e, by patches and rows, where the identity has been taken away from the columns other
/// than the axis (the axis has no bounds); of the terms of l of degree two and more, and three and more.
struct AlongLine {
  std::array<SeriesBound, 3> residual;
  std::array<std::array<std::array<SeriesBound, 9>, 3>, 2> derivative;
  std::array<SeriesBound, 4> bend;
  std::array<SeriesBound, 4> higher_bend;
};

/// Taylor index of the first derivative that column j of the Jacobian is made of.
constexpr std::size_t column_index(std::size_t j) { return j % 2 == 0 ? 3 : 1; }

/// Magnitudes of coefficients of sigma^k, by k: of C F along the line, of C D - 1 (by rows and columns other
/// than the axis), of C, and of the higher derivatives of both nets. They hold for every reach up to the
/// scale.
template <class Ball>
struct LineRemainder {
  static constexpr std::size_t kDegree = kLineDegree<Ball>;
  std::array<Row3, 5 * kDegree + 1> residual;
  std::array<Matrix3, 4 * kDegree + 1> columns;
  std::array<Matrix3, kDegree + 1> preconditioner;
  std::array<std::array<std::array<NetRow<double>, 3>, 2>, 2 * kDegree + 1> higher;
  /// Bound of what underflow takes from each of these, times any powers of sigma.
  double underflow;
};

/// Fills in scale, line, slope and preconditioner for the tube's axis, reach and nets: the Taylor polynomials
/// of the curve and of the inverse of the columns other than the axis along it, but for rounding. Returns
/// what is left; empty if there is no inverse.
template <class Ball>
std::optional<LineRemainder<Ball>> fit_line(Tube<Ball>& tube);
/// Fills in scale, line and slope, in a fifth of the time; false if there is no inverse.
template <class Ball>
bool fit_line_alone(Tube<Ball>& tube);

/// C F and its derivatives at e, |e_i| <= z_i, bounded by those along the centre line: one patch, one row.
/// `part` selects the derivative with respect to tau.
struct OffLine {
  const std::array<SeriesBound, 9>& g;
  double SeriesBound::*part;
  double za, zb;

  double at(std::size_t i) const { return g[i].*part; }
  double value() const {
    return za * (at(3) + za * (at(6) + zb * (at(7) + zb * at(8)))) + zb * (at(1) + zb * at(2)) +
           za * zb * (at(4) + zb * at(5));
  }
  double first_a() const {
    return at(3) + 2 * za * (at(6) + zb * (at(7) + zb * at(8))) + zb * (at(4) + zb * at(5));
  }
  double first_b() const {
    return at(1) + 2 * zb * (at(2) + za * (at(5) + za * at(8))) + za * (at(4) + za * at(7));
  }
  /// The form of second derivatives at a vector of magnitudes at most (ta, tb).
  double quadratic(double ta, double tb) const {
    return 2 * (at(6) + zb * (at(7) + zb * at(8))) * ta * ta +
           2 * (at(4) + 2 * (za * at(7) + zb * at(5) + 2 * za * zb * at(8))) * ta * tb +
           2 * (at(2) + za * (at(5) + za * at(8))) * tb * tb;
  }
};

}  // namespace exsect

// Polynomials of two numbers between -1 and 1 in doubles, with one bound of what rounding does to each
// coefficient of their expansions. Internal to solver/; docs/method-equations.md, section 17.22.
#pragma once

#include <exsect/algebra/ball.h>

#include <array>
#include <cstddef>

namespace exsect {

/// Of a polynomial: m + 1 rows of n + 1 numbers, in lanes with zeros behind them.
class FormTable {
 public:
  static constexpr std::size_t most = 12;  // the greatest degree in each variable
  static constexpr std::size_t lanes = 4;

  FormTable() = default;
  /// Of zeros. Requires m, n <= most.
  FormTable(std::size_t m, std::size_t n) : m_(m), n_(n) {}

  std::size_t m() const { return m_; }
  std::size_t n() const { return n_; }
  /// Of a row, in groups of so many lanes.
  std::size_t width() const { return (n_ / lanes + 1) * lanes; }
  double& operator()(std::size_t i, std::size_t j) { return c_[i * stride + j]; }
  double operator()(std::size_t i, std::size_t j) const { return c_[i * stride + j]; }
  double* row(std::size_t i) { return &c_[i * stride]; }
  const double* row(std::size_t i) const { return &c_[i * stride]; }
  FormTable transposed() const;

 private:
  static constexpr std::size_t stride = (most / lanes + 1) * lanes;

  std::size_t m_ = 0, n_ = 0;
  std::array<double, (most + 1) * stride> c_{};
};

/// A polynomial sum c_ij x^i y^j about a place of the square, in the differences x, y of the coordinates from
/// it. Refers to the form that it is an expansion of.
class LocalForm {
 public:
  /// The rows belong to y.
  LocalForm(const FormTable& c, const FormTable& errors);

  /// The derivative of order k by x and l by y in the place.
  DoubleBall derivative(std::size_t k, std::size_t l) const;
  /// A bound of what it changes by where |x| <= a, |y| <= b.
  double change(std::size_t k, std::size_t l, double a, double b) const { return terms(k, l, a, b, 1); }
  /// It in all these places.
  DoubleBall derivative_over(std::size_t k, std::size_t l, double a, double b) const {
    return derivative(k, l).widened(change(k, l, a, b));
  }
  /// A bound of its terms of the order `least` or more where |x| <= a, |y| <= b.
  double terms(std::size_t k, std::size_t l, double a, double b, std::size_t least) const;

 private:
  FormTable c_;
  FormTable largest_;  // |c_ij| and its error
  const FormTable* errors_;
};

/// sum c_ij p^i q^j, in the place of a polynomial that is meant.
class SquareForm {
 public:
  /// Of coordinates.
  static constexpr double reach = 1.125;

  SquareForm() = default;
  /// `error` bounds the sum of all differences of coefficients from those that are meant.
  SquareForm(const FormTable& c, double error);

  const FormTable& table() const { return c_; }
  /// The value of the polynomial that is meant is within error() of this one for |p|, |q| <= reach.
  double operator()(double p, double q) const;
  double error() const { return errors_(0, 0); }
  /// Requires |p|, |q| <= reach.
  LocalForm about(double p, double q) const;

 private:
  FormTable c_;
  FormTable errors_;  // of the coefficients of expansions, whose rows belong to y
};

}  // namespace exsect

// Polynomials in two variables as rows of balls, expanded about other points and along lines. Internal to
// solver/.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace exsect {

/// The largest |coefficient|; 0 for f = 0.
inline Rational greatest_coefficient(const BivariatePolynomial& f) {
  Rational most = 0;
  for (int i = 0; i <= f.degree_r(); ++i)
    for (int j = 0; j <= f.degree_s(); ++j) most = std::max<Rational>(most, abs(f.coefficient(i, j)));
  return most;
}

/// The coefficients of f / unit: of r^i s^j at i (n + 1) + j, where n = max(degree_s, degree in s). Requires
/// unit != 0. Those of a polynomial of at least the degrees given.
template <class Ball>
std::vector<Ball> enclosed_coefficients(const BivariatePolynomial& f, const Rational& unit, int degree_r = 0,
                                        int degree_s = 0) {
  std::vector<Ball> c;
  for (int i = 0; i <= std::max(f.degree_r(), degree_r); ++i)
    for (int j = 0; j <= std::max(f.degree_s(), degree_s); ++j)
      c.push_back(Ball::enclosing(f.coefficient(i, j) / unit));
  return c;
}

/// From the coefficients of f(r,s), `row` for each power of r, to those of f(u + r, v + s).
template <class Number>
void shift_to(std::vector<Number>& c, std::size_t row, const Number& u, const Number& v) {
  const std::size_t m = c.size() / row - 1, n = row - 1;
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t i = m; i-- > k;)
      for (std::size_t j = 0; j < row; ++j) c[i * row + j] += u * c[(i + 1) * row + j];
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = n; j-- > k;) c[i * row + j] += v * c[i * row + j + 1];
}

/// From the coefficients of f(r,s) to those of f(x, slope x + edge) in x.
template <class Number>
std::vector<Number> along_line(const std::vector<Number>& c, std::size_t row, const Number& slope,
                               const Number& edge) {
  const std::size_t m = c.size() / row - 1, n = row - 1;
  std::vector<Number> result(m + n + 1);
  for (std::size_t j = n + 1; j-- > 0;) {
    if (j < n) {
      for (std::size_t i = m + n - j; i > 0; --i) result[i] = result[i] * edge + result[i - 1] * slope;
      result[0] *= edge;
    }
    for (std::size_t i = 0; i <= m; ++i) result[i] += c[i * row + j];
  }
  return result;
}

/// f along the two lines v + slope x + w and v + slope x - w of u + x; u, v and slope without radius.
template <class Ball>
class LineExpansion {
 public:
  LineExpansion(const std::vector<Ball>& c, std::size_t row, const Ball& u, const Ball& v, const Ball& slope,
                double w)
      : c_(c), row_(row), slope_(slope), w_(w) {
    shift_to(c_, row_, u, v);
  }

  /// Coefficients of f(u + x, v + slope x + w) in x, or below of f(u + x, v + slope x - w).
  std::vector<Ball> at(bool above) const { return along_line(c_, row_, slope_, Ball(above ? w_ : -w_)); }

 private:
  std::vector<Ball> c_;
  std::size_t row_;
  Ball slope_;
  double w_;
};

/// In doubles the midpoints alone, with one bound of the errors (17.3a). What an operation loses by underflow
/// reaches the results multiplied by at most (1 + max(|u|, |v|))^(m+n) (1 + |slope| + w)^n.
template <>
class LineExpansion<DoubleBall> {
 public:
  LineExpansion(const std::vector<DoubleBall>& c, std::size_t row, const DoubleBall& u, const DoubleBall& v,
                const DoubleBall& slope, double w)
      : row_(row), slope_(slope.approximation()), w_(w) {
    const double x = u.approximation(), y = v.approximation(), steep = std::fabs(slope_);
    const double operations = static_cast<double>(2 * (c.size() / row) + 5 * row);
    middles_.resize(c.size());
    std::vector<double> errors(c.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
      middles_[i] = c[i].approximation();
      errors[i] = c[i].radius() + operations * kUnitRoundoff * std::fabs(middles_[i]);
    }
    shift_to(middles_, row_, x, y);
    shift_to(errors, row_, std::fabs(x), std::fabs(y));
    errors_ = along_line(errors, row_, steep, w);
    const double rows = static_cast<double>(c.size() / row), columns = static_cast<double>(row);
    const double lost = kUnderflowLoss *
                        std::pow(1 + larger_bound(std::fabs(x), std::fabs(y)), rows + columns) *
                        std::pow(1 + steep + w, columns);
    for (double& error : errors_) error = error * (1 + 4 * operations * kUnitRoundoff) + lost;
  }

  std::vector<DoubleBall> at(bool above) const {
    const std::vector<double> middle = along_line(middles_, row_, slope_, above ? w_ : -w_);
    std::vector<DoubleBall> result(middle.size());
    for (std::size_t i = 0; i < middle.size(); ++i)  // after an overflow the radius is infinite or NaN
      result[i] = DoubleBall(middle[i], errors_[i] + std::fabs(middle[i]) * kUnitRoundoff);
    return result;
  }

 private:
  std::size_t row_;
  double slope_;
  double w_;
  std::vector<double> middles_;  // about (u,v)
  std::vector<double> errors_;   // along the lines
};

}  // namespace exsect

#include "filter/square_form.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>

namespace exsect {
namespace {

/// i (i-1) ... (i-k+1) for k <= 2.
double falling_factorial(std::size_t i, std::size_t k) {
  const double x = static_cast<double>(i);
  return k == 0 ? 1 : k == 1 ? x : x * (x - 1);
}

/// Each row moved by x along the rows: row i of sum_k c_k (t + x)^k, by repeated Horner steps.
void shift_rows(FormTable& f, double x) {
  const std::size_t m = f.m(), width = f.width();
  for (std::size_t first = 0; first < width; first += FormTable::lanes)
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t i = m; i-- > k;) {
        double* to = f.row(i) + first;
        const double* from = f.row(i + 1) + first;
        for (std::size_t lane = 0; lane < FormTable::lanes; ++lane) to[lane] += x * from[lane];
      }
}

/// The same polynomial about the place (p, q), transposed.
FormTable expanded_about(FormTable f, double p, double q) {
  shift_rows(f, p);
  f = f.transposed();
  shift_rows(f, q);
  return f;
}

/// binom(n,k) reach^(n-k) for k <= n: a bound of the coefficients in the expansions of powers up to n.
std::array<double, FormTable::most + 1> largest_parts(std::size_t n) {
  std::array<double, FormTable::most + 1> parts{};
  parts[n] = 1;
  for (std::size_t k = n; k-- > 0;)
    parts[k] = parts[k + 1] * SquareForm::reach * static_cast<double>(k + 1) / static_cast<double>(n - k);
  return parts;
}

/// What each coefficient of an expansion about any place within the reach may be off (17.51).
FormTable expansion_errors(const FormTable& c, double error) {
  const double rounding = static_cast<double>(2 * c.m() + 2 * c.n() + 2) * kUnitRoundoff;
  FormTable off(c.m(), c.n());
  for (std::size_t i = 0; i <= c.m(); ++i)
    for (std::size_t j = 0; j <= c.n(); ++j) off(i, j) = rounding * std::fabs(c(i, j));
  off = expanded_about(off, SquareForm::reach, SquareForm::reach);
  const auto in_p = largest_parts(c.m()), in_q = largest_parts(c.n());
  for (std::size_t i = 0; i <= c.m(); ++i)
    for (std::size_t j = 0; j <= c.n(); ++j)
      off(j, i) = (off(j, i) + error * in_p[i] * in_q[j]) * kSlack + kUnderflowLoss;
  return off;
}

}  // namespace

FormTable FormTable::transposed() const {
  FormTable result(n_, m_);
  for (std::size_t i = 0; i <= m_; ++i)
    for (std::size_t j = 0; j <= n_; ++j) result(j, i) = (*this)(i, j);
  return result;
}

LocalForm::LocalForm(const FormTable& c, const FormTable& errors)
    : c_(c), largest_(c.m(), c.n()), errors_(&errors) {
  for (std::size_t j = 0; j <= c.m(); ++j)
    for (std::size_t i = 0; i < c.width(); ++i)
      largest_.row(j)[i] = std::fabs(c.row(j)[i]) + errors.row(j)[i];
}

DoubleBall LocalForm::derivative(std::size_t k, std::size_t l) const {
  if (k > c_.n() || l > c_.m()) return 0;
  const double factor = falling_factorial(k, k) * falling_factorial(l, l);  // 1, 2 or 4
  return {factor * c_(l, k), factor * (*errors_)(l, k)};
}

double LocalForm::terms(std::size_t k, std::size_t l, double a, double b, std::size_t least) const {
  if (k > c_.n() || l > c_.m()) return 0;
  double sum = 0;
  for (std::size_t first = c_.width(); first > 0;) {
    first -= FormTable::lanes;
    std::array<double, FormTable::lanes> in_y{};
    for (std::size_t j = c_.m() + 1; j-- > l;) {
      const double factor = falling_factorial(j, l);
      std::array<double, FormTable::lanes> row;
      for (std::size_t lane = 0; lane < FormTable::lanes; ++lane) row[lane] = largest_.row(j)[first + lane];
      if (j - l < least)
        for (std::size_t lane = 0; lane < FormTable::lanes; ++lane)
          if (first + lane + (j - l) < k + least) row[lane] = 0;
      for (std::size_t lane = 0; lane < FormTable::lanes; ++lane)
        in_y[lane] = in_y[lane] * b + factor * row[lane];
    }
    for (std::size_t lane = FormTable::lanes; lane-- > 0;) {
      if (first + lane < k) break;
      sum = sum * a + falling_factorial(first + lane, k) * in_y[lane];
    }
  }
  return sum * kSlack + kUnderflowLoss;
}

SquareForm::SquareForm(const FormTable& c, double error) : c_(c), errors_(expansion_errors(c, error)) {}

double SquareForm::operator()(double p, double q) const {
  double sum = 0;
  for (std::size_t first = c_.width(); first > 0;) {
    first -= FormTable::lanes;
    std::array<double, FormTable::lanes> in_p{};
    for (std::size_t i = c_.m() + 1; i-- > 0;) {
      const double* row = c_.row(i) + first;
      for (std::size_t lane = 0; lane < FormTable::lanes; ++lane) in_p[lane] = in_p[lane] * p + row[lane];
    }
    for (std::size_t lane = FormTable::lanes; lane-- > 0;) sum = sum * q + in_p[lane];
  }
  return sum;
}

LocalForm SquareForm::about(double p, double q) const { return {expanded_about(c_, p, q), errors_}; }

}  // namespace exsect

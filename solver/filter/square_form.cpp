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

/// The same polynomial about the place (p, q), by repeated Horner steps.
FormTable shifted_table(const FormTable& c, double p, double q) {
  FormTable f = c;
  const std::size_t m = c.m(), n = c.n();
  for (std::size_t k = 0; k < m; ++k)
    for (std::size_t i = m; i-- > k;)
      for (std::size_t j = 0; j <= n; ++j) f(i, j) += p * f(i + 1, j);
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = n; j-- > k;) f(i, j) += q * f(i, j + 1);
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
  off = shifted_table(off, SquareForm::reach, SquareForm::reach);
  const auto in_p = largest_parts(c.m()), in_q = largest_parts(c.n());
  for (std::size_t i = 0; i <= c.m(); ++i)
    for (std::size_t j = 0; j <= c.n(); ++j)
      off(i, j) = (off(i, j) + error * in_p[i] * in_q[j]) * kSlack + kUnderflowLoss;
  return off;
}

}  // namespace

DoubleBall LocalForm::derivative(std::size_t k, std::size_t l) const {
  if (k > c_.m() || l > c_.n()) return 0;
  const double factor = falling_factorial(k, k) * falling_factorial(l, l);  // 1, 2 or 4
  return {factor * c_(k, l), factor * (*errors_)(k, l)};
}

double LocalForm::terms(std::size_t k, std::size_t l, double a, double b, std::size_t least) const {
  double sum = 0;
  for (std::size_t i = c_.m() + 1; i-- > k;) {
    const std::size_t first = l + (least > i - k ? least - (i - k) : 0);
    double in_y = 0;
    for (std::size_t j = c_.n() + 1; j-- > first;)
      in_y = in_y * b + falling_factorial(j, l) * (std::fabs(c_(i, j)) + (*errors_)(i, j));
    for (std::size_t j = l; j < first; ++j) in_y *= b;
    sum = sum * a + falling_factorial(i, k) * in_y;
  }
  return sum * kSlack + kUnderflowLoss;
}

SquareForm::SquareForm(const FormTable& c, double error) : c_(c), errors_(expansion_errors(c, error)) {}

double SquareForm::operator()(double p, double q) const {
  double sum = 0;
  for (std::size_t i = c_.m() + 1; i-- > 0;) {
    double in_q = 0;
    for (std::size_t j = c_.n() + 1; j-- > 0;) in_q = in_q * q + c_(i, j);
    sum = sum * p + in_q;
  }
  return sum;
}

LocalForm SquareForm::about(double p, double q) const { return {shifted_table(c_, p, q), errors_}; }

}  // namespace exsect

#include "filter/plane_series.h"

#include <utility>

namespace exsect::filter {

namespace {

std::vector<Rational> powers_of(const Rational& base, int most) {
  std::vector<Rational> result = {1};
  for (int k = 1; k <= most; ++k) result.push_back(result.back() * base);
  return result;
}

}  // namespace

Rational power(const Rational& base, int n) {
  Rational result = 1;
  for (int k = 0; k < n; ++k) result *= base;
  return result;
}

PlaneSeries::PlaneSeries(int order, Rational reach)
    : order_(order),
      reach_(std::move(reach)),
      c_(static_cast<std::size_t>(order + 1) * static_cast<std::size_t>(order + 1)) {}

PlaneSeries PlaneSeries::power(int order, const Rational& reach, int i, int j) {
  PlaneSeries result(order, reach);
  result.c_[result.index(i, j)] = 1;
  return result;
}

bool PlaneSeries::is_polynomial_zero() const {
  for (const Rational& c : c_)
    if (c != 0) return false;
  return true;
}

Rational PlaneSeries::polynomial_size() const {
  const std::vector<Rational> power = powers_of(reach_, order_);
  Rational sum = 0;
  for (int i = 0; i <= order_; ++i)
    for (int j = 0; i + j <= order_; ++j)
      if (const Rational& c = coefficient(i, j); c != 0)
        sum += abs(c) * power[static_cast<std::size_t>(i + j)];
  return sum;
}

Rational PlaneSeries::size() const {
  return polynomial_size() + rest_ * powers_of(reach_, order_ + 1).back();
}

PlaneSeries PlaneSeries::polynomial(int order, const Rational& reach) const {
  PlaneSeries result(order, reach);
  const int common = order < order_ ? order : order_;
  for (int i = 0; i <= common; ++i)
    for (int j = 0; i + j <= common; ++j) result.c_[result.index(i, j)] = coefficient(i, j);
  return result;
}

void PlaneSeries::add(const PlaneSeries& other, const Rational& factor) {
  for (std::size_t k = 0; k < c_.size(); ++k)
    if (other.c_[k] != 0) c_[k] += factor * other.c_[k];
  rest_ += abs(factor) * other.rest_;
}

// (14.128).
std::optional<PlaneSeries> PlaneSeries::divided(int i, int j) const {
  if (order_ < i + j) return std::nullopt;
  PlaneSeries result(order_ - i - j, reach_);
  for (int k = 0; k <= order_; ++k)
    for (int l = 0; k + l <= order_; ++l) {
      const Rational& c = coefficient(k, l);
      if (c == 0) continue;
      if (k < i || l < j) return std::nullopt;
      result.c_[result.index(k - i, l - j)] = c;
    }
  result.rest_ = rest_;
  return result;
}

// Terms of an order m > order are at most |c| reach^(m-order-1) max(|p|,|q|)^(order+1).
PlaneSeries operator*(const PlaneSeries& a, const PlaneSeries& b) {
  const int n = a.order_;
  PlaneSeries result(n, a.reach_);
  const std::vector<Rational> power = powers_of(a.reach_, n + 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Rational& first = a.coefficient(i, j);
      if (first == 0) continue;
      for (int k = 0; k <= n; ++k)
        for (int l = 0; k + l <= n; ++l) {
          const Rational& second = b.coefficient(k, l);
          if (second == 0) continue;
          const int m = i + j + k + l;
          if (m <= n)
            result.c_[result.index(i + k, j + l)] += first * second;
          else
            result.rest_ += abs(Rational(first * second)) * power[static_cast<std::size_t>(m - n - 1)];
        }
    }
  if (a.rest_ != 0) result.rest_ += a.rest_ * b.polynomial_size();
  if (b.rest_ != 0) result.rest_ += b.rest_ * a.polynomial_size();
  if (a.rest_ != 0 && b.rest_ != 0) result.rest_ += a.rest_ * b.rest_ * power.back();
  return result;
}

}  // namespace exsect::filter

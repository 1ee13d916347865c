#include "bernstein_box.h"

#include <algorithm>

#include "bernstein.h"

namespace exsect {
namespace {

using Rows = std::vector<std::vector<Rational>>;

/// Bernstein coefficients in both directions, [i][j].
Rows coefficients_on(const BivariatePolynomial& f, const RationalInterval& r, const RationalInterval& s) {
  if (f.is_zero()) return {{Rational(0)}};
  Rows in_s;
  for (int i = 0; i <= f.degree_r(); ++i)
    in_s.push_back(bernstein_coefficients(f.coefficient(i), f.degree_s(), s.lower, s.upper));
  Rows result(in_s.size(), std::vector<Rational>(in_s.front().size()));
  for (std::size_t j = 0; j < in_s.front().size(); ++j) {
    std::vector<Rational> column;
    for (const std::vector<Rational>& row : in_s) column.push_back(row[j]);
    const std::vector<Rational> b =
        bernstein_coefficients(Polynomial(column), f.degree_r(), r.lower, r.upper);
    for (std::size_t i = 0; i < b.size(); ++i) result[i][j] = b[i];
  }
  return result;
}

}  // namespace

BernsteinBox::BernsteinBox(const BivariatePolynomial& f, const RationalInterval& r, const RationalInterval& s)
    : denominator_(1) {
  const Rows rows = coefficients_on(f, r, s);
  for (const std::vector<Rational>& row : rows)
    for (const Rational& b : row) denominator_ = lcm(denominator_, denominator(b));
  for (const std::vector<Rational>& row : rows) {
    coefficients_.emplace_back();
    for (const Rational& b : row)
      coefficients_.back().push_back(numerator(b) * (denominator_ / denominator(b)));
  }
}

Rational BernsteinBox::lower() const {
  Integer least = coefficients_.front().front();
  for (const std::vector<Integer>& row : coefficients_)
    least = std::min(least, *std::min_element(row.begin(), row.end()));
  return Rational(least, denominator_);
}

Rational BernsteinBox::upper() const {
  Integer greatest = coefficients_.front().front();
  for (const std::vector<Integer>& row : coefficients_)
    greatest = std::max(greatest, *std::max_element(row.begin(), row.end()));
  return Rational(greatest, denominator_);
}

int BernsteinBox::sign() const {
  const int first = coefficients_.front().front().sign();
  for (const std::vector<Integer>& row : coefficients_)
    for (const Integer& b : row)
      if (b.sign() != first) return 0;
  return first;
}

int BernsteinBox::sign_at_corner(bool upper_r, bool upper_s) const {
  const std::vector<Integer>& row = upper_r ? coefficients_.back() : coefficients_.front();
  return (upper_s ? row.back() : row.front()).sign();
}

std::pair<BernsteinBox, BernsteinBox> BernsteinBox::split_r() const {
  const std::size_t n = coefficients_.size();
  BernsteinBox left, right;
  left.denominator_ = right.denominator_ = denominator_ << static_cast<unsigned>(n - 1);
  left.coefficients_.resize(n);
  right.coefficients_.resize(n);
  // De Casteljau with sums for means: after k steps the numbers are 2^k times too large.
  std::vector<std::vector<Integer>> row = coefficients_;
  const auto scaled = [n](std::vector<Integer> b, std::size_t step) {
    for (Integer& value : b) value <<= static_cast<unsigned>(n - 1 - step);
    return b;
  };
  for (std::size_t step = 0; step < n; ++step) {
    left.coefficients_[step] = scaled(row[0], step);
    right.coefficients_[n - 1 - step] = scaled(row[n - 1 - step], step);
    for (std::size_t i = 0; i + 1 + step < n; ++i)
      for (std::size_t j = 0; j < row[i].size(); ++j) row[i][j] += row[i + 1][j];
  }
  return {std::move(left), std::move(right)};
}

std::pair<BernsteinBox, BernsteinBox> BernsteinBox::split_s() const {
  const auto [left, right] = exchanged().split_r();
  return {left.exchanged(), right.exchanged()};
}

BernsteinBox BernsteinBox::exchanged() const {
  BernsteinBox result;
  result.denominator_ = denominator_;
  result.coefficients_.resize(coefficients_.front().size());
  for (const std::vector<Integer>& row : coefficients_)
    for (std::size_t j = 0; j < row.size(); ++j) result.coefficients_[j].push_back(row[j]);
  return result;
}

}  // namespace exsect

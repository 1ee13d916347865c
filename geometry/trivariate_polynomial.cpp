#include "trivariate_polynomial.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace exsect {
namespace {

using Matrix = std::vector<std::vector<Polynomial>>;

Matrix zeros(int degree_r, int degree_s) {
  return Matrix(static_cast<std::size_t>(degree_r + 1),
                std::vector<Polynomial>(static_cast<std::size_t>(degree_s + 1)));
}

}  // namespace

TrivariatePolynomial::TrivariatePolynomial(Matrix coefficients) : coefficients_(std::move(coefficients)) {
  std::size_t rows = 0;
  std::size_t columns = 0;
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    for (std::size_t j = 0; j < coefficients_[i].size(); ++j) {
      if (coefficients_[i][j].is_zero()) continue;
      rows = i + 1;
      columns = std::max(columns, j + 1);
    }
  }
  coefficients_.resize(rows);
  for (std::vector<Polynomial>& row : coefficients_) row.resize(columns);
}

int TrivariatePolynomial::degree_u() const {
  int degree = -1;
  for (const std::vector<Polynomial>& row : coefficients_)
    for (const Polynomial& c : row) degree = std::max(degree, c.degree());
  return degree;
}

Polynomial TrivariatePolynomial::coefficient(int i, int j) const {
  if (i < 0 || j < 0 || i > degree_r() || j > degree_s()) return {};
  return coefficients_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
}

BivariatePolynomial TrivariatePolynomial::at_u(const Rational& u) const {
  std::vector<Polynomial> in_r;
  for (const std::vector<Polynomial>& row : coefficients_) {
    std::vector<Rational> in_s;
    for (const Polynomial& c : row) in_s.push_back(c(u));
    in_r.emplace_back(in_s);
  }
  return BivariatePolynomial(std::move(in_r));
}

TrivariatePolynomial TrivariatePolynomial::derivative_r() const {
  Matrix result;
  for (std::size_t i = 1; i < coefficients_.size(); ++i) {
    result.push_back(coefficients_[i]);
    for (Polynomial& c : result.back()) c *= Polynomial(static_cast<int>(i));
  }
  return TrivariatePolynomial(std::move(result));
}

TrivariatePolynomial TrivariatePolynomial::derivative_s() const {
  Matrix result;
  for (const std::vector<Polynomial>& row : coefficients_) {
    result.emplace_back();
    for (std::size_t j = 1; j < row.size(); ++j)
      result.back().push_back(row[j] * Polynomial(static_cast<int>(j)));
  }
  return TrivariatePolynomial(std::move(result));
}

TrivariatePolynomial operator-(const TrivariatePolynomial& a, const TrivariatePolynomial& b) {
  Matrix result = zeros(std::max(a.degree_r(), b.degree_r()), std::max(a.degree_s(), b.degree_s()));
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < result[i].size(); ++j)
      result[i][j] = a.coefficient(static_cast<int>(i), static_cast<int>(j)) -
                     b.coefficient(static_cast<int>(i), static_cast<int>(j));
  return TrivariatePolynomial(std::move(result));
}

TrivariatePolynomial operator*(const TrivariatePolynomial& a, const TrivariatePolynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  Matrix result = zeros(a.degree_r() + b.degree_r(), a.degree_s() + b.degree_s());
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i)
    for (std::size_t j = 0; j < a.coefficients_[i].size(); ++j)
      for (std::size_t k = 0; k < b.coefficients_.size(); ++k)
        for (std::size_t l = 0; l < b.coefficients_[k].size(); ++l)
          result[i + k][j + l] += a.coefficients_[i][j] * b.coefficients_[k][l];
  return TrivariatePolynomial(std::move(result));
}

}  // namespace exsect

#include "special/space_form.h"

#include <exsect/algebra/rational_matrix.h>
#include <exsect/algebra/tensor_bernstein.h>

#include <algorithm>

namespace exsect {
namespace {

void append_monomials(const VectorPolynomial& x, std::size_t first, int degree,
                      const BivariatePolynomial& factor, std::vector<BivariatePolynomial>& result) {
  if (degree == 0) {
    result.push_back(factor);
    return;
  }
  for (std::size_t k = first; k < x.size(); ++k) append_monomials(x, k, degree - 1, factor * x[k], result);
}

}  // namespace

VectorPolynomial components(const RationalPatch& x) {
  return {x.component(0), x.component(1), x.component(2), x.component(3)};
}

std::vector<BivariatePolynomial> monomials(const VectorPolynomial& x, int degree) {
  std::vector<BivariatePolynomial> result;
  append_monomials(x, 0, degree, BivariatePolynomial::constant(1), result);
  return result;
}

BivariatePolynomial on_patch(const SpaceForm& form, const VectorPolynomial& x) {
  const std::vector<BivariatePolynomial> functions = monomials(x, form.degree);
  BivariatePolynomial sum;
  for (std::size_t i = 0; i < functions.size(); ++i)
    if (form.coefficients[i] != 0) sum += BivariatePolynomial::constant(form.coefficients[i]) * functions[i];
  return sum;
}

std::vector<std::vector<Integer>> relations(const std::vector<BivariatePolynomial>& functions) {
  int m = 0, n = 0;
  for (const BivariatePolynomial& f : functions) {
    m = std::max(m, f.degree_r() + 1);
    n = std::max(n, f.degree_s() + 1);
  }
  RationalMatrix matrix(static_cast<std::size_t>(m * n), functions.size());
  for (std::size_t k = 0; k < functions.size(); ++k)
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j)
        matrix(static_cast<std::size_t>(i * n + j), k) = functions[k].coefficient(i, j);
  return null_space(matrix);
}

std::vector<Rational> bernstein_values(const BivariatePolynomial& f, int m, int n) {
  std::vector<Rational> result;
  for (const std::vector<Rational>& row : tensor_bernstein(f, m, n))
    result.insert(result.end(), row.begin(), row.end());
  return result;
}

std::vector<Rational> bernstein_values(const BivariatePolynomial& f) {
  return bernstein_values(f, std::max(f.degree_r(), 0) + 2, std::max(f.degree_s(), 0) + 2);
}

}  // namespace exsect

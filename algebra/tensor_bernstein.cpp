#include "tensor_bernstein.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "bernstein.h"
#include "bernstein_box.h"

namespace exsect {
namespace {

using TensorCoefficients = std::vector<std::vector<Rational>>;

TensorCoefficients transposed(const TensorCoefficients& b) {
  TensorCoefficients result(b.front().size(), std::vector<Rational>(b.size()));
  for (std::size_t i = 0; i < b.size(); ++i)
    for (std::size_t j = 0; j < b[i].size(); ++j) result[j][i] = b[i][j];
  return result;
}

void extend(RationalInterval& range, const BernsteinBox& part, int depth) {
  if (depth == 0) {
    range.lower = std::min(range.lower, part.lower());
    range.upper = std::max(range.upper, part.upper());
    return;
  }
  const auto [left, right] = part.split_r();
  for (const BernsteinBox* half : {&left, &right}) {
    const auto [lower, upper] = half->split_s();
    extend(range, lower, depth - 1);
    extend(range, upper, depth - 1);
  }
}

}  // namespace

TensorCoefficients tensor_bernstein(const BivariatePolynomial& f, int m, int n, const Rectangle& on) {
  if (m < 0 || n < 0 || m < f.degree_r())
    throw std::invalid_argument("tensor_bernstein: the degree is less than that of the polynomial");
  TensorCoefficients in_s;
  for (int i = 0; i <= m; ++i)
    in_s.push_back(bernstein_coefficients(f.coefficient(i), n, on.s.lower, on.s.upper));
  TensorCoefficients columns;
  for (const std::vector<Rational>& powers : transposed(in_s))
    columns.push_back(bernstein_coefficients(Polynomial(powers), m, on.r.lower, on.r.upper));
  return transposed(columns);
}

RationalInterval range_bound(const BivariatePolynomial& f, const Rectangle& on, int depth) {
  if (depth < 0 || depth > 10) throw std::invalid_argument("range_bound: 0 <= depth <= 10 is required");
  const Rational at_corner = f(on.r.lower, on.s.lower);
  RationalInterval range = {at_corner, at_corner};
  extend(range, BernsteinBox(f, on.r, on.s), depth);
  return range;
}

}  // namespace exsect

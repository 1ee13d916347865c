#include "tensor_bernstein.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "bernstein.h"

namespace exsect {
namespace {

using Coefficients = std::vector<std::vector<Rational>>;

Coefficients transposed(const Coefficients& b) {
  Coefficients result(b.front().size(), std::vector<Rational>(b.size()));
  for (std::size_t i = 0; i < b.size(); ++i)
    for (std::size_t j = 0; j < b[i].size(); ++j) result[j][i] = b[i][j];
  return result;
}

/// The two halves of every row.
std::array<Coefficients, 2> halves(const Coefficients& b) {
  std::array<Coefficients, 2> result;
  for (const std::vector<Rational>& row : b) {
    BernsteinHalves half = split_bernstein(row, Rational(1, 2));
    result[0].push_back(std::move(half.left));
    result[1].push_back(std::move(half.right));
  }
  return result;
}

void extend(RationalInterval& range, const Coefficients& b, int depth) {
  if (depth == 0) {
    for (const std::vector<Rational>& row : b)
      for (const Rational& c : row) {
        range.lower = std::min(range.lower, c);
        range.upper = std::max(range.upper, c);
      }
    return;
  }
  for (const Coefficients& in_s : halves(b))
    for (const Coefficients& part : halves(transposed(in_s))) extend(range, transposed(part), depth - 1);
}

}  // namespace

Coefficients tensor_bernstein(const BivariatePolynomial& f, int m, int n, const Rectangle& on) {
  if (m < 0 || n < 0 || m < f.degree_r())
    throw std::invalid_argument("tensor_bernstein: the degree is less than that of the polynomial");
  Coefficients in_s;
  for (int i = 0; i <= m; ++i)
    in_s.push_back(bernstein_coefficients(f.coefficient(i), n, on.s.lower, on.s.upper));
  Coefficients columns;
  for (const std::vector<Rational>& powers : transposed(in_s))
    columns.push_back(bernstein_coefficients(Polynomial(powers), m, on.r.lower, on.r.upper));
  return transposed(columns);
}

RationalInterval range_bound(const BivariatePolynomial& f, const Rectangle& on, int depth) {
  if (depth < 0 || depth > 10) throw std::invalid_argument("range_bound: 0 <= depth <= 10 is required");
  const Coefficients b = tensor_bernstein(f, std::max(f.degree_r(), 0), std::max(f.degree_s(), 0), on);
  RationalInterval range = {b[0][0], b[0][0]};  // a corner value
  extend(range, b, depth);
  return range;
}

}  // namespace exsect

#include "space_bernstein.h"

#include <exsect/algebra/bernstein.h>

#include <algorithm>

namespace exsect {
namespace {

using Sizes = std::array<std::size_t, 3>;

std::size_t stride(const Sizes& size, std::size_t axis) {
  return axis == 0 ? size[1] * size[2] : axis == 1 ? size[2] : 1;
}

/// The positions of the first elements of all lines along the axis.
std::vector<std::size_t> line_starts(const Sizes& size, std::size_t axis) {
  const std::size_t step = stride(size, axis);
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < size[0] * size[1] * size[2]; ++i)
    if (i / step % size[axis] == 0) starts.push_back(i);
  return starts;
}

}  // namespace

SpaceBernstein::SpaceBernstein(const SpacePolynomial& f, const SpaceBox& box) : denominator_(1) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    size_[axis] = static_cast<std::size_t>(std::max(f.degree_in(axis), 0)) + 1;
  std::vector<Rational> values(size_[0] * size_[1] * size_[2], 0);
  for (const auto& [e, c] : f.terms())
    values[(static_cast<std::size_t>(e[0]) * size_[1] + static_cast<std::size_t>(e[1])) * size_[2] +
           static_cast<std::size_t>(e[2])] = c;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t step = stride(size_, axis);
    for (const std::size_t start : line_starts(size_, axis)) {
      std::vector<Rational> line;
      for (std::size_t i = 0; i < size_[axis]; ++i) line.push_back(values[start + i * step]);
      const std::vector<Rational> b = bernstein_coefficients(
          Polynomial(line), static_cast<int>(size_[axis]) - 1, box[axis].lower, box[axis].upper);
      for (std::size_t i = 0; i < b.size(); ++i) values[start + i * step] = b[i];
    }
  }
  for (const Rational& b : values) denominator_ = lcm(denominator_, denominator(b));
  for (const Rational& b : values) coefficients_.push_back(numerator(b) * (denominator_ / denominator(b)));
}

RationalInterval SpaceBernstein::range() const {
  const auto [least, greatest] = std::minmax_element(coefficients_.begin(), coefficients_.end());
  return {Rational(*least, denominator_), Rational(*greatest, denominator_)};
}

int SpaceBernstein::sign() const {
  const int first = coefficients_.front().sign();
  return std::all_of(coefficients_.begin(), coefficients_.end(),
                     [first](const Integer& b) { return b.sign() == first; })
             ? first
             : 0;
}

std::pair<SpaceBernstein, SpaceBernstein> SpaceBernstein::split(std::size_t axis) const {
  const std::size_t n = size_[axis], step = stride(size_, axis);
  SpaceBernstein left = *this, right = *this;
  left.denominator_ = right.denominator_ = denominator_ << static_cast<unsigned>(n - 1);
  for (const std::size_t start : line_starts(size_, axis)) {
    // De Casteljau with sums for means: after k steps the numbers are 2^k times too large.
    std::vector<Integer> line;
    for (std::size_t i = 0; i < n; ++i) line.push_back(coefficients_[start + i * step]);
    for (std::size_t k = 0; k < n; ++k) {
      const auto missing = static_cast<unsigned>(n - 1 - k);
      left.coefficients_[start + k * step] = line[0] << missing;
      right.coefficients_[start + (n - 1 - k) * step] = line[n - 1 - k] << missing;
      for (std::size_t i = 0; i + 1 + k < n; ++i) line[i] += line[i + 1];
    }
  }
  return {std::move(left), std::move(right)};
}

}  // namespace exsect

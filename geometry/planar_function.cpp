#include "planar_function.h"

#include <algorithm>
#include <stdexcept>

namespace exsect {
namespace {

using Cells = std::vector<std::vector<std::optional<BivariatePolynomial>>>;

/// First and last interval of the breaks that together cover [lower, upper]; nothing if they do not.
struct IntervalRange {
  std::size_t first;
  std::size_t last;
};

std::optional<IntervalRange> covering(const std::vector<Rational>& breaks, const RationalInterval& range) {
  if (range.lower < breaks.front() || range.upper > breaks.back()) return std::nullopt;
  std::size_t first = 0;
  while (first + 2 < breaks.size() && breaks[first + 1] <= range.lower) ++first;
  std::size_t last = first;
  while (breaks[last + 1] < range.upper) ++last;
  return IntervalRange{first, last};
}

bool ascends(const std::vector<Rational>& breaks) {
  return breaks.size() >= 2 &&
         std::adjacent_find(breaks.begin(), breaks.end(), std::greater_equal<>()) == breaks.end();
}

RationalInterval squares(const RationalInterval& x) {
  const Rational a = x.lower * x.lower, b = x.upper * x.upper;
  const bool holds_zero = x.lower <= 0 && x.upper >= 0;
  return {holds_zero ? Rational(0) : std::min(a, b), std::max(a, b)};
}

}  // namespace

PlanarFunction::PlanarFunction(BivariatePolynomial polynomial) : cells_({{std::move(polynomial)}}) {}

PlanarFunction::PlanarFunction(Grid grid, Cells cells) : grid_(std::move(grid)), cells_(std::move(cells)) {
  if (!ascends(grid_.breaks_x) || !ascends(grid_.breaks_y))
    throw std::invalid_argument("planar function: breaks must ascend");
  bool fits = cells_.size() + 1 == grid_.breaks_x.size();
  for (const auto& row : cells_) fits = fits && row.size() + 1 == grid_.breaks_y.size();
  if (!fits) throw std::invalid_argument("planar function: one cell for each pair of intervals is required");
}

const BivariatePolynomial& PlanarFunction::polynomial() const {
  if (!is_polynomial()) throw std::domain_error("planar function: a spline is no polynomial");
  return *cells_.front().front();
}

std::vector<BivariatePolynomial> PlanarFunction::polynomials_on(const PlanarBox& box) const {
  if (is_polynomial()) return {polynomial()};
  const auto in_x = covering(grid_.breaks_x, grid_.squared ? squares(box.x) : box.x);
  const auto in_y = covering(grid_.breaks_y, box.y);
  if (!in_x || !in_y) return {};
  std::vector<BivariatePolynomial> result;
  for (std::size_t i = in_x->first; i <= in_x->last; ++i) {
    for (std::size_t j = in_y->first; j <= in_y->last; ++j) {
      if (!cells_[i][j]) return {};
      result.push_back(*cells_[i][j]);
    }
  }
  return result;
}

std::optional<Rational> PlanarFunction::operator()(const Rational& x, const Rational& y) const {
  const std::vector<BivariatePolynomial> there = polynomials_on({{x, x}, {y, y}});
  if (there.empty()) return std::nullopt;
  return there.front()(x, y);
}

}  // namespace exsect

#include "self/coincident_lines.h"

#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <vector>

namespace exsect {
namespace {

/// Row by row the coefficients of 1, t, t^2, t^3 of each homogeneous coordinate of each column of the net.
RationalMatrix coefficient_rows(const RationalPatch& patch) {
  const auto columns = static_cast<std::size_t>(patch.degree_v()) + 1;
  RationalMatrix rows(4 * columns, 4);
  for (std::size_t j = 0; j < columns; ++j) {
    for (std::size_t c = 0; c < 4; ++c) {
      std::array<Rational, 4> p;
      for (int i = 0; i < 4; ++i)
        p[static_cast<std::size_t>(i)] = patch.homogeneous(i, static_cast<int>(j))[c];
      const std::array<Rational, 4> power = {p[0], 3 * (p[1] - p[0]), 3 * (p[0] - 2 * p[1] + p[2]),
                                             p[3] - 3 * p[2] + 3 * p[1] - p[0]};
      for (std::size_t i = 0; i < 4; ++i) rows(4 * j + c, i) = power[i];
    }
  }
  return rows;
}

}  // namespace

bool CoincidentLines::pass(const ParameterRectangle& first, const ParameterRectangle& second) const {
  const auto value = [&](const Rational& t) { return (t - sum) * t + product; };
  const auto has_one = [&](const RationalInterval& range) {
    return value(range.lower) * value(range.upper) < 0;
  };
  const auto fixed_range = [&](const ParameterRectangle& cell) { return fixed == 0 ? cell.u : cell.v; };
  const auto free_range = [&](const ParameterRectangle& cell) { return fixed == 0 ? cell.v : cell.u; };
  const RationalInterval a = fixed_range(first), b = fixed_range(second);
  const RationalInterval c = free_range(first), d = free_range(second);
  return (a.upper < b.lower || b.upper < a.lower) && has_one(a) && has_one(b) &&
         std::max(c.lower, d.lower) < std::min(c.upper, d.upper);
}

std::optional<CoincidentLines> coincident_lines(const RationalPatch& patch, std::size_t fixed) {
  const RationalPatch reduced = fixed == 0 ? patch.reduced() : patch.reduced().transposed();
  if (reduced.degree_u() < 3) return std::nullopt;
  const auto moments = null_space(coefficient_rows(reduced));
  if (moments.size() != 1) return std::nullopt;
  const std::vector<Integer>& m = moments[0];
  const Integer determinant = m[1] * m[1] - m[0] * m[2];
  if (determinant == 0) return std::nullopt;
  const Rational sum(Integer(m[1] * m[2] - m[0] * m[3]), determinant);
  const Rational product(Integer(m[2] * m[2] - m[1] * m[3]), determinant);
  if (!(sum * sum > 4 * product)) return std::nullopt;
  return CoincidentLines{fixed, sum, product};
}

}  // namespace exsect

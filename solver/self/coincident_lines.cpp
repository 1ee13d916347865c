#include "self/coincident_lines.h"

#include <algorithm>
#include <vector>

namespace exsect {
namespace {

/// Coefficients a1, a2, a3 of t, t^2, t^3 of every coordinate of the columns of a net: (f(t1) - f(t2)) /
/// (t1 - t2) is a1 + a2 s + a3 e, s = t1 + t2, e = s^2 - t1 t2.
std::vector<Point> coefficient_rows(const RationalPatch& patch) {
  const RationalPatch cubic = patch.elevated(3, patch.degree_v());
  std::vector<Point> rows;
  for (int j = 0; j <= cubic.degree_v(); ++j) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<Rational, 4> p;
      for (int i = 0; i < 4; ++i) p[static_cast<std::size_t>(i)] = cubic.point(i, j)[c];
      rows.push_back({3 * (p[1] - p[0]), 3 * (p[0] - 2 * p[1] + p[2]), p[3] - 3 * p[2] + 3 * p[1] - p[0]});
    }
  }
  return rows;
}

/// The direction perpendicular to all rows, if there is one alone.
std::optional<Point> common_normal_of(const std::vector<Point>& rows) {
  for (const Point& a : rows) {
    if (is_zero(a)) continue;
    for (const Point& b : rows) {
      const Point n = cross(a, b);
      if (is_zero(n)) continue;
      const bool all = std::ranges::all_of(rows, [&](const Point& row) { return dot(row, n) == 0; });
      return all ? std::optional(n) : std::nullopt;
    }
  }
  return std::nullopt;
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
  if (!patch.is_polynomial()) return std::nullopt;
  const RationalPatch& reduced = patch.reduced();
  const auto normal = common_normal_of(coefficient_rows(fixed == 0 ? reduced : reduced.transposed()));
  if (!normal || (*normal)[0] == 0) return std::nullopt;
  const Rational sum = (*normal)[1] / (*normal)[0], product = sum * sum - (*normal)[2] / (*normal)[0];
  if (!(sum * sum > 4 * product)) return std::nullopt;
  return CoincidentLines{fixed, sum, product};
}

}  // namespace exsect

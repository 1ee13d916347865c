#include "certificate/regular.h"

#include <exsect/checker/curve_bounds.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "certificate/claims.h"
#include "certificate/search.h"

namespace exsect::cli {
namespace {

using checker::Algebraic;
using checker::others;
using checker::Star;

using ExactTangent = checker::Vector4<Algebraic>;
/// Of a star.
constexpr std::size_t max_weight = 6;

using Columns = std::vector<AlgebraicColumn>;

/// The kernel of DF, 0 if its rank is not 3.
ExactTangent exact_tangent(const std::array<AlgebraicColumn, 4>& columns) {
  ExactTangent result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto o = others(k);
    result[k] = Algebraic(k % 2 == 0 ? 1 : -1) *
                checker::dot(columns[o[0]], checker::cross(columns[o[1]], columns[o[2]]));
  }
  return result;
}

std::size_t largest_coordinate(const AlgebraicColumn& c) {
  const auto size = [&](std::size_t d) { return std::abs(checker::number<double>(c[d])); };
  return size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
}

AlgebraicColumn unit_row(std::size_t d) {
  AlgebraicColumn result;
  result[d] = 1;
  return result;
}

/// A basis of all n with n . c = 0 for each column c.
Columns normals_to(const Columns& columns) {
  const AlgebraicColumn zero = {};
  const auto first = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c != zero; });
  if (first == columns.end()) return {unit_row(0), unit_row(1), unit_row(2)};
  for (const auto& second : columns) {
    const auto normal = checker::cross(*first, second);
    if (normal == zero) continue;
    const auto is_across = [&](const auto& c) { return checker::dot(normal, c) == 0; };
    return std::all_of(columns.begin(), columns.end(), is_across) ? Columns{normal} : Columns{};
  }
  const std::size_t d = largest_coordinate(*first);
  return {checker::cross(*first, unit_row((d + 1) % 3)), checker::cross(*first, unit_row((d + 2) % 3))};
}

/// The row is no combination of the others.
bool is_independent(const Columns& rows, const AlgebraicColumn& row) {
  if (rows.empty()) return true;
  if (rows.size() == 1) return checker::cross(rows[0], row) != AlgebraicColumn{};
  return !(checker::dot(checker::cross(rows[0], rows[1]), row) == 0);
}

/// Three independent rows, of which as many as possible vanish on the columns of DF of parameters with the
/// weights 1, ..., k, for each k; these come last.
checker::Matrix3<Algebraic> rows_across(const std::array<AlgebraicColumn, 4>& columns,
                                        const std::array<std::size_t, 4>& weights) {
  Columns rows;
  for (std::size_t k = max_weight; k > 0; --k) {
    Columns lighter;
    for (std::size_t j = 0; j < 4; ++j)
      if (weights[j] < k) lighter.push_back(columns[j]);
    for (const auto& normal : normals_to(lighter))
      if (rows.size() < 3 && is_independent(rows, normal)) rows.push_back(normal);
  }
  return {rows[2], rows[1], rows[0]};
}

/// The first coefficients of a power series without a constant one: of t, t^2, ...
using Series = std::array<Algebraic, max_weight>;

Series product_of(const Series& a, const Series& b) {
  Series result;
  for (std::size_t i = 0; i < max_weight; ++i)
    for (std::size_t j = 0; i + j + 1 < max_weight; ++j)
      if (!(a[i] == 0) && !(b[j] == 0)) result[i + j + 1] += a[i] * b[j];
  return result;
}

/// F, 0 at the point, along the parameters' series.
std::array<Series, 3> value_along(const AlgebraicMap& local, const std::array<Series, 4>& w) {
  std::array<Series, 3> result;
  for (const auto& term : local.terms()) {
    if (static_cast<std::size_t>(std::accumulate(term.power.begin(), term.power.end(), 0)) > max_weight)
      continue;
    std::optional<Series> factor;
    for (std::size_t i = 0; i < 4; ++i)
      for (int n = 0; n < term.power[i]; ++n) factor = factor ? product_of(*factor, w[i]) : w[i];
    for (std::size_t d = 0; factor && d < 3; ++d)
      for (std::size_t n = 0; n < max_weight; ++n) result[d][n] += term.c[d] * (*factor)[n];
  }
  return result;
}

/// The parameters' differences from the point along the curve, as series in that of the axis: each step of
/// w - C F, C the inverse of the other columns, gives one more coefficient.
std::array<Series, 4> series_along(const AlgebraicMap& local, const std::array<AlgebraicColumn, 4>& columns,
                                   std::size_t axis) {
  const auto o = others(axis);
  const Algebraic factor =
      reciprocal(checker::dot(columns[o[0]], checker::cross(columns[o[1]], columns[o[2]])));
  std::array<Series, 4> w;
  w[axis][0] = 1;
  for (std::size_t step = 0; step < max_weight; ++step) {
    const std::array<Series, 3> f = value_along(local, w);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = checker::cross(columns[o[(i + 1) % 3]], columns[o[(i + 2) % 3]]);
      const Algebraic c = Algebraic(-1) * factor;
      for (std::size_t n = 0; n < max_weight; ++n)
        w[o[i]][n] += c * checker::dot(row, {f[0][n], f[1][n], f[2][n]});
    }
  }
  return w;
}

/// A power of 2 between twice and four times |a|; 1 for 0.
Rational scale_above(double a) {
  return std::abs(a) > 0x1p-60 ? power_of_two(std::ilogb(a) + 2) : Rational(1);
}

/// The curve's derivatives at the point, nothing if it has none there along the axis.
std::optional<checker::CurveBounds<double>> curve_derivatives(const Map& map, const Parameters& w,
                                                              std::size_t axis) {
  const Map local = map.at(w);
  const auto c = inverse(local, axis);
  if (!c) return std::nullopt;
  return checker::curve_bounds(local.times(*c), axis, {});
}

}  // namespace

namespace {

/// A regular solution: the columns of DF, and the parameters as series in that of the axis.
struct RegularPoint {
  std::array<AlgebraicColumn, 4> columns;
  std::size_t axis;
  std::array<Series, 4> along;

  /// The order in which the parameter leaves; max_weight + 1 if it stays.
  std::size_t order(std::size_t j) const {
    std::size_t n = 0;
    while (n < max_weight && along[j][n] == 0) ++n;
    return n + 1;
  }
};

std::optional<RegularPoint> regular_point(const ExactMap& equation, const AlgebraicPoint& at) {
  const AlgebraicMap local = about(equation, at);
  const auto columns = columns_of_derivative(local);
  const ExactTangent tangent = exact_tangent(columns);
  const auto size = [&](std::size_t j) { return std::abs(checker::number<double>(tangent[j])); };
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 4; ++j)
    if (size(j) > size(axis)) axis = j;
  if (tangent[axis] == 0) return std::nullopt;
  return RegularPoint{columns, axis, series_along(local, columns, axis)};
}

}  // namespace

std::array<bool, 4> constant_at(const ExactMap& equation, const AlgebraicPoint& at) {
  std::array<bool, 4> result = {};
  const auto point = regular_point(equation, at);
  for (std::size_t j = 0; point && j < 4; ++j) result[j] = point->order(j) > max_weight;
  return result;
}

std::optional<Star> regular_star(const ExactMap& equation, const AlgebraicPoint& at) {
  const auto point = regular_point(equation, at);
  if (!point) return std::nullopt;
  Star star = {at.root, at.parameters, {}, {}, {1, 1, 1, 1}, {}, {1, 1, 1}, {}};
  for (std::size_t j = 0; j < 4; ++j) {
    const std::size_t n = point->order(j);
    const bool constant = n > max_weight;
    star.weights[j] = constant ? 2 : n;
    star.axes[j][j] = j == point->axis || constant
                          ? Rational(1)
                          : scale_above(checker::number<double>(point->along[j][n - 1]));
  }
  star.rows = rows_across(point->columns, star.weights);
  return star;
}

bool turns_at_side(const Map& near, const SingularSearch& search, const Node& node) {
  const auto along = curve_derivatives(near, node.approx, best_axis(near, node.approx));
  if (!along) return false;
  const auto may_turn = [&](const Side& side) {
    const std::size_t i = index(side.parameter);
    return std::abs(along->first[i].middle) < 1e-6 && std::abs(along->second[i].middle) > 1e-3;
  };
  if (std::none_of(node.on.begin(), node.on.end(), may_turn)) return false;
  try {
    for (const AlgebraicPoint& at : points_in_box(search, node)) {
      const ExactTangent tangent = exact_tangent(columns_of_derivative(about(search.equation, at)));
      const auto turns = [&](const Side& side) { return tangent[index(side.parameter)] == 0; };
      if (tangent != ExactTangent{} && std::any_of(node.on.begin(), node.on.end(), turns)) return true;
    }
  } catch (const NoCertificate&) {
  }
  return false;
}

}  // namespace exsect::cli

#include "filter/corner_equation.h"

#include <exsect/algebra/bernstein.h>

#include <algorithm>
#include <utility>

namespace exsect::filter {

namespace {

/// Coefficients of powers from control vectors, along one row.
void to_powers(std::vector<HomogeneousPoint>& row) {
  const int n = static_cast<int>(row.size()) - 1;
  for (std::size_t step = 1; step < row.size(); ++step)
    for (std::size_t k = row.size() - 1; k >= step; --k)
      for (std::size_t c = 0; c < 4; ++c) row[k][c] -= row[k - 1][c];
  for (std::size_t k = 0; k < row.size(); ++k)
    for (Rational& c : row[k]) c *= binomial(n, static_cast<int>(k));
}

/// The four homogeneous coordinates at two parameters.
std::array<PlaneSeries, 4> values_at(const ControlVectors& c, const PlaneSeries& a, const PlaneSeries& b) {
  const PlaneSeries zero(a.order(), a.reach());
  const PlaneSeries one = PlaneSeries::power(a.order(), a.reach(), 0, 0);
  std::array<PlaneSeries, 4> result = {zero, zero, zero, zero};
  PlaneSeries first = one;
  for (const auto& row : c) {
    PlaneSeries product = first;
    for (const HomogeneousPoint& h : row) {
      for (std::size_t k = 0; k < 4; ++k)
        if (h[k] != 0) result[k].add(product, h[k]);
      if (&h != &row.back()) product = product * b;
    }
    if (&row != &c.back()) first = first * a;
  }
  return result;
}

/// sum |c_ij . row| a^i b^j for a form on space or, if `row` is empty, for the weight; and with the powers'
/// derivatives by one parameter.
struct Sizes {
  Rational value;
  std::array<Rational, 2> slope;
};
/// Without the terms of order up to 1, and 0, for which `least` is 2, and 1.
Sizes sizes(const ControlVectors& c, const Point* row, const std::array<Rational, 2>& at, std::size_t least) {
  Sizes result{0, {0, 0}};
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < c[i].size(); ++j) {
      const HomogeneousPoint& h = c[i][j];
      if (i + j < least) continue;
      const Rational size = abs(row ? exsect::dot(*row, Point{h[0], h[1], h[2]}) : h[3]);
      if (size == 0) continue;
      result.value += size * power(at[0], static_cast<int>(i)) * power(at[1], static_cast<int>(j));
      if (i > 0)
        result.slope[0] +=
            size * Rational(i) * power(at[0], static_cast<int>(i) - 1) * power(at[1], static_cast<int>(j));
      if (j > 0)
        result.slope[1] +=
            size * Rational(j) * power(at[0], static_cast<int>(i)) * power(at[1], static_cast<int>(j) - 1);
    }
  return result;
}

}  // namespace

ControlVectors power_coefficients(const CornerNet& corner) {
  ControlVectors net = corner.points;
  for (auto& row : net) to_powers(row);
  for (std::size_t j = 0; j < net.front().size(); ++j) {
    std::vector<HomogeneousPoint> column;
    for (const auto& row : net) column.push_back(row[j]);
    to_powers(column);
    for (std::size_t i = 0; i < net.size(); ++i) net[i][j] = column[i];
  }
  return net;
}

// (14.128).
std::optional<CornerEquation> divided_at_sides(const CornerEquation& equation,
                                               const std::vector<SideAtCorner>& sides) {
  std::array<int, 2> power = {0, 0};
  for (const SideAtCorner& side : sides) {
    std::array<bool, 2> is_across{};
    for (std::size_t k = 0; k < 2; ++k)
      is_across[k] = std::ranges::count(side.across, equation.split.free[k]) > 0;
    if (is_across[0] == is_across[1]) return std::nullopt;
    int& own = power[is_across[0] ? 0 : 1];
    if (own > 0) return std::nullopt;
    own = side.touching ? 2 : 1;
  }
  auto normal = equation.normal.divided(power[0], power[1]);
  if (!normal) return std::nullopt;
  return CornerEquation{equation.split, equation.bound, *std::move(normal)};
}

CornerSystem::CornerSystem(const CornerNet& x, const CornerNet& y)
    : x_(power_coefficients(x)), y_(power_coefficients(y)) {
  using exsect::operator*;
  const auto slope = [](const HomogeneousPoint& h) { return Point{h[0], h[1], h[2]}; };
  const Rational of_x = y_[0][0][3], of_y = -x_[0][0][3];
  slope_ = {of_x * slope(x_[1][0]), of_x * slope(x_[0][1]), of_y * slope(y_[1][0]), of_y * slope(y_[0][1])};
}

std::vector<CornerSplit> CornerSystem::splits() const {
  std::vector<CornerSplit> result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Point normal = exsect::cross(slope_[i], slope_[j]);
      if (exsect::is_zero(normal)) continue;
      CornerSplit split{{}, {i, j}};
      std::size_t count = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        if (exsect::dot(normal, slope_[k]) != 0) return {};
        if (k != i && k != j) split.free[count++] = k;
      }
      result.push_back(split);
    }
  return result;
}

CornerSystem::Rows CornerSystem::rows(const CornerSplit& split) const {
  using exsect::operator*;
  const Point &a = slope_[split.bound[0]], &b = slope_[split.bound[1]];
  const Point normal = exsect::cross(a, b);
  const Rational scale = 1 / exsect::dot(normal, normal);
  return {scale * exsect::cross(b, normal), scale * exsect::cross(normal, a), normal};
}

std::vector<PlaneSeries> CornerSystem::values(const CornerSplit& split,
                                              const std::array<PlaneSeries, 2>& bound,
                                              const Rows& rows) const {
  const int order = bound[0].order();
  const Rational& reach = bound[0].reach();
  std::array<const PlaneSeries*, 4> at{};
  const std::array<PlaneSeries, 2> free = {PlaneSeries::power(order, reach, 1, 0),
                                           PlaneSeries::power(order, reach, 0, 1)};
  for (std::size_t k = 0; k < 2; ++k) {
    at[split.free[k]] = &free[k];
    at[split.bound[k]] = &bound[k];
  }
  const auto x = values_at(x_, *at[0], *at[1]), y = values_at(y_, *at[2], *at[3]);
  std::vector<PlaneSeries> difference;
  for (std::size_t c = 0; c < 3; ++c) {
    difference.push_back(x[c] * y[3]);
    difference.back().add(y[c] * x[3], -1);
  }
  std::vector<PlaneSeries> result;
  for (const Point& row : rows) {
    PlaneSeries& sum = result.emplace_back(order, reach);
    for (std::size_t c = 0; c < 3; ++c) sum.add(difference[c], row[c]);
  }
  return result;
}

// Each step makes one more order right.
std::array<PlaneSeries, 2> CornerSystem::series(const CornerSplit& split, int order) const {
  const Rows forms = rows(split);
  std::array<PlaneSeries, 2> result = {PlaneSeries(1, 1), PlaneSeries(1, 1)};
  for (int k = 1; k <= order; ++k) {
    for (PlaneSeries& each : result) each = each.polynomial(k, 1);
    const auto value = values(split, result, forms);
    for (std::size_t i = 0; i < 2; ++i) result[i].add(value[i].polynomial(k, 1), -1);
  }
  return {result[0].polynomial(order, 1), result[1].polynomial(order, 1)};
}

// With (X_(i) Y_4 - Y_(i) X_4) for the row i: the terms of order 2 and more of it, differentiated.
Rational CornerSystem::turning(const CornerSplit& split, const Rows& rows, const Rational& free_size,
                               const Rational& bound_size) const {
  std::array<Rational, 4> at;
  for (std::size_t k = 0; k < 2; ++k) {
    at[split.free[k]] = free_size;
    at[split.bound[k]] = bound_size;
  }
  const std::array<Rational, 2> of_x = {at[0], at[1]}, of_y = {at[2], at[3]};
  const Sizes weight_x = sizes(x_, nullptr, of_x, 1), weight_y = sizes(y_, nullptr, of_y, 1);
  const Rational x4 = abs(x_[0][0][3]), y4 = abs(y_[0][0][3]);
  Rational most = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Sizes x1 = sizes(x_, &rows[i], of_x, 1), x2 = sizes(x_, &rows[i], of_x, 2);
    const Sizes y1 = sizes(y_, &rows[i], of_y, 1), y2 = sizes(y_, &rows[i], of_y, 2);
    Rational sum = 0;
    for (const std::size_t j : split.bound) {
      if (j < 2)
        sum += x2.slope[j] * y4 + x1.slope[j] * weight_y.value + y1.value * weight_x.slope[j];
      else
        sum += y2.slope[j - 2] * x4 + y1.slope[j - 2] * weight_x.value + x1.value * weight_y.slope[j - 2];
    }
    most = std::max(most, sum);
  }
  return most;
}

// (14.122).
std::optional<CornerEquation> CornerSystem::equation(const CornerSplit& split,
                                                     const std::array<PlaneSeries, 2>& series,
                                                     const Rational& reach) const {
  const int order = series[0].order();
  std::array<PlaneSeries, 2> bound = {series[0].polynomial(order, reach), series[1].polynomial(order, reach)};
  const Rational room = std::max(bound[0].size(), bound[1].size()) + reach;
  const Rows forms = rows(split);
  const Rational turn = turning(split, forms, reach, room);
  if (!(turn < Rational(1, 2))) return std::nullopt;
  const auto residual = values(split, bound, forms);
  if (!residual[0].is_polynomial_zero() || !residual[1].is_polynomial_zero()) return std::nullopt;
  const Rational rest = std::max(residual[0].rest(), residual[1].rest()) / (1 - turn);
  for (PlaneSeries& each : bound) {
    each.widen(rest);
    if (!(each.size() <= room)) return std::nullopt;
  }
  PlaneSeries normal = values(split, bound, forms)[2];
  return CornerEquation{split, std::move(bound), std::move(normal)};
}

}  // namespace exsect::filter

#include "bezier_patch.h"

#include <stdexcept>
#include <utility>

namespace exsect {
namespace {

/// The coefficients of a vector quadratic in one parameter, in the Bernstein or the power basis.
using Quadratic = std::array<Point, 3>;

Point between(const Point& a, const Point& b, const Rational& t) { return a + t * (b - a); }

/// Polar form (blossom) of the quadratic with Bernstein coefficients b: symmetric, affine in s and in t, and
/// equal to the quadratic's value for s = t.
Point blossom(const Quadratic& b, const Rational& s, const Rational& t) {
  return between(between(b[0], b[1], s), between(b[1], b[2], s), t);
}

/// Derivative at t of the quadratic with Bernstein coefficients b.
Point derivative(const Quadratic& b, const Rational& t) {
  return Rational(2) * between(b[1] - b[0], b[2] - b[1], t);
}

Quadratic bernstein_to_power(const Quadratic& b) {
  return {b[0], Rational(2) * (b[1] - b[0]), b[0] - Rational(2) * b[1] + b[2]};
}

Quadratic power_to_bernstein(const Quadratic& c) {
  return {c[0], c[0] + Rational(1, 2) * c[1], c[0] + c[1] + c[2]};
}

Quadratic elevated_to_quadratic(const std::vector<Point>& points) {
  if (points.size() == 2) return {points[0], Rational(1, 2) * (points[0] + points[1]), points[1]};
  if (points.size() == 3) return {points[0], points[1], points[2]};
  throw std::invalid_argument("Bezier patch: every row must have 2 or 3 points, as many as the first");
}

ControlNet transposed(const ControlNet& net) {
  ControlNet result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = net[j][i];
  return result;
}

/// The map applied to the rows, then to the columns.
template <class RowMap, class ColumnMap>
ControlNet mapped(ControlNet net, RowMap map_rows, ColumnMap map_columns) {
  for (Quadratic& row : net) row = map_rows(row);
  net = transposed(net);
  for (Quadratic& column : net) column = map_columns(column);
  return transposed(net);
}

}  // namespace

BezierPatch BezierPatch::elevated(const std::vector<std::vector<Point>>& points) {
  if (points.size() != 2 && points.size() != 3)
    throw std::invalid_argument("Bezier patch: there must be 2 or 3 rows of control points");
  std::vector<Quadratic> rows;
  for (const std::vector<Point>& row : points) {
    if (row.size() != points.front().size())
      throw std::invalid_argument("Bezier patch: all rows must have the same number of control points");
    rows.push_back(elevated_to_quadratic(row));
  }
  if (rows.size() == 3) return BezierPatch({std::move(rows[0]), std::move(rows[1]), std::move(rows[2])});
  ControlNet columns;
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Point> column;
    for (const Quadratic& row : rows) column.push_back(row[j]);
    columns[j] = elevated_to_quadratic(column);
  }
  return BezierPatch(transposed(columns));
}

BezierPatch BezierPatch::from_power_basis(const ControlNet& c) {
  return BezierPatch(mapped(c, power_to_bernstein, power_to_bernstein));
}

const ControlNet& BezierPatch::power_basis() const {
  std::call_once(nets_->has_power,
                 [this] { nets_->power = mapped(net(), bernstein_to_power, bernstein_to_power); });
  return nets_->power;
}

Point BezierPatch::operator()(const Rational& u, const Rational& v) const {
  return blossom({blossom(net()[0], v, v), blossom(net()[1], v, v), blossom(net()[2], v, v)}, u, u);
}

Point BezierPatch::derivative_first(const Rational& u, const Rational& v) const {
  return derivative({blossom(net()[0], v, v), blossom(net()[1], v, v), blossom(net()[2], v, v)}, u);
}

Point BezierPatch::derivative_second(const Rational& u, const Rational& v) const {
  return blossom({derivative(net()[0], v), derivative(net()[1], v), derivative(net()[2], v)}, u, u);
}

BezierPatch BezierPatch::exchanged() const { return BezierPatch(transposed(net())); }

BezierPatch BezierPatch::reversed_first() const { return BezierPatch({net()[2], net()[1], net()[0]}); }

BezierPatch BezierPatch::reversed_second() const {
  ControlNet reversed = net();
  for (Quadratic& row : reversed) std::swap(row[0], row[2]);
  return BezierPatch(reversed);
}

BezierPatch BezierPatch::restricted_to(const Rational& u0, const Rational& u1, const Rational& v0,
                                       const Rational& v1) const {
  const auto piece = [](const Rational& from, const Rational& to) {
    return [&from, &to](const Quadratic& b) {
      return Quadratic{blossom(b, from, from), blossom(b, from, to), blossom(b, to, to)};
    };
  };
  return BezierPatch(mapped(net(), piece(v0, v1), piece(u0, u1)));
}

}  // namespace exsect

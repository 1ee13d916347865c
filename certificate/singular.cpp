#include "certificate/singular.h"

#include <exsect/checker/map.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate/regular.h"

namespace exsect::cli {
namespace {

using checker::Algebraic;
using checker::Star;
using AlgebraicDirection = checker::Vector4<Algebraic>;

using Column = AlgebraicColumn;

double size(const Algebraic& a) { return std::abs(checker::number<double>(a)); }
double largest_component(const Column& c) { return std::max({size(c[0]), size(c[1]), size(c[2])}); }
bool is_zero(const Column& c) { return c == Column{}; }

/// A solution with parallel tangent planes.
struct SingularPoint {
  AlgebraicPoint at;
  AlgebraicMap local;             // F
  std::array<Column, 4> columns;  // of DF
  Column normal;
  std::size_t steepest;  // the largest coordinate of the normal
};

/// Nothing if the tangent planes are not parallel there, or not known.
std::optional<SingularPoint> singular_at(const ExactMap& equation, const AlgebraicPoint& at) {
  SingularPoint result = {at, about(equation, at), {}, {}, 0};
  result.columns = columns_of_derivative(result.local);
  Column& normal = result.normal;
  normal = checker::cross(result.columns[0], result.columns[1]);
  if (is_zero(normal)) normal = checker::cross(result.columns[2], result.columns[3]);
  for (const Column& column : result.columns)
    if (is_zero(normal) || checker::dot(normal, column) != 0) return std::nullopt;
  for (std::size_t d = 1; d < 3; ++d)
    if (size(normal[d]) > size(normal[result.steepest])) result.steepest = d;
  return result;
}

/// Of weights 1 and with axes along the parameters, the second one of this size beside the first one's 1.
Star plain_star(const SingularPoint& point, const Rational& second) {
  Star star = {point.at.root, point.at.parameters, {}, {}, {1, 1, 1, 1}, {}, {1, 1, 2}, {}};
  star.rows[0][(point.steepest + 1) % 3] = star.rows[1][(point.steepest + 2) % 3] = 1;
  star.rows[2] = point.normal;
  // Unequal, so that no half branch begins between two charts.
  const std::array<Rational, 4> sizes = {1, second, Rational(5, 4), Rational(7, 8)};
  double speed = 0;
  for (const Column& column : point.columns) speed = std::max(speed, largest_component(column));
  for (std::size_t j = 0; j < 4; ++j)
    star.axes[j][j] =
        sizes[j] * (is_zero(point.columns[j])
                        ? Rational(1)
                        : power_of_two(std::min(8, std::ilogb(speed / largest_component(point.columns[j])))));
  return star;
}

/// Directions in which both patches move alike: one with u' = 1, v' = 0 and one with u' = 0, v' = 1, for
/// `first` = 0; with r and s for `first` = 2. Nothing if the other patch is singular.
std::optional<std::array<AlgebraicDirection, 2>> common_directions(const SingularPoint& point,
                                                                   std::size_t first) {
  const std::size_t other = 2 - first;
  const std::size_t a = (point.steepest + 1) % 3;
  const std::size_t b = (point.steepest + 2) % 3;
  const auto det = [&](const Column& x, const Column& y) { return x[a] * y[b] - x[b] * y[a]; };
  const Column& p = point.columns[other];
  const Column& q = point.columns[other + 1];
  if (det(p, q) == 0) return std::nullopt;
  const Algebraic factor = Algebraic(-1) * reciprocal(det(p, q));
  std::array<AlgebraicDirection, 2> result = {};
  for (const std::size_t j : {0, 1}) {
    result[j][first + j] = 1;
    result[j][other] = factor * det(point.columns[first + j], q);
    result[j][other + 1] = factor * det(p, point.columns[first + j]);
  }
  return result;
}

/// The second derivative of normal . F.
Algebraic form(const SingularPoint& point, const AlgebraicDirection& a, const AlgebraicDirection& b) {
  Algebraic sum;
  for (const auto& term : point.local.terms()) {
    std::vector<std::size_t> factors;
    for (std::size_t i = 0; i < 4; ++i)
      for (int n = 0; n < term.power[i]; ++n) factors.push_back(i);
    if (factors.size() != 2) continue;
    const std::size_t i = factors[0];
    const std::size_t j = factors[1];
    sum += checker::dot(point.normal, term.c) * (a[i] * b[j] + a[j] * b[i]);
  }
  return sum;
}

/// p along which the form vanishes, q across, and the two parameters of the other patch.
Star weighted_star(Star star, const AlgebraicDirection& p, const AlgebraicDirection& q, std::size_t first,
                   std::size_t k) {
  const std::size_t weight = k % 2 == 0 ? 2 : 1;
  star.weights = {weight, weight * (k + 1) / 2, 2 * weight, 2 * weight};
  star.axes = {};
  for (std::size_t i = 0; i < 4; ++i) {
    star.axes[i][0] = p[i];
    star.axes[i][1] = Algebraic(Rational(3, 4)) * q[i];
  }
  star.axes[2 - first][2] = Rational(5, 4);
  star.axes[3 - first][3] = Rational(7, 8);
  return star;
}

std::vector<Star> singular_stars(const SingularPoint& point) {
  // Half branches that begin between two charts of the one do not in the other.
  const Star plain = plain_star(point, Rational(3, 4)), other = plain_star(point, Rational(4, 7));
  std::size_t first = 0;
  auto directions = common_directions(point, first);
  if (!directions) directions = common_directions(point, first = 2);
  if (!directions) return {plain, other};
  const auto& [a, b] = *directions;
  const Algebraic aa = form(point, a, a);
  const Algebraic ab = form(point, a, b);
  const Algebraic bb = form(point, b, b);
  if (aa * bb != ab * ab || (aa == 0 && bb == 0)) return {plain, other};
  AlgebraicDirection p = a;
  if (aa != 0)
    for (std::size_t i = 0; i < 4; ++i) p[i] = a[i] * ab * reciprocal(aa) - b[i];
  std::vector<Star> result;
  for (const std::size_t k : {2, 3, 4, 5})
    result.push_back(weighted_star(plain, p, aa != 0 ? a : b, first, k));
  return result;
}

}  // namespace

std::vector<Star> singular_points(const SingularSearch& search, const Node& node) {
  const std::vector<AlgebraicPoint> points = points_in_box(search, node);
  for (const AlgebraicPoint& at : points)
    if (const auto point = singular_at(search.equation, at)) return singular_stars(*point);
  for (const AlgebraicPoint& at : points)
    if (const auto star = regular_star(search.equation, at)) return {*star};
  throw NoCertificate("a special point where a patch is singular, or both cross");
}

Star at_scale(const Star& star, int e) {
  const Rational scale = (e % 2 == 0 ? Rational(1) : Rational(3, 4)) * power_of_two(-(e / 2));
  Star result = star;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t n = 0; n < star.weights[j]; ++n)
      for (std::size_t i = 0; i < 4; ++i) result.axes[i][j] = Algebraic(scale) * result.axes[i][j];
  result.coordinates = inverse(result.axes);
  return result;
}

}  // namespace exsect::cli

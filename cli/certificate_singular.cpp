#include "certificate_singular.h"

#include <exsect/checker/map.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate_seam.h"

namespace exsect::cli {
namespace {

using checker::Star;

double largest(const Point& p) {
  return std::max({std::abs(to_double(p[0])), std::abs(to_double(p[1])), std::abs(to_double(p[2]))});
}

/// A solution with parallel tangent planes.
struct SingularPoint {
  std::array<Rational, 4> at;
  std::array<Point, 4> columns;  // of DF, but for signs
  Point normal;
  std::size_t steepest;  // the largest coordinate of the normal
};

SingularPoint singular_point(const Patches& patches, const Node& node) {
  SingularPoint result = {short_place(node), {}, {}, 0};
  const auto& [u, v, r, s] = result.at;
  if (patches[0](u, v) != patches[1](r, s))
    throw NoCertificate("a special point without short rational parameters");
  result.columns = {patches[0].derivative_first(u, v), patches[0].derivative_second(u, v),
                    patches[1].derivative_first(r, s), patches[1].derivative_second(r, s)};
  Point& normal = result.normal;
  normal = cross(result.columns[0], result.columns[1]);
  if (is_zero(normal)) normal = cross(result.columns[2], result.columns[3]);
  for (const Point& column : result.columns)
    if (is_zero(normal) || dot(normal, column) != 0)
      throw NoCertificate("a special point where a patch is singular, or both cross");
  for (std::size_t d = 1; d < 3; ++d)
    if (abs(normal[d]) > abs(normal[result.steepest])) result.steepest = d;
  return result;
}

/// Of weights 1 and with axes along the parameters.
Star plain_star(const SingularPoint& point) {
  Star star = {{}, point.at, {}, {}, {1, 1, 1, 1}, {}, {1, 1, 2}, {}};
  star.rows[0][(point.steepest + 1) % 3] = star.rows[1][(point.steepest + 2) % 3] = 1;
  star.rows[2] = {point.normal[0], point.normal[1], point.normal[2]};
  // Unequal, so that no half branch begins between two charts.
  const std::array<Rational, 4> sizes = {1, Rational(3, 4), Rational(5, 4), Rational(7, 8)};
  double speed = 0;
  for (const Point& column : point.columns) speed = std::max(speed, largest(column));
  for (std::size_t j = 0; j < 4; ++j)
    star.axes[j][j] =
        sizes[j] * (is_zero(point.columns[j])
                        ? Rational(1)
                        : power_of_two(std::min(8, std::ilogb(speed / largest(point.columns[j])))));
  return star;
}

/// Directions in which both patches move alike: one with u' = 1, v' = 0 and one with u' = 0, v' = 1, for
/// `first` = 0; with r and s for `first` = 2. Nothing if the other patch is singular.
std::optional<std::array<Direction, 2>> common_directions(const SingularPoint& point, std::size_t first) {
  const std::size_t other = 2 - first;
  const std::size_t a = (point.steepest + 1) % 3;
  const std::size_t b = (point.steepest + 2) % 3;
  const auto det = [&](const Point& x, const Point& y) { return Rational(x[a] * y[b] - x[b] * y[a]); };
  const Point& p = point.columns[other];
  const Point& q = point.columns[other + 1];
  if (det(p, q) == 0) return std::nullopt;
  std::array<Direction, 2> result = {};
  for (const std::size_t j : {0, 1}) {
    result[j][first + j] = 1;
    result[j][other] = det(point.columns[first + j], q) / det(p, q);
    result[j][other + 1] = det(p, point.columns[first + j]) / det(p, q);
  }
  return result;
}

/// The second derivative of normal . F.
Rational form(const checker::Map<Rational>& local, const Point& normal, const Direction& a,
              const Direction& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      checker::Power power = {};
      ++power[i];
      ++power[j];
      const auto second = local.derivative(power, {});
      for (std::size_t d = 0; d < 3; ++d) sum += normal[d] * a[i] * b[j] * second[d].middle;
    }
  }
  return sum;
}

/// p along which the form vanishes, q across, and the two parameters of the other patch.
Star weighted_star(Star star, const Direction& p, const Direction& q, std::size_t first, std::size_t k) {
  const std::size_t weight = k % 2 == 0 ? 2 : 1;
  star.weights = {weight, weight * (k + 1) / 2, 2 * weight, 2 * weight};
  star.axes = {};
  for (std::size_t i = 0; i < 4; ++i) {
    star.axes[i][0] = p[i];
    star.axes[i][1] = Rational(3, 4) * q[i];
  }
  star.axes[2 - first][2] = Rational(5, 4);
  star.axes[3 - first][3] = Rational(7, 8);
  return star;
}

}  // namespace

std::vector<Star> singular_points(const Patches& patches, const Node& node) {
  const SingularPoint point = singular_point(patches, node);
  const Star plain = plain_star(point);
  const auto equation = checker::pair_map(patches[0].power_basis(), patches[1].power_basis());
  const checker::Map<Rational> local = equation.at(point.at);
  std::size_t first = 0;
  auto directions = common_directions(point, first);
  if (!directions) directions = common_directions(point, first = 2);
  if (!directions) return {plain};
  const auto& [a, b] = *directions;
  const Rational aa = form(local, point.normal, a, a);
  const Rational ab = form(local, point.normal, a, b);
  const Rational bb = form(local, point.normal, b, b);
  if (aa * bb != ab * ab || (aa == 0 && bb == 0)) return {plain};
  Direction p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = aa != 0 ? a[i] * ab / aa - b[i] : a[i];
  std::vector<Star> result;
  for (const std::size_t k : {2, 3, 4, 5})
    result.push_back(weighted_star(plain, p, aa != 0 ? a : b, first, k));
  return result;
}

Star at_scale(const Star& star, int e) {
  const Rational scale = (e % 2 == 0 ? Rational(1) : Rational(3, 4)) * power_of_two(-(e / 2));
  Star result = star;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t n = 0; n < star.weights[j]; ++n)
      for (std::size_t i = 0; i < 4; ++i) result.axes[i][j] *= scale;
  result.coordinates = inverse(result.axes);
  return result;
}

}  // namespace exsect::cli

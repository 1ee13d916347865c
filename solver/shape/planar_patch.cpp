#include "shape/planar_patch.h"

#include <exsect/geometry/pull_back.h>

#include <algorithm>

#include "curve/plane_curve.h"

namespace exsect {

std::vector<Point> orthogonal_complement(const std::vector<Point>& vectors) {
  if (vectors.empty()) {
    return {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  }
  const Point& first = vectors.front();
  Point normal{};
  for (const Point& p : vectors) {
    normal = is_zero(normal) ? cross(first, p) : normal;
  }
  if (is_zero(normal)) {  // rank 1
    std::vector<Point> normals;
    for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}})
      if (const Point p = cross(first, axis); !is_zero(p)) normals.push_back(p);
    return normals;
  }
  const bool rank2 =
      std::all_of(vectors.begin(), vectors.end(), [&](const Point& p) { return dot(normal, p) == 0; });
  return rank2 ? std::vector<Point>{normal} : std::vector<Point>{};
}

std::optional<AffineForm> plane_of(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  std::vector<Point> spanned;
  for (std::size_t k = 1; k < 9; ++k) {
    if (!is_zero(c[k / 3][k % 3])) {
      spanned.push_back(c[k / 3][k % 3]);
    }
  }
  const std::vector<Point> normals = orthogonal_complement(spanned);
  return normals.size() == 1 ? std::optional(form_through(c[0][0], normals[0])) : std::nullopt;
}

bool planar_patch_folds(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  const auto coordinate = [&](std::size_t m) {
    std::vector<Polynomial> rows;
    for (const auto& row : c) {
      rows.push_back(Polynomial({row[0][m], row[1][m], row[2][m]}));
    }
    return BivariatePolynomial(std::move(rows));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const BivariatePolynomial j = jacobian(coordinate((k + 1) % 3), coordinate((k + 2) % 3));
    // The three are the same polynomial times the coordinates of the plane's normal.
    if (!j.is_zero()) {
      return !component_points(squarefree(j)).empty();
    }
  }
  return true;
}

std::optional<Polynomial> planar_turning_eliminant(const BezierPatch& x, const BezierPatch& y) {
  const auto plane = plane_of(y);
  if (!plane) {
    return std::nullopt;
  }
  const BivariatePolynomial p = pull_back(*plane, x).exchanged();  // in Q[u][v]
  const Polynomial a = p.coefficient(2);
  const Polynomial b = p.coefficient(1);
  const Polynomial c = p.coefficient(0);
  const Polynomial lines = gcd(b, c);
  const Polynomial d = a.is_zero() ? lines * lines : b * b - 4 * a * c;
  if ((a.is_zero() && b.is_zero()) || d.is_zero() || planar_patch_folds(y)) {
    return std::nullopt;
  }
  return d.primitive();
}

}  // namespace exsect

#include "special/pole_directions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace exsect {

BivariatePolynomial divided_by_first(const BivariatePolynomial& f) {
  std::vector<Polynomial> rest;
  for (int i = 1; i <= f.degree_r(); ++i) rest.push_back(f.coefficient(i));
  return BivariatePolynomial(std::move(rest));
}

PolynomialVector pole_directions(const RationalPatch& x, const Point& p) {
  PolynomialVector result = coordinates_from(x, p);
  for (BivariatePolynomial& f : result) f = divided_by_first(f);
  return result;
}

std::vector<Point> directions_in_pole(const PolynomialVector& d) {
  std::vector<Point> result(max_patch_degree + 1);
  for (int i = 0; i <= max_patch_degree; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      result[static_cast<std::size_t>(i)][c] = d[c].coefficient(0).coefficient(i);
  return result;
}

Point common_normal(const std::vector<Point>& vectors) {
  Point normal = {0, 0, 0};
  for (const Point& v : vectors)
    if (is_zero(normal)) normal = cross(vectors[0], v);
  const bool holds_all = std::ranges::all_of(vectors, [&](const Point& v) { return dot(normal, v) == 0; });
  return holds_all ? normal : Point{0, 0, 0};
}

DoubleBall range_on(const BivariatePolynomial& f, const Rectangle& on) {
  return f.is_zero() ? DoubleBall(0) : DoubleBall::enclosing(range_bound(f, on));
}

DoubleBall inverse_range(const BivariatePolynomial& f, const Rectangle& on) {
  const RationalInterval range = range_bound(f, on);
  if (range.lower <= 0) return DoubleBall(0, HUGE_VAL);
  return DoubleBall::enclosing(RationalInterval{1 / range.upper, 1 / range.lower});
}

}  // namespace exsect

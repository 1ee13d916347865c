#include "support/surface_moves.h"

#include <exsect/algebra/resultant.h>
#include <exsect/algebra/sturm.h>

#include <cmath>

namespace exsect::surface_moves {
namespace {

using S = ImplicitSurface;

/// f on the plane origin + s a + t b, in (s,t).
BivariatePolynomial on_plane(const SpacePolynomial& f, const Point& o, const Point& a, const Point& b) {
  BivariatePolynomial sum;
  for (const auto& [exponents, coefficient] : f.terms()) {
    BivariatePolynomial term = BivariatePolynomial::constant(coefficient);
    for (std::size_t k = 0; k < 3; ++k)
      for (int i = 0; i < exponents[k]; ++i)
        term = term * (BivariatePolynomial::constant(o[k]) +
                       BivariatePolynomial::constant(a[k]) * BivariatePolynomial::r() +
                       BivariatePolynomial::constant(b[k]) * BivariatePolynomial::s());
    sum += term;
  }
  return sum;
}

/// How often the polylines cross the plane, -1 if a vertex is too near.
int crossings(const SurfaceIntersection& result, const Point& o, const Point& normal) {
  const double length = std::sqrt(to_double(dot(normal, normal)));
  int count = 0;
  for (const SpaceArc& arc : result.arcs) {
    int before = 0;
    bool near = false;  // since the last vertex that is off the plane for certain
    for (const auto& p : arc.polyline) {
      const Point q = {from_double(p[0]), from_double(p[1]), from_double(p[2])};
      const double distance = to_double(dot(normal, q - o)) / length;
      if (!(std::fabs(distance) > arc.error_bound)) {
        if (&p == &arc.polyline.front() || &p == &arc.polyline.back()) return -1;
        near = true;
        continue;
      }
      const int side = distance > 0 ? 1 : -1;
      if (near && side == before) return -1;
      if (before != 0 && side != before) ++count;
      near = false;
      before = side;
    }
  }
  return count;
}

}  // namespace

Point Motion::direction(const Point& d) const {
  if (!turns) return d;
  const std::array<Point, 3> rows = {Point{-20, 4, 22}, Point{20, -10, 20}, Point{10, 28, 4}};
  return {dot(rows[0], d) / 30, dot(rows[1], d) / 30, dot(rows[2], d) / 30};
}

Point Motion::operator()(const Point& p) const { return scale * direction(p) + shift; }

S Motion::operator()(const S& surface) const {
  const SurfaceData& data = *surface.data();
  const Point at = (*this)(data.point), axis = direction(data.axis);
  const Length length = Length::of_squared(data.squared * scale * scale);
  switch (surface.kind()) {
    case SurfaceKind::plane:
      return S::plane(at, axis);
    case SurfaceKind::cylinder:
      return S::cylinder(at, axis, length);
    case SurfaceKind::cone:
      return S::cone(at, axis, Length::of_squared(data.squared), surface.bound() ? 1 : 2);
    case SurfaceKind::sphere:
      return S::sphere(at, length);
    default:
      return S::torus(at, axis, length, Length::of_squared(data.minor_squared * scale * scale));
  }
}

std::vector<std::pair<std::string, Motion>> motions() {
  return {{"turned", {1, {3, -5, 7}, true}},
          {"times 25.4", {Rational(127, 5), {0, 0, 0}, false}},
          {"small and far", {Rational(1, 1000), {1000000, 0, Rational(1, 3)}, true}}};
}

std::optional<PlaneCounts> plane_counts(const S& first, const S& second, const SurfaceIntersection& result,
                                        const TestPlane& plane) {
  const auto& [o, a, b] = plane;
  const Polynomial eliminant =
      resultant_r(on_plane(first.equation(), o, a, b), on_plane(second.equation(), o, a, b));
  if (eliminant.degree() < 1) return std::nullopt;
  const int crossed = crossings(result, o, cross(a, b));
  if (crossed < 0) return std::nullopt;
  return PlaneCounts{crossed, SturmSequence(eliminant).count_all()};
}

}  // namespace exsect::surface_moves

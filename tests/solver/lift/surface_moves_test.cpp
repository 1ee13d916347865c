// Answers do not depend on where and how large the surfaces are; and common points on planes are counted by
// another route: resultants of both equations on the plane, and Sturm's count.
#include <exsect/algebra/resultant.h>
#include <exsect/algebra/sturm.h>
#include <exsect/solver/intersect_equations.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "support/catch.h"

namespace exsect::surface_moves_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, up = {0, 0, 1};

/// p -> scale (turn p) + shift, with a turn by the quaternion 1 + 2i + 3j + 4k.
struct Motion {
  Rational scale = 1;
  Point shift = {0, 0, 0};
  bool turns = true;

  Point direction(const Point& d) const {
    if (!turns) return d;
    const std::array<Point, 3> rows = {Point{-20, 4, 22}, Point{20, -10, 20}, Point{10, 28, 4}};
    return {dot(rows[0], d) / 30, dot(rows[1], d) / 30, dot(rows[2], d) / 30};
  }
  Point operator()(const Point& p) const { return scale * direction(p) + shift; }

  S operator()(const S& surface) const {
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
};

IntersectOptions drawn_within(double tolerance) {
  IntersectOptions options;
  options.tolerance = tolerance;
  return options;
}

/// Curves by name, contact and shape, and special nodes.
std::map<std::string, int> census(const S& first, const S& second) {
  const SurfaceIntersection result = intersect(first, second, drawn_within(1e-2));
  std::map<std::string, int> counts;
  counts[result.status == Status::complete ? "complete" : "incomplete"] = 1;
  for (const SpaceCurve& curve : result.curves)
    ++counts[std::string(name(curve.kind)) + (curve.is_closed ? " closed " : " ") +
             std::to_string(curve.multiplicity)];
  for (const SpaceNode& node : result.nodes)
    if (node.kind != SpaceNodeKind::joint && node.kind != SpaceNodeKind::cut) ++counts[name(node.kind)];
  return counts;
}

const std::vector<std::array<S, 2>>& specimens() {
  static const std::vector<std::array<S, 2>> pairs = {
      {S::cylinder({1, 0, 0}, up, 1), S::sphere(origin, 2)},
      {S::cylinder(origin, up, 1), S::cylinder(origin, {1, 0, 0}, 1)},
      {S::cylinder(origin, up, 2), S::cylinder({0, 1, 0}, {1, 0, 0}, 1)},
      {S::cylinder(origin, up, 1), S::cylinder({2, 0, 0}, up, 1)},
      {S::torus(origin, up, 5, 3), S::plane(origin, {3, 0, 4})},
      {S::torus(origin, up, 5, 3), S::plane({0, 0, 3}, up)},
      {S::torus(origin, up, 5, 3), S::cylinder(origin, {1, 0, 0}, 1)},
      {S::torus(origin, up, 5, 3), S::sphere({5, 0, 0}, 3)},
      {S::cone(origin, up, 1), S::plane({0, 0, 1}, {2, 0, 1})},
      {S::cone(origin, up, 2, 2), S::cone(origin, {1, 0, 0}, 2, 2)},
      {S::cone(origin, up, 1), S::sphere({0, 0, 1}, 1)},
      {S::cylinder(origin, up, 1), S::sphere(origin, 1)},
      {S::cylinder({0, 1, 0}, up, 2), S::cone({3, 0, 0}, {-1, 0, 1}, 1)},
      {S::torus(origin, up, 5, 3), S::torus({0, 0, 4}, up, 8, 2)},
      {S::torus(origin, up, 5, 2), S::torus({14, 0, 0}, {0, 1, 0}, 5, 2)},
      {S::torus(origin, up, 5, 2), S::torus({3, 0, 1}, {2, 2, 1}, 4, 1)},
  };
  return pairs;
}

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
    for (const auto& p : arc.polyline) {
      const Point q = {from_double(p[0]), from_double(p[1]), from_double(p[2])};
      const double distance = to_double(dot(normal, q - o)) / length;
      if (std::fabs(distance) <= arc.error_bound) {
        if (&p == &arc.polyline.front() || &p == &arc.polyline.back()) return -1;
        continue;
      }
      const int side = distance > 0 ? 1 : -1;
      if (before != 0 && side != before) ++count;
      before = side;
    }
  }
  return count;
}

int number_in(std::mt19937& random, int least, int most) {
  return static_cast<int>(random() % static_cast<unsigned>(most - least + 1)) + least;
}

Point vector_of(std::mt19937& random, int size) {
  const auto number = [&] { return number_in(random, -size, size); };
  Point p;
  do p = {number(), number(), number()};
  while (is_zero(p));
  return p;
}

/// Common points on random planes, by polylines and by resultants.
struct PlaneCounts {
  std::mt19937& random;
  int counted = 0;  // planes
  int points = 0;

  void count(const S& first, const S& second, const SurfaceIntersection& result) {
    for (int k = 0; k < 4; ++k) {
      const Point o = Rational(1, 8) * vector_of(random, 6), a = vector_of(random, 9),
                  b = vector_of(random, 9), normal = cross(a, b);
      if (is_zero(normal)) continue;
      const Polynomial eliminant =
          resultant_r(on_plane(first.equation(), o, a, b), on_plane(second.equation(), o, a, b));
      if (eliminant.degree() < 1) continue;
      const int crossed = crossings(result, o, normal);
      if (crossed < 0) continue;
      CHECK(crossed == SturmSequence(eliminant).count_all());
      ++counted;
      points += crossed;
    }
  }
};

}  // namespace

TEST_CASE("equations: moved, turned and scaled pairs have the same curves") {
  for (const auto& [first, second] : specimens()) {
    const auto expected = census(first, second);
    CHECK(expected.contains("complete"));
    for (const Motion& motion : {Motion{1, {3, -5, 7}, true}, Motion{Rational(127, 5), {0, 0, 0}, true},
                                 Motion{100000000, {1, 2, 3}, false},
                                 Motion{Rational(1, 1000), {1000000, 0, Rational(1, 3)}, true}}) {
      CHECK(census(motion(first), motion(second)) == expected);
      CHECK(census(motion(second), motion(first)) == expected);
    }
  }
}

TEST_CASE("equations: common points on random planes, counted by resultants") {
  std::mt19937 random(26);
  const auto number = [&](int least, int most) { return number_in(random, least, most); };
  const auto vector = [&](int size) { return vector_of(random, size); };
  const auto surface = [&]() -> S {
    const Point at = Rational(1, 4) * vector(4), axis = vector(5);
    switch (number(0, 3)) {
      case 0:
        return S::cylinder(at, axis, Rational(number(4, 12), 8));
      case 1:
        return S::sphere(at, Rational(number(6, 16), 8));
      case 2:
        return S::cone(at, axis, Rational(number(4, 12), 8), 2);
      default:
        return S::torus(at, axis, Rational(number(12, 16), 8), Rational(number(4, 10), 8));
    }
  };
  PlaneCounts planes{random};
  for (int round = 0; round < 30; ++round) {
    const S first = surface(), second = surface();
    if (first.kind() == SurfaceKind::torus && second.kind() == SurfaceKind::torus) continue;
    INFO(round << ' ' << name(first.kind()) << ' ' << name(second.kind()));
    const SurfaceIntersection result = intersect(first, second, drawn_within(1e-4));
    REQUIRE(result.status == Status::complete);
    if (result.count(SpaceNodeKind::cut) == 0) planes.count(first, second, result);
  }
  CHECK(planes.counted > 30);
  CHECK(planes.points > 30);
}

TEST_CASE("equations: two tori, and a torus with a polynomial, on random planes") {
  std::mt19937 random(27);
  const auto axis = [&] {
    const std::array<Point, 4> axes = {Point{0, 0, 1}, Point{2, -2, 1}, Point{0, 3, 4}, Point{6, 2, -3}};
    return axes[static_cast<std::size_t>(number_in(random, 0, 3))];
  };
  const auto torus = [&] {
    return S::torus(Rational(1, 4) * vector_of(random, 4), axis(), Rational(number_in(random, 12, 16), 8),
                    Rational(number_in(random, 4, 10), 8));
  };
  PlaneCounts planes{random};
  for (int round = 0; round < 24; ++round) {
    INFO("round " << round);
    const S first = torus();
    const bool both = round % 2 == 0;
    const Point c = vector_of(random, 3);
    SpacePolynomial f = SpacePolynomial::constant(number_in(random, -3, 3));
    for (std::size_t k = 0; k < 3; ++k) {
      const SpacePolynomial x = SpacePolynomial::variable(k), y = SpacePolynomial::variable((k + 1) % 3);
      f += c[k] * x * x * y + Rational(number_in(random, 1, 3)) * y;
    }
    const S second = both ? torus() : S::polynomial(f);
    const SurfaceIntersection result = intersect(first, second, drawn_within(1e-3));
    REQUIRE(result.status == Status::complete);
    planes.count(first, second, result);
  }
  CHECK(planes.counted > 40);
  CHECK(planes.points > 40);
}

}  // namespace exsect::surface_moves_test

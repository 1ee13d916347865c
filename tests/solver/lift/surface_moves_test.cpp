// Answers do not depend on where and how large the surfaces are; and common points on planes are counted by
// another route: resultants of both equations on the plane, and Sturm's count.
#include "support/surface_moves.h"

#include <exsect/solver/intersect_equations.h>

#include <map>
#include <random>
#include <string>

#include "support/catch.h"

namespace exsect::surface_moves_test {
namespace {

using S = ImplicitSurface;
using surface_moves::Motion, surface_moves::plane_counts;
const Point origin = {0, 0, 0}, up = {0, 0, 1};

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
                  b = vector_of(random, 9);
      if (is_zero(cross(a, b))) continue;
      const auto counts = plane_counts(first, second, result, {o, a, b});
      if (!counts) continue;
      CHECK(counts->by_polylines == counts->by_resultant);
      ++counted;
      points += counts->by_polylines;
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

// On which side of each other surfaces lie beside their curves and around their points: against points of the
// first surface there, and where the answer is known.
#include "lift/space_sides.h"

#include <exsect/algebra/nearest_double.h>
#include <exsect/solver/intersect_equations.h>

#include <cmath>
#include <random>

#include "support/catch.h"
#include "support/surface_moves.h"

namespace exsect::space_sides_test {
namespace {

using S = ImplicitSurface;
using Vec3 = std::array<double, 3>;

const Point origin = {0, 0, 0}, up = {0, 0, 1}, right = {1, 0, 0}, oblique = {1, 1, 1};

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 times(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double size_of(const Vec3& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

double at(const SpacePolynomial& f, const Vec3& p) {
  return to_double(f({from_double(p[0]), from_double(p[1]), from_double(p[2])}));
}
Vec3 gradient(const SpacePolynomial& f, const Vec3& p) {
  return {at(f.derivative(0), p), at(f.derivative(1), p), at(f.derivative(2), p)};
}

/// The sign of g in the point of f = 0 next to p + step.
int sign_beside(const SpacePolynomial& f, const SpacePolynomial& g, const Vec3& p, const Vec3& step) {
  Vec3 q = {p[0] + step[0], p[1] + step[1], p[2] + step[2]};
  for (int i = 0; i < 6; ++i) {
    const Vec3 n = gradient(f, q);
    const double move = at(f, q) / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (std::size_t k = 0; k < 3; ++k) q[k] -= move * n[k];
  }
  const double value = at(g, q);
  return value > 0 ? 1 : -1;
}

/// Beside a vertex in the middle, a thousandth of the arc's size away.
SideSigns seen(const SpaceArc& arc, const SpacePolynomial& f, const SpacePolynomial& g) {
  const std::size_t n = arc.polyline.size(), i = n / 2;
  const Vec3 &a = arc.polyline[i - 1], &b = arc.polyline[i];
  const Vec3 along = minus(b, a);
  const Vec3 p = n == 2 ? Vec3{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2} : b;
  double extent = 0;
  for (const Vec3& q : arc.polyline) extent = std::max(extent, size_of(minus(q, arc.polyline[0])));
  Vec3 step = times(gradient(f, p), along);
  const double size = size_of(step);
  for (double& c : step) c *= extent / 256 / size;
  const Vec3 back = {-step[0], -step[1], -step[2]};
  return {sign_beside(f, g, p, step), sign_beside(f, g, p, back)};
}

struct Seen {
  int crossing = 0;
  int touching = 0;
  int around = 0;
  int unknown = 0;
};

void check_order(const S& first, const S& second, Seen& count) {
  IntersectOptions options;
  options.tolerance = 1e-7;
  const SurfaceIntersection result = intersect(first, second, options);
  REQUIRE(result.status == Status::complete);
  for (const SpaceArc& arc : result.arcs) {
    if (arc.multiplicity == 0) {
      CHECK_FALSE(arc.beside);
      continue;
    }
    if (!arc.beside) {
      ++count.unknown;
      continue;
    }
    CAPTURE(arc.id, arc.multiplicity);
    CHECK(arc.beside->left == (arc.multiplicity % 2 == 0 ? 1 : -1) * arc.beside->right);
    CHECK(*arc.beside == seen(arc, first.equation(), second.equation()));
    ++(arc.multiplicity % 2 == 0 ? count.touching : count.crossing);
  }
  for (const SpaceNode& node : result.nodes)
    if (node.around) {
      CHECK(node.kind == SpaceNodeKind::touch);
      ++count.around;
    }
}

S reversed(const S& plane) { return S::plane(plane.data()->point, Rational(-1) * plane.data()->axis); }

/// In both orders, moved, and planes with the other normal.
Seen check_images(const S& first, const S& second) {
  Seen count;
  check_order(first, second, count);
  check_order(second, first, count);
  if (first.kind() == SurfaceKind::plane) check_order(reversed(first), second, count);
  if (second.kind() == SurfaceKind::plane) check_order(first, reversed(second), count);
  if (first.kind() == SurfaceKind::polynomial || second.kind() == SurfaceKind::polynomial) return count;
  const auto move = surface_moves::motions().front().second;
  check_order(move(first), move(second), count);
  return count;
}

S graph_of(SpacePolynomial f) { return S::polynomial(SpacePolynomial::variable(2) - std::move(f)); }

}  // namespace

TEST_CASE("space sides: pairs of planes, spheres, cylinders and cones") {
  const S plane = S::plane({0, 0, Rational(1, 3)}, {1, 2, 3}), ball = S::sphere({1, 0, 0}, 2),
          tube = S::cylinder({0, Rational(1, 5), 0}, oblique, 1), cone = S::cone({0, 0, -1}, {0, 1, 3}, 1),
          both = S::cone({0, Rational(1, 7), 0}, {1, 0, 2}, Rational(1, 2), 2);
  const std::vector<S> all = {plane, S::plane(origin, right),
                              ball,  S::sphere(origin, 2),
                              tube,  S::cylinder(origin, up, Rational(3, 2)),
                              cone,  both};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      CAPTURE(i, k);
      const Seen count = check_images(all[i], all[k]);
      CHECK(count.crossing + count.touching > 0);
      CHECK(count.unknown == 0);
    }
}

TEST_CASE("space sides: tori with everything, on each of their charts") {
  const S torus = S::torus(origin, up, 3, 1), other = S::torus({2, 0, Rational(1, 2)}, {0, 3, 4}, 3, 1),
          ring = S::torus({1, 0, 0}, oblique, 3, 1),
          wild = S::torus({1, 1, 0}, {1, 2, 0}, Length::of_squared(7), Length::of_squared(2));
  const std::vector<S> simple = {S::plane({0, 0, Rational(1, 3)}, {1, 2, 3}), S::sphere({2, 1, 0}, 2),
                                 S::cylinder({0, Rational(1, 5), 0}, {1, 0, 1}, 1),
                                 S::cone({0, 0, -1}, {0, 1, 3}, 1)};
  for (const S& of : {torus, ring, wild}) {
    int crossing = 0;
    for (const S& with : simple) {
      const Seen count = check_images(of, with);
      CHECK(count.unknown == 0);
      crossing += count.crossing;
    }
    CHECK(crossing > 0);
  }
  for (const auto& [a, b] : {std::pair(torus, other), std::pair(torus, ring), std::pair(ring, other)}) {
    const Seen count = check_images(a, b);
    CHECK(count.crossing > 0);
    CHECK(count.unknown == 0);
  }
}

TEST_CASE("space sides: contact along lines and circles") {
  const S torus = S::torus(origin, up, 3, 1);
  const std::vector<std::pair<S, S>> pairs = {
      {S::plane({0, 1, 0}, {0, 1, 0}), S::cylinder(origin, up, 1)},
      {S::cylinder(origin, up, 1), S::cylinder({3, 0, 0}, up, 2)},
      {S::cylinder(origin, up, 3), S::cylinder({1, 0, 0}, up, 2)},
      {S::sphere(origin, 1), S::cylinder(origin, oblique, 1)},
      {S::sphere(origin, 4), torus},
      {S::sphere(origin, 2), torus},
      {S::plane({0, 0, 1}, up), torus},
      {S::cylinder(origin, up, 4), torus},
      {S::cylinder({3, 0, 0}, {0, 1, 0}, 1), torus},
      {S::cone({0, 0, 5}, {0, 0, -1}, Rational(3, 4)), S::sphere(origin, 3)},
      {torus, S::torus(origin, up, 5, 1)},
      {torus, S::torus(origin, up, Rational(7, 2), Rational(1, 2))},
      {torus, S::torus({0, 0, 3}, up, 3, 2)},
      {torus, S::torus({0, 0, 1}, up, 3, 2)},
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    CAPTURE(i);
    const Seen count = check_images(pairs[i].first, pairs[i].second);
    CHECK(count.touching + count.around > 0);
    CHECK(count.unknown == 0);
  }
  // About one axis the second torus is replaced by a plane, a cylinder or a cone, on either side.
  for (const auto& [major, minor, shift] : {std::array<Rational, 3>{3, 2, Rational(4, 3)},
                                            {3, 2, Rational(-4, 3)},
                                            {Rational(7, 2), 1, 0},
                                            {Rational(5, 2), 1, 0},
                                            {Rational(7, 2), 1, Rational(1, 4)},
                                            {Rational(5, 2), 1, Rational(-1, 4)}}) {
    const Seen count = check_images(torus, S::torus({0, 0, shift}, up, major, minor));
    CHECK(count.crossing > 0);
    CHECK(count.unknown == 0);
  }
}

TEST_CASE("space sides: contact of orders up to four, and of polynomials") {
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1);
  const SpacePolynomial bend = x * x - x * y;
  for (const SpacePolynomial& base : {SpacePolynomial(), bend})
    for (const SpacePolynomial& lift : {y, y * y, y * y * y, y * y * y * y})
      for (const Rational& factor : {Rational(1), Rational(-1)}) {
        const Seen count = check_images(graph_of(base), graph_of(base + factor * lift));
        CAPTURE(lift.degree());
        CHECK(count.crossing + count.touching >= 2);
        CHECK(count.unknown == 0);
      }
  const Seen planes = check_images(S::plane(origin, up), graph_of(y * y * y));
  CHECK(planes.crossing >= 3);
  // The negative equation has the other side.
  const SpacePolynomial paraboloid = SpacePolynomial::variable(2) - x * x - y * y;
  for (const Rational& factor : {Rational(2), Rational(-2)}) {
    const Seen count = check_images(S::polynomial(factor * paraboloid), S::sphere({0, 0, 1}, 1));
    CHECK(count.crossing > 0);
    CHECK(count.unknown == 0);
  }
}

TEST_CASE("space sides: around isolated points, and normals of one surface") {
  const auto around = [](const S& first, const S& second) {
    const SurfaceIntersection result = intersect(first, second);
    REQUIRE(result.nodes.size() == 1);
    return result.nodes[0].around.value_or(0);
  };
  const S ball = S::sphere(origin, 1), torus = S::torus(origin, up, 3, 1);
  CHECK(around(ball, S::sphere({3, 0, 0}, 2)) == 1);
  CHECK(around(S::sphere({3, 0, 0}, 2), ball) == 1);
  CHECK(around(ball, S::sphere({1, 0, 0}, 2)) == -1);
  CHECK(around(S::sphere({1, 0, 0}, 2), ball) == 1);
  CHECK(around(ball, S::plane({1, 0, 0}, right)) == -1);
  CHECK(around(ball, S::plane({1, 0, 0}, {-1, 0, 0})) == 1);
  CHECK(around(S::plane({1, 0, 0}, right), ball) == 1);
  CHECK(around(S::plane({4, 0, 0}, right), torus) == 1);
  CHECK(around(torus, S::plane({4, 0, 0}, {-2, 0, 0})) == 1);
  CHECK(around(S::sphere({3, 0, 0}, Rational(1, 2)), S::sphere({3, 0, Rational(-1, 2)}, 1)) == -1);
  CHECK(around(S::plane(origin, up), S::cone(origin, up, 1)) == 1);
  CHECK(around(S::cone(origin, up, 1), S::plane(origin, up)) == 0);  // no normal in the apex
  const auto normals = [](const S& first, const S& second) { return intersect(first, second).normals; };
  CHECK(normals(S::plane(origin, up), S::plane({1, 0, 0}, {0, 0, 3})) == 1);
  CHECK(normals(S::plane(origin, up), S::plane({1, 0, 0}, {0, 0, -3})) == -1);
  CHECK(normals(torus, S::torus(origin, {0, 0, -2}, 3, 1)) == 1);
  const SpacePolynomial quartic =
      SpacePolynomial::variable(0) * torus.equation().derivative(1) - SpacePolynomial::constant(3);
  CHECK(normals(S::polynomial(quartic), S::polynomial(Rational(-5) * quartic)) == -1);
  CHECK_FALSE(normals(ball, torus));
}

TEST_CASE("space sides: random pairs") {
  constexpr unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto number = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const auto point = [&] { return Point{number(-2, 2), number(-2, 2), number(-2, 2)}; };
  const auto direction = [&] {
    Point d = point();
    while (is_zero(d)) d = point();
    return d;
  };
  const auto surface = [&]() -> S {
    switch (number(0, 4)) {
      case 0:
        return S::plane(point(), direction());
      case 1:
        return S::cylinder(point(), direction(), number(1, 2));
      case 2:
        return S::sphere(point(), number(1, 3));
      case 3:
        return S::cone(point(), direction(), number(1, 2), number(1, 2));
      default:
        return S::torus(point(), direction(), 3, number(1, 2));
    }
  };
  int arcs = 0;
  for (int i = 0; i < 24; ++i) {
    const S first = surface(), second = surface();
    Seen count;
    check_order(first, second, count);
    check_order(second, first, count);
    CHECK(count.unknown == 0);
    arcs += count.crossing + count.touching;
  }
  CHECK(arcs > 0);
}

}  // namespace exsect::space_sides_test

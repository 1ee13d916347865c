#include <exsect/geometry/bezier_patch.h>

#include <stdexcept>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::bezier_patch_test {

namespace {

/// The definition: sum over i, j of B_i^2(u) B_j^2(v) X[i][j].
Point by_bernstein_polynomials(const ControlNet& net, const Rational& u, const Rational& v) {
  const auto bernstein = [](const Rational& t) {
    return std::array<Rational, 3>{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  };
  Point sum = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum = sum + Rational(bernstein(u)[i] * bernstein(v)[j]) * net[i][j];
  return sum;
}

Point by_power_basis(const ControlNet& c, const Rational& u, const Rational& v) {
  Point sum = {0, 0, 0};
  for (std::size_t i = 3; i-- > 0;) sum = u * sum + (c[i][0] + v * (c[i][1] + v * c[i][2]));
  return sum;
}

/// Patches on which an index or a sign error shows, and degenerate ones.
std::vector<BezierPatch> awkward_patches() {
  const Point origin = {0, 0, 0};
  ControlNet collapsed;
  for (auto& row : collapsed) row.fill({Rational(1, 3), -2, 5});
  ControlNet one_corner;
  for (auto& row : one_corner) row.fill(origin);
  ControlNet one_side = one_corner;
  one_corner[0][2] = {1, 0, 0};
  one_side[1][2] = {0, 1, 0};
  one_side[2][2] = {0, 0, 1};
  return {BezierPatch(collapsed), BezierPatch(one_corner), BezierPatch(one_side)};
}

const std::vector<Rational> parameters = {0, 1, Rational(1, 2), Rational(1, 3), Rational(-3, 7), 5};

}  // namespace

TEST_CASE("evaluation agrees with the definition and the power basis", "[bezier_patch]") {
  const auto seed = 2u;
  INFO("seed " << seed);
  Random random(seed);
  std::vector<BezierPatch> patches = awkward_patches();
  for (int i = 0; i < 5; ++i) patches.push_back(random_patch(random));
  for (const BezierPatch& x : patches) {
    const ControlNet c = x.power_basis();
    CHECK(BezierPatch::from_power_basis(c) == x);
    for (const Rational& u : parameters) {
      for (const Rational& v : parameters) {
        CHECK(x(u, v) == by_bernstein_polynomials(x.net(), u, v));
        CHECK(x(u, v) == by_power_basis(c, u, v));
      }
    }
    CHECK(x(0, 1) == x.net()[0][2]);
    CHECK(x(1, 0) == x.net()[2][0]);
  }
}

TEST_CASE("derivatives are exact central differences of quadratics", "[bezier_patch]") {
  const auto seed = 3u;
  INFO("seed " << seed);
  Random random(seed);
  std::vector<BezierPatch> patches = awkward_patches();
  for (int i = 0; i < 5; ++i) patches.push_back(random_patch(random));
  for (const BezierPatch& x : patches) {
    for (const Rational& u : parameters) {
      for (const Rational& v : parameters) {
        const Rational h(1, 7);
        CHECK(x.derivative_first(u, v) == Rational(1 / (2 * h)) * (x(u + h, v) - x(u - h, v)));
        CHECK(x.derivative_second(u, v) == Rational(1 / (2 * h)) * (x(u, v + h) - x(u, v - h)));
      }
    }
  }
}

TEST_CASE("exchange, reversal and restriction reparametrise", "[bezier_patch]") {
  const auto seed = 4u;
  INFO("seed " << seed);
  Random random(seed);
  std::vector<BezierPatch> patches = awkward_patches();
  for (int i = 0; i < 5; ++i) patches.push_back(random_patch(random));
  for (const BezierPatch& x : patches) {
    const Rational u0 = random_rational(random);
    const Rational u1 = random_rational(random);
    const Rational v0 = random_rational(random);
    const Rational v1 = random_rational(random);
    const BezierPatch piece = x.restricted_to(u0, u1, v0, v1);
    for (const Rational& u : parameters) {
      for (const Rational& v : parameters) {
        CHECK(x.exchanged()(u, v) == x(v, u));
        CHECK(x.reversed_first()(u, v) == x(1 - u, v));
        CHECK(x.reversed_second()(u, v) == x(u, 1 - v));
        CHECK(piece(u, v) == x(u0 + u * (u1 - u0), v0 + v * (v1 - v0)));
      }
    }
    CHECK(x.restricted_to(0, 1, 0, 1) == x);
    CHECK(x.restricted_to(1, 0, 0, 1) == x.reversed_first());
    CHECK(x.restricted_to(0, 1, 1, 0) == x.reversed_second());
    CHECK(x.exchanged().exchanged() == x);
  }
}

TEST_CASE("lower degrees are elevated exactly", "[bezier_patch]") {
  const auto seed = 5u;
  INFO("seed " << seed);
  Random random(seed);
  const Point a = random_point(random);
  const Point b = random_point(random);
  const Point c = random_point(random);
  const Point d = random_point(random);
  const BezierPatch bilinear = BezierPatch::elevated({{a, b}, {c, d}});
  for (const Rational& u : parameters) {
    for (const Rational& v : parameters) {
      const Point expected =
          Rational(1 - u) * (Rational(1 - v) * a + v * b) + u * (Rational(1 - v) * c + v * d);
      CHECK(bilinear(u, v) == expected);
    }
  }
  const BezierPatch ruled = BezierPatch::elevated({{a, b}, {c, d}, {d, a}});
  CHECK(ruled.power_basis()[1][2] == Point{0, 0, 0});
  CHECK(ruled.power_basis()[2][0] == a - Rational(2) * c + d);
  CHECK(ruled(1, Rational(1, 2)) == Rational(1, 2) * (d + a));
  CHECK(BezierPatch::elevated({{a, c, d}, {b, d, a}}) == ruled.exchanged());

  CHECK_THROWS_AS(BezierPatch::elevated({}), std::invalid_argument);
  CHECK_THROWS_AS(BezierPatch::elevated({{a, b}}), std::invalid_argument);
  CHECK_THROWS_AS(BezierPatch::elevated({{a}, {b}}), std::invalid_argument);
  CHECK_THROWS_AS(BezierPatch::elevated({{a, b}, {c, d, a}}), std::invalid_argument);
  CHECK_THROWS_AS(BezierPatch::elevated({{a, b}, {c}}), std::invalid_argument);
  CHECK_THROWS_AS(BezierPatch::elevated({{}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(BezierPatch::elevated({{a, b, c, d}, {a, b, c, d}}), std::invalid_argument);
  CHECK_THROWS_AS(BezierPatch::elevated({{a, b}, {a, b}, {a, b}, {a, b}}), std::invalid_argument);
}

}  // namespace exsect::bezier_patch_test

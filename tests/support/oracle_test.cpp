#include "support/oracle.h"

#include <exsect/geometry/patch_file.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"

namespace exsect::oracle_test {
namespace {

using testing::plane;

/// The square (u, v, 0), and the graph z = height - (u - 1/2)^2 - (v - 1/2)^2 over it.
BezierPatch cap(const Rational& height) {
  ControlNet c{};
  c[0][0] = {0, 0, height - Rational(1, 2)};
  c[1][0] = {1, 0, 1};
  c[0][1] = {0, 1, 1};
  c[2][0] = {0, 0, -1};
  c[0][2] = {0, 0, -1};
  return BezierPatch::from_power_basis(c);
}

const BezierPatch floor_square = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

oracle::Intersection example(const std::string& name) {
  const auto file = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name);
  return oracle::intersect(file.patches.at(0).patch, file.patches.at(1).patch);
}

void check_counts(const oracle::Intersection& found, int closed, int open) {
  INFO("doubt: " << found.doubt);
  CHECK(found.conclusive());
  CHECK(found.closed() == closed);
  CHECK(found.open() == open);
  CHECK(found.boundary_points.size() == static_cast<std::size_t>(2 * open));
}

}  // namespace

TEST_CASE("oracle: a cap meets the floor in a circle of any size") {
  for (const long denominator : {16, 100, 10000}) {
    const Rational height(1, denominator);
    CAPTURE(denominator);
    const auto found = oracle::intersect(cap(height), floor_square);
    check_counts(found, 1, 0);
    const double radius = std::sqrt(to_double(height));
    for (const auto& z : found.curves.at(0).points) {
      CHECK(std::hypot(z[0] - 0.5, z[1] - 0.5) == Approx(radius));
      CHECK(std::abs(z[0] - z[2]) + std::abs(z[1] - z[3]) < 1e-10);
    }
  }
  check_counts(oracle::intersect(cap(Rational(-1, 10000)), floor_square), 0, 0);
}

TEST_CASE("oracle: a cap that reaches over the sides leaves arcs at the corners") {
  // Radius^2 = 3/10: outside the sides (1/4), inside the corners (1/2).
  const auto wide_floor = plane({-1, -1, 0}, {3, 0, 0}, {0, 3, 0});
  check_counts(oracle::intersect(cap(Rational(3, 10)), wide_floor), 0, 4);
}

TEST_CASE("oracle: two squares cross in one open arc") {
  const auto upright =
      plane({Rational(1, 5), Rational(1, 3), -1}, {Rational(2, 5), Rational(1, 7), 0}, {0, 0, 2});
  check_counts(oracle::intersect(floor_square, upright), 0, 1);
  check_counts(oracle::intersect(upright, floor_square), 0, 1);
}

TEST_CASE("oracle: the first example has a loop and an arc between known ends") {
  const auto found = example("chapter9-first.json");
  check_counts(found, 1, 1);
  const auto has = [&](const oracle::Vector4& expected) {
    return std::any_of(found.boundary_points.begin(), found.boundary_points.end(), [&](const auto& z) {
      double largest = 0;
      for (std::size_t i = 0; i < 4; ++i) largest = std::max(largest, std::abs(z[i] - expected[i]));
      return largest < 1e-12;
    });
  };
  CHECK(has({0, 0.734303721558761, 0.041334560673668, 0.7477094010264}));
  CHECK(has({0.0753529119328255, 0.953884419355198, 0.104442005262723, 1}));
}

TEST_CASE("oracle: the second example has three arcs") {
  check_counts(example("chapter9-second.json"), 0, 3);
}

TEST_CASE("oracle: what doubles cannot decide is called doubtful") {
  CHECK_FALSE(example("touching-curve.json").conclusive());
  CHECK_FALSE(oracle::intersect(cap(0), floor_square).conclusive());  // touch in a point
  CHECK_FALSE(
      oracle::intersect(cap(Rational(1, 4)), floor_square).conclusive());  // the circle touches the sides
  CHECK_FALSE(oracle::intersect(floor_square, floor_square).conclusive());
}

TEST_CASE("oracle: random pairs give curves on both patches, most of them without doubt") {
  for (const auto family :
       {random_pairs::small_rationals, random_pairs::doubles, random_pairs::scattered, random_pairs::loop}) {
    int conclusive = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      random_pairs::Generator generator(seed);
      const auto pair = family(generator);
      const auto found = oracle::intersect(pair.x, pair.y);
      conclusive += found.conclusive() ? 1 : 0;
      INFO("seed " << seed);
      if (found.conclusive())
        CHECK(found.boundary_points.size() == static_cast<std::size_t>(2 * found.open()));
      for (const auto& curve : found.curves) {
        const auto& z = curve.points.at(curve.points.size() / 2);
        const Point difference =
            pair.x(from_double(z[0]), from_double(z[1])) - pair.y(from_double(z[2]), from_double(z[3]));
        CHECK(std::abs(to_double(dot(difference, difference))) < 1e-20);
      }
    }
    CHECK(conclusive >= 8);
  }
}

}  // namespace exsect::oracle_test

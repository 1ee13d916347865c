#include "output/drawing/plane_curve.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::cli::plane_curve_test {
namespace {

double distance(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const double length2 = std::pow(b[0] - a[0], 2) + std::pow(b[1] - a[1], 2);
  double t = length2 > 0 ? ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length2 : 0;
  t = std::min(1.0, std::max(0.0, t));
  return std::hypot(p[0] - a[0] - t * (b[0] - a[0]), p[1] - a[1] - t * (b[1] - a[1]));
}

double distance(const PlanePoint& p, const PlanePolyline& polyline) {
  double least = std::hypot(p[0] - polyline[0][0], p[1] - polyline[0][1]);
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
    least = std::min(least, distance(p, polyline[i], polyline[i + 1]));
  return least;
}

TEST_CASE("a simplified polyline keeps its ends and stays near every vertex") {
  CHECK(simplified({}, 0.1).empty());
  CHECK(simplified({{0, 0}}, 0.1).size() == 1);
  CHECK(simplified({{0, 0}, {0.5, 0}, {1, 0}}, 1e-9) == PlanePolyline{{0, 0}, {1, 0}});
  // A loop: the chord between equal ends is a point.
  CHECK(simplified({{0, 0}, {1, 0}, {1, 1}, {0, 0}}, 0.1).size() == 4);
  std::mt19937_64 random(11);
  std::normal_distribution<double> step(0, 0.01);
  for (int repeat = 0; repeat < 20; ++repeat) {
    PlanePolyline walk = {{0.5, 0.5}};
    for (int i = 0; i < 300; ++i)
      walk.push_back({walk.back()[0] + step(random), walk.back()[1] + step(random)});
    const PlanePolyline simple = simplified(walk, 0.02);
    CHECK(simple.front() == walk.front());
    CHECK(simple.back() == walk.back());
    CHECK(simple.size() < walk.size());
    for (const PlanePoint& p : walk) CHECK(distance(p, simple) <= 0.02);
  }
}

TEST_CASE("a circle inside the square is one closed polyline of zeros") {
  const auto circle = [](PlanePoint p) { return std::hypot(p[0] - 0.5, p[1] - 0.4) - 0.3; };
  const auto curves = zero_set(circle, 50);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].front() == curves[0].back());
  for (const PlanePoint& p : curves[0]) CHECK(std::abs(circle(p)) < 1e-6);
  double length = 0;
  for (std::size_t i = 0; i + 1 < curves[0].size(); ++i) {
    length += std::hypot(curves[0][i + 1][0] - curves[0][i][0], curves[0][i + 1][1] - curves[0][i][1]);
  }
  CHECK(length == Approx(0.6 * std::acos(-1.0)).epsilon(0.002));
}

TEST_CASE("open curves run from side to side") {
  const auto curves = zero_set([](PlanePoint p) { return (p[0] - 0.31) * (p[0] - 0.72); }, 20);
  REQUIRE(curves.size() == 2);
  for (const PlanePolyline& curve : curves) {
    CHECK(std::min(curve.front()[1], curve.back()[1]) == 0);
    CHECK(std::max(curve.front()[1], curve.back()[1]) == 1);
    CHECK(curve.size() == 21);
  }
}

TEST_CASE("a saddle inside one cell is resolved by the middle of the cell") {
  // Zero on a hyperbola whose two branches pass one cell; both belong to the zero set.
  for (double level : {-0.01, 0.01}) {
    const auto saddle = [level](PlanePoint p) { return (p[0] - 0.5) * (p[1] - 0.5) - level; };
    const auto curves = zero_set(saddle, 3);
    REQUIRE(curves.size() == 2);
    for (const PlanePolyline& curve : curves) {
      CHECK(curve.size() == 4);
      for (const PlanePoint& p : curve) CHECK(std::abs(saddle(p)) < 1e-6);
    }
  }
}

TEST_CASE("no curve where the sign does not change") {
  CHECK(zero_set([](PlanePoint) { return 1.0; }, 10).empty());
  CHECK(zero_set([](PlanePoint p) { return (p[0] - 0.5) * (p[0] - 0.5); }, 10).empty());
}

}  // namespace
}  // namespace exsect::cli::plane_curve_test

// All pairs of patches of models made of biquadratic B-splines: rings, balls, tubes, and how they meet.
#include "support/renaming_checks.h"

namespace exsect::spline_models_test {

namespace {

using Row = std::vector<Point>;

/// The Bézier control points of the segments of a uniform quadratic B-spline, its ends as they are or closed.
std::vector<std::array<Point, 3>> segments(const Row& spline, bool closed) {
  const Rational half(1, 2);
  const std::size_t n = spline.size();
  std::vector<std::array<Point, 3>> result;
  for (std::size_t i = 0; i < (closed ? n : n - 2); ++i) {
    const Point& p = spline[i];
    const Point& q = spline[(i + 1) % n];
    const Point& r = spline[(i + 2) % n];
    result.push_back({!closed && i == 0 ? p : half * (p + q), q, !closed && i == n - 3 ? r : half * (q + r)});
  }
  return result;
}

/// The profile, radius and height, turned around the z axis, with a square as the spline of circles.
std::vector<BezierPatch> turned(const std::vector<std::array<int, 2>>& profile, bool closed) {
  std::array<Row, 4> columns;
  for (const auto& [radius, height] : profile)
    for (std::size_t k = 0; k < 4; ++k)
      columns[k].push_back({radius * (k == 0 || k == 3 ? 1 : -1), radius * (k < 2 ? 1 : -1), height});
  std::array<std::vector<std::array<Point, 3>>, 4> along;
  for (std::size_t k = 0; k < 4; ++k) along[k] = segments(columns[k], closed);
  std::vector<BezierPatch> patches;
  for (std::size_t i = 0; i < along[0].size(); ++i) {
    std::array<std::vector<std::array<Point, 3>>, 3> around;
    for (std::size_t j = 0; j < 3; ++j)
      around[j] = segments({along[0][i][j], along[1][i][j], along[2][i][j], along[3][i][j]}, true);
    for (std::size_t k = 0; k < 4; ++k) {
      ControlNet net;
      for (std::size_t j = 0; j < 3; ++j) net[j] = around[j][k];
      patches.emplace_back(net);
    }
  }
  return patches;
}

/// The axis is that of x, y or z (2), and moved.
std::vector<BezierPatch> placed(const std::vector<BezierPatch>& patches, std::size_t axis, const Point& to) {
  std::vector<BezierPatch> result;
  for (const BezierPatch& patch : patches) {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (Point& p : row) p = Point{p[(2 - axis) % 3], p[(3 - axis) % 3], p[(4 - axis) % 3]} + to;
    result.emplace_back(net);
  }
  return result;
}

/// Every coordinate of every patch is moved by up to 2^-51, on its own.
std::vector<BezierPatch> rounded(const std::vector<BezierPatch>& patches, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::vector<BezierPatch> result;
  for (const BezierPatch& patch : patches) {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (Point& p : row)
        for (Rational& c : p) c += (static_cast<int>(generator() % 1025) - 512) * power_of_two(-60);
    result.emplace_back(net);
  }
  return result;
}

struct Count {
  std::size_t components = 0;
  std::size_t isolated = 0;
  std::size_t crossings = 0;
};

/// Every pair of one patch of each model, or, of the same one, of two.
Count check_pairs(const std::vector<BezierPatch>& first, const std::vector<BezierPatch>& second) {
  Count count;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = &first == &second ? i + 1 : 0; k < second.size(); ++k) {
      INFO("patches " << i << " and " << k);
      const IntersectResult result = complete_intersection(first[i], second[k]);
      count.components += result.graph.components.size();
      count.isolated += result.graph.isolated_points.size();
      for (const Node& node : result.graph.nodes)
        count.crossings +=
            static_cast<std::size_t>(std::count(node.kinds.begin(), node.kinds.end(), NodeKind::crossing));
    }
  return count;
}

}  // namespace

TEST_CASE("spline models: a ball, with its poles") {
  const std::vector<BezierPatch> ball = turned({{0, -2}, {2, -2}, {2, 2}, {0, 2}}, false);
  REQUIRE(ball.size() == 8);
  const Count count = check_pairs(ball, ball);
  CHECK(count.components == 12);       // 4 edges around either pole, 4 on the equator
  CHECK(count.isolated == 2 * 2 + 8);  // opposite quarters at the poles; across the corners of the equator
}

TEST_CASE("spline models: a ring") {
  const std::vector<BezierPatch> ring = turned({{3, 0}, {2, 1}, {1, 0}, {2, -1}}, true);
  REQUIRE(ring.size() == 16);
  const Count count = check_pairs(ring, ring);
  CHECK(count.components == 32);  // every edge
  CHECK(count.isolated == 32);    // two across every corner
}

TEST_CASE("spline models: two rings, exchanged by symmetries") {
  const std::vector<BezierPatch> ring = turned({{3, 0}, {2, 1}, {1, 0}, {2, -1}}, true);
  const Count linked = check_pairs(ring, placed(ring, 0, {0, 2, 0}));
  CHECK((linked.components == 0 && linked.isolated == 0));
  for (const Point& to : {Point{0, 0, 0}, Point{1, 1, 1}, Point{0, 1, 0}}) {
    INFO("moved by " << to[0] << ", " << to[1] << ", " << to[2]);
    CHECK(check_pairs(ring, placed(ring, 0, to)).components > 0);
    CHECK(check_pairs(ring, placed(ring, 1, to)).components > 0);
  }
}

TEST_CASE("spline models: two tubes of one radius whose axes cross") {
  const std::vector<BezierPatch> tube = turned({{1, -2}, {1, 0}, {1, 2}}, false);
  REQUIRE(tube.size() == 4);
  check_pairs(tube, placed(tube, 0, {0, 0, 0}));
}

TEST_CASE("spline models: a ring whose edges agree but for rounding") {
  constexpr unsigned seed = 5;
  INFO("seed " << seed);
  const std::vector<BezierPatch> ring = rounded(turned({{3, 0}, {2, 1}, {1, 0}, {2, -1}}, true), seed);
  CHECK(check_pairs(ring, ring).components > 8);
}

}  // namespace exsect::spline_models_test

#include "shape/coincident_parameters.h"

#include <random>

#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::coincident_parameters_test {
namespace {

using exsect::testing::graph_patch;
using exsect::testing::plane_patch;

/// A graph of small integer heights over the square of its parameters.
BezierPatch random_graph(std::mt19937& generator) {
  std::uniform_int_distribution<int> height(-3, 3);
  testing::HeightCoefficients h{};
  for (auto& row : h)
    for (Rational& c : row) c = height(generator);
  return graph_patch(h);
}

}  // namespace

TEST_CASE("parameters of a graph and its plane are one, exchanged or not") {
  const unsigned seed = 7;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  for (int round = 0; round < 20; ++round) {
    const BezierPatch x = random_graph(generator);
    CHECK(coincident_parameters(x, plane_patch()) == std::array<std::size_t, 4>{2, 3, 0, 1});
    CHECK(coincident_parameters(x, plane_patch().exchanged()) == std::array<std::size_t, 4>{3, 2, 1, 0});
    CHECK(coincident_parameters(plane_patch(), x) == std::array<std::size_t, 4>{2, 3, 0, 1});
  }
}

TEST_CASE("parameters of bent charts are not one") {
  ControlNet net = graph_patch({{{Rational(-13, 36), 1, 0}, {Rational(2, 3), 0, 0}, {-1, 0, 0}}}).net();
  net[1][1][0] += Rational(1, 7);
  net[0][2][1] += Rational(1, 5);
  CHECK(coincident_parameters(BezierPatch(net), plane_patch()) == std::array<std::size_t, 4>{0, 1, 2, 3});
}

namespace {

/// (X,Y,h(X,Y)/w) over the unit square turned into the homogeneous net of bidegree (2,2).
RationalPatch lofted(std::mt19937_64& generator, const std::array<Rational, 3>& heights) {
  std::uniform_int_distribution<int> number(-8, 8);
  std::vector<std::vector<Point>> net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i].push_back({Rational(number(generator), 16) + static_cast<long>(j),
                        Rational(number(generator), 16), heights[i]});
  return RationalPatch(net);
}

RationalPatch image(const RationalPatch& patch, const std::array<HomogeneousPoint, 4>& rows) {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      HomogeneousPoint& q = net[static_cast<std::size_t>(i)].emplace_back();
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; l < 4; ++l) q[k] += rows[k][l] * patch.homogeneous(i, j)[l];
    }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE("parameters along which sections are in planes of one pencil turn together, with weights too") {
  std::mt19937_64 generator(8);
  const std::array<HomogeneousPoint, 4> rows = {{{1, Rational(1, 5), 0, 0},
                                                 {0, 1, Rational(-1, 3), 1},
                                                 {Rational(1, 7), 0, 1, 0},
                                                 {Rational(1, 16), Rational(-1, 16), Rational(1, 8), 1}}};
  const RationalPatch x = lofted(generator, {0, Rational(1, 5), 1});
  const RationalPatch y = lofted(generator, {Rational(-1, 8), Rational(1, 2), 2});
  using Partners = std::array<std::size_t, 4>;
  CHECK(coincident_parameters(x, y) == Partners{2, 1, 0, 3});
  CHECK(coincident_parameters(image(x, rows), image(y, rows)) == Partners{2, 1, 0, 3});
  CHECK(coincident_parameters(image(x, rows).transposed(), image(y, rows)) == Partners{0, 2, 1, 3});
  // A flat end: the heights 0, 0, 1 are u².
  const RationalPatch flat = lofted(generator, {0, 0, 1});
  const CoincidentParameters ends = coincidence(image(flat, rows), image(y, rows));
  CHECK(ends.partner == Partners{2, 1, 0, 3});
  CHECK(ends.flat[0] == std::array<bool, 2>{true, false});
  CHECK(ends.flat[2] == std::array<bool, 2>{false, false});
  // Not monotone, and planes that are others.
  CHECK(coincident_parameters(image(lofted(generator, {0, 1, 0}), rows), image(y, rows)) ==
        Partners{0, 1, 2, 3});
  CHECK(coincident_parameters(image(x, rows), y) == Partners{0, 1, 2, 3});
}

TEST_CASE("a patch that meets the axis of its pencil, and one that goes around it") {
  // Planes through the axis X = Y = 0; a half turn of (1 - u², 2u) is too far.
  const auto around = [](const Rational& from, const Rational& to, const Rational& least) {
    const auto circle = [](const Rational& a, const Rational& b) {
      return HomogeneousPoint{1 - a * b, a + b, 0, 1 + a * b};
    };
    std::vector<std::vector<HomogeneousPoint>> net(3);
    const std::array<HomogeneousPoint, 3> c = {circle(from, from), circle(from, to), circle(to, to)};
    const std::array<Rational, 3> radius = {least, 1, 2};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        net[i].push_back(
            {c[i][0] * radius[j], c[i][1] * radius[j], c[i][3] * static_cast<long>(j * j), c[i][3]});
    return RationalPatch::from_homogeneous(net);
  };
  const RationalPatch quarter = around(0, 1, 1);
  CHECK(coincident_parameters(quarter, around(Rational(1, 5), Rational(1, 2), 1))[0] == 2);
  CHECK(coincident_parameters(quarter, around(Rational(1, 5), Rational(1, 2), 0))[0] == 0);
  CHECK(coincident_parameters(quarter, around(-1, 1, 1))[0] ==
        0);  // a value twice: both ends are in one plane
  CHECK(coincident_parameters(quarter, around(Rational(-9, 10), Rational(9, 10), 1))[0] == 2);
}

}  // namespace exsect::coincident_parameters_test

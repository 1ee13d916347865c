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

}  // namespace exsect::coincident_parameters_test

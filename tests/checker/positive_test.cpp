// Denominators: positive ones of each kind, and those that are not.
#include <exsect/checker/positive.h>
#include <exsect/geometry/rational_patch.h>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::positive_test {
namespace {

using Weights = random_nets::Weights;

bool is_positive(const Weights& weights) {
  checker::Grid<Rational, 1> grid(weights.size() - 1, weights[0].size() - 1);
  grid.each([&](std::size_t i, std::size_t j) { grid[i][j][0] = weights[i][j]; });
  try {
    checker::require_positive(grid);
    return true;
  } catch (const checker::Failed&) {
    return false;
  }
}
/// By the invariant of patches, which is proved in another way.
bool has_patch(const Weights& weights) {
  std::vector<std::vector<Point>> points(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t j = 0; j < weights[0].size(); ++j)
      points[i].push_back({Rational(static_cast<long>(i)), Rational(static_cast<long>(j)), 0});
  try {
    RationalPatch(points, weights);
    return true;
  } catch (const PatchError&) {
    return false;
  }
}

}  // namespace

TEST_CASE("a denominator is positive, or it is refused") {
  const Rational little = power_of_two(-30);
  CHECK(is_positive({{1, 1}, {1, 1}}));
  // (1 - t)^2 + 2 a t (1 - t) + t^2 is (1 + a)/2 at t = 1/2.
  for (const Rational& a : {Rational(0), Rational(-9, 10), Rational(-1 + little)})
    CHECK(is_positive({{1, 1}, {a, a}, {1, 1}}));
  for (const Rational& a : {Rational(-1), Rational(-1 - little), Rational(-3)})
    CHECK(!is_positive({{1, 1}, {a, a}, {1, 1}}));
  // 0 or negative at one corner alone, and everywhere.
  CHECK(!is_positive({{1, 1}, {1, 0}}));
  CHECK(!is_positive({{-little, 1, 1, 1}, {1, 1, 1, 1}}));
  CHECK(!is_positive({{-1, -1}, {-1, -1}}));
  // (u - v)^2 and (u - v)^2 + little: along a line.
  CHECK(!is_positive({{0, Rational(0), 1}, {0, Rational(-1, 2), 0}, {1, 0, 0}}));
  CHECK(!is_positive({{little, little, 1}, {little, Rational(-1, 2), little}, {1, little, little}}));
}

TEST_CASE("denominators of patches are positive, and others are not") {
  random_pairs::Generator generator(43);
  INFO("seed 43");
  int positive = 0;
  for (int i = 0; i < 300; ++i) {
    const auto degree = [&] { return static_cast<std::size_t>(random_pairs::integer(generator, 1, 3)); };
    Weights weights(degree() + 1, std::vector<Rational>(degree() + 1));
    for (auto& row : weights)
      for (Rational& w : row) w = Rational(random_pairs::integer(generator, -2, 9), 4);
    INFO(i);
    REQUIRE(is_positive(weights) == has_patch(weights));
    positive += is_positive(weights) ? 1 : 0;
  }
  CHECK((positive > 30 && positive < 270));
}

}  // namespace exsect::positive_test

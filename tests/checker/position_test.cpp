// The point of space as a quotient: values against the patch, derivatives against exact differences.
#include <exsect/checker/position.h>
#include <exsect/geometry/number.h>
#include <exsect/geometry/rational_patch.h>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::position_test {
namespace {

using namespace checker;
using Generator = random_pairs::Generator;
using Place = Vector4<Rational>;

WeightedNet<Rational> coefficients(const RationalPatch& patch) {
  const auto m = static_cast<std::size_t>(patch.degree_u());
  const auto n = static_cast<std::size_t>(patch.degree_v());
  WeightedNet<Rational> net = {Net<Rational>(m, n), Grid<Rational, 1>(m, n)};
  net.points.each([&](std::size_t i, std::size_t j) {
    const HomogeneousPoint& p = patch.homogeneous(static_cast<int>(i), static_cast<int>(j));
    net.points[i][j] = {p[0], p[1], p[2]};
    net.weights[i][j][0] = p[3];
  });
  net.to_powers();
  return net;
}
bool holds(const Ball<Rational>& ball, const Rational& q) {
  return magnitude(Rational(q - ball.middle)) <= ball.radius;
}

}  // namespace

TEST_CASE("positions of patches with weights and their derivatives along lines") {
  Generator generator(44);
  INFO("seed 44");
  for (int i = 0; i < 30; ++i) {
    INFO(i);
    const auto nets = random_nets::scattered(generator, {1 + i % 3, 1 + i / 3 % 3, 1, 1});
    const RationalPatch patch = random_nets::weighted(generator, nets.x);
    const Position<Rational> position = position_on(coefficients(patch));
    const auto coordinate = [&] { return Rational(random_pairs::integer(generator, 20, 80), 100); };
    const Place middle = {coordinate(), coordinate(), coordinate(), coordinate()};
    const auto x = [&](const Rational& t, const Place& d) {
      return patch(middle[0] + t * d[0], middle[1] + t * d[1]);
    };
    CHECK(position.value(middle) == x(0, {}));
    const Place d = {coordinate() - Rational(1, 2), coordinate() - Rational(1, 2), 0, 0};
    const Rational t = power_of_two(-6);
    Place half;
    Box<Rational> line;
    for (std::size_t j = 0; j < 4; ++j) {
      half[j] = t * magnitude(d[j]);
      line[j] = d[j];
    }
    const auto bounds = position.bounds(middle, half, line, Box<Rational>{});
    const Point first = Rational(1 / t) * (x(t, d) - x(0, d));
    const Point second = Rational(1 / (t * t)) * (x(t, d) - Rational(2) * x(0, d) + x(-t, d));
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(holds(bounds.partial[0][c] * Ball<Rational>(d[0]) + bounds.partial[1][c] * Ball<Rational>(d[1]),
                  first[c]));
      CHECK(holds(bounds.second[c], second[c]));
    }
    // At a point both are the limits: half the step, a quarter of the difference at most.
    const auto exactly = position.bounds(middle, {}, line, Box<Rational>{});
    for (std::size_t c = 0; c < 3; ++c) {
      const auto away = [&](const Rational& h) {
        const Rational along = exactly.partial[0][c].middle * d[0] + exactly.partial[1][c].middle * d[1];
        return std::array{Rational(abs(Rational((x(h, d)[c] - x(-h, d)[c]) / (2 * h) - along))),
                          Rational(abs(Rational((x(h, d)[c] - 2 * x(0, d)[c] + x(-h, d)[c]) / (h * h) -
                                                exactly.second[c].middle)))};
      };
      const Rational h = power_of_two(-20);
      for (std::size_t order = 0; order < 2; ++order)
        CHECK(away(h)[order] <= Rational(26, 100) * away(2 * h)[order]);
      CHECK(exactly.second[c].radius == 0);
    }
  }
}

TEST_CASE("a position is not divided by what may be 0") {
  const std::vector<std::vector<Point>> points = {{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}};
  const Position<Rational> position =
      position_on(coefficients(RationalPatch(points, {{1, 1}, {2, 2}})));  // 1 + u
  CHECK_THROWS_AS(position.value({-1, 0, 0, 0}), Failed);
  CHECK_THROWS_AS(position.bounds({0, 0, 0, 0}, {1, 0, 0, 0}, Box<Rational>{}, Box<Rational>{}), Failed);
  CHECK_NOTHROW(
      position.bounds({0, 0, 0, 0}, {Rational(99, 100), 0, 0, 0}, Box<Rational>{}, Box<Rational>{}));
}

}  // namespace exsect::position_test

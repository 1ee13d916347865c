#include "trace/bounded_vertex.h"

#include <cmath>
#include <random>

#include "support/catch.h"
#include "support/self_checks.h"

namespace exsect::bounded_vertex_test {
using exsect::testing::random_patch;

namespace {

const ModelFrame kUnit = {{0, 0, 0}, 0};

double bound(const BezierPatch& x, const ParameterBox& box) {
  return chord_bound(PairSystem<DoubleBall>(x, x, {0, 0, 0}, 0), kUnit, box);
}

double distance(const Point& a, const Point& b) {
  const Point d = a - b;
  return std::sqrt(to_double(dot(d, d)));
}

}  // namespace

TEST_CASE("chord bound: at least any distance in the box, the same with the parameters exchanged") {
  std::mt19937 generator(7);
  std::uniform_int_distribution<int> grid(0, 16);
  for (int i = 0; i < 50; ++i) {
    const BezierPatch x = random_patch(generator, 5);
    const Rational width(1, 1 << (1 + i % 12));
    const Rational height(1, 1 << (1 + i % 5));
    const Rational u(grid(generator), 32);
    const Rational v(grid(generator), 32);
    const ParameterBox box = {{{u, u + width}, {v, v + height}, {0, 1}, {0, 1}}};
    const double known = bound(x, box);
    CAPTURE(i, known);
    for (int k = 0; k < 10; ++k) {
      const auto point = [&] {
        const Rational a = u + width * Rational(grid(generator), 16);
        return x(a, v + height * Rational(grid(generator), 16));
      };
      const Point first = point();
      CHECK(distance(first, point()) <= known);
    }
    CHECK(bound(x.exchanged(), {box[1], box[0], box[3], box[2]}) == Approx(known));
  }
}

TEST_CASE("chord bound: small where a line turns") {
  // x = (u^2 + (1 - v) u, v, 0): on v = 1 and 0 <= u <= h the points are at most h^2 apart.
  ControlNet power{};
  power[2][0] = {1, 0, 0};
  power[1][0] = {1, 0, 0};
  power[1][1] = {-1, 0, 0};
  power[0][1] = {0, 1, 0};
  const BezierPatch x = BezierPatch::from_power_basis(power);
  const Rational h(1, 256);
  const ParameterBox box = {{{0, h}, {1, 1}, {0, 1}, {0, 1}}};
  CHECK(bound(x, box) < 4 * 0x1p-16);
  CHECK(bound(x.exchanged(), {box[1], box[0], box[3], box[2]}) < 4 * 0x1p-16);
}

}  // namespace exsect::bounded_vertex_test

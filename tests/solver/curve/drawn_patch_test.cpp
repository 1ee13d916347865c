// Bounds of the derivatives of patches, on the square and on rectangles of it, and of chords.
#include "curve/drawn_patch.h"

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/catch.h"

namespace exsect::drawn_patch_test {
namespace {

RationalPatch random_patch(std::mt19937& generator, int m, int n, bool weighted) {
  std::uniform_int_distribution<int> digit(-9, 9), weight(1, 9);
  std::vector<std::vector<Point>> points;
  std::vector<std::vector<Rational>> weights;
  for (int i = 0; i <= m; ++i) {
    points.emplace_back();
    if (weighted) weights.emplace_back();
    for (int j = 0; j <= n; ++j) {
      points.back().push_back({digit(generator), digit(generator), digit(generator)});
      if (weighted) weights.back().emplace_back(weight(generator), 3);
    }
  }
  return RationalPatch(points, weights);
}

double distance(const Point& a, const Point& b) {
  return std::hypot(to_double(a[0] - b[0]), to_double(a[1] - b[1]), to_double(a[2] - b[2]));
}

/// The lengths of difference quotients about (u,v), exact but for the last step.
PatchRates quotients(const RationalPatch& x, const Rational& u, const Rational& v) {
  const Rational h = power_of_two(-20);
  const double step = to_double(h);
  const Point o = x(u, v), e = x(u + h, v), w = x(u - h, v), n = x(u, v + h), s = x(u, v - h);
  const Rational two = 2;
  return {distance(e, w) / (2 * step), distance(n, s) / (2 * step), distance(e + w, two * o) / step / step,
          distance(x(u + h, v + h) + x(u - h, v - h), x(u + h, v - h) + x(u - h, v + h)) / 4 / step / step,
          distance(n + s, two * o) / step / step};
}

bool covers(const PatchRates& bound, const PatchRates& found) {
  const auto above = [](double a, double b) { return a * (1 + 1e-4) + 1e-4 >= b; };
  return above(bound.u, found.u) && above(bound.v, found.v) && above(bound.uu, found.uu) &&
         above(bound.uv, found.uv) && above(bound.vv, found.vv);
}

/// A quarter of a torus, half a circle in either direction, whose weights in the middle are 0.
RationalPatch quarter_torus(const Rational& major, const Rational& minor, const Point& centre) {
  const std::array<std::array<Rational, 3>, 3> half = {{{1, 0, -1}, {0, 1, 0}, {1, 0, 1}}};  // x, y, w
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational weight = half[2][i] * half[2][j], out = major * half[2][j] + minor * half[1][j];
      net[i].push_back({half[0][i] * out + weight * centre[0], half[1][i] * out + weight * centre[1],
                        half[2][i] * minor * half[0][j] + weight * centre[2], weight});
    }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE("rates of patches bound difference quotients, cells less than the square", "[curve]") {
  const unsigned seed = 3;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> place(1, 999);
  double whole = 0, local = 0;
  for (int i = 0; i < 24; ++i) {
    const RationalPatch x = random_patch(generator, 1 + i % 3, 1 + i / 3 % 3, i % 2 == 0);
    const DrawnPatch drawn(x);
    for (int k = 0; k < 20; ++k) {
      const Rational u(place(generator), 1000), v(place(generator), 1000);
      const PatchRates found = quotients(x, u, v);
      const double a = to_double(u), b = to_double(v);
      const PatchRates near = drawn.rates_in(a - 1e-6, a + 1e-6, b - 1e-6, b + 1e-6);
      CHECK(covers(near, found));
      CHECK(covers(drawn.rates(), found));
      CHECK(covers(drawn.rates_in(-1, 2, -1, 2), near));
      whole += drawn.rates().u;
      local += near.u;
    }
  }
  CHECK(local < 0.7 * whole);
}

TEST_CASE("rates of a torus are near its derivatives wherever it is", "[curve]") {
  for (const Point& centre : {Point{0, 0, 0}, Point{1000, -300, Rational(1, 7)}}) {
    const RationalPatch x = quarter_torus(1, Rational(1, 2), centre);
    const DrawnPatch drawn(x);
    for (int i = 0; i < 16; ++i)
      for (int j = 0; j < 16; ++j) {
        const Rational u(2 * i + 1, 32), v(2 * j + 1, 32);
        const double a = to_double(u), b = to_double(v);
        const PatchRates near = drawn.rates_in(a, a, b, b), found = quotients(x, u, v);
        INFO(i << ", " << j);
        CHECK(covers(near, found));
        CHECK(near.u < 2 * found.u);
        CHECK(near.v < 2 * found.v);
        CHECK(near.uu < 5 * found.uu);
        CHECK(near.vv < 5 * found.vv);
        CHECK(near.uv < 30);  // 8 in the middle of the patch
      }
  }
}

TEST_CASE("rates over ranges beyond the square or without order are not too small", "[curve]") {
  std::mt19937 generator(5);
  const DrawnPatch drawn(random_patch(generator, 3, 2, true));
  const double huge = 1e300, infinite = std::numeric_limits<double>::infinity();
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const PatchRates all = drawn.rates_in(0, 1, 0, 1);
  CHECK(covers(drawn.rates_in(-huge, huge, -infinite, infinite), all));
  CHECK(covers(drawn.rates_in(unknown, 1, 0, 1), drawn.rates()));
  CHECK(covers(drawn.rates_in(0, 1, 0, unknown), drawn.rates()));
  CHECK(covers(drawn.rates_in(0, 1, 0.5, 0.25), drawn.rates()));
  CHECK(covers(drawn.rates_in(huge, infinite, 0, 0), drawn.rates_in(0.999, 1, 0, 0)));
}

TEST_CASE("chords keep within their bounds", "[curve]") {
  const unsigned seed = 4;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> place(50, 950), step(-40, 40);
  for (int i = 0; i < 100; ++i) {
    const RationalPatch x = random_patch(generator, 1 + i % 3, 1 + i / 3 % 3, i % 2 == 0);
    const DrawnPatch drawn(x);
    const Rational u0(place(generator), 1000), v0(place(generator), 1000);
    const Rational u1 = u0 + Rational(step(generator), 1000), v1 = v0 + Rational(step(generator), 1000);
    const auto [a, b] = std::minmax({to_double(u0), to_double(u1)});
    const auto [c, d] = std::minmax({to_double(v0), to_double(v1)});
    const double bound = chord_bound(drawn.rates_in(a, b, c, d), b - a, d - c);
    const Point from = x(u0, v0), to = x(u1, v1);
    for (int k = 1; k < 8; ++k) {
      const Rational t(k, 8);
      const Point on_chord = (1 - t) * from + t * to;
      CHECK(distance(x(u0 + t * (u1 - u0), v0 + t * (v1 - v0)), on_chord) <= bound * (1 + 1e-9) + 1e-12);
    }
  }
}

}  // namespace exsect::drawn_patch_test

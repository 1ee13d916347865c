// Bounds for a curve in a tube against the curve itself: u -> (u, u^2, u^3 - u/4, 1 - u).
#include <exsect/checker/curve_bounds.h>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::curve_bounds_test {
namespace {

using Place = checker::Vector4<Rational>;
using checker::Ball;

Rational q(long a, long b) { return Rational(a, b); }

/// (v - u^2)(1 + r/4), (r - u^3 + u/4)(1 + v/4), (s - 1 + u)(1 + u/4): it vanishes on the curve alone.
checker::Map<Rational> map() {
  checker::Map<Rational> result;
  const auto add = [&](std::size_t d, const checker::Power& power, const Rational& c) {
    checker::Vector3<Rational> row = {};
    row[d] = 1;
    result.add(power, row, c);
  };
  add(0, {0, 1, 0, 0}, 1), add(0, {0, 1, 1, 0}, q(1, 4)), add(0, {2, 0, 0, 0}, -1),
      add(0, {2, 0, 1, 0}, q(-1, 4));
  add(1, {0, 0, 1, 0}, 1), add(1, {0, 1, 1, 0}, q(1, 4)), add(1, {3, 0, 0, 0}, -1),
      add(1, {3, 1, 0, 0}, q(-1, 4));
  add(1, {1, 0, 0, 0}, q(1, 4)), add(1, {1, 1, 0, 0}, q(1, 16));
  add(2, {0, 0, 0, 1}, 1), add(2, {1, 0, 0, 1}, q(1, 4)), add(2, {0, 0, 0, 0}, -1),
      add(2, {1, 0, 0, 0}, q(3, 4));
  add(2, {2, 0, 0, 0}, q(1, 4));
  return result;
}
Place curve(const Rational& u) { return {u, u * u, u * u * u - u / 4, 1 - u}; }
Rational slope_of_r(const Rational& u) { return 3 * u * u - q(1, 4); }

/// Around the place with u = 3/10, near which r turns: at u = 0.2887.
struct Example {
  checker::Map<Rational> f = map();
  checker::Tube<Rational> tube = {{}, curve(q(3, 10)), {0}, {1, q(3, 5), q(1, 50), -1}, q(1, 8), q(1, 8), {}};
  checker::CurveBounds<Rational> bounds = {};

  Example() {
    tube.inverse = checker::near_inverse(f.at(tube.centre), 0);
    bounds = checker::bounds_over(f, 0, tube.centre, tube.extent());
  }
};

}  // namespace

TEST_CASE("the box around a tube holds the tube and more, up to its edges") {
  const Example e;
  for (const Rational& slack : checker::contraction(e.tube, e.f.at(e.tube.centre).times(e.tube.inverse)))
    CHECK(slack > 0);
  const Place h = e.tube.extent();
  CHECK(h == Place{q(1, 8), q(1, 5), q(51, 400), q(1, 4)});
  for (std::size_t i = 0; i < 4; ++i) {
    INFO(i);
    for (const int side : {-1, 1}) {
      Place w = e.tube.centre;
      w[i] += side * (h[i] - q(1, 1000));
      CHECK(e.tube.surrounds(checker::box_around(w, q(1, 1000))));
      CHECK(!e.tube.surrounds(checker::box_around(w, q(1, 999))));
      CHECK((i == 2 || !e.tube.contains(checker::box_around(w, q(1, 1000)))));
    }
  }
}

TEST_CASE("the curve is in the box around its chord, and its derivatives have the signs found") {
  const Example e;
  REQUIRE(e.bounds.defect < 1);
  REQUIRE(e.bounds.first[2].sign() == 0);
  random_pairs::Generator generator(61);
  INFO("seed 61");
  std::array<int, 3> found = {};
  for (int n = 0; n < 200; ++n) {
    const Rational begin = q(3, 10) + q(random_pairs::integer(generator, -120, 110), 1000);
    const Rational end =
        std::min<Rational>(begin + q(random_pairs::integer(generator, 1, 60), 1000), q(21, 50));
    const Rational margin = q(random_pairs::integer(generator, 0, 1), 100000);
    Place a = curve(begin), b = curve(end);
    for (std::size_t i = 1; i < 4; ++i) a[i] += margin, b[i] -= margin;
    const auto box = checker::around_chord(e.tube, e.bounds, a, b, margin, {false, false, true, false});
    for (int m = 0; m <= 10; ++m) {
      const Place w = curve(begin + (end - begin) * m / 10);
      for (std::size_t i = 0; i < 4; ++i) CHECK(abs(w[i] - box[i].middle) <= box[i].radius);
    }
    const auto over = checker::bounds_over(e.f, 0, checker::middles(box), checker::radii(box));
    const auto signs = checker::slope_signs(e.f, 0, over, a, margin, Rational(end - begin + margin));
    CHECK(signs[0] == 1);
    CHECK(signs[3] == -1);
    const int sign = signs[2];
    ++found[static_cast<std::size_t>(sign + 1)];
    INFO(begin << " to " << end << " : " << sign);
    // r' grows for u > 0: it has one sign from begin to end where it has the same at both.
    if (sign != 0) CHECK((sign * slope_of_r(begin) > 0 && sign * slope_of_r(end) > 0));
    if (slope_of_r(begin) > q(6, 5) * q(6, 5) * 6 * (end - begin + margin)) CHECK(sign == 1);
  }
  for (const int count : found) CHECK(count > 10);
}

}  // namespace exsect::curve_bounds_test

#include "self/chart.h"

#include <algorithm>
#include <cmath>

#include "self/tube.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::chart_test {

namespace {

BezierPatch random_patch(std::uint64_t seed) {
  random_pairs::Generator generator(seed);
  return random_pairs::scattered(generator).x;
}

BallPoint<DoubleBall> random_point(random_pairs::Generator& generator) {
  const auto coordinate = [&] {
    return DoubleBall(0x1p-10 * static_cast<double>(random_pairs::integer(generator, 1, 1023)));
  };
  return {coordinate(), coordinate(), coordinate(), coordinate()};
}

/// The balls have a common point, which is trivial for wide balls: they must be narrow.
bool equal(const DoubleBall& a, const DoubleBall& b) {
  return (a - b).certain_sign() == 0 && (a - b).radius() < 1e-10;
}

}  // namespace

TEST_CASE("charts: Taylor coefficients by two ways, zero off the support") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    for (const Chart chart : {Chart::first, Chart::second}) {
      const ChartSystem<DoubleBall> system(random_patch(seed), {1, 2, 3}, 2, chart);
      const BallPoint<DoubleBall> p = random_point(generator);
      ChartNet<DoubleBall, 2> expected = system.equation();
      shift<DoubleBall, 2>(expected, p);
      const ChartNet<DoubleBall, 2> taylor = system.taylor(p);
      for (std::size_t i = 0; i < taylor.size(); ++i) {
        const bool in_support = std::count(chart_support.begin(), chart_support.end(), i) > 0;
        for (std::size_t c = 0; c < 3; ++c) {
          CHECK(equal(taylor[i][c], expected[i][c]));
          if (!in_support) CHECK(taylor[i][c].upper_magnitude() < 1e-290);
        }
      }
    }
  }
}

TEST_CASE("charts: 2 t H is the difference and X the mean of the two values") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    const BezierPatch x = random_patch(seed);
    random_pairs::Generator generator(seed);
    for (const Chart chart : {Chart::first, Chart::second}) {
      const ChartSystem<DoubleBall> system(x, {0, 0, 0}, 0, chart);
      const BallPoint<DoubleBall> p = random_point(generator);
      const double t = 0.375;
      const BallPoint<DoubleBall> at = {p[0], p[1], p[2], DoubleBall(t * t)};
      const BallPoint<DoubleBall> pair = pair_of(chart, at);
      const auto exact = [&](std::size_t j) { return from_double(pair[j].approximation()); };
      const Point first = x(exact(0), exact(1));
      const Point second = x(exact(2), exact(3));
      const DoubleBall difference(2 * t);
      const BallVector<DoubleBall> h = system.taylor(at)[0];
      const BallVector<DoubleBall> mean = space_point(system, at);
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(std::fabs(to_double(first[c] - second[c]) - (difference * h[c]).approximation()) < 1e-12);
        CHECK(std::fabs(to_double((first[c] + second[c]) / 2) - mean[c].approximation()) < 1e-12);
      }
      const BallPoint<DoubleBall> other =
          pair_of(chart == Chart::first ? Chart::second : Chart::first, in_other_chart(at));
      for (std::size_t j = 0; j < 4; ++j) CHECK(equal(pair[j], other[j]));
    }
  }
}

TEST_CASE("charts: square roots and reciprocals of balls enclose") {
  for (const double x : {1e-30, 1e-9, 0.3, 2.0, 7e8}) {
    for (const double radius : {0.0, 1e-3}) {
      const DoubleBall ball(x, radius * x);
      const DoubleBall root = square_root(ball);
      const DoubleBall inverse = reciprocal(ball);
      for (const double end : {x - radius * x, x, x + radius * x}) {
        const Rational q = from_double(end);
        CHECK(root.interval().lower * root.interval().lower <= q);
        CHECK(root.interval().upper * root.interval().upper >= q);
        CHECK(inverse.interval().lower * q <= 1);
        CHECK(inverse.interval().upper * q >= 1);
      }
      CHECK(root.radius() <= (1.01 * radius + 1e-14) * std::sqrt(x));
      CHECK(inverse.radius() <= 2 * (radius + 1e-14) / x);
    }
  }
  const ArbBall<256> root = square_root(ArbBall<256>(2.0));
  CHECK(root.radius() < 1e-60);
  CHECK(reciprocal(ArbBall<256>(3.0)).radius() < 1e-60);
}

TEST_CASE("chart tubes: points on the tube solve H = 0, one for every offset") {
  int certified = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    const ChartSystem<DoubleBall> system(random_patch(seed), {0, 0, 0}, 0, Chart::first);
    const auto start = newton_corrected(system, random_point(generator), 3, 20);
    if (!start) continue;
    const auto tube = certify_tube(system, *start, 3, 1e-3, 1e-9);
    if (!tube) continue;
    ++certified;
    for (const double tau : {-9e-4, 0.0, 7e-4}) {
      const BallPoint<DoubleBall> p = point_at(*tube, tau);
      CHECK(contains(*tube, p));
      const BallVector<DoubleBall> h = system.taylor(p)[0];
      for (const DoubleBall& c : h) CHECK((c.certain_sign() == 0 && c.radius() < 1e-9));
      // Another start near by comes to the same point.
      BallPoint<DoubleBall> moved = p;
      moved[0] += DoubleBall(0.25 * tube->halfwidth);
      const auto again = newton_corrected(system, moved, 3, 6);
      REQUIRE(again);
      for (std::size_t j = 0; j < 4; ++j) CHECK(((*again)[j] - p[j]).upper_magnitude() < 1e-10);
    }
    // The space curve's chord deviates by less than the second derivative allows.
    const double k = space_second_derivative(system, *tube);
    const auto a = space_point(system, point_at(*tube, -1e-3));
    const auto b = space_point(system, point_at(*tube, 1e-3));
    const auto m = space_point(system, point_at(*tube, 0));
    double d2 = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = m[c].approximation() - 0.5 * (a[c].approximation() + b[c].approximation());
      d2 += d * d;
    }
    CHECK(std::sqrt(d2) <= k * 4e-6 / 8 * (1 + 1e-9) + 1e-13);
  }
  CHECK(certified >= 3);
}

}  // namespace exsect::chart_test

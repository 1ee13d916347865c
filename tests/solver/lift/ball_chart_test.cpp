#include "lift/ball_chart.h"

#include <exsect/algebra/nearest_rounding.h>

#include <cmath>
#include <random>

#include "lift/exact_chart.h"
#include "support/catch.h"

namespace exsect::ball_chart_test {
namespace {

SurfaceChart chart_with(Polynomial height, Polynomial width, Polynomial denominator) {
  const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s();
  const auto number = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  return {{Rational(1, 3), 2, -5},
          {Rational(127, 5), 1, 0},
          {-1, Rational(127, 5), 0},
          {0, 0, Rational(3, 7)},
          number(Rational(9, 4)) - number(Rational(1, 3)) * u * u - v * v,
          std::move(height),
          std::move(width),
          std::move(denominator),
          Rational(1, 7)};
}

SurfaceChart affine() { return chart_with({0, 1}, 1, 1); }
SurfaceChart of_torus() {
  return chart_with({1, Rational(2, 3), Rational(-1, 5)}, {3, 1, Rational(1, 2)}, {1, 0, Rational(4, 9)});
}

bool contains(const DoubleBall& ball, const RationalInterval& all) {
  const RationalInterval of = ball.interval();
  return of.lower <= all.lower && all.upper <= of.upper;
}

/// Random rectangles, from points to all of [0,1].
void compare(const SurfaceChart& data) {
  const ExactChart exact(data);
  const BallChart balls(data);
  std::mt19937_64 generator(1);
  const auto random = [&](long lowest, long highest) {
    return lowest + static_cast<long>(generator() % static_cast<std::uint64_t>(highest - lowest + 1));
  };
  for (int i = 0; i < 300; ++i) {
    const long width = 1L << random(0, 12);
    const auto interval = [&] {
      const Rational lower(random(0, 4096), 8192);
      return RationalInterval{lower, lower + (i % 3 == 0 ? Rational(0) : Rational(random(0, width), 8192))};
    };
    const RationalInterval u = interval(), v = interval();
    const int sheet = static_cast<int>(random(-1, 1));
    const ExactChart::Place at = {u, v, exact.y_over(u, v, sheet)};
    const BallChart::Place ball = {ball_of(u), ball_of(v), balls.y_over(ball_of(u), ball_of(v), sheet)};
    INFO(i);
    // The exact root is next to the true one by 2^-100.
    CHECK(contains(ball[2].widened(0x1p-99), at[2]));
    const ExactChart::Place along = exact.along_axes(at);
    const BallChart::Place ball_along = balls.along_axes(ball);
    const SpaceBox box = exact.in_space(along);
    const auto ball_box = balls.in_space(ball_along);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(contains(ball_along[k].widened(0x1p-95), along[k]));
      CHECK(contains(ball_box[k].widened(0x1p-90), box[k]));
      if (i % 3 == 0 && sheet == 0) CHECK(width_of(ball_box[k]) < 1e-13);
    }
  }
}

}  // namespace

TEST_CASE("balls of a chart contain its exact intervals") {
  in_nearest_rounding([] {
    compare(affine());
    compare(of_torus());
    return 0;
  });
}

TEST_CASE("nothing is proved of balls beyond doubles, or over zeros of the denominator") {
  in_nearest_rounding([] {
    const BallChart balls(chart_with({0, 1}, 1, {0, 1}));
    for (const DoubleBall& u : {DoubleBall(0, 0.5), DoubleBall(std::nan("")), DoubleBall(1e300)}) {
      const BallChart::Place along =
          balls.along_axes({u * DoubleBall(1e300), DoubleBall(0.5), DoubleBall(1)});
      CHECK(along[1].certain_sign() == 0);
      CHECK_FALSE(width_of(along[1]) < 1e-3);
    }
    const DoubleBall nan(std::nan(""), 0);
    CHECK_FALSE(width_of(hull(nan, DoubleBall(1))) < 1);
    CHECK_FALSE(width_of(hull(DoubleBall(1), nan)) < 1);
    CHECK_FALSE(width_of(balls.y_over(nan, DoubleBall(0), 1)) < 1);
    return 0;
  });
}

TEST_CASE("tangents along the axes are the derivative") {
  in_nearest_rounding([] {
    const SurfaceChart data = of_torus();
    const BallChart balls(data);
    // On the line (u, v, y) = (1/4 + t, 1/2 + 2 t, 1 - t), by central differences.
    const auto at = [&](double t) {
      return balls.along_axes({DoubleBall(0.25 + t), DoubleBall(0.5 + 2 * t), DoubleBall(1 - t)});
    };
    const double step = 0x1p-18;
    const BallChart::Place above = at(step), below = at(-step);
    const BallChart::Place tangent = balls.tangent_along_axes(
        {DoubleBall(1), DoubleBall(2), DoubleBall(-1)}, {DoubleBall(0.25), DoubleBall(0.5), DoubleBall(1)});
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(middle_of(tangent[k]) ==
            Approx((middle_of(above[k]) - middle_of(below[k])) / (2 * step)).epsilon(1e-6));
    return 0;
  });
}

}  // namespace exsect::ball_chart_test

#include "trace/preconditioned_newton.h"

#include <cmath>

#include "support/ball_checks.h"
#include "support/catch.h"

namespace exsect::preconditioned_newton_test {
namespace {

template <class Ball>
std::array<BallVector<Ball>, 3> balls(const std::array<Point, 3>& columns) {
  std::array<BallVector<Ball>, 3> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = {Ball::enclosing(columns[i][0]), Ball::enclosing(columns[i][1]),
                 Ball::enclosing(columns[i][2])};
  return result;
}

/// The largest entry of the matrix times the columns, less the identity.
template <class Ball>
double distance_from_identity(const std::array<Point, 3>& columns) {
  const auto column = balls<Ball>(columns);
  const auto inverse = approximate_inverse(column);
  REQUIRE(inverse);
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const BallVector<Ball> image = preconditioned(*inverse, column[i]);
    for (std::size_t row = 0; row < 3; ++row)
      largest = std::max(largest, (image[row] - Ball(row == i ? 1.0 : 0.0)).upper_magnitude());
  }
  return largest;
}

}  // namespace

TEST_CASE("preconditioners: the inverse of nearly dependent columns at the balls' precision", "[trace]") {
  for (const int bits : {0, 20, 50}) {
    const Rational e = power_of_two(-bits);
    const std::array<Point, 3> columns = {Point{1, Rational(1, 3), 2},
                                          Point{Rational(-2, 7), 1, Rational(1, 2)},
                                          Point{1 + e, Rational(1, 3) - e, 2 + 3 * e}};
    CHECK(distance_from_identity<ArbBall<256>>(columns) < std::ldexp(1, 2 * bits - 200));
    CHECK(distance_from_identity<DoubleDoubleBall>(columns) < std::ldexp(1, 2 * bits - 95));
  }
  const std::array<Row3, 3> dependent = {Row3{1, 2, 3}, Row3{2, 4, 6}, Row3{0, 1, 0}};
  CHECK_FALSE(approximate_inverse(dependent));
}

TEST_CASE("preconditioners: reciprocals to nearly all bits, and none of zero", "[trace]") {
  const Rational a(-7, 3);
  const auto found = approximate_reciprocal(ArbBall<1024>::enclosing(a));
  REQUIRE(found);
  CHECK(abs(found->interval().lower - 1 / a) < power_of_two(-800));
  CHECK_FALSE(approximate_reciprocal(ArbBall<256>(0.0)));
  CHECK_FALSE(approximate_reciprocal(ArbBall<256>::enclosing(power_of_two(-1074))));
}

TEST_CASE("preconditioners: the three axes that are not held", "[trace]") {
  CHECK(other_axes(0) == std::array<std::size_t, 3>{1, 2, 3});
  CHECK(other_axes(2) == std::array<std::size_t, 3>{0, 1, 3});
  CHECK(other_axes(3) == std::array<std::size_t, 3>{0, 1, 2});
}

TEST_CASE("newton steps: quadratic convergence in the axes that are not held", "[trace]") {
  using Ball = ArbBall<256>;
  // w_j^2 = 2 for j other than the axis: the correction is (w^2 - 2)/(2 w).
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto others = other_axes(axis);
    BallPoint<Ball> start;
    for (Ball& c : start) c = Ball(1.5);
    const auto correction = [&](const BallPoint<Ball>& p) -> std::optional<BallVector<Ball>> {
      BallVector<Ball> c;
      for (std::size_t i = 0; i < 3; ++i) {
        const Ball& w = p[others[i]];
        c[i] = (w * w - Ball(2)) * *approximate_reciprocal(Ball(2) * w);
      }
      return c;
    };
    const auto found = newton_steps(start, axis, 7, correction);
    REQUIRE(found);
    CHECK((*found)[axis].approximation() == 1.5);
    for (const std::size_t j : others)
      CHECK(((*found)[j] * (*found)[j] - Ball(2)).upper_magnitude() < std::ldexp(1, -180));
  }
  const auto far = [](const BallPoint<Ball>&) -> std::optional<BallVector<Ball>> {
    return BallVector<Ball>{Ball(-9), Ball(0), Ball(0)};
  };
  CHECK_FALSE(newton_steps(BallPoint<Ball>{}, 0, 1, far));
  const auto none = [](const BallPoint<Ball>&) -> std::optional<BallVector<Ball>> { return std::nullopt; };
  CHECK_FALSE(newton_steps(BallPoint<Ball>{}, 0, 1, none));
}

}  // namespace exsect::preconditioned_newton_test

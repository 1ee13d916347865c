#include "trace/tube_evaluation.h"

#include <random>

#include "support/ball_checks.h"
#include "support/catch.h"

namespace exsect::tube_evaluation_test {
namespace {

/// t with t_i = base_i + sum E_ij t_j, by Cramer's rule over Q.
std::array<Rational, 3> solution(const std::array<Row3, 4>& e, const std::array<std::size_t, 3>& others,
                                 const Row3& base) {
  std::array<Point, 3> column;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t row = 0; row < 3; ++row)
      column[i][row] = Rational(row == i ? 1 : 0) - from_double(e[others[i]][row]);
  const Point b = {from_double(base[0]), from_double(base[1]), from_double(base[2])};
  const auto det = [](const Point& p, const Point& q, const Point& r) { return dot(p, cross(q, r)); };
  const Rational d = det(column[0], column[1], column[2]);
  return {det(b, column[1], column[2]) / d, det(column[0], b, column[2]) / d,
          det(column[0], column[1], b) / d};
}

}  // namespace

TEST_CASE("tube evaluation: bounds are above the solution, and near it where rows differ much", "[trace]") {
  std::mt19937_64 generator(20270);
  std::uniform_real_distribution<double> part(0, 1);
  for (int round = 0; round < 300; ++round) {
    const auto others = other_axes(static_cast<std::size_t>(round % 4));
    const double contraction = 0.5 * part(generator);
    std::array<Row3, 4> e{};
    Row3 base;
    for (std::size_t row = 0; row < 3; ++row) {
      base[row] = std::exp2(-60 * part(generator));
      double left = contraction;
      for (const std::size_t j : others) {
        e[j][row] =
            left * part(generator) * std::exp2(-40.0 * static_cast<double>(round % 3) * part(generator));
        left -= e[j][row];
      }
    }
    const Row3 bound = tubes::bound_solution(e, others, base, contraction);
    const auto exact = solution(e, others, base);
    for (std::size_t row = 0; row < 3; ++row) {
      CHECK(from_double(bound[row]) >= exact[row]);
      // Four steps by rows: what is left of the largest row comes through E four times.
      const double largest = std::max({base[0], base[1], base[2]});
      CHECK(bound[row] <= 1.01 * to_double(exact[row]) + 1.01 * largest * std::pow(contraction, 4));
    }
  }
}

TEST_CASE("tube evaluation: a net's value at an offset", "[trace]") {
  random_pairs::Generator generator(20271);
  using Ball = ArbBall<256>;
  const BezierPatch x = random_pairs::scattered(generator).x;
  const PairSystem<Ball> system(x, x, {0, 0, 0}, 0);
  for (int round = 0; round < 20; ++round) {
    const auto p = testing::random_place(generator);
    const auto w = testing::random_place(generator);
    const TaylorNet<Ball> net = system.taylor_x(testing::ball_point<Ball>(p));
    const BallVector<Ball> value =
        tubes::value_at(net, Ball::enclosing(w[0] - p[0]), Ball::enclosing(w[1] - p[1]));
    CHECK(testing::encloses(value, x(w[0], w[1])));
  }
}

}  // namespace exsect::tube_evaluation_test

#include "trace/pair_system.h"

#include "support/ball_checks.h"
#include "support/catch.h"

namespace exsect::pair_system_test {
namespace {

using testing::ball_point;
using testing::encloses;

/// x(u,v) - y(r,s) and its derivatives are exact: from the patches themselves.
template <class Ball>
void check_expansion(const random_pairs::Pair& pair, const std::array<Rational, 4>& w) {
  const Point origin = {Rational(1, 3), Rational(-2, 7), Rational(1, 5)};
  const PairSystem<Ball> system(pair.x, pair.y, origin, 1);
  const Expansion<Ball> at(system, ball_point<Ball>(w));
  const Rational half(1, 2);
  CHECK(encloses(at.value(), half * (pair.x(w[0], w[1]) - pair.y(w[2], w[3]))));
  CHECK(encloses(at.x[0], half * (pair.x(w[0], w[1]) - origin)));
  const std::array<Point, 4> columns = {
      half * pair.x.derivative_first(w[0], w[1]), half * pair.x.derivative_second(w[0], w[1]),
      -half * pair.y.derivative_first(w[2], w[3]), -half * pair.y.derivative_second(w[2], w[3])};
  std::array<Rational, 4> tangent;
  const Point nx = cross(columns[0], columns[1]);
  const Point ny = cross(columns[2], columns[3]);
  tangent = {dot(columns[1], ny), -dot(columns[0], ny), dot(columns[3], nx), -dot(columns[2], nx)};
  for (std::size_t j = 0; j < 4; ++j) {
    CHECK(encloses(at.column(j), columns[j]));
    CHECK(encloses(at.tangent()[j], tangent[j]));
  }
  // (5.1) spans the kernel of the Jacobian.
  for (std::size_t k = 0; k < 3; ++k) {
    Rational sum = 0;
    for (std::size_t j = 0; j < 4; ++j) sum += tangent[j] * columns[j][k];
    CHECK(sum == 0);
  }
}

}  // namespace

TEST_CASE("pair system: values, columns and tangent are those of the patches", "[trace]") {
  random_pairs::Generator generator(20261);
  for (int i = 0; i < 20; ++i) {
    const random_pairs::Pair pair =
        i % 2 == 0 ? random_pairs::small_rationals(generator) : random_pairs::doubles(generator);
    const std::array<Rational, 4> w = testing::random_place(generator);
    check_expansion<DoubleBall>(pair, w);
    check_expansion<DoubleDoubleBall>(pair, w);
    check_expansion<ArbBall<256>>(pair, w);
  }
}

TEST_CASE("pair system: a part of the range of one parameter is the pair seen closely", "[trace]") {
  random_pairs::Generator generator(20262);
  using Ball = ArbBall<256>;
  const random_pairs::Pair pair = random_pairs::small_rationals(generator);
  const PairSystem<Ball> system(pair.x, pair.y, {0, 0, 0}, 0);
  const RationalInterval part = {Rational(1, 5), Rational(1, 5) + power_of_two(-100)};
  for (std::size_t j = 0; j < 4; ++j) {
    const PairSystem<Ball> close = system.restricted(j, part);
    std::array<Rational, 4> w = testing::random_place(generator);
    const Expansion<Ball> seen(close, ball_point<Ball>(w));
    w[j] = part.lower + part.width() * w[j];
    CHECK(encloses(seen.value(), pair.x(w[0], w[1]) - pair.y(w[2], w[3])));
    const Point column = j == 0   ? pair.x.derivative_first(w[0], w[1])
                         : j == 1 ? pair.x.derivative_second(w[0], w[1])
                         : j == 2 ? Rational(-1) * pair.y.derivative_first(w[2], w[3])
                                  : Rational(-1) * pair.y.derivative_second(w[2], w[3]);
    CHECK(encloses(seen.column(j), part.width() * column));
  }
}

}  // namespace exsect::pair_system_test

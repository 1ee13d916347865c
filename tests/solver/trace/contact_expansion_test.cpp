#include "trace/contact_expansion.h"

#include "support/ball_checks.h"
#include "support/catch.h"

namespace exsect::contact_expansion_test {
namespace {

using Ball = ArbBall<256>;

Ball value(const ContactEquations<Ball>& phi, std::size_t row, const std::array<Rational, 4>& offset) {
  Ball sum(0.0);
  phi.for_each_term([&](const std::array<std::size_t, 4>& e, const BallVector<Ball>& c) {
    Rational power = 1;
    for (std::size_t v = 0; v < 4; ++v)
      for (std::size_t n = 0; n < e[v]; ++n) power *= offset[v];
    sum = sum + c[row] * Ball::enclosing(power);
  });
  return sum;
}

}  // namespace

TEST_CASE("contact equations: polynomials in all offsets with the values of F and T", "[trace]") {
  random_pairs::Generator generator(20268);
  for (int round = 0; round < 12; ++round) {
    const random_pairs::Pair pair = random_pairs::small_rationals(generator);
    const PairSystem<Ball> system(pair.x, pair.y, {0, 0, 0}, 0);
    const std::array<Rational, 4> p = testing::random_place(generator);
    const std::array<Rational, 4> w = testing::random_place(generator);
    const Expansion<Ball> centre(system, testing::ball_point<Ball>(p));
    const Expansion<Ball> there(system, testing::ball_point<Ball>(w));
    const std::array<Rational, 4> offset = {w[0] - p[0], w[1] - p[1], w[2] - p[2], w[3] - p[3]};
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const std::array<std::size_t, 2> rows = {0, 2};
      const ContactEquations<Ball> phi = contact_equations(centre, rows, axis);
      for (std::size_t k = 0; k < 2; ++k)
        CHECK((value(phi, k, offset) - there.value()[rows[k]]).upper_magnitude() < 1e-60);
      CHECK((value(phi, 2, offset) - there.tangent()[axis]).upper_magnitude() < 1e-60);
    }
  }
}

TEST_CASE("contact equations: the linear part is the derivative", "[trace]") {
  random_pairs::Generator generator(20269);
  const random_pairs::Pair pair = random_pairs::small_rationals(generator);
  const PairSystem<Ball> system(pair.x, pair.y, {0, 0, 0}, 0);
  const std::array<Rational, 4> p = testing::random_place(generator);
  const Expansion<Ball> centre(system, testing::ball_point<Ball>(p));
  const Rational h = power_of_two(-60);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const ContactEquations<Ball> phi = contact_equations(centre, {1, 2}, axis);
    const auto linear = linear_part(phi);
    for (std::size_t j = 0; j < 4; ++j) {
      std::array<Rational, 4> w = p;
      w[j] += h;
      const Expansion<Ball> there(system, testing::ball_point<Ball>(w));
      const BallVector<Ball> change = {there.value()[1] - centre.value()[1],
                                       there.value()[2] - centre.value()[2],
                                       there.tangent()[axis] - centre.tangent()[axis]};
      for (std::size_t row = 0; row < 3; ++row)
        CHECK((change[row] - Ball::enclosing(h) * linear[j][row]).upper_magnitude() < 1e-30);
    }
  }
}

}  // namespace exsect::contact_expansion_test

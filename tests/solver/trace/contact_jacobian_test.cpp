#include "trace/contact_jacobian.h"

#include <random>

#include "support/ball_checks.h"
#include "support/catch.h"

namespace exsect::contact_jacobian_test {
namespace {

using Ball = ArbBall<256>;

/// How far the derivatives of C Phi at p + offset are from the ideal ones, from the expansion there.
double deviation_there(const PairSystem<Ball>& system, const std::array<Rational, 4>& at,
                       const Linearisation& line, std::size_t row, std::size_t j) {
  const Expansion<Ball> there(system, testing::ball_point<Ball>(at));
  const auto g = preconditioned(line.preconditioner, contact_equations(there, {0, 1}, line.axis));
  const auto others = other_axes(line.axis);
  const double ideal = j == line.axis ? -line.slope[others[row]] : (others[row] == j ? 1.0 : 0.0);
  return (linear_part(g, line.axis)[row][j] - Ball(ideal)).lower_magnitude();
}

}  // namespace

TEST_CASE("contact jacobian: bounds over a box hold at its points, and grow with it", "[trace]") {
  random_pairs::Generator generator(20274);
  std::uniform_real_distribution<double> any(-1, 1);
  int linearised_systems = 0;
  for (int round = 0; round < 20; ++round) {
    const auto pair = random_pairs::small_rationals(generator);
    const PairSystem<Ball> system(pair.x, pair.y, {0, 0, 0}, 0);
    const std::array<Rational, 4> p = testing::random_place(generator);
    const std::size_t axis = static_cast<std::size_t>(round % 4);
    const auto phi = contact_equations(Expansion<Ball>(system, testing::ball_point<Ball>(p)), {0, 1}, axis);
    const auto line = linearised(phi, axis);
    if (!line) continue;
    ++linearised_systems;
    const auto g = preconditioned(line->preconditioner, phi);
    double before = 0;
    for (const double h : {0x1p-20, 0x1p-8, 0x1p-4}) {
      const std::array<double, 4> reach = {h, h / 2, h, h / 4};
      const JacobianDeviation bound = jacobian_deviation(g, axis, line->slope, reach);
      for (int sample = 0; sample < 5; ++sample) {
        std::array<Rational, 4> at = p;
        for (std::size_t j = 0; j < 4; ++j) at[j] += from_double(reach[j] * any(generator));
        for (std::size_t row = 0; row < 3; ++row)
          for (std::size_t j = 0; j < 4; ++j)
            CHECK(deviation_there(system, at, *line, row, j) <= bound[row][j] * (1 + 1e-9) + 1e-13);
      }
      CHECK(largest_row_sum(bound, axis) >= before);
      before = largest_row_sum(bound, axis);
    }
  }
  CHECK(linearised_systems > 10);
}

}  // namespace exsect::contact_jacobian_test

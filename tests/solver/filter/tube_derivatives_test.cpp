#include "filter/tube_derivatives.h"

#include <cmath>
#include <random>

#include "known_curve.h"

namespace exsect::tube_derivatives_test {
namespace {

using testing::KnownCurve;

}  // namespace

TEST_CASE("filter derivatives: along the hyperbola, by its formula", "[filter]") {
  const unsigned seed = 20331;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0.3, 0.9), part(-1, 1);
  const KnownCurve curve(testing::kHyperbola);
  for (int round = 0; round < 100; ++round) {
    const double u = place(generator), reach = std::exp2(-5 - round % 15);
    const filter::Tube tube = curve.tube(u, 1 / (4 * u), 0, reach);
    const double tau = reach * part(generator), p = u + tau;
    const std::array<double, 4> first = {1, -1 / (4 * p * p), 2.0 / 3, -1 / (6 * p * p)};
    const std::array<double, 4> second = {0, 1 / (2 * p * p * p), 0, 1 / (3 * p * p * p)};
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(std::fabs(first[j] - tube.slope[j]) <= tube.slope_error[j] + 1e-14);
      CHECK(std::fabs(second[j] - tube.second[j]) <= tube.second_error[j] + 1e-13);
    }
    // No worse than some times the change of the slope.
    CHECK(tube.slope_error[1] <= 4 * reach / (2 * std::pow(u - reach, 3)) + 1e-6);
  }
}

}  // namespace exsect::tube_derivatives_test

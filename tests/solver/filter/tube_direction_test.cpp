#include "filter/tube_direction.h"

#include <cmath>

#include "filter/series.h"
#include "known_curve.h"

namespace exsect::tube_direction_test {

TEST_CASE("filter direction: an enclosure of w' along the hyperbola, narrower than the tube's", "[filter]") {
  const testing::KnownCurve curve(testing::kHyperbola);
  for (const double u : {0.3, 0.5, 0.8})
    for (const double reach : {0x1p-5, 0x1p-9}) {
      filter::Tube tube = curve.tube(u, 1 / (4 * u), 0, reach);
      filter::expand_arc(tube);
      for (int i = -4; i <= 4; ++i) {
        const double tau = reach * i / 4, p = u + tau;
        const auto direction = filter::direction_at<filter::Biquadratic>(tube, tau);
        const std::array<double, 4> expected = {1, -1 / (4 * p * p), 2.0 / 3, -1 / (6 * p * p)};
        for (std::size_t j = 0; j < 4; ++j)
          CHECK(std::fabs(direction.middle[j] - expected[j]) <= direction.radius + 1e-14);
        CHECK(direction.radius <= tube.slope_error[1]);
      }
    }
}

}  // namespace exsect::tube_direction_test

#include "trace/steps.h"

#include "support/catch.h"

namespace exsect::steps_test {

TEST_CASE("steps: every row of the table is in order", "[trace]") {
  for (const Steps& steps : {kPairSteps, kContactSteps, kChartSteps, kFilterSteps}) {
    CHECK(0 < steps.least_of_two);
    CHECK(steps.least_of_two <= steps.least);
    CHECK(steps.least < steps.first);
    CHECK(steps.first <= steps.longest);
    CHECK(steps.longest < 1);  // a parameter square has width 1
    CHECK(steps.good < steps.worst);
    CHECK(steps.most_pieces > 0);
    // Chains of tubes follow a curve through the half of each tube next to its centre: (5.2) needs less
    // than 1.
    CHECK(steps.worst < 1);
  }
  // TangentialTube states this as its invariant.
  CHECK(kContactSteps.worst <= 0.5);
}

}  // namespace exsect::steps_test

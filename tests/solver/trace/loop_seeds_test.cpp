#include "trace/loop_seeds.h"

#include "support/known_curves.h"

namespace exsect::loop_seeds_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

using Outcome = std::variant<Trace<DoubleBall>, TraceFailure>;

}  // namespace

TEST_CASE("loop seeds: a closed curve is given on, and its taker has the last word", "[trace]") {
  const auto system = system_of<DoubleBall>(kCircle);
  LoopSeeds<DoubleBall> seeds;
  for (const bool answer : {true, false}) {
    int closed = 0;
    CHECK(seeds.trace(system, {}, on_diagonal(q(7, 10), q(23, 30)), {}, [&](Outcome outcome) {
      closed += std::get<Trace<DoubleBall>>(outcome).start == -1 ? 1 : 0;
      return answer;
    }) == answer);
    CHECK(closed == 1);
  }
}

TEST_CASE("loop seeds: after eight failures no further one is tried", "[trace]") {
  const auto system = system_of<DoubleBall>(kCircle);
  const auto never = [](const Outcome&) { return true; };
  LoopSeeds<DoubleBall> seeds;
  // No point of the circle, so that no closed curve runs through it.
  for (int i = 0; i < 8; ++i) {
    CHECK_FALSE(seeds.trace(system, {}, on_diagonal(q(1, 2), q(1, 2)), {}, never));
    if (i == 6) CHECK(seeds.trace(system, {}, on_diagonal(q(7, 10), q(23, 30)), {}, never));
  }
  CHECK_FALSE(seeds.trace(system, {}, on_diagonal(q(7, 10), q(23, 30)), {}, never));
}

}  // namespace exsect::loop_seeds_test

#include "self/loops.h"

#include <algorithm>

#include "support/catch.h"
#include "support/self_checks.h"

namespace exsect::loops_test {
using exsect::testing::checked;
using exsect::testing::degrees;
using exsect::testing::patch;

namespace {

// The sides u = 1 and v = 0 are glued, x(1,t) = x(1 - t,0), so that their corner is cuspidal: doubles are too
// coarse for the curve next to it, and boxes in 256 bits too slow for the search.
const std::vector<int> kGluedAtCuspidalCorner = {0, 0, -1, 1, 0, -1, -1, 1, 0,  0,  -1, -1, 0, -1,
                                                 0, 1, -1, 0, 1, 1,  -1, 0, -1, -1, 0,  0,  -1};

}  // namespace

TEST_CASE("closed curves: searched in doubles though the curves are traced in 256 bits") {
  const IntersectionGraph graph = checked(patch(kGluedAtCuspidalCorner));
  CHECK(std::ranges::count(graph.arcs, ArcPlace::patch_boundary, &Arc::place) == 2);
  CHECK(degrees(graph, NodeKind::crossing) == std::vector{2});
}

}  // namespace exsect::loops_test

// Many pairs on several threads: the results of one thread, in their order.
#include <exsect/solver/intersect_all.h>

#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::intersect_all_test {
namespace {

std::vector<PatchPair> pairs(std::uint64_t seed, std::size_t count) {
  random_pairs::Generator generator(seed);
  std::vector<PatchPair> result;
  for (std::size_t i = 0; i < count; ++i) {
    random_pairs::Pair pair = random_pairs::small_rationals(generator);
    result.push_back({pair.x, pair.y});
  }
  return result;
}

}  // namespace

TEST_CASE("intersect_all: the results of one thread, in their order") {
  const std::vector<PatchPair> list = pairs(8300, 60);
  const std::vector<IntersectResult> one = intersect_all(list), three = intersect_all(list, {}, 3);
  REQUIRE(one.size() == 60);
  REQUIRE(three.size() == 60);
  for (std::size_t i = 0; i < list.size(); ++i) {
    CAPTURE(i);
    CHECK(three[i].status == one[i].status);
    CHECK(difference(three[i].graph, one[i].graph, {}) == "");
    CHECK(difference(three[i].graph, intersect(list[i].x, list[i].y).graph, {}) == "");
  }
}

TEST_CASE("intersect_all: what is refused, and no pair at all") {
  const std::vector<PatchPair> list = pairs(8301, 3);
  CHECK_THROWS_AS(intersect_all(list, {}, 0), std::invalid_argument);
  IntersectOptions wrong;
  wrong.tolerance = 0;
  CHECK_THROWS_AS(intersect_all(list, wrong), std::invalid_argument);
  CHECK_THROWS_AS(intersect_all(list, wrong, 2), std::invalid_argument);
  CHECK(intersect_all({}, {}, 2).empty());
}

}  // namespace exsect::intersect_all_test

// What tests of patches against themselves in doubles share.
#pragma once

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>

#include "self/self_intersect_in_doubles.h"
#include "support/catch.h"
#include "support/polynomial_patch.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"
#include "support/self_orders.h"

namespace exsect::self_in_doubles {

using random_pairs::Generator;
using testing::in_both_orders;

inline BezierPatch scattered(Generator& generator) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = random_pairs::integer(generator, -1000, 1000);
  return BezierPatch(net);
}

/// Not by the exact way, whatever the patch.
inline IntersectResult in_doubles(const RationalPatch& x) {
  return in_nearest_rounding([&] {
    const Run run;
    return run.finished(self_intersect_in_doubles(x, run));
  });
}

inline void check_complete(const IntersectResult& result) {
  for (const Incomplete& open : result.incomplete) UNSCOPED_INFO(open.why);
  REQUIRE(result.status == Status::complete);
}

inline void check_same(const IntersectResult& result, const IntersectionGraph& expected,
                       const Renaming& renaming = {}) {
  check_complete(result);
  CHECK(difference(in_both_orders(expected), in_both_orders(result.graph), renaming) == "");
}

}  // namespace exsect::self_in_doubles

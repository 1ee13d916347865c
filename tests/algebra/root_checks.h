// Checks on lists of isolating intervals, shared by the tests of the isolators.
#pragma once

#include <exsect/algebra/descartes.h>

#include <algorithm>
#include <vector>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::test {

/// The promises of isolate_roots that need no second count: order, disjointness, zeros and signs at the ends.
inline void check_isolating(const Polynomial& f, const Rational& a, const Rational& b,
                            const std::vector<IsolatingInterval>& intervals) {
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto& [lower, upper] = intervals[i];
    INFO("interval " << i << ": " << lower << " .. " << upper);
    CHECK(a <= lower);
    CHECK(upper <= b);
    const int left = f.sign_at(lower);
    const int right = f.sign_at(upper);
    if (lower == upper)
      CHECK(left == 0);
    else {
      CHECK(lower < upper);
      CHECK(left * right == -1);
    }
    if (i > 0) CHECK(intervals[i - 1].upper <= lower);
  }
}

/// `roots` are all roots in [a,b], ascending and distinct: each interval holds its own.
inline void check_roots(const Polynomial& f, const Rational& a, const Rational& b,
                        const std::vector<Rational>& roots) {
  const std::vector<IsolatingInterval> intervals = isolate_roots(f, a, b);
  check_isolating(f, a, b, intervals);
  REQUIRE(intervals.size() == roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const auto& [lower, upper] = intervals[i];
    INFO("root " << roots[i]);
    CHECK((lower == upper ? lower == roots[i] : lower < roots[i] && roots[i] < upper));
  }
}

inline std::vector<Rational> sorted(std::vector<Rational> roots) {
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return roots;
}

inline std::vector<Rational> inside(std::vector<Rational> roots, const Rational& a, const Rational& b) {
  std::erase_if(roots, [&](const Rational& r) { return r < a || r > b; });
  return sorted(std::move(roots));
}

}  // namespace exsect::test

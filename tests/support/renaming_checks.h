// Checks of intersect() that tests of special pairs share.
#pragma once

#include <exsect/solver/intersect.h>

#include <utility>
#include <vector>

#include "support/catch.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect {

/// The patch with these power-basis coefficients c[i][j] of the first parameter's power i.
inline BezierPatch power(const std::vector<std::pair<std::pair<std::size_t, std::size_t>, Point>>& terms) {
  ControlNet c;
  for (auto& row : c) row.fill(Point{0, 0, 0});
  for (const auto& [exponents, coefficient] : terms) c[exponents.first][exponents.second] = coefficient;
  return BezierPatch::from_power_basis(c);
}

inline void check_complete(const IntersectResult& result) {
  for (const Incomplete& region : result.incomplete) UNSCOPED_INFO(region.why);
  CHECK(result.status == Status::complete);
}

/// intersect(), which must be complete and sound.
inline IntersectResult complete_intersection(const BezierPatch& x, const BezierPatch& y,
                                             const IntersectOptions& options = {}) {
  IntersectResult result = intersect(x, y, options);
  check_complete(result);
  CHECK(unsound(x, y, result) == "");
  return result;
}

/// The pair's graph is the same, up to renaming, with patches and parameters exchanged, reversed, and mapped
/// affinely.
inline void check_renamings(const random_pairs::Pair& pair, const IntersectionGraph& graph) {
  struct Renamed {
    random_pairs::Pair pair;
    Renaming renaming;
  };
  constexpr unsigned seed = 7;
  random_pairs::Generator generator(seed);
  const random_pairs::AffineMap map = random_pairs::affine_map(generator);
  const std::vector<Renamed> all = {
      {{pair.y, pair.x}, {{2, 3, 0, 1}, {}}},
      {{pair.x.exchanged(), pair.y}, {{1, 0, 2, 3}, {}}},
      {{pair.x, pair.y.exchanged()}, {{0, 1, 3, 2}, {}}},
      {{pair.x.reversed_first(), pair.y.reversed_second()}, {{0, 1, 2, 3}, {true, false, false, true}}},
      {{map(pair.x), map(pair.y)}, {}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO("renaming " << i << ", seed " << seed);
    const IntersectResult other = intersect(all[i].pair.x, all[i].pair.y);
    check_complete(other);
    CHECK(difference(graph, other.graph, all[i].renaming) == "");
  }
}

}  // namespace exsect

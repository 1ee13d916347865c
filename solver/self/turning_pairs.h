// Pairs of a self-intersection at which components of the tangent vanish, exactly. Internal to solver/;
// docs/method.md, section 7.6.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "self/singular_pairs.h"
#include "self/turning.h"

namespace exsect {

/// Pairs over algebraic values of moderate degree; computed where they are asked for.
class TurningPairs {
 public:
  explicit TurningPairs(const BezierPatch& x);

  const SelfValues& values();

  /// Components of T that vanish at the boundary point, one of disjoint boxes that hold all of them.
  std::array<bool, 4> zero_at(const CertifiedPoint& point);

  /// A box inside `where` that holds a pair at which components i and j vanish.
  std::optional<ParameterBox> common_zero(const ParameterBox& where, std::size_t i, std::size_t j);

 private:
  /// Over number `k` of the turning values of u (sweep: 0) or v (1), which is that of the first point.
  const std::vector<TurningPair>& over(std::size_t sweep, std::size_t k);
  /// In either order, those with the value in question in the box.
  std::vector<TurningPair> near(const ParameterBox& box);

  BezierPatch x_;
  BezierPatch exchanged_;
  std::optional<SelfValues> values_;
  std::array<std::optional<SelfProjection>, 2> projections_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<TurningPair>> over_;
};

}  // namespace exsect

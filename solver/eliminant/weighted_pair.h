// A pair of patches with weights on integers, as the eliminant takes it. Internal to solver/.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

#include "eliminant/eliminant_kinds.h"

namespace exsect {

/// X = sum x[i][j] u^i v^j and Y = sum y[i][j] r^i s^j in homogeneous coordinates (16.1). Invariant: all
/// coefficients of each patch have greatest common divisor 1; the first three coordinates of x[0][0] are
/// zero.
struct WeightedPair {
  using Vector = std::array<Integer, 4>;
  using Net = std::vector<std::vector<Vector>>;
  Net x;
  Net y;
};

/// With D of (16.19), constant term first, of y: primitive, of a leading coefficient that is not zero.
struct StrippedPair : WeightedPair {
  std::vector<Integer> factor;
};

/// The image of the pair under the translation by -x(0,0), a scaling of each coordinate and of each patch by
/// positive rationals: the same solutions. Nets of the degrees that the patches are given with.
WeightedPair weighted_pair(const RationalPatch& x, const RationalPatch& y);

/// function(Kind()) for the kind of the pair: both of bidegree (2,2), or x of bidegree (a,1) and y of (m,n),
/// m <= n.
template <class Function>
auto by_kind(const WeightedPair& pair, const Function& function) {
  const std::size_t m = pair.y.size() - 1, n = pair.y.front().size() - 1;
  if (pair.x.front().size() == 3) return function(WeightedKind());
  if (m == 1) return n == 1 ? function(Ruled11()) : n == 2 ? function(Ruled12()) : function(Ruled13());
  if (m == 2) return n == 2 ? function(Ruled22()) : function(Ruled23());
  return function(Ruled33());
}

/// function(Kind()) for the stripped kind of the pair; a value-initialised result where there is none.
template <class Function>
auto by_kind(const StrippedPair& pair, const Function& function) {
  return by_kind(static_cast<const WeightedPair&>(pair), [&]<class Kind>(Kind) {
    using Result = decltype(function(StrippedKind<WeightedKind, 1>()));
    if constexpr (Kind::s_degree >= 2) {
      if (pair.factor.size() == 2) return function(StrippedKind<Kind, 1>());
      if (pair.factor.size() == 3) return function(StrippedKind<Kind, 2>());
    }
    return Result();
  });
}

}  // namespace exsect

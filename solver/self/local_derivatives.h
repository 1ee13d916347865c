// The derivatives of a patch of any kind, enclosed at a point and over the whole patch. Internal to solver/;
// docs/method-doubles.md, section 14.17.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <vector>

#include "trace/pair_system.h"

namespace exsect {

inline constexpr std::size_t kLocalOrders = 6;
template <class T>
using ByOrder = std::array<std::array<T, kLocalOrders>, kLocalOrders>;
/// Those of order (i,j), i + j < kLocalOrders, at [i][j]. A ball that is not finite encloses nothing that is
/// known.
using AffineDerivatives = ByOrder<BallVector<DoubleBall>>;

/// Contains all balls and what is between them; 0 if there are none.
DoubleBall hull_of(const std::vector<DoubleBall>& balls);

/// Of the patch moved by -origin; those of an order not below `orders` are none, and are given as zero.
class LocalDerivatives {
 public:
  LocalDerivatives(const RationalPatch& patch, const Point& origin, std::size_t orders = kLocalOrders);

  /// Over the whole square.
  AffineDerivatives everywhere() const;
  /// At all (u,v) of the balls.
  AffineDerivatives at(const DoubleBall& u, const DoubleBall& v) const;

 private:
  /// Control vectors of a derivative, row by row; none if it is zero.
  struct Net {
    std::size_t columns = 0;
    std::vector<std::array<DoubleBall, 4>> vectors;
  };
  std::size_t orders_;
  ByOrder<Net> nets_;  // of the homogeneous derivatives
};

}  // namespace exsect

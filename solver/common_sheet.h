// Regions of parameters where two patches on one surface are the same sheet of it. Internal to solver/;
// docs/method.md, section 6.3.
#pragma once

#include <optional>

#include "common_surface.h"
#include "model_scale.h"
#include "pair_system.h"
#include "subdivision.h"

namespace exsect {

/// Proved: over the first two intervals A of a region there is an analytic local diffeomorphism w with x(u,v)
/// = y(w(u,v)), and every solution in the region has (r,s) = w(u,v). Both patches are regular at all of them.
struct Sheet {
  /// Enclosures of w's derivatives on A: derivative[k][l] of r (k = 0) or s with respect to u (l = 0) or v.
  std::array<std::array<DoubleBall, 2>, 2> derivative;
};

/// Proved by (6.2): for every point (u,v) of two intervals A there is exactly one (r,s) in `range` with
/// C(x(u,v)
/// - y(r,s)) = 0, in the interior; C y' is regular there and y injective. So all solutions with (u,v) in A
/// and (r,s) in `range` lie on a graph over A.
struct SheetGraph {
  std::array<RationalInterval, 2> range;             // of r and s; may reach beyond [0,1]
  std::array<std::array<double, 3>, 2> combination;  // C
  /// For fixed (u,v) the map b -> b + C(x - y(b)) contracts distances in `range` by this factor, in the norm
  /// max |b_k| / width_k.
  std::array<double, 2> width;
  double contraction;
};

/// Over the first two intervals of the region, near the middle of the last two; empty if it is not proved.
std::optional<SheetGraph> graph_over(const PairSystem<DoubleBall>& system, const SearchRegion& region);

class CommonSheets {
 public:
  CommonSheets(const BezierPatch& x, const BezierPatch& y, const ModelScale& scale, CommonSurface surface)
      : system_(x, y, scale.origin, scale.frame.exponent), surface_(std::move(surface)) {}

  /// Empty if it could not be proved for this region, which may reach beyond the unit squares.
  std::optional<Sheet> certify(const SearchRegion& region) const;
  /// True only if the region holds no solutions apart from those of a common sheet.
  bool settles(const SearchRegion& region) const;

 private:
  PairSystem<DoubleBall> system_;
  CommonSurface surface_;
};

}  // namespace exsect

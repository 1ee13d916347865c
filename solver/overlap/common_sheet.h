// Regions of parameters where two patches on one surface are the same sheet of it. Internal to solver/;
// docs/method.md, section 6.3.
#pragma once

#include <optional>

#include "answer/model_scale.h"
#include "overlap/common_surface.h"
#include "trace/sheet_graph.h"

namespace exsect {

/// Proved: over the first two intervals A of a region there is an analytic local diffeomorphism w with x(u,v)
/// = y(w(u,v)), and every solution in the region has (r,s) = w(u,v). Both patches are regular at all of them.
struct CommonSheet {
  /// Enclosures of w's derivatives on A: derivative[k][l] of r (k = 0) or s with respect to u (l = 0) or v.
  std::array<std::array<DoubleBall, 2>, 2> derivative;
};

class CommonSheets {
 public:
  CommonSheets(const BezierPatch& x, const BezierPatch& y, const ModelScale& scale, CommonSurface surface)
      : system_(x, y, scale.origin, scale.frame.exponent), surface_(std::move(surface)) {}

  /// Empty if it could not be proved for this region, which may reach beyond the unit squares.
  std::optional<CommonSheet> certify(const SearchRegion& region) const;
  /// True only if the region holds no solutions apart from those of a common sheet.
  bool settles(const SearchRegion& region) const;

 private:
  PairSystem<DoubleBall> system_;
  CommonSurface surface_;
};

}  // namespace exsect

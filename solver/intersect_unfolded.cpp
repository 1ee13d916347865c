#include "intersect_unfolded.h"

#include <utility>

#include "answer/proof.h"
#include "intersect_within.h"
#include "special/unfolded_parameters.h"

namespace exsect {

std::optional<IntersectResult> intersect_unfolded(const BezierPatch& x, const BezierPatch& y,
                                                  const Run& run) {
  const std::optional<UnfoldedPair> pair = unfolded_pair(x, y);
  if (!pair) return std::nullopt;
  const auto fold_back = [pair, x, y](IntersectResult& result, const Run& given) {
    result = folded_back(*pair, std::move(result), x, y, given);
  };
  return changed(intersect_within(run, pair->x, pair->y), run, fold_back);
}

}  // namespace exsect

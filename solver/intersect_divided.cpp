#include "intersect_divided.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "answer/proof.h"
#include "intersect_within.h"
#include "special/divided_patches.h"

namespace exsect {

std::optional<IntersectResult> intersect_divided(const BezierPatch& x, const BezierPatch& y, const Run& run) {
  const auto pieces = divided_pair(x, y);
  if (!pieces) return std::nullopt;
  std::vector<IntersectResult> results;
  results.reserve(pieces->size());
  std::vector<std::shared_ptr<const Proof>> proofs;
  for (const PairOfPieces& pair : *pieces) {
    results.push_back(intersect_within(run, pair.x, pair.y));
    proofs.push_back(results.back().proof);
  }
  std::optional<IntersectResult> result = joined(*pieces, std::move(results), x, y, run);
  if (!result || std::ranges::any_of(proofs, [](const auto& proof) { return !proof || !proof->draw; }))
    return result;
  const Draw draw = [pieces, proofs, x, y](const Run& again) -> std::optional<IntersectResult> {
    std::vector<IntersectResult> drawn;
    for (const auto& proof : proofs) {
      auto part = proof->draw(again);
      if (!part) return std::nullopt;
      drawn.push_back(*std::move(part));
    }
    return joined(*pieces, std::move(drawn), x, y, again);
  };
  result->proof = std::make_shared<const Proof>(Proof{draw, {}, {}});
  return result;
}

}  // namespace exsect

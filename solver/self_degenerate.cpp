#include "self_degenerate.h"

#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <string>
#include <utility>

#include "degenerate_patches.h"
#include "model_scale.h"
#include "parameter_names.h"
#include "rim_arc.h"

namespace exsect {
namespace {

constexpr const char* kTooFine = "the tolerance is below what a polyline in doubles can be proved to keep";

/// a + b q over the values q of (u - fold)^2, 0 <= u <= 1: run through once.
BezierPatch unfolded(const FoldedPatch& patch) {
  const Rational at0 = patch.fold * patch.fold;
  const Rational at1 = (1 - patch.fold) * (1 - patch.fold);
  const Rational least = patch.fold >= 0 && patch.fold <= 1 ? Rational(0) : std::min(at0, at1);
  const Rational range = std::max(at0, at1) - least;
  ControlNet c{};
  for (std::size_t j = 0; j < 3; ++j) {
    c[0][j] = patch.a[j] + least * patch.b[j];
    c[1][j] = range * patch.b[j];
  }
  return BezierPatch::from_power_basis(c);
}

/// The pairs (fold + d, v), (fold - d, v): an overlap of the patch with itself. Its rim are two segments v =
/// 0, 1, the side or sides at the largest d, and the fold d = 0, where the two points of a pair agree.
class FoldOverlap {
 public:
  FoldOverlap(const BezierPatch& x, const Rational& fold, const IntersectOptions& options)
      : x_(x), fold_(fold), scale_(model_scale(x, x)), tolerance_(options.tolerance * scale_.extent) {}

  IntersectResult run() {
    const Rational reach = std::min<Rational>(fold_, 1 - fold_);
    const std::array<RimEnd, 4> corner = {add(0, 0), add(reach, 0), add(reach, 1), add(0, 1)};
    std::vector<Arc> chain;
    for (std::size_t i = 0; i < 4; ++i) {
      const ArcPlace place = i == 3 ? ArcPlace::interior : ArcPlace::patch_boundary;
      chain.push_back(rim_arc(x_, corner[i], corner[(i + 1) % 4], place, tolerance_));
      chain.back().id = static_cast<int>(i);
      if (!(chain.back().error_bound <= tolerance_)) incomplete(result_.graph.nodes[i].box, kTooFine);
    }
    result_.graph.overlaps.push_back({0, {std::move(chain)}});
    result_.status = result_.incomplete.empty() ? Status::complete : Status::incomplete;
    return std::move(result_);
  }

 private:
  void incomplete(const ParameterBox& where, const std::string& why) {
    result_.incomplete.push_back({where, why});
  }

  RimEnd add(const Rational& d, int v) {
    const std::array<Rational, 4> at = {fold_ + d, v, fold_ - d, v};
    ParameterBox box;
    BallPoint<DoubleBall> ball;
    std::vector<Side> sides;
    for (const Parameter p : all_parameters) {
      const std::size_t j = index(p);
      box[j] = {at[j], at[j]};
      ball[j] = DoubleBall::enclosing(at[j]);
      if (at[j] == 0 || at[j] == 1) sides.push_back({p, at[j] == 0 ? 0 : 1});
    }
    const PairSystem<DoubleBall> system(x_, x_, scale_.origin, scale_.frame.exponent);
    Node node = landmark_node(system, scale_.frame, ball, box, sides);
    if (d == 0) node.kinds.push_back(NodeKind::cusp);
    node.id = static_cast<int>(result_.graph.nodes.size());
    result_.graph.nodes.push_back(node);
    return {at, node.id};
  }

  const BezierPatch& x_;
  Rational fold_;
  ModelScale scale_;
  double tolerance_;
  IntersectResult result_{};
};

/// Empty if the patch is not folded in u, or meets itself in another way too.
std::optional<IntersectResult> self_intersect_folded(const BezierPatch& x, const IntersectOptions& options) {
  const std::optional<FoldedPatch> folded = folded_patch(x);
  if (!folded) return std::nullopt;
  IntersectResult rest = self_intersect(unfolded(*folded), options);
  if (rest.status != Status::complete || !rest.graph.nodes.empty()) return std::nullopt;
  if (folded->fold <= 0 || folded->fold >= 1) return rest;
  IntersectResult result = FoldOverlap(x, folded->fold, options).run();
  result.work = rest.work;
  return result;
}

}  // namespace

std::optional<FoldedPatch> folded_patch(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  std::optional<Rational> ratio;  // c1 = ratio c2
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      if (!ratio && c[2][j][k] != 0) ratio = c[1][j][k] / c[2][j][k];
  if (!ratio) return std::nullopt;
  FoldedPatch result{-*ratio / 2, {}, c[2]};
  for (std::size_t j = 0; j < 3; ++j) {
    if (!(c[1][j] == *ratio * c[2][j])) return std::nullopt;
    result.a[j] = c[0][j] - result.fold * result.fold * c[2][j];
  }
  return result;
}

std::optional<IntersectResult> self_intersect_degenerate(const BezierPatch& x,
                                                         const IntersectOptions& options) {
  using enum Parameter;
  if (shape(x) != PatchShape::surface) return intersect_degenerate(x, x, options);
  if (auto result = self_intersect_folded(x, options)) return result;
  IntersectOptions exchanged = options;
  for (Parameter& p : exchanged.turning) p = static_cast<Parameter>(index(p) ^ 1U);
  auto result = self_intersect_folded(x.exchanged(), exchanged);
  if (result) rename_parameters(*result, {v, u, s, r});
  return result;
}

}  // namespace exsect

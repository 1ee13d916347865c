#include "self/overlaps.h"

#include <map>
#include <string>
#include <utility>

#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/rim_arc.h"
#include "trace/landmark_node.h"

namespace exsect {
namespace {

constexpr const char* kTooFine = "the tolerance is below what a polyline in doubles can be proved to keep";

class OverlapBuilder {
 public:
  OverlapBuilder(const BezierPatch& x, const Run& run)
      : x_(x), run_(run), scale_(model_scale(x, x)), system_(x, x, scale_.origin, scale_.frame.exponent) {}

  void add(const Symmetry& symmetry) {
    std::vector<RimEnd> ends;
    for (const ParameterPair& at : rim(symmetry)) ends.push_back({at, node(at)});
    std::vector<Arc> chain;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const RimEnd& to = ends[(i + 1) % ends.size()];
      const ArcPlace place =
          is_on_cut(symmetry, ends[i].at, to.at) ? ArcPlace::interior : ArcPlace::patch_boundary;
      chain.push_back(rim_arc(x_, ends[i], to, place, run_.drawn_tolerance(scale_.extent)));
      chain.back().id = static_cast<int>(i);
      if (!(chain.back().error_bound <= run_.tolerance(scale_.extent)))
        incomplete(result_.graph.nodes[static_cast<std::size_t>(ends[i].node)].box, kTooFine);
    }
    result_.graph.overlaps.push_back({static_cast<int>(result_.graph.overlaps.size()), {std::move(chain)}});
  }

  IntersectResult result() {
    result_.status = result_.incomplete.empty() ? Status::complete : Status::incomplete;
    return std::move(result_);
  }

 private:
  void incomplete(const ParameterBox& where, const std::string& why) {
    result_.incomplete.push_back({where, why});
  }

  int node(const ParameterPair& at) {
    const auto [known, is_new] = nodes_.try_emplace(at, static_cast<int>(result_.graph.nodes.size()));
    if (!is_new) return known->second;
    ParameterBox box;
    BallPoint<DoubleBall> ball;
    std::vector<Side> sides;
    for (const Parameter p : all_parameters) {
      const std::size_t j = index(p);
      box[j] = {at[j], at[j]};
      ball[j] = DoubleBall::enclosing(at[j]);
      if (at[j] == 0 || at[j] == 1) sides.push_back({p, at[j] == 0 ? 0 : 1});
    }
    Node node = landmark_node(system_, scale_.frame, ball, box, sides);
    if (at[0] == at[2] && at[1] == at[3]) node.kinds.push_back(NodeKind::cusp);
    node.id = known->second;
    result_.graph.nodes.push_back(node);
    return node.id;
  }

  const BezierPatch& x_;
  const Run& run_;
  ModelScale scale_;
  PairSystem<DoubleBall> system_;
  std::map<ParameterPair, int> nodes_;
  IntersectResult result_{};
};

}  // namespace

IntersectResult symmetric_overlaps(const BezierPatch& x, const std::vector<Symmetry>& symmetries,
                                   const Run& run) {
  OverlapBuilder overlaps(x, run);
  for (const Symmetry& symmetry : symmetries) overlaps.add(symmetry);
  return overlaps.result();
}

}  // namespace exsect

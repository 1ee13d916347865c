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
    }
    made_.graph.add_overlap({std::move(chain)});
  }

  SymmetricOverlaps take() { return std::move(made_); }

 private:
  int node(const ParameterPair& at) {
    const auto [known, is_new] = nodes_.try_emplace(at, static_cast<int>(made_.graph.nodes().size()));
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
    return made_.graph.add_node(std::move(node));
  }

  const BezierPatch& x_;
  const Run& run_;
  ModelScale scale_;
  PairSystem<DoubleBall> system_;
  std::map<ParameterPair, int> nodes_;
  SymmetricOverlaps made_;
};

}  // namespace

SymmetricOverlaps symmetric_overlaps(const BezierPatch& x, const std::vector<Symmetry>& symmetries,
                                     const Run& run) {
  OverlapBuilder overlaps(x, run);
  for (const Symmetry& symmetry : symmetries) overlaps.add(symmetry);
  return overlaps.take();
}

}  // namespace exsect

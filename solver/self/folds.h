// Folded parameter lines along which both tangent planes agree: curves of a self-intersection that are known
// exactly and that no tube can follow. Internal to solver/; docs/method.md, section 7.7.
#pragma once

#include "self/places.h"

namespace exsect {

/// Those with rational constants and turns, the turns inside the square or on a side.
std::vector<MultipleFold> multiple_folds(const BezierPatch& x, const SpecialCusps& cusps,
                                         const std::vector<CertifiedPoint>& boundary);

/// The pairs near these lines: true only if a box of a chart holds none but those of one of the lines.
template <class Ball>
class FoldNeighbourhoods {
 public:
  explicit FoldNeighbourhoods(const std::vector<MultipleFold>& folds);
  bool operator()(Chart chart, const ChartBox& box) const;

 private:
  struct Neighbourhood {
    Chart chart;
    Ball turn;
    Ball constant;
    FoldFactors<Ball> factors;
  };
  std::vector<Neighbourhood> neighbourhoods_;
};

/// Whether the arc that ends in the port is on the line.
bool lies_on(const MultipleFold& fold, const SelfStar& star, std::size_t port);

/// Appends the lines as arcs, cut at the stars on them, in the order in which the first point is behind the
/// turn. The nodes of turns that are no centres of stars are appended; `ends`: what the landmarks of `found`
/// lead to.
template <class Ball>
void append_folds(GraphBuilder& graph, const BezierPatch& x, const SelfSystem<Ball>& system,
                  const ExactPlaces& exact, const SelfCurves<Ball>& found, const std::vector<TraceEnd>& ends,
                  const ModelFrame& frame, double tolerance);

}  // namespace exsect

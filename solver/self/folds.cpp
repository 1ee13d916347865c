#include "self/folds.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>

#include "answer/graph_builder.h"
#include "answer/parameter_box.h"
#include "answer/rim_arc.h"
#include "trace/landmark_node.h"

namespace exsect {
namespace {

/// The parameter along the line: u (0) or v (1).
std::size_t along(const MultipleFold& fold) { return fold.chart == Chart::first ? 0 : 1; }

/// The pair t, 2 f - t on the line.
std::array<Rational, 4> pair_at(const MultipleFold& fold, const Rational& t) {
  const std::size_t j = along(fold);
  std::array<Rational, 4> pair;
  pair[j] = t;
  pair[j + 2] = 2 * fold.expansion.turn - t;
  pair[1 - j] = pair[3 - j] = fold.expansion.constant;
  return pair;
}

ParameterBox box_of_pair(const std::array<Rational, 4>& pair) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) box[j] = {pair[j], pair[j]};
  return box;
}

/// Of the first point of the last pair in the square.
Rational last_along(const FoldExpansion& fold) { return std::min<Rational>(1, 2 * fold.turn); }

template <class Ball>
class FoldArcs {
 public:
  FoldArcs(GraphBuilder& graph, const BezierPatch& x, const SelfSystem<Ball>& system,
           const ExactPlaces& exact, const SelfCurves<Ball>& found, const std::vector<TraceEnd>& ends,
           const ModelFrame& frame, double tolerance)
      : graph_(graph),
        x_(x),
        system_(system),
        exact_(exact),
        found_(found),
        ends_(ends),
        frame_(frame),
        tolerance_(tolerance) {}

  void append(const MultipleFold& fold) {
    if (!fold.end) return;
    std::vector<Station> stations = at_stars(fold);
    const auto has = [&](const Rational& t) {
      return std::ranges::any_of(stations, [&](const Station& s) { return s.at == t; });
    };
    const Rational last = last_along(fold.expansion);
    if (!has(fold.expansion.turn)) stations.push_back({fold.expansion.turn, add_turn(fold)});
    if (!has(last)) stations.push_back({last, static_cast<int>(*fold.end)});
    std::ranges::sort(stations, {}, &Station::at);
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      graph_.add_arc(rim_arc(x_, {pair_at(fold, stations[i].at), stations[i].node},
                             {pair_at(fold, stations[i + 1].at), stations[i + 1].node},
                             fold.side ? ArcPlace::patch_boundary : ArcPlace::interior, tolerance_));
    }
  }

 private:
  /// A node on the line, the first point of its pair at `at`: within 2^-100 where that is irrational.
  struct Station {
    Rational at;
    int node;
  };

  std::vector<Station> at_stars(const MultipleFold& fold) const {
    std::vector<Station> stations;
    for (std::size_t i = 0; i < found_.ports.size(); ++i) {
      const auto& port = found_.ports[i];
      const SelfStar& star = exact_.stars[port.star];
      if (!lies_on(fold, star, port.port)) continue;
      const ParameterBox box = star.star.centre.refined_to(power_of_two(-100)).box();
      const Rational at = box[along(fold) + (port.exchanged ? 2 : 0)].midpoint();
      const int node = ends_[found_.boundary_points + i].node;
      const bool known =
          std::ranges::any_of(stations, [&](const Station& other) { return other.node == node; });
      if (at >= fold.expansion.turn && !known) stations.push_back({at, node});
    }
    return stations;
  }

  int add_turn(const MultipleFold& fold) {
    const ParameterBox box = box_of_pair(pair_at(fold, fold.expansion.turn));
    BallPoint<Ball> at;
    std::vector<Side> sides;
    for (const Parameter p : all_parameters) {
      at[index(p)] = Ball::enclosing(box[index(p)].lower);
      if (fold.side && index(p) % 2 != along(fold)) sides.push_back({p, *fold.side});
    }
    Node node = landmark_node(system_.pair, frame_, at, box, sides);
    node.kinds.push_back(NodeKind::cusp);
    return graph_.add_node(std::move(node));
  }

  GraphBuilder& graph_;
  const BezierPatch& x_;
  const SelfSystem<Ball>& system_;
  const ExactPlaces& exact_;
  const SelfCurves<Ball>& found_;
  const std::vector<TraceEnd>& ends_;
  const ModelFrame& frame_;
  double tolerance_;
};

template <class Ball>
Ball between(double lower, double upper) {
  const double middle = 0.5 * lower + 0.5 * upper;
  return Ball(middle).widened(larger_bound(upper - middle, middle - lower) * kSlack);
}

}  // namespace

std::vector<MultipleFold> multiple_folds(const BezierPatch& x, const SpecialCusps& cusps,
                                         const std::vector<CertifiedPoint>& boundary) {
  std::vector<MultipleFold> result;
  for (const Chart chart : {Chart::first, Chart::second}) {
    const std::size_t k = chart == Chart::first ? 0 : 1;
    for (const FoldedLine& line : cusps.folded[k]) {
      const auto turn = rational_turn(line);
      if (!turn) continue;
      const auto expansion = fold_expansion(k == 0 ? x : x.exchanged(), (*turn)[0], (*turn)[1]);
      if (!expansion || !expansion->is_multiple()) continue;
      MultipleFold fold{*expansion, chart, line.side[1], {}};
      const ParameterBox last = box_of_pair(pair_at(fold, last_along(fold.expansion)));
      for (std::size_t i = 0; i < boundary.size() && !line.side[0]; ++i)
        if (lies_in(last, boundary[i].box())) fold.end = i;
      result.push_back(std::move(fold));
    }
  }
  return result;
}

template <class Ball>
FoldNeighbourhoods<Ball>::FoldNeighbourhoods(const std::vector<MultipleFold>& folds) {
  for (const MultipleFold& fold : folds)
    neighbourhoods_.push_back({fold.chart, Ball::enclosing(fold.expansion.turn),
                               Ball::enclosing(fold.expansion.constant), FoldFactors<Ball>(fold.expansion)});
}

template <class Ball>
bool FoldNeighbourhoods<Ball>::operator()(Chart chart, const ChartBox& box) const {
  BallPoint<Ball> at;
  for (std::size_t j = 0; j < 4; ++j) at[j] = between<Ball>(box.lower[j], box.upper[j]);
  return std::ranges::any_of(neighbourhoods_, [&](const Neighbourhood& near) {
    if (near.chart != chart) return false;
    const auto m = near.factors(at[0] - near.turn, at[1] - near.constant, at[2], at[3]);
    return dot(m[0], cross(m[1], m[2])).certain_sign() != 0;  // (7.14)
  });
}

bool lies_on(const MultipleFold& fold, const SelfStar& star, std::size_t port) {
  const auto& line = star.folded[port];
  return line && line->fixed == 1 - along(fold) && line->constant == fold.expansion.constant;
}

template <class Ball>
void append_folds(GraphBuilder& graph, const BezierPatch& x, const SelfSystem<Ball>& system,
                  const ExactPlaces& exact, const SelfCurves<Ball>& found, const std::vector<TraceEnd>& ends,
                  const ModelFrame& frame, double tolerance) {
  FoldArcs<Ball> arcs(graph, x, system, exact, found, ends, frame, tolerance);
  for (const MultipleFold& fold : exact.folds) arcs.append(fold);
}

#define EXSECT_INSTANTIATE_SELF_FOLDS(Ball)                                                                  \
  template class FoldNeighbourhoods<Ball>;                                                                   \
  template void append_folds(GraphBuilder&, const BezierPatch&, const SelfSystem<Ball>&, const ExactPlaces&, \
                             const SelfCurves<Ball>&, const std::vector<TraceEnd>&, const ModelFrame&,       \
                             double);

EXSECT_INSTANTIATE_SELF_FOLDS(DoubleBall)
EXSECT_INSTANTIATE_SELF_FOLDS(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_FOLDS

}  // namespace exsect

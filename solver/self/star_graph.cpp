#include "self/star_graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>

#include "answer/graph_builder.h"
#include "line/known_tangent.h"
#include "star/star_arc.h"
#include "trace/bounded_vertex.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"

namespace exsect {
namespace {

template <class T>
std::array<T, 4> in_order(const std::array<T, 4>& p, bool exchange) {
  return exchange ? exchanged_pair(p) : p;
}

template <class Ball>
class StarEnds {
 public:
  StarEnds(GraphBuilder& graph, const BezierPatch& x, const SelfSystem<Ball>& system,
           const ExactPlaces& exact, const SelfCurves<Ball>& found, const ModelFrame& frame)
      : graph_(graph), x_(x), system_(system), exact_(exact), found_(found), frame_(frame) {}

  std::vector<TraceEnd> run() {
    std::vector<TraceEnd> ends = nodes_of_landmarks(found_.landmarks.size());
    for (std::size_t k = 0; k < exact_.stars.size(); ++k) {
      const std::array<int, 2> nodes = nodes_of(exact_.stars[k]);
      for (std::size_t i = 0; i < found_.ports.size(); ++i) {
        const auto& port = found_.ports[i];
        if (port.star == k)
          ends[found_.boundary_points + i] = {nodes[port.exchanged ? 1 : 0], approach(port)};
      }
    }
    return ends;
  }

 private:
  /// In both orders.
  std::array<int, 2> nodes_of(const SelfStar& star) {
    std::array<int, 2> result{};
    if (star.landmark) {
      result = {static_cast<int>(*star.landmark), static_cast<int>(exact_.boundary.mate[*star.landmark])};
    } else {
      result[0] = add_node(star, false);
      result[1] = star.cuspidal ? result[0] : add_node(star, true);
    }
    for (const int id : star.cuspidal ? std::vector{result[0]} : std::vector{result[0], result[1]})
      classify(id, star);
    if (star.star.ports.empty() && !star.cuspidal) graph_.add_isolated(result[0]);
    return result;
  }

  int add_node(const SelfStar& star, bool exchange) {
    const BallPoint<Ball> at = in_order(enclose<Ball>(star.star.centre, power_of_two(-100)), exchange);
    return graph_.add_node(landmark_node(system_.pair, frame_, at, in_order(star.star.centre.box(), exchange),
                                         sides(star.star.centre, exchange)));
  }

  static std::vector<Side> sides(const CertifiedPoint& point, bool exchange) {
    std::vector<Side> result = point.sides();
    if (!exchange) return result;
    for (Side& side : result) side.parameter = static_cast<Parameter>((index(side.parameter) + 2) % 4);
    std::ranges::stable_sort(result, {}, &Side::parameter);
    return result;
  }

  void classify(int id, const SelfStar& star) const {
    const std::size_t degree = star.star.ports.size();
    if (star.cuspidal) {
      graph_.add_kind(id, NodeKind::cusp);
    } else if (degree >= 3 || is_known_singular(x_, x_, star.star.centre)) {
      graph_.add_kind(id, singular_kind(degree, graph_.node(id).on.empty()));
    }
  }

  Approach approach(const typename SelfCurves<Ball>::PortOfStar& port) const {
    const StarNeighbourhood& star = exact_.stars[port.star].star;
    const StarArc arc = star_arc(star, star.ports[port.port]);
    Approach result{{}, 0};
    for (const CertifiedPoint& point : arc.vertices) {
      const BallPoint<Ball> at = in_order(enclose<Ball>(point, power_of_two(-50)), port.exchanged);
      const Node vertex = landmark_node(system_.pair, frame_, at, in_order(point.box(), port.exchanged), {});
      result.vertices.push_back({vertex.approx, vertex.point});
    }
    for (const ParameterBox& hull : arc.hulls)
      result.bound =
          larger_bound(result.bound, chord_bound(system_.pair, frame_, in_order(hull, port.exchanged)));
    return result;
  }

  GraphBuilder& graph_;
  const BezierPatch& x_;
  const SelfSystem<Ball>& system_;
  const ExactPlaces& exact_;
  const SelfCurves<Ball>& found_;
  const ModelFrame& frame_;
};

}  // namespace

template <class Ball>
std::vector<TraceEnd> ends_at_stars(GraphBuilder& graph, const BezierPatch& x, const SelfSystem<Ball>& system,
                                    const ExactPlaces& exact, const SelfCurves<Ball>& found,
                                    const ModelFrame& frame) {
  return StarEnds<Ball>(graph, x, system, exact, found, frame).run();
}

#define EXSECT_INSTANTIATE_SELF_STAR_GRAPH(Ball)                                                           \
  template std::vector<TraceEnd> ends_at_stars(GraphBuilder&, const BezierPatch&, const SelfSystem<Ball>&, \
                                               const ExactPlaces&, const SelfCurves<Ball>&,                \
                                               const ModelFrame&);

EXSECT_INSTANTIATE_SELF_STAR_GRAPH(DoubleBall)
EXSECT_INSTANTIATE_SELF_STAR_GRAPH(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_STAR_GRAPH

}  // namespace exsect

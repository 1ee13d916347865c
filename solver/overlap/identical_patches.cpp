#include "overlap/identical_patches.h"

#include <algorithm>

#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/parameter_names.h"
#include "answer/rim_arc.h"
#include "self/self_intersect_within.h"
#include "trace/landmark_node.h"
#include "trace/regular_degree.h"

namespace exsect {

namespace {

bool is_planar(const BezierPatch& x) {
  const Point& origin = x.net()[0][0];
  Point first = {0, 0, 0};
  Point normal = {0, 0, 0};
  bool planar = true;
  for (const auto& row : x.net())
    for (const Point& p : row) {
      if (is_zero(first)) first = p - origin;
      if (is_zero(normal)) normal = cross(first, p - origin);
    }
  for (const auto& row : x.net())
    for (const Point& p : row) planar = planar && dot(normal, p - origin) == 0;
  return planar;
}

/// Both are one point, known exactly: the rim of a half turn has pairs in both orders.
bool is_same_point(const ParameterBox& a, const ParameterBox& b) {
  return std::ranges::equal(a, b, [](const RationalInterval& i, const RationalInterval& j) {
    return i.lower == i.upper && j.lower == j.upper && i.lower == j.lower;
  });
}

/// `graph` holds the pairs of parameters at which a patch meets itself, in one order, as `itself` found them:
/// those in the other order are added. A cuspidal point has equal parameters: there the two orders of a curve
/// meet, inside the overlap, as do the two orders of the pairs of a fold. A side that is one point, with free
/// parameters, meets its rim.
void add_other_order(GraphBuilder& graph, const IntersectResult& itself) {
  using enum Parameter;
  IntersectResult mirrored = itself;
  rename_parameters(mirrored, {r, s, u, v});
  std::vector<int> mirror;
  for (Node& copy : mirrored.graph.nodes) {
    const std::vector<Node>& nodes = graph.nodes();
    if (std::ranges::count(copy.kinds, NodeKind::cusp) > 0 || !copy.free.empty()) {
      graph.add_kind(copy.id, NodeKind::end_of_overlap);
      mirror.push_back(copy.id);
    } else if (const auto known = std::ranges::find_if(
                   nodes, [&](const Node& node) { return is_same_point(node.box, copy.box); });
               known != nodes.end()) {
      mirror.push_back(known->id);
    } else {
      mirror.push_back(graph.add_node(std::move(copy)));
    }
  }
  const auto mirrored_id = [&](int id) { return mirror[static_cast<std::size_t>(id)]; };
  for (Arc& arc : mirrored.graph.arcs) {
    arc.from = mirrored_id(arc.from);
    arc.to = mirrored_id(arc.to);
    graph.add_arc(std::move(arc));
  }
  for (Overlap& overlap : mirrored.graph.overlaps) {
    for (Arc& arc : overlap.chains.front()) {
      arc.from = mirrored_id(arc.from);
      arc.to = mirrored_id(arc.to);
    }
    graph.add_overlap(std::move(overlap.chains));
  }
  for (const int id : mirrored.graph.isolated_points)
    if (mirrored_id(id) != id) graph.add_isolated(mirrored_id(id));
}

class ItselfBuilder {
 public:
  ItselfBuilder(const BezierPatch& x, const Run& run)
      : x_(x), run_(run), scale_(model_scale(x, x)), turning_(run.turning()) {
    for (const Parameter p : run.turning()) turning_.push_back(all_parameters[index(p) ^ 2]);
    itself_ = self_intersect_within(run.with_turning(turning_), x);
    graph_ = GraphBuilder(itself_.graph);
  }

  IntersectResult run() {
    add_other_order(graph_, itself_);
    add_overlap();
    return finished(std::move(graph_), {turning_, RegularDegree(x_, x_)}, std::move(itself_.incomplete),
                    std::move(itself_.work));
  }

 private:
  /// Equal parameters: the rim runs once around both squares.
  void add_overlap() {
    const std::array<std::array<int, 2>, 4> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::vector<RimEnd> ends;
    for (const auto& [u, v] : corners) {
      const ParameterBox box = {{{u, u}, {v, v}, {u, u}, {v, v}}};
      const PairSystem<DoubleBall> system(x_, x_, scale_.origin, scale_.frame.exponent);
      const auto at = [](int c) { return DoubleBall(static_cast<double>(c)); };
      Node node = landmark_node(system, scale_.frame, {at(u), at(v), at(u), at(v)}, box,
                                {{Parameter::u, u}, {Parameter::v, v}, {Parameter::r, u}, {Parameter::s, v}});
      ends.push_back({{u, v, u, v}, graph_.add_node(std::move(node))});
    }
    std::vector<Arc> chain;
    for (std::size_t i = 0; i < 4; ++i) {
      chain.push_back(rim_arc(x_, ends[i], ends[(i + 1) % 4], ArcPlace::patch_boundary,
                              run_.drawn_tolerance(scale_.extent)));
    }
    graph_.add_overlap({std::move(chain)});
  }

  const BezierPatch& x_;
  const Run& run_;
  ModelScale scale_;
  std::vector<Parameter> turning_;
  IntersectResult itself_;  // pairs in one order
  GraphBuilder graph_;
};

}  // namespace

std::optional<IntersectResult> intersect_identical(const BezierPatch& x, const BezierPatch& y,
                                                   const Run& run) {
  using enum Parameter;
  if (is_planar(x)) return std::nullopt;
  for (const bool exchanged : {false, true})
    for (const bool first : {false, true})
      for (const bool second : {false, true}) {
        BezierPatch z = exchanged ? y.exchanged() : y;
        if (first) z = z.reversed_first();
        if (second) z = z.reversed_second();
        if (!(x == z)) continue;
        IntersectResult result = ItselfBuilder(x, run).run();
        if (first) reverse_parameter(result, r);
        if (second) reverse_parameter(result, s);
        if (exchanged) rename_parameters(result, {u, v, s, r});
        return result;
      }
  return std::nullopt;
}

}  // namespace exsect

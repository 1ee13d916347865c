#include "overlap/identical_patches.h"

#include <algorithm>

#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/parameter_names.h"
#include "answer/rim_arc.h"
#include "self/self_intersect_within.h"
#include "trace/landmark_node.h"

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

constexpr const char* kTooFine = "the tolerance is below what a polyline in doubles can be proved to keep";

class ItselfBuilder {
 public:
  ItselfBuilder(const BezierPatch& x, const Run& run) : x_(x), run_(run), scale_(model_scale(x, x)) {
    std::vector<Parameter> both = run.turning();
    for (const Parameter p : run.turning()) both.push_back(all_parameters[index(p) ^ 2]);
    result_ = self_intersect_within(run.with_turning(std::move(both)), x);
  }

  IntersectResult run() {
    add_mirrored();
    add_overlap();
    result_.graph.components.clear();
    finish_components(result_.graph);
    result_.status = result_.incomplete.empty() ? Status::complete : Status::incomplete;
    return std::move(result_);
  }

 private:
  void incomplete(const ParameterBox& where, const std::string& why) {
    result_.incomplete.push_back({where, why});
  }

  /// The pairs in the other order. A cuspidal point has equal parameters: there the two orders of a curve
  /// meet, inside the overlap, as do the two orders of the pairs of a fold. A side that is one point, with
  /// free parameters, meets its rim.
  void add_mirrored() {
    using enum Parameter;
    IntersectResult mirrored = result_;
    rename_parameters(mirrored, {r, s, u, v});
    IntersectionGraph& graph = result_.graph;
    std::vector<int> mirror;
    for (Node& copy : mirrored.graph.nodes) {
      std::vector<NodeKind>& kinds = graph.nodes[static_cast<std::size_t>(copy.id)].kinds;
      if (std::count(kinds.begin(), kinds.end(), NodeKind::cusp) > 0 || !copy.free.empty()) {
        kinds.push_back(NodeKind::end_of_overlap);
        mirror.push_back(copy.id);
      } else if (const auto known = std::ranges::find_if(
                     graph.nodes, [&](const Node& node) { return is_same_point(node.box, copy.box); });
                 known != graph.nodes.end()) {
        mirror.push_back(known->id);
      } else {
        copy.id = static_cast<int>(graph.nodes.size());
        mirror.push_back(copy.id);
        graph.nodes.push_back(std::move(copy));
      }
    }
    const auto mirrored_id = [&](int id) { return mirror[static_cast<std::size_t>(id)]; };
    for (Arc& arc : mirrored.graph.arcs) {
      arc.id = static_cast<int>(graph.arcs.size());
      arc.from = mirrored_id(arc.from);
      arc.to = mirrored_id(arc.to);
      graph.arcs.push_back(std::move(arc));
    }
    for (Overlap& overlap : mirrored.graph.overlaps) {
      overlap.id = static_cast<int>(graph.overlaps.size());
      for (Arc& arc : overlap.chains.front()) {
        arc.from = mirrored_id(arc.from);
        arc.to = mirrored_id(arc.to);
      }
      graph.overlaps.push_back(std::move(overlap));
    }
    for (const int id : mirrored.graph.isolated_points)
      if (mirrored_id(id) != id) graph.isolated_points.push_back(mirrored_id(id));
  }

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
      node.id = static_cast<int>(result_.graph.nodes.size());
      ends.push_back({{u, v, u, v}, node.id});
      result_.graph.nodes.push_back(std::move(node));
    }
    std::vector<Arc> chain;
    for (std::size_t i = 0; i < 4; ++i) {
      chain.push_back(rim_arc(x_, ends[i], ends[(i + 1) % 4], ArcPlace::patch_boundary,
                              run_.drawn_tolerance(scale_.extent)));
      chain.back().id = static_cast<int>(i);
      if (!(chain.back().error_bound <= run_.tolerance(scale_.extent)))
        incomplete(result_.graph.nodes[static_cast<std::size_t>(ends[i].node)].box, kTooFine);
    }
    result_.graph.overlaps.push_back({static_cast<int>(result_.graph.overlaps.size()), {std::move(chain)}});
  }

  const BezierPatch& x_;
  const Run& run_;
  ModelScale scale_;
  IntersectResult result_;
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

#include "intersect_at_pole.h"

#include <exsect/algebra/nearest_double.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "answer/arc_joints.h"
#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/parameter_names.h"
#include "answer/placement.h"
#include "answer/proof.h"
#include "pole_drawing.h"
#include "special/common_pole.h"

namespace exsect {
namespace {

constexpr long kFirstReachBits = 4;
constexpr long kLastReachBits = 14;

/// One of the eight sides of the two patches.
struct SideOfPair {
  std::size_t patch;
  std::size_t fixed;  // the parameter across, 0 or 1
  int value;

  /// The names of (a,t,r,s), a across the side, t along it.
  ParameterNames names() const {
    const std::size_t own = 2 * patch, other = 2 - own;
    return {all_parameters[own + fixed], all_parameters[own + 1 - fixed], all_parameters[other],
            all_parameters[other + 1]};
  }
  /// The side is (0,t).
  RationalPatch turned(const RationalPatch& x) const {
    const RationalPatch first = fixed == 0 ? x : x.transposed();
    return value == 0 ? first : first.restricted_to(1, 0, 0, 1);
  }
};

std::array<SideOfPair, 8> all_sides() {
  std::array<SideOfPair, 8> sides{};
  for (std::size_t i = 0; i < 8; ++i) sides[i] = {i / 4, i / 2 % 2, static_cast<int>(i % 2)};
  return sides;
}

/// The patch with the side, turned, in the first place.
struct TurnedPair {
  SideOfPair side;
  PolePair pair;
};

Run turned_run(const SideOfPair& side, const Run& run) {
  const ParameterNames names = side.names();
  std::vector<Parameter> turning;
  for (const Parameter p : run.turning())
    turning.push_back(all_parameters[static_cast<std::size_t>(std::ranges::find(names, p) - names.begin())]);
  std::ranges::sort(turning);
  return run.with_turning(std::move(turning));
}

constexpr Side kCut = {Parameter::u, 0};

bool is_on_cut(const Node& node) { return std::ranges::count(node.on, kCut) > 0; }

/// The arc near the pole that ends in a node on the cut: each is over an interval of its own.
std::optional<std::size_t> arc_to(const std::vector<PoleArc>& arcs, const Node& node) {
  const RationalInterval& t = node.box[1];
  const auto is_over = [&](const PoleArc& arc) {
    return arc.along.lower <= t.upper && t.lower <= arc.along.upper;
  };
  const auto found = std::ranges::find_if(arcs, is_over);
  if (found == arcs.end() || std::ranges::count_if(arcs, is_over) != 1) return std::nullopt;
  return static_cast<std::size_t>(found - arcs.begin());
}

/// The node is the end of this arc, and is nothing else.
bool is_end_of(const PoleArc& arc, const Node& node) {
  const auto is_known = [&](const Side& side) {
    return side == kCut || std::ranges::count(arc.on, side) > 0;
  };
  const auto is_simple = [](NodeKind kind) { return kind == NodeKind::boundary || kind == NodeKind::corner; };
  return node.free.empty() && node.on.size() == arc.on.size() + 1 && std::ranges::all_of(node.on, is_known) &&
         std::ranges::all_of(node.kinds, is_simple);
}

bool goes_on_in(const PoleArc& arc, const Arc& other) {
  return arc.contact == other.contact && arc.on.empty() == (other.place == ArcPlace::interior);
}

/// Each arc near the pole goes on in one arc of the rest.
bool fit(const std::vector<PoleArc>& arcs, const IntersectResult& rest) {
  if (!rest.graph.overlaps.empty()) return false;
  std::vector<int> ends(arcs.size(), 0);
  for (const Node& node : rest.graph.nodes) {
    if (!is_on_cut(node)) continue;
    const auto arc = arc_to(arcs, node);
    if (!arc || !is_end_of(arcs[*arc], node)) return false;
    for (const Arc& other : rest.graph.arcs) {
      const int count = (other.from == node.id) + (other.to == node.id);
      if (count > 0 && !goes_on_in(arcs[*arc], other)) return false;
      ends[*arc] += count;
    }
  }
  return std::ranges::all_of(ends, [](int count) { return count == 1; });
}

/// From the piece over [reach,1] to the whole patch.
void place_across(const Rational& reach, IntersectionGraph& graph) {
  const double lower = to_double(reach), width = to_double(1 - reach);
  for (Node& node : graph.nodes) {
    if (is_on_cut(node)) node.kinds.clear();
    std::erase(node.on, kCut);
    RationalInterval& a = node.box[0];
    a = {reach + (1 - reach) * a.lower, reach + (1 - reach) * a.upper};
    node.approx[0] = lower + width * node.approx[0];
  }
  for (Arc& arc : graph.arcs)
    for (PolylineVertex& vertex : arc.polyline) vertex.parameters[0] = lower + width * vertex.parameters[0];
}

/// The result of the rest becomes that of the pair, in its own parameters.
void join(const TurnedPair& turned, const PoleNeighbourhood& near, IntersectResult& result, const Run& run) {
  std::vector<std::pair<int, std::size_t>> ends;  // nodes on the cut, and arcs near the pole
  for (const Node& node : result.graph.nodes)
    if (is_on_cut(node)) ends.emplace_back(node.id, *arc_to(near.arcs, node));
  place_across(near.reach, result.graph);
  GraphBuilder graph(std::move(result.graph));
  const PoleDrawing drawing(turned.pair, near, run);
  const int pole = graph.add_node(drawing.node());
  if (ends.empty()) graph.add_isolated(pole);
  for (const auto& [node, which] : ends) {
    const auto goes_on = std::ranges::find_if(
        graph.arcs(), [id = node](const Arc& arc) { return arc.from == id || arc.to == id; });
    Arc arc =
        drawing.arc(which, goes_on->from == node ? goes_on->polyline.front() : goes_on->polyline.back());
    arc.from = pole;
    arc.to = node;
    graph.add_arc(std::move(arc));
  }
  join_at_nodes_of_no_kind(graph, 0);
  auto proof = std::move(result.proof);
  result = finished(std::move(graph), {turned_run(turned.side, run).turning(), {}}, {});
  result.proof = std::move(proof);
  const ParameterNames names = turned.side.names();
  rename_parameters(result, names);
  if (turned.side.value == 1) reverse_parameter(result, names[0]);
  result.coarse = coarse_drawing(result.graph, run.tolerance(turned.pair.extent));
}

double extent_of(const RationalPatch& x, const RationalPatch& y) {
  std::vector<Point> points;
  for (const RationalPatch* patch : {&x, &y})
    std::ranges::copy(affine_points(*patch), std::back_inserter(points));
  return to_double(model_extent(points));
}

/// By what is proved near the pole, and the rest of the patch.
std::optional<IntersectResult> with_rest(const TurnedPair& turned, const Rational& reach, const Run& run,
                                         const filter::SolvePieces& solve) {
  const PolePair& pair = turned.pair;
  const Run part = turned_run(turned.side, run);
  auto arcs = pair.near_pole(reach, part.turning());
  if (!arcs) return std::nullopt;
  IntersectResult rest = solve(pair.x.restricted_to(reach, 1, 0, 1), pair.y, part);
  if (rest.status != Status::complete || !fit(*arcs, rest)) return std::nullopt;
  return changed(
      std::move(rest), run,
      [turned, near = PoleNeighbourhood{reach, *std::move(arcs)}](IntersectResult& result, const Run& given) {
        join(turned, near, result, given);
      },
      [side = turned.side](const Run& given) { return turned_run(side, given); });
}

std::optional<IntersectResult> over_reaches(const TurnedPair& turned, const Run& run,
                                            const filter::SolvePieces& solve) {
  for (long bits = kFirstReachBits; bits <= kLastReachBits && !run.out_of_time(); bits += 2)
    if (auto result = with_rest(turned, power_of_two(-bits), run, solve)) return result;
  return std::nullopt;
}

/// The place on y of a pole that is this side of it.
PoleOnPatch on_side(const Point& point, const SideOfPair& side) {
  PoleOnPatch pole{point, {RationalInterval{0, 1}, RationalInterval{0, 1}}};
  pole.at[side.fixed] = {side.value, side.value};
  return pole;
}

/// With (b,s) for (r,s), b across this side of y, in the order of y and back.
void exchange(const SideOfPair& side, Parameter& p) {
  if (side.fixed == 0) return;
  if (p == Parameter::r || p == Parameter::s) p = p == Parameter::r ? Parameter::s : Parameter::r;
}
void exchange(const SideOfPair& side, PoleArc& arc) {
  RationalInterval& across = arc.on_other[0];
  if (side.value == 1) across = {1 - across.upper, 1 - across.lower};
  if (side.fixed == 1) std::swap(arc.on_other[0], arc.on_other[1]);
  for (Side& on : arc.on) exchange(side, on.parameter);
  if (!arc.ray) return;
  auto& [p, q] = arc.ray->on_other[0];
  if (side.value == 1) arc.ray->on_other[0] = {1 - p, arc.ray->bend - q};
  if (side.fixed == 1) std::swap(arc.ray->on_other[0], arc.ray->on_other[1]);
}

TurnedPair at_point(const SideOfPair& side, const RationalPatch& x, const RationalPatch& y,
                    const PoleOnPatch& pole, double extent) {
  const auto near_pole = [=](const Rational& reach, const std::vector<Parameter>& turning) {
    return arcs_at_pole(x, y, pole, reach, turning);
  };
  return {side, {x, y, pole, extent, near_pole}};
}

TurnedPair at_common_pole(const SideOfPair& side, const RationalPatch& x, const SideOfPair& of_other,
                          const RationalPatch& y, double extent) {
  const auto near_pole = [=, turned = of_other.turned(y)](const Rational& reach,
                                                          std::vector<Parameter> turning) {
    for (Parameter& p : turning) exchange(of_other, p);
    auto arcs = arcs_at_common_pole(x, turned, reach, turning);
    if (arcs)
      for (PoleArc& arc : *arcs) exchange(of_other, arc);
    return arcs;
  };
  return {side, {x, y, on_side(x(0, 0), of_other), extent, near_pole}};
}

}  // namespace

std::optional<IntersectResult> intersect_at_pole(const RationalPatch& x, const RationalPatch& y,
                                                 const Run& run, const filter::SolvePieces& solve) {
  const double extent = extent_of(x, y);
  for (const SideOfPair& side : all_sides()) {
    const RationalPatch first = side.turned(side.patch == 0 ? x : y);
    const RationalPatch& other = side.patch == 0 ? y : x;
    if (const auto pole = pole_on_patch(first, other))
      if (auto result = over_reaches(at_point(side, first, other, *pole, extent), run, solve)) return result;
    for (const SideOfPair& of_other : all_sides()) {
      if (side.patch == 1 || of_other.patch == 0 || !have_common_pole(first, of_other.turned(other)))
        continue;
      const TurnedPair turned = at_common_pole(side, first, of_other, other, extent);
      if (auto result = over_reaches(turned, run, solve)) return result;
    }
  }
  return std::nullopt;
}

}  // namespace exsect

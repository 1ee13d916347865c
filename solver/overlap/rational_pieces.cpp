#include "overlap/rational_pieces.h"

#include <exsect/geometry/net_piece.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/parameter_names.h"
#include "answer/placed_result.h"
#include "answer/placement.h"
#include "filter/affine_parameters.h"
#include "filter/overlap.h"
#include "overlap/identical_patches.h"
#include "self/self_intersect_in_doubles.h"

namespace exsect {
namespace {

using filter::OverlapOfPieces;

/// The smallest rectangle of x's parameters around both squares: its ends in u and in v.
std::array<RationalInterval, 2> around(const OverlapOfPieces& pieces) {
  std::array<RationalInterval, 2> ends;
  for (std::size_t j = 0; j < 2; ++j) {
    const AffineMap& map = pieces.maps[j];
    const auto [lower, upper] = std::minmax({Rational(0), Rational(1), map(0), map(1)});
    ends[j] = {lower, upper};
  }
  return ends;
}

/// x over that rectangle. Empty if its denominator is not positive there.
std::optional<RationalPatch> hull(const RationalPatch& x, const std::array<RationalInterval, 2>& ends) {
  const int m = x.degree_u(), n = x.degree_v();
  std::vector<HomogeneousPoint> net;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) net.push_back(x.homogeneous(i, j));
  const auto piece = net_of_piece(net, m, n, {ends[0].lower, ends[0].upper}, {ends[1].lower, ends[1].upper});
  filter::ControlVectors rows(static_cast<std::size_t>(m) + 1);
  for (std::size_t k = 0; k < piece.size(); ++k)
    rows[k / (static_cast<std::size_t>(n) + 1)].push_back(piece[k]);
  try {
    return RationalPatch::from_homogeneous(rows);
  } catch (const PatchError&) {
    return std::nullopt;
  }
}

/// A pole of the hull in the parameters of both patches. Empty if one of them does not reach it.
std::optional<Node> pole_of_both(const Node& pole, const OverlapOfPieces& pieces,
                                 const std::array<RationalInterval, 2>& ends) {
  const std::size_t j = index(pole.on.front().parameter) % 2;
  const Rational at = pole.on.front().value == 0 ? ends[j].lower : ends[j].upper;
  const std::array<Rational, 2> values = {at, pieces.maps[j].inverse(at)};
  Node node{};
  node.kinds = {NodeKind::boundary, NodeKind::end_of_overlap};
  node.box = whole_domain();
  node.approx = {0.5, 0.5, 0.5, 0.5};
  node.point = pole.point;
  const std::array<std::size_t, 2> fixed = {j, 2 + pieces.parameter(j)};
  for (std::size_t k = 0; k < 2; ++k) {
    if (values[k] != 0 && values[k] != 1) return std::nullopt;
    node.box[fixed[k]] = {values[k], values[k]};
    node.approx[fixed[k]] = to_double(values[k]);
    node.on.push_back({all_parameters[fixed[k]], values[k] == 0 ? 0 : 1});
  }
  for (std::size_t k = 0; k < 4; ++k)
    if (k != fixed[0] && k != fixed[1]) node.free.push_back(all_parameters[k]);
  return node;
}

/// One arc ends in a point on one side that is no pole.
std::optional<int> arcs_at_a_side(const Node& node) {
  return node.on.size() == 1 ? std::optional(1) : std::nullopt;
}

/// y is x but for the names and directions of its parameters.
bool is_same_patch(const OverlapOfPieces& pieces) {
  return std::ranges::all_of(pieces.maps, [](const AffineMap& map) {
    return (map.offset == 0 && map.factor == 1) || (map.offset == 1 && map.factor == -1);
  });
}

/// The intersection with y from that with x itself.
void name_parameters(IntersectResult& result, const OverlapOfPieces& pieces) {
  using enum Parameter;
  if (pieces.maps[0].factor < 0) reverse_parameter(result, r);
  if (pieces.maps[1].factor < 0) reverse_parameter(result, s);
  if (pieces.exchanged) rename_parameters(result, {u, v, s, r});
}

/// The whole intersection of a patch with itself, of which `itself` is in one order: an overlap, and the
/// pairs at which it meets itself in both orders. Empty if a polyline cannot keep within `accepted`.
std::optional<GraphBuilder> of_same_patch(const RationalPatch& x, const IntersectResult& itself,
                                          double tolerance, double accepted) {
  auto rim = filter::overlap_graph(x, {{{{0, 1}, {0, 1}}}, false}, tolerance, accepted);
  if (!rim) return std::nullopt;
  GraphBuilder graph(itself.graph);
  add_other_order(graph, itself);
  const auto first = static_cast<int>(graph.nodes().size());
  for (const Node& node : rim->nodes()) graph.add_node(node, 0);
  for (Overlap& overlap : rim->take_overlaps()) {
    for (Arc& arc : overlap.chains.front()) {
      arc.from += first;
      arc.to += first;
    }
    graph.add_overlap(std::move(overlap.chains));
  }
  return graph;
}

/// The overlap of two pieces, and the poles of the surface over both that are in both squares.
std::optional<GraphBuilder> of_pieces(const RationalPatch& x, const OverlapOfPieces& pieces,
                                      const IntersectionGraph& poles,
                                      const std::array<RationalInterval, 2>& ends, double tolerance,
                                      double accepted) {
  auto graph = filter::overlap_graph(x, pieces, tolerance, accepted);
  if (!graph) return std::nullopt;
  for (const Node& node : poles.nodes)
    if (auto pole = pole_of_both(node, pieces, ends))
      graph->add_isolated(graph->add_node(*std::move(pole), 0));
  return graph;
}

/// All pairs of two points on one side.
bool is_pole(const Node& node) {
  return node.free.size() == 2 && node.on.size() == 2 && node.on[0].value == node.on[1].value &&
         index(node.on[0].parameter) % 2 == index(node.on[1].parameter) % 2;
}

bool has_poles_alone(const IntersectionGraph& graph) {
  return graph.arcs.empty() && graph.overlaps.empty() && std::ranges::all_of(graph.nodes, is_pole);
}

/// All pairs of points of both squares at which the surface has one value: one point twice, or two points at
/// which the surface over both squares meets itself. Empty if these are not known, or are no poles and the
/// patches are not the same.
std::optional<IntersectResult> with_itself(const RationalPatch& x, const OverlapOfPieces& pieces,
                                           const Run& run) {
  const std::array<RationalInterval, 2> ends = around(pieces);
  const std::optional<RationalPatch> both = hull(x, ends);
  if (!both) return std::nullopt;
  std::vector<Parameter> turning = run.turning();
  for (const Parameter p : run.turning()) turning.push_back(all_parameters[index(p) ^ 2]);
  const IntersectResult itself = self_intersect_in_doubles(*both, run.with_turning(turning));
  const bool has_curves = !has_poles_alone(itself.graph);
  if (itself.status != Status::complete || (has_curves && !is_same_patch(pieces))) return std::nullopt;
  const double extent = to_double(model_extent(affine_points(*both)));
  const double tolerance = run.drawn_tolerance(extent);
  auto graph = has_curves ? of_same_patch(x, itself, tolerance, extent)
                          : of_pieces(x, pieces, itself.graph, ends, tolerance, extent);
  if (!graph) return std::nullopt;
  IntersectResult result = finished(*std::move(graph), {turning, arcs_at_a_side}, {});
  result.coarse = coarse_drawing(result.graph, run.tolerance(extent));
  if (has_curves) name_parameters(result, pieces);
  return result;
}

/// y in its own parameters, or in those in which it may be an affine piece of x.
template <class K>
std::optional<IntersectResult> of_kind(const filter::ElevatedPatch<K>& x, const filter::ElevatedPatch<K>& y,
                                       const Run& run) {
  const auto solve = [&](const filter::ElevatedPatch<K>& other) -> std::optional<IntersectResult> {
    const auto pair = filter::make_pair_of<K>(x, other);
    const auto pieces = pair ? filter::pieces_of_one_surface<K>(x, other, *pair) : std::nullopt;
    return pieces ? with_itself(filter::rational_patch(x), *pieces, run) : std::nullopt;
  };
  if (auto result = solve(y)) return result;
  const auto pair = filter::make_pair_of<K>(x, y);
  return pair ? filter::in_affine_parameters<K>(x, y, *pair, run, solve) : std::nullopt;
}

}  // namespace

IntersectResult intersect_rational_pieces(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  std::vector<Point> points = affine_points(x.reduced());
  std::ranges::copy(affine_points(y.reduced()), std::back_inserter(points));
  const auto place = Placement::of(points);
  return solved_in_place(place, to_double(model_extent(points)), run, [&](const Run& about_origin) {
    const RationalPatch a = place ? place->placed(x) : x, b = place ? place->placed(y) : y;
    const auto solve = [&]<class K>(K, const RationalPatch& first, const RationalPatch& second) {
      return of_kind<K>(filter::elevated<K>(first), filter::elevated<K>(second), about_origin);
    };
    return filter::in_smallest_kind(a, b, solve)
        .value_or(undecided(whole_domain(), "not decided in doubles"));
  });
}

}  // namespace exsect

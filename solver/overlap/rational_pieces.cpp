#include "overlap/rational_pieces.h"

#include <exsect/geometry/net_piece.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "answer/arc_joints.h"
#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/placed_result.h"
#include "answer/placement.h"
#include "filter/affine_parameters.h"
#include "filter/overlap.h"
#include "overlap/clipped_cells.h"
#include "self/self_intersect_in_doubles.h"

namespace exsect {
namespace {

using filter::OverlapOfPieces;

/// x over the hull. Empty if its denominator is not positive there.
std::optional<RationalPatch> hull(const RationalPatch& x, const PiecesInHull& pieces) {
  const auto& [u, v] = pieces.around;
  const int m = x.degree_u(), n = x.degree_v();
  std::vector<HomogeneousPoint> net;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) net.push_back(x.homogeneous(i, j));
  const auto piece = net_of_piece(net, m, n, {u(0), u(1)}, {v(0), v(1)});
  filter::ControlVectors rows(static_cast<std::size_t>(m) + 1);
  for (std::size_t k = 0; k < piece.size(); ++k)
    rows[k / (static_cast<std::size_t>(n) + 1)].push_back(piece[k]);
  try {
    return RationalPatch::from_homogeneous(rows);
  } catch (const PatchError&) {
    return std::nullopt;
  }
}

/// One arc ends in a point on one side that is no pole.
std::optional<int> arcs_at_a_side(const Node& node) {
  return node.on.size() == 1 ? std::optional(1) : std::nullopt;
}

/// Of the surface, those that are asked for of the patches.
std::vector<Parameter> turning_in_hull(const OverlapOfPieces& pieces, const Run& run) {
  std::vector<Parameter> turning = run.turning();
  for (Parameter& p : turning)
    if (pieces.exchanged && index(p) >= 2) p = all_parameters[5 - index(p)];
  return turning;
}

/// All pairs of points of both squares at which the surface has one value: one point twice, or two points at
/// which the surface over both squares meets itself. Empty if these are not known.
std::optional<IntersectResult> with_itself(const RationalPatch& x, const OverlapOfPieces& pieces,
                                           const Run& run) {
  const PiecesInHull in_hull(pieces);
  const std::optional<RationalPatch> both = hull(x, in_hull);
  if (!both) return std::nullopt;
  const double extent = to_double(model_extent(affine_points(*both)));
  const auto finish = [&](const GluedCells& cells) {
    auto graph = filter::overlap_graph(x, pieces, run.drawn_tolerance(extent), extent);
    if (!graph || !append_clipped_cells(*graph, cells, in_hull))
      return undecided(whole_domain(), "the rim of an overlap is not decided");
    join_at_other_turning_points(*graph, 0, 0, run.turning());
    return finished(*std::move(graph), {run.turning(), arcs_at_a_side}, {});
  };
  IntersectResult result = self_intersect_in_cells(both->reduced(), in_hull.sides(),
                                                   run.with_turning(turning_in_hull(pieces, run)), finish);
  if (result.status != Status::complete) return std::nullopt;
  result.coarse = coarse_drawing(result.graph, run.tolerance(extent));
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

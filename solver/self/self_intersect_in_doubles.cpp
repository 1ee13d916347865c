#include "self/self_intersect_in_doubles.h"

#include <optional>
#include <utility>

#include "answer/arc_joints.h"
#include "answer/finished_result.h"
#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "answer/placed_result.h"
#include "self/glued_cells.h"
#include "self/pair_orders.h"
#include "shape/self_symmetry.h"

namespace exsect {
namespace {

/// A grid is given up where a curve passes a corner of its cells or runs along a cut.
constexpr unsigned kMostGrids = 3;

/// One arc ends in a boundary point on a single side.
std::optional<int> arcs_at_side(const Node& node) {
  return node.on.size() == 1 ? std::optional(1) : std::nullopt;
}

IntersectResult left_undecided(std::vector<Incomplete> problems) {
  return {Status::incomplete, {}, std::move(problems), {}};
}

IntersectResult in_grid(const RationalPatch& x, const InjectiveRectangle& is_injective, unsigned grid,
                        double extent, const Run& run) {
  std::optional<CellPairs> pairs;
  run.timed("pairs of cells", [&] {
    pairs = cell_pairs(x, is_injective, grid, extent, run.with_turning(in_both_orders(run.turning())));
  });
  run.count("pairs of cells", static_cast<double>(pairs->pairs));
  if (!pairs->problems.empty()) return left_undecided(std::move(pairs->problems));
  GluedCells glued = glued_cells(*pairs, run.drawn_tolerance(extent));
  if (!glued.problems.empty()) return left_undecided(std::move(glued.problems));
  join_orders(glued.graph, glued.mates);
  join_at_other_turning_points(glued.graph, 0, 0, run.turning());
  return finished(std::move(glued.graph), {run.turning(), arcs_at_side, true}, {});
}

IntersectResult in_some_grid(const RationalPatch& x, double extent, const Run& run) {
  const InjectiveRectangle is_injective = patch_injectivity(x);
  if (!is_injective) return undecided(whole_domain(), "not decided in doubles");
  IntersectResult result = in_grid(x, is_injective, 0, extent, run);
  for (unsigned grid = 1; result.status != Status::complete && grid < kMostGrids && !run.out_of_time();
       ++grid) {
    IntersectResult other = in_grid(x, is_injective, grid, extent, run);
    if (other.status == Status::complete) result = std::move(other);
  }
  return result;
}

}  // namespace

IntersectResult self_intersect_in_doubles(const RationalPatch& x, const Run& run) {
  const RationalPatch& patch = x.reduced();
  const std::vector<Symmetry> symmetries = symmetries_of_square(patch);
  if (!symmetries.empty()) return undecided(whole_domain(), covered_more_than_once(symmetries));
  const std::vector<Point> points = affine_points(patch);
  const auto place = Placement::of(points);
  return solved_in_place(place, to_double(model_extent(points)), run, [&](const Run& about_origin) {
    const RationalPatch given = place ? place->placed(patch) : patch;
    return in_some_grid(given, to_double(model_extent(affine_points(given))), about_origin);
  });
}

}  // namespace exsect

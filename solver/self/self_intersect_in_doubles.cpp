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

using Finish = std::function<IntersectResult(GluedCells)>;

IntersectResult in_grid(const RationalPatch& x, const InjectiveRectangle& is_injective, unsigned grid,
                        const ParameterLines& lines, const Run& run, const Finish& finish) {
  const double extent = to_double(model_extent(affine_points(x)));
  std::optional<CellPairs> pairs;
  run.timed("pairs of cells", [&] {
    const Run in_both = run.with_turning(in_both_orders(run.turning()));
    pairs = cell_pairs(x, is_injective, grid, lines, extent, in_both);
  });
  run.count("pairs of cells", static_cast<double>(pairs->pairs));
  if (!pairs->problems.empty()) return left_undecided(std::move(pairs->problems));
  GluedCells glued = glued_cells(*pairs, run.drawn_tolerance(extent));
  if (!glued.problems.empty()) return left_undecided(std::move(glued.problems));
  return finish(std::move(glued));
}

}  // namespace

IntersectResult self_intersect_in_cells(const RationalPatch& x, const ParameterLines& lines, const Run& run,
                                        const Finish& finish) {
  const std::vector<Symmetry> symmetries = symmetries_of_square(x);
  if (!symmetries.empty()) return undecided(whole_domain(), covered_more_than_once(symmetries));
  const InjectiveRectangle is_injective = patch_injectivity(x);
  if (!is_injective) return undecided(whole_domain(), "not decided in doubles");
  IntersectResult result = in_grid(x, is_injective, 0, lines, run, finish);
  for (unsigned grid = 1; result.status != Status::complete && grid < kMostGrids && !run.out_of_time();
       ++grid) {
    IntersectResult other = in_grid(x, is_injective, grid, lines, run, finish);
    if (other.status == Status::complete) result = std::move(other);
  }
  return result;
}

IntersectResult self_intersect_in_doubles(const RationalPatch& x, const Run& run) {
  const RationalPatch& patch = x.reduced();
  const std::vector<Point> points = affine_points(patch);
  const auto place = Placement::of(points);
  return solved_in_place(place, to_double(model_extent(points)), run, [&](const Run& about_origin) {
    const auto finish = [&](GluedCells glued) {
      join_orders(glued.graph, glued.mates);
      join_at_other_turning_points(glued.graph, 0, 0, about_origin.turning());
      return finished(std::move(glued.graph), {about_origin.turning(), arcs_at_side, true}, {});
    };
    return self_intersect_in_cells(place ? place->placed(patch) : patch, {}, about_origin, finish);
  });
}

}  // namespace exsect

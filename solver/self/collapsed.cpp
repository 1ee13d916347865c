#include "self/collapsed.h"

#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "answer/finished_result.h"
#include "curve/half_space.h"
#include "self/degenerate.h"
#include "self/self_intersect_within.h"
#include "shape/special_cusps.h"

namespace exsect {
namespace {

/// n.x depends on v only and grows or falls in v: two points with one image are on one line v = constant.
bool grows(const BezierPatch& x, const std::vector<Integer>& n) {
  const ControlNet c = x.power_basis();
  const Point normal = {n[0], n[1], n[2]};
  const Rational at0 = dot(normal, c[0][1]);
  const Rational at1 = at0 + 2 * dot(normal, c[0][2]);
  return sign(at0) * sign(at1) >= 0 && (at0 != 0 || at1 != 0);
}

bool lies_in_slices(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  RationalMatrix along(6, 3);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 3; ++k) along(i, k) = c[1 + i / 3][i % 3][k];
  return std::ranges::any_of(null_space(along), [&](const std::vector<Integer>& n) { return grows(x, n); });
}

/// All pairs of the part are those on its side v = `side`.
bool meets_itself_in_tip(const BezierPatch& part, int side, const Run& run) {
  const IntersectResult result = self_intersect_within(run, part);
  if (result.status != Status::complete || result.graph.nodes.size() != 1) return false;
  const Node& node = result.graph.nodes.front();
  return node.free.size() == 2 && index(node.free[0]) == 0 && node.box[1].lower == side &&
         node.box[1].upper == side;
}

/// A plane through the tip, the line v = c, has the two cones on its two sides.
bool is_double_cone(const BezierPatch& x, const Rational& c, const Run& run) {
  const BezierPatch before = x.restricted_to(0, 1, 0, c);
  const BezierPatch behind = x.restricted_to(0, 1, c, 1);
  const Point tip = x(0, c);
  std::vector<Point> ahead;
  for (std::size_t i = 0; i < 3; ++i)
    for (const std::size_t j : {1, 2}) {
      ahead.push_back(behind.net()[i][j] - tip);
      ahead.push_back(tip - before.net()[i][2 - j]);
    }
  return lie_in_half_space(ahead) && meets_itself_in_tip(before, 1, run) &&
         meets_itself_in_tip(behind, 0, run);
}

/// The lines v = constant, if there are any and all pairs are on them.
std::vector<Rational> tips(const BezierPatch& x, const Run& run) {
  std::vector<Rational> lines;
  for (const RealAlgebraic& v : collapsed_lines(x)) {
    if (!v.is_rational()) return {};
    lines.push_back(v.rational());
  }
  if (lines.empty() || (lies_in_slices(x) && !has_folded_line(x))) return lines;
  const bool inside = lines.size() == 1 && lines[0] > 0 && lines[0] < 1;
  return inside && is_double_cone(x, lines[0], run) ? lines : std::vector<Rational>{};
}

}  // namespace

std::optional<IntersectResult> self_intersect_collapsed(const BezierPatch& x, const Run& run) {
  for (const std::size_t fixed : {1, 0}) {
    const std::vector<Rational> lines = tips(fixed == 1 ? x : x.exchanged(), run);
    if (lines.empty()) continue;
    GraphBuilder graph;
    for (const Rational& line : lines)
      graph.add_isolated(graph.add_node(collapsed_line_node(x, fixed, line)));
    return finished(std::move(graph), {}, {});
  }
  return std::nullopt;
}

}  // namespace exsect

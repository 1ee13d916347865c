#include "curve/curve_place.h"

#include <exsect/algebra/interruption.h>

#include <algorithm>

#include "curve/no_zero.h"

namespace exsect {
namespace {

/// The column with u in it: above the interval of its first value and below that of its last one.
std::optional<std::size_t> column_over(const CurveGraph& graph, const Rational& u) {
  for (std::size_t i = 0; i < graph.columns.size(); ++i)
    if (graph.values[i].compare(u) < 0 && graph.values[i + 1].compare(u) > 0) return i;
  return std::nullopt;
}

std::size_t value_of(const CurveGraph& graph, const RealAlgebraic& u) {
  for (std::size_t i = 0; i < graph.values.size(); ++i) {
    const RationalInterval a = graph.values[i].interval(), b = u.interval();
    if (a.lower <= b.upper && b.lower <= a.upper) return i;
  }
  return 0;
}

/// A rational number at most `reach` away from value i, in the column before or after it.
Rational beside(const CurveGraph& graph, std::size_t i, bool before, const Rational& reach) {
  const RationalInterval at = graph.values[i].refined_to(reach).interval();
  if (at.lower < at.upper) return before ? at.lower : at.upper;
  const Rational next = before ? graph.values[i - 1].interval().upper : graph.values[i + 1].interval().lower;
  return before ? std::max<Rational>(at.lower - reach, (at.lower + next) / 2)
                : std::min<Rational>(at.upper + reach, (at.upper + next) / 2);
}

/// A fold: the node lies between bounds that the curve does not meet between its u and a place beside it,
/// where its two arcs are between them.
std::array<RationalInterval, 2> fold_place(const CurveGraph& graph, std::size_t node, const Rational& width) {
  const CurveNode& fold = graph.nodes[node];
  const std::size_t i = value_of(graph, fold.u);
  const bool before = fold.left == 2;
  const CurveColumn& column = graph.columns[before ? i - 1 : i];
  const auto is_end = [&](std::size_t arc) {
    return arc != CurveGraph::dropped && (before ? graph.arcs[arc].to : graph.arcs[arc].from) == node;
  };
  const auto lower =
      static_cast<std::size_t>(std::find_if(column.begin(), column.end(), is_end) - column.begin());
  for (Rational reach = width * width;; reach = reach * reach) {
    interruption_point();
    const Rational u = beside(graph, i, before, reach);
    const RationalInterval at = graph.values[i].refined_to(reach).interval();
    const RationalInterval window = before ? RationalInterval{u, at.upper} : RationalInterval{at.lower, u};
    const std::vector<RealAlgebraic> points = real_roots(graph.swept.at_r(u), 0, 1);
    const RationalInterval a = points[lower].refined_to(width / 8).interval();
    const RationalInterval b = points[lower + 1].refined_to(width / 8).interval();
    const Rational room = b.upper - a.lower + width / 4;
    const RationalInterval v = {std::max<Rational>(a.lower - room, fold.v.lower),
                                std::min<Rational>(b.upper + room, fold.v.upper)};
    if (v.width() > 2 * width) continue;
    const auto is_clear = [&](const Rational& edge) {
      return edge <= 0 || edge >= 1 || has_no_zero(graph.swept.at_s(edge), window);
    };
    if (is_clear(v.lower) && is_clear(v.upper)) return {at, v};
  }
}

}  // namespace

std::vector<std::optional<ArcColumns>> columns_of_arcs(const CurveGraph& graph) {
  std::vector<std::optional<ArcColumns>> ranges(graph.arcs.size());
  for (std::size_t i = 0; i < graph.columns.size(); ++i)
    for (const std::size_t arc : graph.columns[i]) {
      if (arc == CurveGraph::dropped) continue;
      if (!ranges[arc]) ranges[arc] = ArcColumns{i, i};
      ranges[arc]->last = i;
    }
  return ranges;
}

std::optional<RationalInterval> arc_over(const CurveGraph& graph, std::size_t arc, const Rational& u,
                                         const Rational& width) {
  const std::optional<std::size_t> i = column_over(graph, u);
  if (!i) return std::nullopt;
  const CurveColumn& column = graph.columns[*i];
  const auto found = std::find(column.begin(), column.end(), arc);
  if (found == column.end()) return std::nullopt;
  const std::vector<RealAlgebraic> points = real_roots(graph.swept.at_r(u), 0, 1);
  return points.at(static_cast<std::size_t>(found - column.begin())).refined_to(width).interval();
}

std::array<RationalInterval, 2> place_of(const CurveGraph& graph, std::size_t node, const Rational& width) {
  const CurveNode& at = graph.nodes[node];
  if (at.exact) {
    // Arcs may leave it as the fourth root of the distance in u.
    const Rational squared = width * width;
    return {at.u.refined_to(squared * squared).interval(), at.exact->refined_to(width).r_interval()};
  }
  return fold_place(graph, node, width);
}

}  // namespace exsect

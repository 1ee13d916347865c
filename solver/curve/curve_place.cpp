#include "curve/curve_place.h"

#include <exsect/algebra/interruption.h>

#include <algorithm>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/factor_points.h"

namespace exsect {
namespace {

/// The column with u in it: above the interval of its first value and below that of its last one.
std::optional<std::size_t> column_over(const CurveGraph& graph, const Rational& u) {
  for (std::size_t i = 0; i < graph.columns.size(); ++i)
    if (graph.values[i].compare(u) < 0 && graph.values[i + 1].compare(u) > 0) return i;
  return std::nullopt;
}

std::size_t value_of(const CurveGraph& graph, const RealAlgebraic& u) {
  return static_cast<std::size_t>(std::find(graph.values.begin(), graph.values.end(), u) -
                                  graph.values.begin());
}

/// A rational number at most `reach` away from value i, in the column before or after it.
Rational beside(const CurveGraph& graph, std::size_t i, bool before, const Rational& reach) {
  const RationalInterval at = graph.values[i].refined_to(reach).interval();
  if (at.lower < at.upper) return before ? at.lower : at.upper;
  const Rational next = before ? graph.values[i - 1].interval().upper : graph.values[i + 1].interval().lower;
  return before ? std::max<Rational>(at.lower - reach, (at.lower + next) / 2)
                : std::min<Rational>(at.upper + reach, (at.upper + next) / 2);
}

/// The closed interval around the v of all arcs of the column over u that have the node at this end.
RationalInterval ends_over(const CurveGraph& graph, std::size_t column, bool at_upper_end, std::size_t node,
                           const Rational& u, const Rational& width) {
  const std::vector<FactorRoot> points = roots_over(graph.factors, u);
  std::optional<RationalInterval> all;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t arc = graph.columns[column][k];
    if (arc == CurveGraph::dropped || (at_upper_end ? graph.arcs[arc].to : graph.arcs[arc].from) != node)
      continue;
    const RationalInterval at = points[k].v.refined_to(width).interval();
    all = all ? hull(*all, at) : at;
  }
  if (!all) throw ProofFailure(whole_domain(), "a node of a curve without its arcs");
  return *all;
}

/// A node that is not exact, with arcs alone that are monotone beside it: it lies between bounds that the
/// curve does not meet between its u and places beside it, where its arcs are between them.
std::array<RationalInterval, 2> enclosed_place(const CurveGraph& graph, std::size_t node,
                                               const Rational& width) {
  const CurveNode& at = graph.nodes[node];
  const std::size_t i = value_of(graph, at.u);
  for (Rational reach = width * width;; reach = reach * reach) {
    interruption_point();
    RationalInterval window = graph.values[i].refined_to(reach).interval();
    const RationalInterval u = window;
    std::optional<RationalInterval> v;
    for (const bool before : {true, false}) {
      if ((before ? at.left : at.right) == 0) continue;
      const Rational place = beside(graph, i, before, reach);
      (before ? window.lower : window.upper) = place;
      const RationalInterval ends = ends_over(graph, before ? i - 1 : i, before, node, place, width / 8);
      v = v ? hull(*v, ends) : ends;
    }
    const Rational room = v->width() + width / 4;
    const RationalInterval wider = {std::max<Rational>(v->lower - room, at.v.lower),
                                    std::min<Rational>(v->upper + room, at.v.upper)};
    const auto is_clear = [&](const Rational& edge) {
      return edge <= 0 || edge >= 1 || has_no_zero_along(graph.factors, edge, window);
    };
    if (wider.width() <= 2 * width && is_clear(wider.lower) && is_clear(wider.upper)) return {u, wider};
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
  const std::vector<FactorRoot> points = roots_over(graph.factors, u);
  return points.at(static_cast<std::size_t>(found - column.begin())).v.refined_to(width).interval();
}

std::array<RationalInterval, 2> place_of(const CurveGraph& graph, std::size_t node, const Rational& width) {
  const CurveNode& at = graph.nodes[node];
  if (at.exact) {
    // Arcs may leave it as the fourth root of the distance in u.
    const Rational squared = width * width;
    return {at.u.refined_to(squared * squared).interval(), at.exact->refined_to(width).r_interval()};
  }
  return enclosed_place(graph, node, width);
}

}  // namespace exsect

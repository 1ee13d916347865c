#include "special/unfolded_parameters.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "answer/finished_result.h"
#include "answer/model_scale.h"
#include "answer/parameter_names.h"
#include "shape/folded_patch.h"
#include "special/turned_line.h"
#include "trace/regular_degree.h"

namespace exsect {

namespace {

constexpr double kLargestBend = 1.0 / 256;  // of a chord in the parameters
constexpr int kLargestDepth = 24;

PolylineVertex midpoint(const PolylineVertex& a, const PolylineVertex& b) {
  PolylineVertex result;
  for (std::size_t i = 0; i < 4; ++i) result.parameters[i] = std::midpoint(a.parameters[i], b.parameters[i]);
  for (std::size_t i = 0; i < 3; ++i) result.point[i] = std::midpoint(a.point[i], b.point[i]);
  return result;
}

/// Replaces the square by the parameter in results.
class Preimage {
 public:
  explicit Preimage(const Unfolding& unfolding) : k_(index(unfolding.parameter)), square_(unfolding.square) {}

  void operator()(IntersectResult& result) const {
    lift_boxes(result);
    for (Node& node : result.graph.nodes)
      node.approx[k_] = node.box[k_].width() == 1 ? 0.5 : square_.inverse(node.approx[k_]);
    for (Arc& arc : result.graph.arcs) lift(arc);
    for (Overlap& overlap : result.graph.overlaps)
      for (std::vector<Arc>& chain : overlap.chains)
        std::for_each(chain.begin(), chain.end(), [&](Arc& arc) { lift(arc); });
  }

 private:
  void lift_boxes(IntersectResult& result) const {
    std::vector<RationalInterval*> intervals;
    for (Node& node : result.graph.nodes) intervals.push_back(&node.box[k_]);
    for (Incomplete& region : result.incomplete) intervals.push_back(&region.where[k_]);
    std::vector<RationalInterval> values;
    for (const RationalInterval* i : intervals) values.push_back(*i);
    values = square_.inverse(values);
    for (std::size_t i = 0; i < values.size(); ++i) *intervals[i] = values[i];
  }

  void lift(Arc& arc) const {
    std::vector<PolylineVertex> polyline = {arc.polyline.front()};
    double largest = 0;
    for (std::size_t i = 1; i < arc.polyline.size(); ++i) append(polyline, arc.polyline[i], 0);
    for (const PolylineVertex& vertex : polyline)
      for (const double c : vertex.point) largest = larger_bound(largest, std::fabs(c));
    if (polyline.size() > arc.polyline.size())  // a point halfway is rounded, kLargestDepth times at most
      arc.error_bound += 2 * kLargestDepth * std::numeric_limits<double>::epsilon() * largest;
    for (PolylineVertex& vertex : polyline) vertex.parameters[k_] = square_.inverse(vertex.parameters[k_]);
    arc.polyline = std::move(polyline);
  }

  /// Appends a chord's end, with vertices on the chord so that the parameter is nearly linear between them.
  void append(std::vector<PolylineVertex>& polyline, const PolylineVertex& to, int depth) const {
    const PolylineVertex from = polyline.back();
    const PolylineVertex middle = midpoint(from, to);
    const double linear =
        std::midpoint(square_.inverse(from.parameters[k_]), square_.inverse(to.parameters[k_]));
    if (depth < kLargestDepth && std::fabs(square_.inverse(middle.parameters[k_]) - linear) > kLargestBend) {
      append(polyline, middle, depth + 1);
      append(polyline, to, depth + 1);
    } else {
      polyline.push_back(to);
    }
  }

  std::size_t k_;
  const MonotoneQuadratic& square_;
};

}  // namespace

std::optional<UnfoldedPair> unfolded_pair(const BezierPatch& x, const BezierPatch& y) {
  UnfoldedPair result = {x, y, {}};
  for (const Parameter p : all_parameters) {
    BezierPatch& patch = index(p) < 2 ? result.x : result.y;
    const bool second = index(p) % 2 == 1;
    const std::optional<FoldedPatch> folded = folded_patch(second ? patch.exchanged() : patch);
    if (!folded) continue;
    if (folded->fold > 0 && folded->fold < 1) return std::nullopt;
    const bool reversed = folded->fold > 0;
    const Rational before = reversed ? Rational(folded->fold - 1) : Rational(-folded->fold);
    result.unfoldings.push_back({p, MonotoneQuadratic(before / (1 + 2 * before)), reversed});
    patch = second ? unfolded(*folded).exchanged() : unfolded(*folded);
  }
  return result.unfoldings.empty() ? std::nullopt : std::optional(std::move(result));
}

IntersectResult folded_back(const UnfoldedPair& pair, IntersectResult of_squares, const BezierPatch& x,
                            const BezierPatch& y, const Run& run) {
  for (const Unfolding& unfolding : pair.unfoldings) {
    Preimage{unfolding}(of_squares);
    if (unfolding.reversed) reverse_parameter(of_squares, unfolding.parameter);
  }
  const ModelScale scale = model_scale(x, y);
  GraphBuilder graph(std::move(of_squares.graph));
  for (const Unfolding& unfolding : pair.unfoldings)
    if (const auto side = unfolding.turned_side())
      mark_turned_line(graph, of_squares.incomplete, x, y, *side, scale, run.drawn_tolerance(scale.extent),
                       run.stop());
  return finished(std::move(graph), {run.turning(), RegularDegree(x, y)}, std::move(of_squares.incomplete));
}

}  // namespace exsect

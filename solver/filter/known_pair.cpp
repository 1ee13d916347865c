#include "filter/known_pair.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "filter/contact_graph.h"

namespace exsect::filter {

namespace {

/// Relative to the extent, of polylines with too many vertices; and by how much the next ones are coarser.
constexpr double kCoarsest = 1e-3;
constexpr double kCoarser = 64;

/// One arc ends in a BoundaryPoint on a single side.
std::optional<int> arcs_at_sides(const Node& node) {
  const bool is_singular = std::ranges::count(node.kinds, NodeKind::touch) > 0 ||
                           std::ranges::count(node.kinds, NodeKind::crossing) > 0;
  return node.on.size() == 1 && !is_singular ? std::optional(1) : std::nullopt;
}

/// What polylines keep within is no question of topology: with nothing behind, any bound is taken.
template <class K>
constexpr bool kAnyBound = !std::is_same_v<K, Biquadratic>;

template <class K>
std::optional<GraphBuilder> graph_of_curves(const KnownPair<K>& known, const Run& run) {
  const double extent = known.pair.extent;
  const auto graph_within = [&](double tolerance) {
    return make_graph(known.pair, known.points, known.centres, known.curves, run.turning(), known.coincident,
                      {tolerance, known.finest_vertices ? 0 : tolerance, kAnyBound<K> ? extent : tolerance});
  };
  double tolerance = run.drawn_tolerance(extent);
  auto graph = graph_within(tolerance);
  for (; kAnyBound<K> && !graph && tolerance < kCoarsest * extent; tolerance *= kCoarser) {
    graph = graph_within(kCoarser * tolerance);
  }
  return graph;
}

}  // namespace

template <class K>
std::optional<IntersectResult> drawn(const KnownPair<K>& known, const Run& run) {
  const double tolerance = run.drawn_tolerance(known.pair.extent);
  const double accepted = kAnyBound<K> ? known.pair.extent : tolerance;
  auto graph = known.overlap
                   ? overlap_graph(rational_patch(known.exact->x), *known.overlap, tolerance, accepted)
                   : graph_of_curves(known, run);
  if (!graph ||
      (known.exact && !append_contacts<K>(known.exact->x, known.exact->y, known.pair, known.contacts,
                                          tolerance, accepted, *graph)) ||
      run.out_of_time()) {
    return std::nullopt;
  }
  IntersectResult result = finished(*std::move(graph), {run.turning(), arcs_at_sides}, {});
  if (result.status != Status::complete) {
    return std::nullopt;
  }
  result.coarse = coarse_drawing(result.graph, run.tolerance(known.pair.extent));
  return result;
}

#define EXSECT_INSTANTIATE(K) \
  template std::optional<IntersectResult> drawn<K>(const KnownPair<K>&, const Run&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "filter/proved_by_eliminant.h"

#include <optional>

#include "answer/proof_failure.h"
#include "eliminant/weighted_eliminant.h"

namespace exsect::filter {

namespace {

/// Beyond the first two the time is better spent on the patches exchanged.
constexpr std::size_t kMostSweeps = 2;

/// With respect to parameter p.
template <class K>
Stations stations_of(const AnalysedTraceOf<K>& curve, const std::vector<BoundaryPointOf<K>>& points,
                     const std::vector<CentreOf<K>>& centres, const std::array<std::size_t, 4>& coincident,
                     std::size_t p) {
  const bool open = curve.trace.start >= 0;
  Stations stations{{}, !open};
  const auto add_end = [&](int end) {
    if (!open) return;
    const BoundaryPointOf<K>& point = points[static_cast<std::size_t>(end)];
    // From a port to its centre all parameters are monotone.
    stations.at.push_back(point.centre < 0 ? interval(point.ball, p)
                                           : centres[static_cast<std::size_t>(point.centre)].box[p]);
  };
  add_end(curve.trace.start);
  for (const TurnOf<K>& turn : curve.turns)
    if (turn.parameter == p || coincident[p] == turn.parameter) stations.at.push_back(interval(turn.ball, p));
  add_end(curve.trace.end);
  return stations;
}

}  // namespace

bool has_eliminant(const RationalPatch& x, const RationalPatch& y) {
  return !(x.biquadratic() && y.biquadratic()) && !eliminant_sweeps(x, y).empty();
}

template <class K>
KnownStations known_stations(const std::vector<AnalysedTraceOf<K>>& curves,
                             const std::vector<BoundaryPointOf<K>>& points,
                             const std::vector<CentreOf<K>>& centres,
                             const std::vector<DoublePointOf<K>>& double_points,
                             const std::vector<DoublePointOf<K>>& on_sides,
                             const std::array<std::size_t, 4>& coincident) {
  KnownStations known;
  for (std::size_t p = 0; p < 4; ++p) {
    const auto add_isolated = [&](const RationalInterval& place) {
      known.curves[p].push_back({{place, place}, false});
    };
    const auto add_singular = [&](const DoublePointOf<K>& point) {
      if (!point.forms.crossing) add_isolated(point.box[p]);
      if (point.on[p] == 0) known.singular[p].push_back(point.box[p]);
    };
    for (const AnalysedTraceOf<K>& curve : curves)
      known.curves[p].push_back(stations_of(curve, points, centres, coincident, p));
    for (const BoundaryPointOf<K>& point : points)
      if (point.isolated) add_isolated(interval(point.ball, p));
    for (const DoublePointOf<K>& point : double_points) add_singular(point);
    for (const DoublePointOf<K>& point : on_sides)
      if (!point.forms.crossing) add_singular(point);
  }
  return known;
}

template <class K>
bool proved_by_eliminant(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                         const ContactsOf<K>& contacts, const KnownStations& known, TreesOf<K>& trees,
                         long& boxes) {
  const RationalPatch first = rational_patch(x), second = rational_patch(y);
  std::vector<Parameter> sweeps = eliminant_sweeps(first, second);
  if (sweeps.size() > kMostSweeps) sweeps.resize(kMostSweeps);
  for (const Parameter p : sweeps) {
    PatchTreeOf<K>& other = index(p) < 2 ? trees.y : trees.x;
    const auto count = [&](const RationalInterval& at) -> std::optional<std::size_t> {
      const auto points = points_on_line<K>(pair, centred_line(p, at), contacts, other, boxes);
      return points ? std::optional(points->size()) : std::nullopt;
    };
    const auto roots = weighted_turning_roots(first, second, p);
    try {
      if (roots && no_curve_is_missing(*roots, known.curves[index(p)], count, p, known.singular[index(p)]))
        return true;
    } catch (const ProofFailure&) {  // a curve is missing
      return false;
    }
  }
  return false;
}

#define EXSECT_INSTANTIATE(K)                                                                        \
  template KnownStations known_stations<K>(                                                          \
      const std::vector<AnalysedTraceOf<K>>&, const std::vector<BoundaryPointOf<K>>&,                \
      const std::vector<CentreOf<K>>&, const std::vector<DoublePointOf<K>>&,                         \
      const std::vector<DoublePointOf<K>>&, const std::array<std::size_t, 4>&);                      \
  template bool proved_by_eliminant<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, \
                                       const ContactsOf<K>&, const KnownStations&, TreesOf<K>&, long&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "sweep/fibre_crossings.h"

#include <vector>

#include "trace/trace_graph.h"
#include "trace/turning_points.h"

namespace exsect {

namespace {

int side_of(const RationalInterval& interval, const Rational& sample) {
  return interval.upper < sample ? -1 : interval.lower > sample ? 1 : 0;
}

/// The values of the sweep parameter at the ends and turning points of a curve, in order; a closed curve's
/// first turning point is repeated at the end. Ends close to the sample are enclosed more narrowly.
template <class Ball>
std::vector<RationalInterval> monotone_stations(const SweepData& sweep, const AnalysedTrace<Ball>& curve,
                                                const Rational& sample) {
  const std::size_t parameter = index(sweep.turning->sweep);
  const auto at_landmark = [&](int i) {
    const CertifiedPoint& point = sweep.landmarks[static_cast<std::size_t>(i)].point;
    const RationalInterval& at = point.box()[parameter];
    return side_of(at, sample) != 0 ? at : point.refined_to(power_of_two(-200)).box()[parameter];
  };
  std::vector<RationalInterval> stations;
  const bool open = curve.trace.start >= 0;
  if (open) {
    stations.push_back(at_landmark(curve.trace.start));
  }
  for (const TurningPoint<Ball>& point : curve.turning) {
    if (turns_in(point, parameter)) {
      stations.push_back(point.box[parameter].interval());
    }
  }
  if (open) {
    stations.push_back(at_landmark(curve.trace.end));
  } else if (!stations.empty()) {
    stations.push_back(stations.front());
  }
  return stations;
}

}  // namespace

template <class Ball>
std::optional<std::size_t> crossings(const SweepData& sweep, const AnalysedTrace<Ball>& curve,
                                     const Rational& sample) {
  const auto stations = monotone_stations(sweep, curve, sample);
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const int a = side_of(stations[i], sample);
    const int b = side_of(stations[i + 1], sample);
    if (a == 0 || b == 0) {
      return std::nullopt;
    }
    count += a != b ? 1 : 0;
  }
  return count;
}

#define EXSECT_INSTANTIATE_CROSSINGS(Ball)                                                    \
  template std::optional<std::size_t> crossings(const SweepData&, const AnalysedTrace<Ball>&, \
                                                const Rational&);

EXSECT_INSTANTIATE_CROSSINGS(DoubleBall)
EXSECT_INSTANTIATE_CROSSINGS(DoubleDoubleBall)
EXSECT_INSTANTIATE_CROSSINGS(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CROSSINGS

}  // namespace exsect

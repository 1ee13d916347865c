#include "sweep/fibre_crossings.h"

#include <vector>

#include "trace/trace_graph.h"
#include "trace/turning_points.h"

namespace exsect {

namespace {

int side_of(const RationalInterval& interval, const Rational& sample) {
  return interval.upper < sample ? -1 : interval.lower > sample ? 1 : 0;
}

/// On which side of the sample, -1 or +1, a boundary point or port is; 0: not known.
int side_of(const CertifiedPoint& point, std::size_t parameter, const Rational& sample) {
  int side = side_of(point.box()[parameter], sample);
  for (Rational width = power_of_two(-200); side == 0 && width > power_of_two(-2000); width *= width) {
    side = side_of(point.refined_to(width).box()[parameter], sample);
  }
  return side;
}

/// The same for a turning point with respect to the sweep parameter: that takes a turning value there, and
/// no turning value is a sample.
int side_of_turning_point(const RationalInterval& at, const TurningValues& turning, const Rational& sample) {
  int side = side_of(at, sample);
  if (side != 0) {
    return side;
  }
  for (const TurningValue& value : turning.values) {
    if (value.value.compare(at.lower) < 0 || value.value.compare(at.upper) > 0) {
      continue;
    }
    const int other = value.value.compare(sample) < 0 ? -1 : 1;
    if (side == -other) {
      return 0;
    }
    side = other;
  }
  return side;
}

/// On which side of the sample the ends and turning points of a curve are, in order; a closed curve's first
/// turning point is repeated at the end.
template <class Ball>
std::vector<int> monotone_stations(const SweepData& sweep, const AnalysedTrace<Ball>& curve,
                                   const Rational& sample) {
  const std::size_t parameter = index(sweep.turning->sweep);
  const auto at_landmark = [&](int i) {
    return side_of(sweep.landmarks[static_cast<std::size_t>(i)].point, parameter, sample);
  };
  std::vector<int> stations;
  const bool open = curve.trace.start >= 0;
  if (open) {
    stations.push_back(at_landmark(curve.trace.start));
  }
  for (const TurningPoint<Ball>& point : curve.turning) {
    if (turns_in(point, parameter)) {
      stations.push_back(side_of_turning_point(point.box[parameter].interval(), *sweep.turning, sample));
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
    if (stations[i] == 0 || stations[i + 1] == 0) {
      return std::nullopt;
    }
    count += stations[i] != stations[i + 1] ? 1 : 0;
  }
  return count;
}

#define EXSECT_INSTANTIATE_CROSSINGS(Ball)                                                    \
  template std::optional<std::size_t> crossings(const SweepData&, const AnalysedTrace<Ball>&, \
                                                const Rational&);

EXSECT_INSTANTIATE_CROSSINGS(DoubleBall)
EXSECT_INSTANTIATE_CROSSINGS(DoubleDoubleBall)
EXSECT_INSTANTIATE_CROSSINGS(ArbBall<256>)
EXSECT_INSTANTIATE_CROSSINGS(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_CROSSINGS

}  // namespace exsect

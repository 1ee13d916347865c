#include "filter/exact_turning.h"

#include <algorithm>

namespace exsect::filter {

namespace {

/// A closed interval around a tube's values of a parameter.
template <class K>
RationalInterval values_in(const TubeOf<K>& tube, std::size_t i) {
  const Rational middle = from_double(tube.centre[i]) + Rational(1, 2);
  const Rational reach = from_double(tube.offset[i]);
  return {middle - reach, middle + reach};
}

template <class K>
std::vector<SectionBox> boxes_of(const TraceOf<K>& trace, std::size_t first) {
  std::vector<SectionBox> boxes;
  for (const PieceOf<K>& piece : trace.pieces)
    boxes.push_back({values_in<K>(piece.tube, first), values_in<K>(piece.tube, first + 1)});
  return boxes;
}

}  // namespace

template <class K>
void ExactTurning<K>::ask() {
  if (is_asked_) return;
  is_asked_ = true;
  const RationalPatch x = rational_patch(x_);
  const RationalPatch y = rational_patch(y_);
  coincident_ = coincidence(x, y);
  sections_ = sections(x, y);
}

template <class K>
std::array<bool, 4> ExactTurning<K>::turning_at(const BoundaryPointOf<K>& point) const {
  std::array<bool, 4> result = {};
  if (point.centre >= 0) return result;
  const Side side = {all_parameters[point.parameter], point.side > 0 ? 1 : 0};
  const std::size_t partner = coincident_.partner[point.parameter];
  if (partner != point.parameter)
    result[partner] = coincident_.flat[point.parameter][static_cast<std::size_t>(side.value)];
  for (const Section& section : sections_) {
    if (point.parameter / 2 != section.first / 2) continue;
    const RationalInterval other = interval(point.ball, 2 * section.first + 1 - point.parameter);
    for (std::size_t i = 0; i < 4; ++i) result[i] = result[i] || turns_on_side(section, i, side, other);
  }
  return result;
}

template <class K>
KnownTurning<K> ExactTurning<K>::known_of(const TraceOf<K>& trace,
                                          const std::vector<BoundaryPointOf<K>>& points) {
  ask();
  KnownTurning<K> known{coincident_.partner};
  for (const Section& section : sections_) {
    const auto boxes = boxes_of(trace, section.first);
    for (std::size_t i = 0; i < 4; ++i)
      known.left_out[i] = known.left_out[i] || is_constant_in(section, i, boxes);
  }
  if (trace.start >= 0) {
    const BoundaryPointOf<K>& start = points[static_cast<std::size_t>(trace.start)];
    const BoundaryPointOf<K>& end = points[static_cast<std::size_t>(trace.end)];
    known.at_start = turning_at(start);
    known.at_end = turning_at(end);
    known.start = start.ball;
    known.end = end.ball;
  }
  return known;
}

#define EXSECT_INSTANTIATE(K) template class ExactTurning<K>;
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

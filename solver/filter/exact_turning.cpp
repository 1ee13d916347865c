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
std::vector<exsect::Rectangle> boxes_of(const TraceOf<K>& trace, std::size_t first) {
  std::vector<exsect::Rectangle> boxes;
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
void ExactTurning<K>::add_turning_at(const BoundaryPointOf<K>& point, std::array<bool, 4>& turning) const {
  if (point.centre >= 0) return;
  const Side side = {all_parameters[point.parameter], point.side > 0 ? 1 : 0};
  const std::size_t partner = coincident_.partner[point.parameter];
  if (partner != point.parameter && point.on[partner] == 0 &&
      coincident_.flat[point.parameter][static_cast<std::size_t>(side.value)])
    turning[partner] = true;
  for (const Section& section : sections_) {
    if (point.parameter / 2 != section.first / 2) continue;
    const RationalInterval other = interval(point.ball, 2 * section.first + 1 - point.parameter);
    for (std::size_t i = 0; i < 4; ++i) turning[i] = turning[i] || turns_on_side(section, i, side, other);
  }
}

template <class K>
void ExactTurning<K>::add_to(KnownTurning<K>& known, const TraceOf<K>& trace,
                             const std::vector<BoundaryPointOf<K>>& points) {
  ask();
  known.coincident = coincident_.partner;
  for (const Section& section : sections_) {
    const auto boxes = boxes_of(trace, section.first);
    for (std::size_t i = 0; i < 4; ++i)
      known.constant[i] = known.constant[i] || is_constant_in(section, i, boxes);
  }
  if (trace.start < 0) return;
  add_turning_at(points[static_cast<std::size_t>(trace.start)], known.at_start);
  add_turning_at(points[static_cast<std::size_t>(trace.end)], known.at_end);
}

#define EXSECT_INSTANTIATE(K) template class ExactTurning<K>;
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

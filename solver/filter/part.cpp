#include "filter/part.h"

namespace exsect::filter {

namespace {

using Interval = Part::Interval;

Interval counted(const Interval& range, bool backwards) {
  return backwards ? Interval{1 - range.upper, 1 - range.lower} : range;
}

}  // namespace

std::size_t SideView::index(std::size_t across, std::size_t along) const {
  const std::size_t a = side.upper ? 2 - across : across;
  const std::size_t b = reversed ? 2 - along : along;
  return side.parameter == 0 ? 3 * a + b : 3 * b + a;
}

Part part_of(const SubPatch& patch) {
  const auto from = [&](double lower) { return Interval{lower + 0.5, lower + 0.5 + patch.width}; };
  return {{from(patch.first), from(patch.second)}, patch.net};
}

Part part_of(const SubCurve& curve, std::size_t fixed, double value) {
  Part part{{}, curve.net};
  part.range[fixed] = {value + 0.5, value + 0.5};
  part.range[1 - fixed] = {curve.from + 0.5, curve.from + 0.5 + curve.width};
  return part;
}

SideIntervals intervals(const SideView& view, const Part& part) {
  const std::size_t across = view.side.parameter;
  return {counted(part.range[across], view.side.upper), counted(part.range[1 - across], view.reversed)};
}

/// x(a,.) = (1-a)² P0 + 2 a (1-a) P1 + a² P2 = P0 + a ((1-a) 2 (P1 - P0) + a (P2 - P0)).
AcrossField across_field(const std::array<Vec3, 9>& net, const SideView& view) {
  AcrossField result;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3& on_side = net[view.index(0, j)];
    result[j] = 2.0 * (net[view.index(1, j)] - on_side);
    result[3 + j] = net[view.index(2, j)] - on_side;
  }
  return result;
}

/// By the blossom.
AcrossField restricted(const AcrossField& field, const SideIntervals& to) {
  AcrossField result;
  for (std::size_t i = 0; i < 2; ++i) {
    const double a = i == 0 ? to.across.lower : to.across.upper;
    const Vec3 p = between(field[0], field[3], a);
    const Vec3 q = between(field[1], field[4], a);
    const Vec3 r = between(field[2], field[5], a);
    const Vec3 first = between(p, q, to.along.lower);
    const Vec3 last = between(q, r, to.along.lower);
    result[3 * i] = between(first, last, to.along.lower);
    result[3 * i + 1] = between(first, last, to.along.upper);
    result[3 * i + 2] = between(between(p, q, to.along.upper), between(q, r, to.along.upper), to.along.upper);
  }
  return result;
}

}  // namespace exsect::filter

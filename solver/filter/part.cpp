#include "filter/part.h"

namespace exsect::filter {

namespace {

using PartInterval = Part::Interval;

PartInterval counted(const PartInterval& range, bool backwards) {
  return backwards ? PartInterval{1 - range.upper, 1 - range.lower} : range;
}

template <class K, class Piece>
void add_weights([[maybe_unused]] const Piece& piece, [[maybe_unused]] Part& part) {
  if constexpr (K::weighted) {
    part.error = piece.affine_error;
    part.least_weight = piece.least_weight;
    part.greatest_weight = piece.greatest_weight;
  }
}

}  // namespace

std::size_t SideView::index(std::size_t across, std::size_t along) const {
  const std::size_t a = side.upper ? degree - across : across;
  const std::size_t b = reversed ? degree - along : along;
  return side.parameter == 0 ? (degree + 1) * a + b : (degree + 1) * b + a;
}

template <class K>
Part part_of(const SubPatchOf<K>& patch) {
  const auto from = [&](double lower) { return PartInterval{lower + 0.5, lower + 0.5 + patch.width}; };
  Part part{{from(patch.first), from(patch.second)}, patch.points()};
  add_weights<K>(patch, part);
  return part;
}

template <class K>
Part part_of(const SubCurveOf<K>& curve, std::size_t fixed, double value) {
  Part part{{}, curve.points()};
  part.range[fixed] = {value + 0.5, value + 0.5};
  part.range[1 - fixed] = {curve.from + 0.5, curve.from + 0.5 + curve.width};
  add_weights<K>(curve, part);
  return part;
}

SideIntervals intervals(const SideView& view, const Part& part) {
  const std::size_t across = view.side.parameter;
  return {counted(part.range[across], view.side.upper), counted(part.range[1 - across], view.reversed)};
}

/// (B_i^n(a) - B_i^n(0)) / a is n/i B_(i-1)^(n-1)(a).
template <class K>
AcrossFieldOf<K> across_field(const CoefficientsOf<K>& net, const SideView& view) {
  AcrossFieldOf<K> result;
  for (std::size_t j = 0; j < K::side; ++j) {
    const Row<K>& on_side = net[view.index(0, j)];
    for (std::size_t i = 1; i <= K::degree; ++i) {
      const double factor = static_cast<double>(K::degree) / static_cast<double>(i);
      result[K::side * (i - 1) + j] = factor * (net[view.index(i, j)] - on_side);
    }
  }
  return result;
}

template <class K>
AcrossFieldOf<K> restricted(const AcrossFieldOf<K>& field, const SideIntervals& to) {
  AcrossFieldOf<K> result;
  for (std::size_t i = 0; i < K::degree; ++i) {
    std::array<Row<K>, K::side> row;
    for (std::size_t j = 0; j < K::side; ++j) {
      std::array<Row<K>, K::degree> column;
      for (std::size_t k = 0; k < K::degree; ++k) column[k] = field[K::side * k + j];
      row[j] = restricted_point(column, to.across, i);
    }
    for (std::size_t j = 0; j < K::side; ++j) result[K::side * i + j] = restricted_point(row, to.along, j);
  }
  return result;
}

#define EXSECT_INSTANTIATE(K)                     \
  template Part part_of<K>(const SubPatchOf<K>&); \
  template Part part_of<K>(const SubCurveOf<K>&, std::size_t, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

#define EXSECT_INSTANTIATE(K)                                                           \
  template AcrossFieldOf<K> across_field<K>(const CoefficientsOf<K>&, const SideView&); \
  template AcrossFieldOf<K> restricted<K>(const AcrossFieldOf<K>&, const SideIntervals&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

// Parts of the squares, and patches as seen from one of their sides. Internal to solver/;
// docs/method-doubles.md, section 14.7.
#pragma once

#include <array>
#include <span>

#include "filter/pieces.h"

namespace exsect::filter {

/// (1-t) a + t b for a dyadic t in [0,1]: errs by 3 u times the size, of which the error of 1-t is no part.
template <std::size_t N>
Vec<N> between(const Vec<N>& a, const Vec<N>& b, double t) {
  return (1 - t) * a + t * b;
}

/// A side of a square: its first (0) or second (1) parameter is 0 or, if `upper`, 1.
struct SquareSide {
  std::size_t parameter;
  bool upper;
  friend bool operator==(const SquareSide&, const SquareSide&) = default;
};

/// Control points of one patch as seen from one of its sides: point(across, along) of row `across` from the
/// side, along it in the direction of the parameter or, if `reversed`, against it.
struct SideView {
  SquareSide side;
  bool reversed;
  std::size_t degree = 2;
  std::size_t index(std::size_t across, std::size_t along) const;
};

/// A rectangle of a square, which may be a segment or a point, and control points of the patch on it.
struct Part {
  struct Interval {
    double lower;
    double upper;
  };
  std::array<Interval, 2> range;  // parameters, not centred
  std::span<const Vec3> points;
  double error = 0;         // of the points of weighted patches; else it is Pair::net_error
  double least_weight = 1;  // bounds of the weights on it
  double greatest_weight = 1;
};
template <class K>
Part part_of(const SubPatchOf<K>& patch);
/// The curve is on the line where the first (0) or second (1) parameter is `value`, centred, of a square.
template <class K>
Part part_of(const SubCurveOf<K>& curve, std::size_t fixed, double value);

/// The part's intervals counted from the side, and along it.
struct SideIntervals {
  Part::Interval across;
  Part::Interval along;
};
SideIntervals intervals(const SideView& view, const Part& part);

/// Control vectors of (x(a,t) - x(0,t)) / a, a and t counted as the view does: bidegree (n-1,n), index
/// side i + j.
template <class K>
using AcrossFieldOf = std::array<Row<K>, K::degree * K::side>;
using AcrossField = AcrossFieldOf<Biquadratic>;
template <class K>
AcrossFieldOf<K> across_field(const CoefficientsOf<K>& net, const SideView& view);
/// Control point k on the interval of the curve with these control points: the blossom with k arguments
/// `upper`, the others `lower`, these first.
template <std::size_t Count, std::size_t N>
Vec<N> restricted_point(std::array<Vec<N>, Count> p, const Part::Interval& to, std::size_t k) {
  constexpr std::size_t degree = Count - 1;
  for (std::size_t level = 1; level <= degree; ++level) {
    const double t = level + k <= degree ? to.lower : to.upper;
    for (std::size_t i = 0; i + level <= degree; ++i) p[i] = between(p[i], p[i + 1], t);
  }
  return p[0];
}
/// Those on a rectangle.
template <class K>
AcrossFieldOf<K> restricted(const AcrossFieldOf<K>& field, const SideIntervals& to);

}  // namespace exsect::filter

// Control vectors of c_u x_v - c_v x_u and of the normals, and the proof that no curve on two sub-patches
// turns. Internal to solver/; docs/method-doubles.md, section 14.4.
#pragma once

#include "filter/pieces.h"

namespace exsect::filter {

/// Control vectors of c_u x_v - c_v x_u, bidegree (n,n), divided by a positive number, on a sub-patch, with
/// their box and a bound of the error of every coordinate.
template <class K>
struct DirectionNetOf {
  CoefficientsOf<K> vectors;
  Row<K> lower;
  Row<K> upper;
  double size;  // bound of all coordinates
  double error;
};

/// The same of y_r x y_s, bidegree (2n-1,2n-1), or, in R^4, of the covector [. Y Y_r Y_s], bidegree
/// (3n-2,3n-2): by coordinates, the number of vectors made a multiple of four by the first one.
template <class K>
struct NormalNetOf {
  static constexpr std::size_t side = K::weighted ? 3 * K::degree - 1 : 2 * K::degree;
  static constexpr std::size_t count = side * side;
  std::array<std::array<double, (count + 3) / 4 * 4>, K::rows> coordinate;
  Row<K> lower;
  Row<K> upper;
  double size;
  double error;

  Row<K> vector(std::size_t k) const {
    Row<K> result;
    for (std::size_t c = 0; c < K::rows; ++c) result[c] = coordinate[c][k];
    return result;
  }
};
using NormalNet = NormalNetOf<Biquadratic>;
template <class K>
DirectionNetOf<K> direction_net(const SubPatchOf<K>& x, const std::array<double, 2>& c, double net_error);
template <class K>
NormalNetOf<K> normal_net(const SubPatchOf<K>& y, double net_error);

/// The normals, or covectors, at the four corners of a sub-patch, up to one positive factor and rounding.
template <class K>
std::array<Row<K>, 4> corner_normals(const SubPatchOf<K>& y);
/// Whether the products below have both signs at corners: then never_orthogonal is false, which this tells
/// without the net of normals.
template <class K>
bool changes_sign(const DirectionNetOf<K>& d, const std::array<Row<K>, 4>& normals);

/// True only if (c_u x_v - c_v x_u).(y_r x y_s) has no zero on the two sub-patches.
template <class K>
bool never_orthogonal(const DirectionNetOf<K>& d, const NormalNetOf<K>& n);

}  // namespace exsect::filter

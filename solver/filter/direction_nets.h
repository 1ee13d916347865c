// Control vectors of c_u x_v - c_v x_u and of the normals, and the proof that no curve on two sub-patches
// turns. Internal to solver/; docs/method-doubles.md, section 14.4.
#pragma once

#include "filter/pieces.h"

namespace exsect::filter {

/// Control vectors, all divided by the same positive number, of c_u x_v - c_v x_u, bidegree (n,n), or of y_r
/// x y_s, bidegree (2n-1,2n-1), on a sub-patch, with their box and a bound of the error of every coordinate.
/// Of weighted patches: in R^4, and the covector [. Y Y_r Y_s], bidegree (3n-1,3n-1).
template <std::size_t N, std::size_t Rows>
struct VectorNet {
  std::array<Vec<Rows>, N> vectors;
  Vec<Rows> lower;
  Vec<Rows> upper;
  double size;  // bound of all coordinates
  double error;
};
template <class K>
using DirectionNetOf = VectorNet<K::count, K::rows>;
template <class K>
using NormalNetOf = VectorNet<K::weighted ? 9 * K::degree * K::degree : 4 * K::degree * K::degree, K::rows>;
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
template <std::size_t M, std::size_t N, std::size_t Rows>
bool never_orthogonal(const VectorNet<M, Rows>& d, const VectorNet<N, Rows>& n);

}  // namespace exsect::filter

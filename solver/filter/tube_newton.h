// Approximations of points of F = 0 and of its derivatives there: guesses, which tubes prove. Internal to
// solver/.
#pragma once

#include "filter/tube.h"

namespace exsect::filter {

/// A place with the scale that belongs to it, approximately: x_4 = kScaleUnit w_4 y_4.
template <class K>
Unknowns<K> with_scale(const PairOf<K>& pair, const Vec4& place);

/// F and its derivatives at a point, approximately.
template <class K>
struct Linearisation {
  Row<K> value;
  std::array<Row<K>, K::unknowns> column;  // F_u, F_v, F_r, F_s
  Unknowns<K> tangent;                     // (5.1), and the change of the scale along it
};
template <class K>
Linearisation<K> linearise(const PairOf<K>& pair, const Unknowns<K>& at);

/// Where in the tangent the largest component is, each divided by its weight.
std::size_t steepest(const Vec4& tangent, const Vec4& weight = {1, 1, 1, 1});

/// Newton's method in the parameters other than `axis`, at most `steps` times; a guess and no more. False if
/// it leaves [-3/4,3/4]^4.
template <class K>
bool improve(const PairOf<K>& pair, Unknowns<K>& point, std::size_t axis, int steps);

}  // namespace exsect::filter

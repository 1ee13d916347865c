// The patches that the solution in doubles is given, exactly. Internal to solver/.
#pragma once

#include <exsect/algebra/binary_order.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/rational_patch.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include "answer/placement.h"
#include "filter/kind.h"

namespace exsect::filter {

/// Control points of a patch of bidegree (K::degree,K::degree), row index = first parameter, times their
/// weights; these are 1 unless K::weighted.
template <class K>
struct ElevatedPatch {
  std::array<Point, K::count> points;
  std::array<Rational, K::count> weights;
};
template <class K>
using ExactPatch = std::conditional_t<std::is_same_v<K, Biquadratic>, BezierPatch, ElevatedPatch<K>>;

inline const Point& control_point(const BezierPatch& patch, std::size_t i) {
  return patch.net()[i / 3][i % 3];
}
template <class K>
const Point& control_point(const ElevatedPatch<K>& patch, std::size_t i) {
  return patch.points[i];
}

/// result = q 2^exponent, without the search for common divisors of a product.
inline void set_scaled(Rational& result, const Rational& q, long exponent) {
  const auto shift = static_cast<mp_bitcnt_t>(std::labs(exponent));
  (exponent < 0 ? mpq_div_2exp : mpq_mul_2exp)(result.backend().data(), q.backend().data(), shift);
}

/// The patch with the net of bidegree (K::degree,K::degree), weights of size 1. Requires a patch of no higher
/// degrees, polynomial unless K::weighted.
template <class K>
ElevatedPatch<K> elevated(const RationalPatch& patch) {
  constexpr int n = static_cast<int>(K::degree);
  const RationalPatch net = patch.reduced().elevated(n, n);
  const auto vector = [&](std::size_t k) -> const HomogeneousPoint& {
    return net.homogeneous(static_cast<int>(k / K::side), static_cast<int>(k % K::side));
  };
  ElevatedPatch<K> result;
  if constexpr (K::weighted) {
    long order = binary_order(vector(0)[3]);  // weights of corners are positive
    for (std::size_t k = 1; k < K::count; ++k) {
      if (vector(k)[3] != 0) order = std::max(order, binary_order(vector(k)[3]));
    }
    for (std::size_t k = 0; k < K::count; ++k) {
      for (std::size_t c = 0; c < 3; ++c) set_scaled(result.points[k][c], vector(k)[c], -order - 1);
      set_scaled(result.weights[k], vector(k)[3], -order - 1);
    }
  } else {
    for (std::size_t k = 0; k < K::count; ++k) {
      for (std::size_t c = 0; c < 3; ++c) result.points[k][c] = vector(k)[c] / vector(0)[3];
      result.weights[k] = 1;
    }
  }
  return result;
}

using ControlVectors = std::vector<std::vector<HomogeneousPoint>>;
inline ControlVectors control_vectors(const BezierPatch& patch) {
  ControlVectors net(3);
  for (std::size_t k = 0; k < 9; ++k) {
    const Point& p = control_point(patch, k);
    net[k / 3].push_back({p[0], p[1], p[2], 1});
  }
  return net;
}
template <class K>
ControlVectors control_vectors(const ElevatedPatch<K>& patch) {
  ControlVectors net(K::side);
  for (std::size_t k = 0; k < K::count; ++k) {
    const Point& p = patch.points[k];
    net[k / K::side].push_back({p[0], p[1], p[2], patch.weights[k]});
  }
  return net;
}

/// The same patch by its maker, which proves again that the weight is positive.
inline RationalPatch rational_patch(const BezierPatch& patch) { return patch; }
template <class K>
RationalPatch rational_patch(const ElevatedPatch<K>& patch) {
  return RationalPatch::from_homogeneous(control_vectors(patch));
}

/// The patch moved and scaled.
template <class K>
ElevatedPatch<K> placed(const ElevatedPatch<K>& patch, const Placement& place) {
  using exsect::operator*;
  using exsect::operator+;
  ElevatedPatch<K> result = patch;
  const Point origin = place.placed(Point{0, 0, 0});  // (P - o) s = P s + (0 - o) s
  for (std::size_t k = 0; k < K::count; ++k) {
    result.points[k] = place.placed(patch.points[k]) + (patch.weights[k] - 1) * origin;
  }
  return result;
}

/// The control points that are points of space, those with positive weights.
template <class K>
std::vector<Point> affine_points(const ElevatedPatch<K>& patch) {
  using exsect::operator*;
  std::vector<Point> points;
  for (std::size_t k = 0; k < K::count; ++k) {
    if (patch.weights[k] > 0) points.push_back(Rational(1 / patch.weights[k]) * patch.points[k]);
  }
  return points;
}

/// What `solve` returns for the smallest kind of pairs, with three or four rows, that both patches belong to,
/// and for both patches reduced: Bicubic, WeightedBiquadratic or WeightedBicubic.
template <class Solve>
auto in_smallest_kind(const RationalPatch& x, const RationalPatch& y, const Solve& solve) {
  const RationalPatch &first = x.reduced(), &second = y.reduced();
  if (first.is_polynomial() && second.is_polynomial()) return solve(Bicubic(), first, second);
  const int degree = std::max({first.degree_u(), first.degree_v(), second.degree_u(), second.degree_v()});
  return degree <= 2 ? solve(WeightedBiquadratic(), first, second) : solve(WeightedBicubic(), first, second);
}

}  // namespace exsect::filter

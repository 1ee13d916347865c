// Sub-patches and pieces of boundary lines with their control nets, in trees, and the proofs that two of them
// have no point, or no point with c.T = 0, in common. Internal to solver/; docs/method.md,
// section 14.1, 14.4.
#pragma once

#include <vector>

#include "filter/patch.h"

namespace exsect::filter {

/// Its exact control points are within Pair::net_error of `net`.
template <class K>
struct SubPatchOf {
  CoefficientsOf<K> net;
  Vec3 lower;  // box of the net
  Vec3 upper;
  Vec3 normal;  // any direction; and the interval of normal.P over the net, and a bound of |normal|_1 + kTiny
  double normal_lower;
  double normal_upper;
  double normal_size;
  double first;  // the square [first, first + width] x [second, second + width] of centred parameters
  double second;
  double width;
  int level;
  std::size_t children;  // index of the first of four; 0: not yet made
};
using SubPatch = SubPatchOf<Biquadratic>;

/// The square and its quarters, made when they are asked for. Indices stay valid, references do not.
template <class K>
class PatchTreeOf {
 public:
  explicit PatchTreeOf(const PatchOf<K>& patch);
  const SubPatchOf<K>& operator[](std::size_t i) const { return nodes_[i]; }
  std::size_t size() const { return nodes_.size(); }
  /// Index of the first of four children. Requires level < kDeepestLevel.
  std::size_t split(std::size_t i);

 private:
  std::vector<SubPatchOf<K>> nodes_;
};
using PatchTree = PatchTreeOf<Biquadratic>;

/// Indices of a sub-patch of each patch.
struct PiecePair {
  std::size_t x;
  std::size_t y;
};

/// Sub-patches of both patches, shared by all searches.
template <class K>
struct TreesOf {
  PatchTreeOf<K> x;
  PatchTreeOf<K> y;

  /// Appends the four pairs that come of splitting the larger one of the two. Requires that its level is
  /// below kDeepestLevel.
  void split_larger(const PiecePair& pair, std::vector<PiecePair>& pairs);
};
using Trees = TreesOf<Biquadratic>;

/// A piece of a boundary line.
template <class K>
struct SubCurveOf {
  std::array<Row<K>, K::side> net;
  Vec3 lower;
  Vec3 upper;
  double from;
  double width;
  int level;
};
template <class K>
SubCurveOf<K> make_curve(const std::array<Row<K>, K::side>& net, double from, double width, int level);
template <class K>
std::array<SubCurveOf<K>, 2> halves(const SubCurveOf<K>& curve);

/// True only if the two have no point in common.
template <class K>
bool separated(const SubPatchOf<K>& x, const SubPatchOf<K>& y, double net_error);
template <class K>
bool separated(const SubCurveOf<K>& curve, const SubPatchOf<K>& patch, double net_error);

/// The largest extent of the box.
inline double extent(const Vec3& lower, const Vec3& upper) {
  return std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
}

/// Control vectors, all divided by the same positive number, of c_u x_v - c_v x_u, bidegree (n,n), or of y_r
/// x y_s, bidegree (2n-1,2n-1), on a sub-patch, with their box and a bound of the error of every coordinate.
template <std::size_t N>
struct VectorNet {
  std::array<Vec3, N> vectors;
  Vec3 lower;
  Vec3 upper;
  double size;  // bound of all coordinates
  double error;
};
template <class K>
using DirectionNetOf = VectorNet<K::count>;
template <class K>
using NormalNetOf = VectorNet<4 * K::degree * K::degree>;
using NormalNet = NormalNetOf<Biquadratic>;
template <class K>
DirectionNetOf<K> direction_net(const SubPatchOf<K>& x, const std::array<double, 2>& c, double net_error);
template <class K>
NormalNetOf<K> normal_net(const SubPatchOf<K>& y, double net_error);

/// True only if (c_u x_v - c_v x_u).(y_r x y_s) has no zero on the two sub-patches.
template <std::size_t M, std::size_t N>
bool never_orthogonal(const VectorNet<M>& d, const VectorNet<N>& n);

}  // namespace exsect::filter

// Sub-patches and pieces of boundary lines with their control nets, in trees, and the proofs that two of them
// have no point, or no point with c.T = 0, in common. Internal to solver/; docs/method.md,
// section 14.1, 14.4.
#pragma once

#include <vector>

#include "filter/patch.h"

namespace exsect::filter {

/// Its exact control points are within Pair::net_error of `net`.
struct SubPatch {
  std::array<Vec3, 9> net;
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

/// The square and its quarters, made when they are asked for. Indices stay valid, references do not.
class PatchTree {
 public:
  explicit PatchTree(const Patch& patch);
  const SubPatch& operator[](std::size_t i) const { return nodes_[i]; }
  std::size_t size() const { return nodes_.size(); }
  /// Index of the first of four children. Requires level < kDeepestLevel.
  std::size_t split(std::size_t i);

 private:
  std::vector<SubPatch> nodes_;
};

/// Indices of a sub-patch of each patch.
struct PiecePair {
  std::size_t x;
  std::size_t y;
};

/// Sub-patches of both patches, shared by all searches.
struct Trees {
  PatchTree x;
  PatchTree y;

  /// Appends the four pairs that come of splitting the larger one of the two. Requires that its level is
  /// below kDeepestLevel.
  void split_larger(const PiecePair& pair, std::vector<PiecePair>& pairs);
};

/// A piece of a boundary line.
struct SubCurve {
  std::array<Vec3, 3> net;
  Vec3 lower;
  Vec3 upper;
  double from;
  double width;
  int level;
};
SubCurve make_curve(const std::array<Vec3, 3>& net, double from, double width, int level);
std::array<SubCurve, 2> halves(const SubCurve& curve);

/// True only if the two have no point in common.
bool separated(const SubPatch& x, const SubPatch& y, double net_error);
bool separated(const SubCurve& curve, const SubPatch& patch, double net_error);

/// The largest extent of the box.
inline double extent(const Vec3& lower, const Vec3& upper) {
  return std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
}

/// Control vectors, all divided by the same positive number, of c_u x_v - c_v x_u, bidegree (2,2), or of y_r
/// x y_s, bidegree (3,3), on a sub-patch, with their box and a bound of the error of every coordinate.
template <std::size_t N>
struct VectorNet {
  std::array<Vec3, N> vectors;
  Vec3 lower;
  Vec3 upper;
  double size;  // bound of all coordinates
  double error;
};
using DirectionNet = VectorNet<9>;
using NormalNet = VectorNet<16>;
DirectionNet direction_net(const SubPatch& x, const std::array<double, 2>& c, double net_error);
NormalNet normal_net(const SubPatch& y, double net_error);

/// True only if (c_u x_v - c_v x_u).(y_r x y_s) has no zero on the two sub-patches.
bool never_orthogonal(const DirectionNet& d, const NormalNet& n);

}  // namespace exsect::filter

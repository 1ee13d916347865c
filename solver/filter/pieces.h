// Sub-patches and pieces of boundary lines with their control nets, in trees, and the proofs that two of them
// have no point, or no point with c.T = 0, in common. Internal to solver/; docs/method-doubles.md,
// section 14.1, 14.4.
#pragma once

#include <memory>
#include <vector>

#include "filter/patch.h"

namespace exsect::filter {

/// Points of space whose convex hull contains a curve or patch, but for an error of each coordinate: for
/// polynomial ones the control points themselves, for weighted ones these divided by their weights, as long
/// as all of these are positive; otherwise the error is infinite. The scale of a solution is between
/// quotients of the weights' bounds.
template <class K, std::size_t Count>
struct AffineNet {
  const std::array<Vec3, Count>& points(const std::array<Row<K>, Count>& net) const { return net; }
  double error(double net_error) const { return net_error; }
};
template <class K, std::size_t Count>
requires K::weighted struct AffineNet<K, Count> {
  std::array<Vec3, Count> affine;
  double affine_error;
  double least_weight;
  double greatest_weight;
  const std::array<Vec3, Count>& points(const std::array<Row<K>, Count>&) const { return affine; }
  double error(double) const { return affine_error; }
};

/// Its exact control points are within Pair::net_error of `net`.
template <class K>
struct SubPatchOf : AffineNet<K, K::count> {
  CoefficientsOf<K> net;
  const std::array<Vec3, K::count>& points() const { return AffineNet<K, K::count>::points(net); }
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

/// The square and its quarters, made when they are asked for. Indices and references stay valid.
template <class K>
class PatchTreeOf {
 public:
  /// `net_error` as in Pair: of all nets of the tree.
  explicit PatchTreeOf(const PatchOf<K>& patch, double net_error = 0);
  const SubPatchOf<K>& operator[](std::size_t i) const { return (*chunks_[i / kChunk])[i % kChunk]; }
  /// Index of the first of four children. Requires level < kDeepestLevel.
  std::size_t split(std::size_t i);

 private:
  static constexpr std::size_t kChunk = 32;
  using Chunk = std::array<SubPatchOf<K>, kChunk>;

  SubPatchOf<K>& at(std::size_t i) { return (*chunks_[i / kChunk])[i % kChunk]; }
  /// The index of the first of four new ones.
  std::size_t four_more();

  std::vector<std::unique_ptr<Chunk>> chunks_;  // copies of the nets would take longer than the nets
  std::size_t size_ = 0;
  double net_error_;
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

/// The box of some vectors.
template <std::size_t N, std::size_t Rows>
void enclose(const std::array<Vec<Rows>, N>& points, Vec<Rows>& lower, Vec<Rows>& upper) {
  lower = upper = points[0];
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t c = 0; c < Rows; ++c) {
      lower[c] = std::min(lower[c], points[i][c]);
      upper[c] = std::max(upper[c], points[i][c]);
    }
  }
}

/// A piece of a boundary line.
template <class K>
struct SubCurveOf : AffineNet<K, K::side> {
  std::array<Row<K>, K::side> net;
  const std::array<Vec3, K::side>& points() const { return AffineNet<K, K::side>::points(net); }
  Vec3 lower;
  Vec3 upper;
  double from;
  double width;
  int level;
};
template <class K>
SubCurveOf<K> make_curve(const std::array<Row<K>, K::side>& net, double from, double width, int level,
                         double net_error);
template <class K>
std::array<SubCurveOf<K>, 2> halves(const SubCurveOf<K>& curve, double net_error);

/// True only if the two have no point in common.
template <class K>
bool separated(const SubPatchOf<K>& x, const SubPatchOf<K>& y, double net_error);
template <class K>
bool separated(const SubCurveOf<K>& curve, const SubPatchOf<K>& patch, double net_error);

/// The scale of solutions on two pieces, x_4 / (kScaleUnit y_4), as an interval that is infinite where
/// weights are not proved positive.
struct RangeOfScale {
  double middle;
  double half;
};
template <class X, class Y>
RangeOfScale range_of_scale(const X& x, const Y& y) {
  if (!(x.least_weight > 0 && y.least_weight > 0)) {
    return {1, HUGE_VAL};
  }
  const double lower = x.least_weight / (kScaleUnit * y.greatest_weight);
  const double upper = x.greatest_weight / (kScaleUnit * y.least_weight);
  return {0.5 * (lower + upper), kSlack * 0.5 * (upper - lower) + 8 * kUnit * upper};
}

/// Where weights hardly vary the range of the scale is far smaller than those of the parameters: a region,
/// given by half widths of a tube, has some room beyond it. Nothing for polynomial patches.
template <class K>
void widen_scale([[maybe_unused]] Unknowns<K>& halfwidth) {
  if constexpr (K::weighted) {
    halfwidth[4] += 0.25 * std::max({halfwidth[0], halfwidth[1], halfwidth[2], halfwidth[3]});
  }
}

/// The largest extent of the box.
inline double extent(const Vec3& lower, const Vec3& upper) {
  return std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
}

}  // namespace exsect::filter

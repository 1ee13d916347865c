// A patch of any kind, and its derivatives of first and second order, in ball arithmetic. Internal to
// solver/; docs/method.md, section 8.4.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "trace/pair_system.h"

namespace exsect {

/// With the denominator w and X = w x, the vectors w X_ab - w_ab X: w^2 x_u and w^2 x_v, and w^2 x_uu, w^2
/// x_uv, w^2 x_vv up to sums of multiples of the first two. A polynomial patch has w = 1.
template <class Ball>
struct PatchJet {
  Ball weight;
  BallVector<Ball> u, v, uu, uv, vv;

  BallVector<Ball> normal() const { return cross(u, v); }
};

/// B_i of degree n <= 3, i in 0..n, and its first two derivatives at t.
template <class Ball>
std::array<std::array<Ball, 4>, 3> bernstein_values(std::size_t n, const Ball& t) {
  const Ball rest = Ball(1.0) - t;
  std::array<std::array<Ball, 4>, 4> of = {};  // by degree
  of[0][0] = Ball(1.0);
  for (std::size_t k = 1; k <= n; ++k)
    for (std::size_t i = 0; i <= k; ++i) {
      if (i < k) of[k][i] += rest * of[k - 1][i];
      if (i > 0) of[k][i] += t * of[k - 1][i - 1];
    }
  std::array<std::array<Ball, 4>, 3> result = {of[n]};
  const auto add = [&](std::size_t order, std::size_t i, double factor) {
    for (std::size_t k = 0; k <= n - order; ++k) result[order][k + i] += Ball(factor) * of[n - order][k];
  };
  const auto degree = static_cast<double>(n);
  add(1, 0, -degree);
  add(1, 1, degree);
  if (n < 2) return result;
  const double twice = degree * (degree - 1);
  add(2, 0, twice);
  add(2, 1, -2 * twice);
  add(2, 2, twice);
  return result;
}

/// A ball around q; all numbers where q is beyond the range of doubles.
template <class Ball>
Ball ball_around(const Rational& q) {
  if constexpr (std::is_same_v<Ball, DoubleBall>) {
    // Nearest rounding: the error is at most u|m|, or 2^-1075 below the normal range.
    const double m = to_double(q);
    return std::isfinite(m) ? DoubleBall(m).widened(std::fabs(m) * 0x1p-53)
                            : DoubleBall(0, std::numeric_limits<double>::infinity());
  } else {
    return Ball::enclosing(q);
  }
}

template <class Ball>
class PatchNet {
 public:
  explicit PatchNet(const BezierPatch& patch) : rows_(3), columns_(3), weighted_(false) {
    for (const auto& row : patch.net())
      for (const Point& p : row) add(p[0], p[1], p[2]);
  }
  explicit PatchNet(const RationalPatch& patch)
      : rows_(static_cast<std::size_t>(patch.degree_u()) + 1),
        columns_(static_cast<std::size_t>(patch.degree_v()) + 1),
        weighted_(false) {
    for (int i = 0; i <= patch.degree_u(); ++i)
      for (int j = 0; j <= patch.degree_v(); ++j) {
        const HomogeneousPoint& p = patch.homogeneous(i, j);
        add(p[0], p[1], p[2]);
        net_.back()[3] = ball_around<Ball>(p[3]);
        weighted_ = weighted_ || p[3] != 1;
      }
  }

  /// At all (u,v) in the balls; second derivatives only if `order` is 2.
  PatchJet<Ball> at(const Ball& u, const Ball& v, int order) const {
    const Values in_u = bernstein_values(rows_ - 1, u), in_v = bernstein_values(columns_ - 1, v);
    const std::array<Ball, 4> value = weighted_ ? sum(in_u[0], in_v[0]) : std::array<Ball, 4>{};
    const auto vector = [&](std::size_t a, std::size_t b) {
      const std::array<Ball, 4> x = sum(in_u[a], in_v[b]);
      if (!weighted_) return BallVector<Ball>{x[0], x[1], x[2]};
      BallVector<Ball> result;
      for (std::size_t k = 0; k < 3; ++k) result[k] = value[3] * x[k] - x[3] * value[k];
      return result;
    };
    PatchJet<Ball> jet{weighted_ ? value[3] : Ball(1.0), vector(1, 0), vector(0, 1), {}, {}, {}};
    if (order < 2) return jet;
    jet.uu = vector(2, 0);
    jet.uv = vector(1, 1);
    jet.vv = vector(0, 2);
    return jet;
  }

 private:
  using Values = std::array<std::array<Ball, 4>, 3>;

  void add(const Rational& x, const Rational& y, const Rational& z) {
    net_.push_back({ball_around<Ball>(x), ball_around<Ball>(y), ball_around<Ball>(z), Ball()});
  }

  std::array<Ball, 4> sum(const std::array<Ball, 4>& in_u, const std::array<Ball, 4>& in_v) const {
    std::array<Ball, 4> result = {};
    for (std::size_t i = 0; i < rows_; ++i)
      for (std::size_t j = 0; j < columns_; ++j) {
        const Ball factor = in_u[i] * in_v[j];
        for (std::size_t k = 0; k < (weighted_ ? 4U : 3U); ++k)
          add_product(result[k], factor, net_[i * columns_ + j][k]);
      }
    return result;
  }

  std::size_t rows_, columns_;
  bool weighted_;
  std::vector<std::array<Ball, 4>> net_;  // X_ij
};

}  // namespace exsect

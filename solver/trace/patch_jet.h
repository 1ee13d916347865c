// A patch of any kind, and its derivatives of first and second order, in ball arithmetic. Internal to
// solver/; docs/method.md, section 8.4.
#pragma once

#include <exsect/algebra/nearest_double.h>
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

/// A ball around q; all numbers where q is beyond the range of doubles.
template <class Ball>
Ball ball_around(const Rational& q) {
  if constexpr (std::is_same_v<Ball, DoubleBall>) {
    // Nearest rounding: the error is at most u|m|, or 2^-1075 below the normal range.
    const auto [m, exact] = nearest_double(q);
    if (exact) return m;
    return std::isfinite(m) ? DoubleBall(m).widened(std::fabs(m) * 0x1p-53)
                            : DoubleBall(0, std::numeric_limits<double>::infinity());
  } else {
    return Ball::enclosing(q);
  }
}

/// X in the power basis.
template <class Ball>
class PatchNet {
 public:
  explicit PatchNet(const BezierPatch& patch) : m_(2), n_(2), weighted_(false) {
    for (const auto& row : patch.net())
      for (const Point& p : row) add(p[0], p[1], p[2]);
    to_power_basis();
  }
  explicit PatchNet(const RationalPatch& patch)
      : m_(static_cast<std::size_t>(patch.degree_u())),
        n_(static_cast<std::size_t>(patch.degree_v())),
        weighted_(false) {
    for (int i = 0; i <= patch.degree_u(); ++i)
      for (int j = 0; j <= patch.degree_v(); ++j) {
        const HomogeneousPoint& p = patch.homogeneous(i, j);
        add(p[0], p[1], p[2]);
        net_.back()[3] = ball_around<Ball>(p[3]);
        weighted_ = weighted_ || p[3] != 1;
      }
    to_power_basis();
  }

  /// At all (u,v) in the balls that are in [0,1]^2, as are their middles; second derivatives only if `order`
  /// is 2.
  PatchJet<Ball> at(const Ball& u, const Ball& v, int order) const {
    const Vector4 value = weighted_ ? derivative(0, 0, u, v) : Vector4{};
    const auto vector = [&](std::size_t a, std::size_t b) {
      const Vector4 x = derivative(a, b, u, v);
      if (!weighted_) return BallVector<Ball>{x[0], x[1], x[2]};
      BallVector<Ball> result;
      for (std::size_t k = 0; k < 3; ++k) result[k] = value[3] * x[k] - x[3] * value[k];
      return result;
    };
    if constexpr (std::is_same_v<Ball, DoubleBall>)
      if (!weighted_ && order < 2)
        return {Ball(1.0), first_derivative(0, u, v), first_derivative(1, u, v), {}, {}, {}};
    PatchJet<Ball> jet{weighted_ ? value[3] : Ball(1.0), vector(1, 0), vector(0, 1), {}, {}, {}};
    if (order < 2) return jet;
    jet.uu = vector(2, 0);
    jet.uv = vector(1, 1);
    jet.vv = vector(0, 2);
    return jet;
  }

 private:
  using Vector4 = std::array<Ball, 4>;

  void add(const Rational& x, const Rational& y, const Rational& z) {
    net_.push_back({ball_around<Ball>(x), ball_around<Ball>(y), ball_around<Ball>(z), Ball()});
  }

  std::size_t count() const { return weighted_ ? 4 : 3; }

  /// The coefficient of t^k is n over k times the k-th forward difference at the first control point.
  void to_power_basis() {
    for (std::size_t j = 0; j <= n_; ++j) to_power_basis(m_, j, n_ + 1);
    for (std::size_t i = 0; i <= m_; ++i) to_power_basis(n_, i * (n_ + 1), 1);
  }
  void to_power_basis(std::size_t degree, std::size_t first, std::size_t step) {
    double binomial = 1;
    for (std::size_t k = 1; k <= degree; ++k) {
      for (std::size_t i = degree; i >= k; --i)
        for (std::size_t c = 0; c < count(); ++c)
          net_[first + i * step][c] -= net_[first + (i - 1) * step][c];
    }
    for (std::size_t k = 1; k < degree; ++k) {
      binomial *= static_cast<double>(degree - k + 1) / static_cast<double>(k);  // 2, or 3 and 3
      for (std::size_t c = 0; c < count(); ++c) net_[first + k * step][c] *= Ball(binomial);
    }
  }

  /// X differentiated a times by u and b times by v, a and b at most 2.
  Vector4 derivative(std::size_t a, std::size_t b, const Ball& u, const Ball& v) const {
    Vector4 result = {};
    for (std::size_t i = m_ + 1; i-- > a;)
      for (std::size_t c = 0; c < count(); ++c) {
        Ball in_v;
        for (std::size_t j = n_ + 1; j-- > b;) {
          const double factor = kFactors[a][i] * kFactors[b][j];
          const Ball& x = net_[i * (n_ + 1) + j][c];
          in_v = in_v * v + (factor == 1 ? x : Ball(factor) * x);
        }
        result[c] = result[c] * u + in_v;
      }
    return result;
  }

  /// The same once by u (0) or v (1), in doubles with one bound: a term passes 13 roundings at most, and from
  /// the middle to any point of the balls a sum over moduli, with what coefficients err by, bounds the
  /// change.
  BallVector<Ball> first_derivative(std::size_t in, const Ball& u, const Ball& v) const {
    const std::size_t a = 1 - in, b = in;
    const double s = u.approximation(), t = v.approximation();
    BallVector<Ball> result;
    for (std::size_t c = 0; c < 3; ++c) {
      double value = 0, size = 0, along_u = 0, along_v = 0, error = 0;
      for (std::size_t i = m_ + 1; i-- > a;) {
        double in_v = 0;
        for (std::size_t j = n_ + 1; j-- > b;) {
          const double factor = kFactors[a][i] * kFactors[b][j];
          const Ball& x = net_[i * (n_ + 1) + j][c];
          const double term = factor * x.approximation(), modulus = std::fabs(term);
          in_v = in_v * t + term;
          size += modulus;
          along_u += static_cast<double>(i - a) * modulus;
          along_v += static_cast<double>(j - b) * modulus;
          error += factor * x.radius();
        }
        value = value * s + in_v;
      }
      const double change = along_u * u.radius() + along_v * v.radius();
      result[c] = Ball(value).widened((size * 0x1p-49 + change + error) * (1 + 0x1p-40) + 0x1p-1000);
    }
    return result;
  }

  /// k (k - 1) ... of t^k differentiated.
  static constexpr std::array<std::array<double, 4>, 3> kFactors = {
      {{1, 1, 1, 1}, {0, 1, 2, 3}, {0, 0, 2, 6}}};

  std::size_t m_, n_;
  bool weighted_;
  std::vector<Vector4> net_;  // of u^i v^j at i (n+1) + j
};

}  // namespace exsect

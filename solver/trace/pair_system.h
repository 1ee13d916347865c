// F(u,v,r,s) = x(u,v) - y(r,s) in ball arithmetic: Taylor expansions, Jacobian columns, the tangent field.
// Internal to solver/.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/algebra/double_double_ball.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>

namespace exsect {

template <class Ball>
using BallVector = std::array<Ball, 3>;
template <class Ball>
using BallPoint = std::array<Ball, 4>;  // u, v, r, s
/// c[3 * i + j]: the vector coefficient of (first - p0)^i (second - p1)^j, i and j in 0..2.
template <class Ball>
using TaylorNet = std::array<BallVector<Ball>, 9>;

template <class Ball>
BallVector<Ball> cross(const BallVector<Ball>& a, const BallVector<Ball>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Ball>
Ball dot(const BallVector<Ball>& a, const BallVector<Ball>& b) {
  Ball sum = a[0] * b[0];
  add_product(sum, a[1], b[1]);
  add_product(sum, a[2], b[2]);
  return sum;
}

/// q(t + p) for q = c0 + c1 t + c2 t^2, in place.
template <class Ball>
void shift(Ball& c0, Ball& c1, const Ball& c2, const Ball& p) {
  const Ball upper = c1 + p * c2;
  c0 += p * upper;
  c1 = upper + p * c2;
}

/// The Taylor coefficients at (p0,p1) of the polynomial with these coefficients at (0,0).
template <class Ball>
TaylorNet<Ball> shifted(const TaylorNet<Ball>& net, const Ball& p0, const Ball& p1) {
  TaylorNet<Ball> c = net;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      shift(c[j][k], c[3 + j][k], c[6 + j][k], p0);
    }
    for (std::size_t i = 0; i < 9; i += 3) {
      shift(c[i][k], c[i + 1][k], c[i + 2][k], p1);
    }
  }
  return c;
}

/// A pair of patches translated by `origin` and scaled by 2^-exponent, enclosed in balls.
template <class Ball>
class PairSystem {
 public:
  PairSystem(const BezierPatch& x, const BezierPatch& y, const Point& origin, long exponent)
      : x_(enclose(x, origin, exponent)), y_(enclose(y, origin, exponent)) {}

  /// Taylor coefficients of x at (u,v) and of y at (r,s).
  TaylorNet<Ball> taylor_x(const BallPoint<Ball>& p) const { return shifted(x_, p[0], p[1]); }
  TaylorNet<Ball> taylor_y(const BallPoint<Ball>& p) const { return shifted(y_, p[2], p[3]); }

  /// The pair over a part of the range of parameter j, which is [0,1] in it: a zoom, exact but for rounding.
  PairSystem restricted(std::size_t j, const RationalInterval& to) const {
    BallPoint<Ball> at;
    at[j] = Ball::enclosing(to.lower);
    const Ball width = Ball::enclosing(to.width());
    PairSystem result = *this;
    TaylorNet<Ball>& net = j < 2 ? result.x_ : result.y_;
    net = j < 2 ? taylor_x(at) : taylor_y(at);
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t power = j % 2 == 0 ? i / 3 : i % 3; power > 0; --power) {
        for (Ball& c : net[i]) c *= width;
      }
    }
    return result;
  }

 private:
  static TaylorNet<Ball> enclose(const BezierPatch& patch, const Point& origin, long exponent) {
    const Rational scale = power_of_two(-exponent);
    const ControlNet power = patch.power_basis();
    TaylorNet<Ball> net;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Point c = scale * (i + j == 0 ? power[0][0] - origin : power[i][j]);
        net[3 * i + j] = {Ball::enclosing(c[0]), Ball::enclosing(c[1]), Ball::enclosing(c[2])};
      }
    }
    return net;
  }

  TaylorNet<Ball> x_;
  TaylorNet<Ball> y_;
};

/// F and its derivatives at a point: everything needed there is a Taylor coefficient of x or y.
template <class Ball>
struct Expansion {
  TaylorNet<Ball> x;
  TaylorNet<Ball> y;

  Expansion(const PairSystem<Ball>& system, const BallPoint<Ball>& p)
      : x(system.taylor_x(p)), y(system.taylor_y(p)) {}

  BallVector<Ball> value() const { return {x[0][0] - y[0][0], x[0][1] - y[0][1], x[0][2] - y[0][2]}; }
  /// Columns of the Jacobian: x_u, x_v, -y_r, -y_s.
  BallVector<Ball> column(std::size_t j) const {
    if (j < 2) {
      return j == 0 ? x[3] : x[1];
    }
    const BallVector<Ball>& d = j == 2 ? y[3] : y[1];
    return {-d[0], -d[1], -d[2]};
  }
  /// T = (x_v.Ny, -x_u.Ny, -y_s.Nx, y_r.Nx) with Nx = x_u x x_v, Ny = y_r x y_s: the kernel of the Jacobian,
  /// a continuous field, nonzero exactly where the Jacobian has rank 3.
  BallPoint<Ball> tangent() const {
    const BallVector<Ball> nx = cross(x[3], x[1]);
    const BallVector<Ball> ny = cross(y[3], y[1]);
    return {dot(x[1], ny), -dot(x[3], ny), -dot(y[1], nx), dot(y[3], nx)};
  }
};

}  // namespace exsect

// Where two patches have one normal, approximately. Internal to solver/; docs/method-doubles.md,
// section 14.9.
#pragma once

#include <array>
#include <optional>

#include "filter/patch.h"
#include "filter/second_order.h"

namespace exsect::filter {

/// Of a patch at (h,k), centred.
template <class K>
SecondOrder second_order(const PatchOf<K>& patch, double h, double k);

/// (x - y).y_r, (x - y).y_s, x_u.n and x_v.n, n = y_r x y_s, and their derivatives by u, v, r and s.
template <class Number>
struct CommonNormalEquations {
  std::array<Number, 4> value;
  std::array<std::array<Number, 4>, 4> jacobian;
};
/// From Taylor coefficients of both patches in any arithmetic, such as SecondOrder.
template <class Number, class Coefficients>
CommonNormalEquations<Number> common_normal_equations(const Coefficients& x, const Coefficients& y) {
  using Vector = std::array<Number, 3>;
  const auto dot = [](const Vector& a, const Vector& b) -> Number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto cross = [](const Vector& a, const Vector& b) -> Vector {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto sum = [](const Number& p, const Vector& a, const Number& q, const Vector& b) -> Vector {
    return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
  };
  const Vector d = sum(1, x.value, -1, y.value);
  const Vector n = cross(y.u, y.v);
  const Vector nr = sum(2, cross(y.uu, y.v), 1, cross(y.u, y.uv));
  const Vector ns = sum(1, cross(y.uv, y.v), 2, cross(y.u, y.vv));
  return {{dot(d, y.u), dot(d, y.v), dot(x.u, n), dot(x.v, n)},
          {{{dot(x.u, y.u), dot(x.v, y.u), 2 * dot(d, y.uu) - dot(y.u, y.u), dot(d, y.uv) - dot(y.v, y.u)},
            {dot(x.u, y.v), dot(x.v, y.v), dot(d, y.uv) - dot(y.u, y.v), 2 * dot(d, y.vv) - dot(y.v, y.v)},
            {2 * dot(x.uu, n), dot(x.uv, n), dot(x.u, nr), dot(x.u, ns)},
            {dot(x.uv, n), 2 * dot(x.vv, n), dot(x.v, nr), dot(x.v, ns)}}}};
}

/// Newton's method for (x - y).y_r = (x - y).y_s = x_u.(y_r x y_s) = x_v.(y_r x y_s) = 0 from w (centred):
/// where it ends, if it settles; |x - y| is that of `distance` then.
struct CommonNormal {
  Vec4 at;
  double distance;
};
template <class K>
std::optional<CommonNormal> common_normal(const PairOf<K>& pair, Vec4 w);

/// The tangent planes being the same at w: the difference of the heights of x and y over the plane takes both
/// signs, to second order, (14.17).
template <class K>
bool looks_like_crossing(const PairOf<K>& pair, const Vec4& w);

}  // namespace exsect::filter

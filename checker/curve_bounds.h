// Bounds for the curve x(u,v) = y(r,s) near a point (docs/certificate.md, "Tubes"). Over Q, and in Enclosure,
// they prove; over doubles they let a writer look for claims.
//
// Notation: F(w) = x(u,v) - y(r,s), w = (u,v,r,s); k the axis of a tube, the curve is a graph over w_k; C its
// inverse, a 3 x 3 matrix near the inverse of the columns of DF other than k. Row i of C F belongs to the
// parameter others(k)[i].
#pragma once

#include <array>
#include <cstddef>

#include "enclosure.h"

namespace exsect::checker {

template <class N>
using Vector4 = std::array<N, 4>;
template <class N>
using Vector3 = std::array<N, 3>;
template <class N>
using Matrix3 = std::array<std::array<N, 3>, 3>;
/// c[i][j] is the vector coefficient of du^i dv^j.
template <class N>
using Net = std::array<std::array<Vector3<N>, 3>, 3>;

template <class N>
N magnitude(const N& a) {
  return a < 0 ? N(-a) : a;
}
template <class N>
const N& larger(const N& a, const N& b) {
  return a < b ? b : a;
}

/// -1, 0, 1.
template <class N>
int sign_of(const N& a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}
template <class N>
N dot(const Vector3<N>& a, const Vector3<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// All numbers within `radius` of `middle`.
template <class N>
struct Ball {
  N middle{};
  N radius{};

  N magnitude() const { return checker::magnitude(middle) + radius; }
  /// -1 or 1 if all numbers of the ball have this sign, else 0.
  int sign() const { return middle > radius ? 1 : middle < -radius ? -1 : 0; }
  friend Ball operator+(const Ball& a, const Ball& b) { return {a.middle + b.middle, a.radius + b.radius}; }
  friend Ball operator-(const Ball& a) { return {-a.middle, a.radius}; }
  friend Ball operator*(const Ball& a, const Ball& b) {
    return {a.middle * b.middle, checker::magnitude(a.middle) * b.radius + a.radius * b.magnitude()};
  }
};

/// The three parameters other than k, in order.
inline std::array<std::size_t, 3> others(std::size_t k) {
  return {k == 0 ? std::size_t{1} : 0, k <= 1 ? std::size_t{2} : 1, k <= 2 ? std::size_t{3} : 2};
}

/// Component d of c at (u, v).
template <class N>
N value(const Net<N>& c, std::size_t d, const N& u, const N& v) {
  const auto row = [&](std::size_t i) { return N(c[i][0][d] + v * (c[i][1][d] + v * c[i][2][d])); };
  return row(0) + u * (row(1) + u * row(2));
}

/// The coefficients of c at (u + du, v + dv) in du, dv.
template <class N>
Net<N> shifted(Net<N> c, const N& u, const N& v) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      c[0][i][d] += u * (c[1][i][d] + u * c[2][i][d]);
      c[1][i][d] += 2 * u * c[2][i][d];
    }
  }
  for (auto& row : c) {
    for (std::size_t d = 0; d < 3; ++d) {
      row[0][d] += v * (row[1][d] + v * row[2][d]);
      row[1][d] += 2 * v * row[2][d];
    }
  }
  return c;
}

/// The range of the derivative of component d, a times to u and b times to v, over |du| <= hu, |dv| <= hv.
template <class N>
Ball<N> derivative(const Net<N>& c, std::size_t d, std::size_t a, std::size_t b, const N& hu, const N& hv) {
  Ball<N> result;
  N pu = 1;
  for (std::size_t i = a; i < 3; ++i, pu = pu * hu) {
    N pv = pu;
    for (std::size_t j = b; j < 3; ++j, pv = pv * hv) {
      const int factor = (a == 2 || (a == 1 && i == 2) ? 2 : 1) * (b == 2 || (b == 1 && j == 2) ? 2 : 1);
      if (i == a && j == b)
        result.middle = factor * c[i][j][d];
      else
        result.radius += factor * magnitude(c[i][j][d]) * pv;
    }
  }
  return result;
}

/// x and -y, shifted to a point w and, where that is said, multiplied by C.
template <class N>
struct Pair {
  Net<N> x;
  Net<N> y;

  Pair at(const Vector4<N>& w) const { return {shifted(x, w[0], w[1]), shifted(y, w[2], w[3])}; }
  Pair times(const Matrix3<N>& m) const {
    Pair result;
    for (auto [from, to] : {std::pair{&x, &result.x}, std::pair{&y, &result.y}}) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const auto& a = (*from)[i][j];
          for (std::size_t d = 0; d < 3; ++d)
            (*to)[i][j][d] = m[d][0] * a[0] + m[d][1] * a[1] + m[d][2] * a[2];
        }
      }
    }
    return result;
  }
  /// Component d of F at the point.
  N value(std::size_t d) const { return x[0][0][d] + y[0][0][d]; }
  /// The range of dF_d/dw_j over |dw_i| <= h_i.
  Ball<N> first(std::size_t d, std::size_t j, const Vector4<N>& h) const {
    return j < 2 ? derivative(x, d, 1 - j, j, h[0], h[1]) : derivative(y, d, 3 - j, j - 2, h[2], h[3]);
  }
  /// The range of the second derivative of F_d along vectors in the box t, over |dw_i| <= h_i.
  Ball<N> second(std::size_t d, const std::array<Ball<N>, 4>& t, const Vector4<N>& h) const {
    const Ball<N> two = {2, 0};
    return derivative(x, d, 2, 0, h[0], h[1]) * t[0] * t[0] +
           two * derivative(x, d, 1, 1, h[0], h[1]) * t[0] * t[1] +
           derivative(x, d, 0, 2, h[0], h[1]) * t[1] * t[1] +
           derivative(y, d, 2, 0, h[2], h[3]) * t[2] * t[2] +
           two * derivative(y, d, 1, 1, h[2], h[3]) * t[2] * t[3] +
           derivative(y, d, 0, 2, h[2], h[3]) * t[3] * t[3];
  }
};

/// T over |dw_i| <= h_i: T_k is (-1)^k times the determinant of the columns of DF other than k, and T_i / T_k
/// is the derivative of w_i with respect to w_k along the curve.
template <class N>
std::array<Ball<N>, 4> tangent(const Pair<N>& local, const Vector4<N>& h) {
  std::array<Ball<N>, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto entry = [&](std::size_t d, std::size_t j) { return local.first(d, others(k)[j], h); };
    const auto minor = [&](std::size_t i, std::size_t j) {
      return entry(1, i) * entry(2, j) + -(entry(1, j) * entry(2, i));
    };
    const Ball<N> t = entry(0, 0) * minor(1, 2) + entry(0, 1) * minor(2, 0) + entry(0, 2) * minor(0, 1);
    result[k] = k % 2 == 0 ? t : -t;
  }
  return result;
}

/// The set of all centre + t slope + e, |t| <= reach, |e_i| <= width, e_k = 0; slope_k = 1.
template <class N>
struct Tube {
  Vector4<N> centre;
  std::size_t axis;
  Vector4<N> slope;
  N reach;
  N width;
  Matrix3<N> inverse;

  /// Half extents of the box around the tube.
  Vector4<N> extent() const {
    Vector4<N> h;
    for (std::size_t i = 0; i < 4; ++i) h[i] = magnitude(slope[i]) * reach + (i == axis ? N(0) : width);
    return h;
  }
  /// The box around w with half extents h lies in the tube.
  bool contains(const Vector4<N>& w, const Vector4<N>& h) const {
    const N t = w[axis] - centre[axis];
    if (!(magnitude(t) + h[axis] <= reach)) return false;
    for (const std::size_t i : others(axis)) {
      if (!(magnitude(N(w[i] - centre[i] - slope[i] * t)) + h[i] + magnitude(slope[i]) * h[axis] <= width))
        return false;
    }
    return true;
  }
};

/// width - f - E width row by row, `local` the pair at the centre times C. If all three are > 0, then for
/// every t there is exactly one zero of F in the tube.
template <class N>
std::array<N, 3> contraction(const Tube<N>& tube, const Pair<N>& local) {
  const auto& [du, dv, dr, ds] = tube.slope;
  const Vector4<N> h = tube.extent();
  const N& t = tube.reach;
  std::array<N, 3> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto x = [&](std::size_t i, std::size_t j) -> const N& { return local.x[i][j][d]; };
    const auto y = [&](std::size_t i, std::size_t j) -> const N& { return local.y[i][j][d]; };
    const N f1 = x(1, 0) * du + x(0, 1) * dv + y(1, 0) * dr + y(0, 1) * ds;
    const N f2 = x(2, 0) * du * du + x(1, 1) * du * dv + x(0, 2) * dv * dv + y(2, 0) * dr * dr +
                 y(1, 1) * dr * ds + y(0, 2) * ds * ds;
    const N f3 = du * dv * (x(2, 1) * du + x(1, 2) * dv) + dr * ds * (y(2, 1) * dr + y(1, 2) * ds);
    const N f4 = x(2, 2) * du * du * dv * dv + y(2, 2) * dr * dr * ds * ds;
    const N f = magnitude(local.value(d)) +
                t * (magnitude(f1) + t * (magnitude(f2) + t * (magnitude(f3) + t * magnitude(f4))));
    N e = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      Ball<N> entry = local.first(d, others(tube.axis)[j], h);
      if (j == d) entry.middle -= 1;
      e += entry.magnitude();
    }
    result[d] = tube.width - f - e * tube.width;
  }
  return result;
}

/// Derivatives of the curve with respect to w_k wherever it lies in a box |dw_i| <= h_i, as enclosures.
template <class N>
struct CurveBounds {
  N defect;  // >= the row sums of |C D'F - 1| over the box; nothing is known unless it is < 1
  std::array<Ball<N>, 4> first;
  std::array<Ball<N>, 4> second;
};

/// `local`: the pair at the middle of the box times C.
template <class N>
CurveBounds<N> curve_bounds(const Pair<N>& local, std::size_t axis, const Vector4<N>& h) {
  const std::array<std::size_t, 3> other = others(axis);
  CurveBounds<N> result{};
  std::array<N, 3> row{};
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t j = 0; j < 3; ++j) {
      Ball<N> entry = local.first(d, other[j], h);
      if (j == d) entry.middle -= 1;
      row[d] += entry.magnitude();
    }
    result.defect = larger(result.defect, row[d]);
  }
  if (!(result.defect < 1)) return result;
  // (1 + E) w' = g with |E| <= row: |w'| <= max|g| / (1 - defect) and |w' - g| <= row |w'|.
  const auto solve = [&](std::array<Ball<N>, 3> g, std::array<Ball<N>, 4>& w) {
    N most = 0;
    for (const Ball<N>& b : g) most = larger(most, b.magnitude());
    most = most / (1 - result.defect);
    for (std::size_t d = 0; d < 3; ++d) w[other[d]] = {g[d].middle, g[d].radius + row[d] * most};
  };
  std::array<Ball<N>, 3> g;
  result.first[axis] = {1, 0};
  for (std::size_t d = 0; d < 3; ++d) g[d] = -local.first(d, axis, h);
  solve(g, result.first);
  for (std::size_t d = 0; d < 3; ++d) g[d] = -local.second(d, result.first, h);
  solve(g, result.second);
  return result;
}

}  // namespace exsect::checker

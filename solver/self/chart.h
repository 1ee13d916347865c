// Unordered pairs of parameters of one patch in charts that stay regular at cuspidal points. Internal to
// solver/.
//
// Notation (docs/method.md, section 7): the pair (U + t, V + m t), (U - t, V - m t) of midpoint (U,V) and
// half difference t (1, m), w = t^2. x takes the same value at both exactly where t H(U,V,m,w) = 0 (7.2),
//   H = x_u + m x_v + w m (c21 + 2 c22 V + m (c12 + 2 c22 U)).                                       (7.3)
#pragma once

#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/bezier_patch.h>

#include <cmath>
#include <cstddef>

#include "trace/pair_system.h"

namespace exsect {

/// Which parameter the half difference is normalised to: first, the chart above; second, the chart above of
/// the patch with exchanged parameters, where U, V and m change their roles. The chart `first` covers |m| <=
/// 1, `second` the other directions.
enum class Chart { first, second };

/// Coefficients of U^i V^j m^k w^l at [((3 i + j) 3 + k) W + l], i, j, k in 0..2, l in 0..W-1.
template <class Ball, std::size_t W>
using ChartNet = std::array<BallVector<Ball>, 27 * W>;

inline constexpr std::array<std::size_t, 4> chart_strides(std::size_t w) { return {9 * w, 3 * w, w, 1}; }
/// The exponent of variable j at index i of a net.
template <std::size_t W>
constexpr std::size_t exponent(std::size_t i, std::size_t j) {
  return j == 3 ? i % W : i / chart_strides(W)[j] % 3;
}

/// Indices of the 25 coefficients of H that do not vanish identically; the constant one is the first.
inline constexpr std::array<std::size_t, 25> chart_support = {
    0, 2, 4, 1, 3, 5, 6, 8, 7, 9, 18, 20, 22, 19, 21, 23, 10, 12, 24, 26, 30, 36, 38, 42, 44};

/// H (7.3) and the point of space X(U,V,m,w) = (x(first) + x(second))/2 (7.4), both polynomials, for the
/// patch scaled by 2^-exponent after translation by -origin.
template <class Ball>
class ChartSystem {
 public:
  ChartSystem(const BezierPatch& patch, const Point& origin, long exponent, Chart chart) : chart_(chart) {
    const Rational scale = power_of_two(-exponent);
    ControlNet c = (chart == Chart::first ? patch : patch.exchanged()).power_basis();
    c[0][0] = c[0][0] - origin;
    for (auto& row : c) {
      for (Point& p : row) {
        p = scale * p;
      }
    }
    for (std::size_t i = 0; i < 9; ++i) {
      const Point& p = c[i / 3][i % 3];
      power_[i] = {Ball::enclosing(p[0]), Ball::enclosing(p[1]), Ball::enclosing(p[2])};
    }
    fill_equation(c);
    fill_space(c);
  }

  Chart chart() const { return chart_; }
  const ChartNet<Ball, 2>& equation() const { return equation_; }
  const ChartNet<Ball, 3>& space() const { return space_; }

  /// The Taylor coefficients of H at p: as shift() of equation(), in less time. Zero off chart_support.
  ChartNet<Ball, 2> taylor(const BallPoint<Ball>& p) const {
    const TaylorNet<Ball> c = shifted(power_, p[0], p[1]);
    ChartNet<Ball, 2> net;
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (i < 6) {
          net[6 * i][k] = i < 3 ? c[i + 3][k] : Ball(2) * c[i + 3][k];
        }
        if (i % 3 < 2) {
          net[6 * i + 2][k] = i % 3 == 0 ? c[i + 1][k] : Ball(2) * c[i + 1][k];
          net[6 * i][k] += p[2] * net[6 * i + 2][k];
        }
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Ball c22 = Ball(2) * c[8][k];
      add_product(net, 0, k, c[7][k], c[5][k], p[2], p[3]);
      add_product(net, 1, k, c22, Ball(), p[2], p[3]);
      add_product(net, 3, k, Ball(), c22, p[2], p[3]);
    }
    return net;
  }

 private:
  /// Adds (w + dw) (m + dm) (e + (m + dm) f) U^(i/3) V^(i%3), coordinate k.
  static void add_product(ChartNet<Ball, 2>& net, std::size_t i, std::size_t k, const Ball& e, const Ball& f,
                          const Ball& m, const Ball& w) {
    const Ball mf = m * f;
    const std::array<Ball, 3> in_m = {m * (e + mf), e + mf + mf, f};
    for (std::size_t j = 0; j < 3; ++j) {
      net[6 * i + 2 * j][k] += w * in_m[j];
      net[6 * i + 2 * j + 1][k] += in_m[j];
    }
  }

  template <std::size_t W>
  static void add(ChartNet<Ball, W>& net, std::array<std::size_t, 4> power, const Point& value) {
    const auto stride = chart_strides(W);
    BallVector<Ball>& entry =
        net[power[0] * stride[0] + power[1] * stride[1] + power[2] * stride[2] + power[3]];
    entry = {Ball::enclosing(value[0]), Ball::enclosing(value[1]), Ball::enclosing(value[2])};
  }

  void fill_equation(const ControlNet& c) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (i > 0) {
          add<2>(equation_, {i - 1, j, 0, 0}, Rational(i) * c[i][j]);
        }
        if (j > 0) {
          add<2>(equation_, {i, j - 1, 1, 0}, Rational(j) * c[i][j]);
        }
      }
    }
    add<2>(equation_, {0, 0, 1, 1}, c[2][1]);
    add<2>(equation_, {0, 1, 1, 1}, Rational(2) * c[2][2]);
    add<2>(equation_, {0, 0, 2, 1}, c[1][2]);
    add<2>(equation_, {1, 0, 2, 1}, Rational(2) * c[2][2]);
  }

  /// X = x + w (x_uu/2 + m x_uv + m^2 x_vv/2) + w^2 m^2 c22.
  void fill_space(const ControlNet& c) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        add<3>(space_, {i, j, 0, 0}, c[i][j]);
        if (i > 0 && j > 0) {
          add<3>(space_, {i - 1, j - 1, 1, 1}, Rational(i * j) * c[i][j]);
        }
      }
    }
    for (std::size_t j = 0; j < 3; ++j) {
      add<3>(space_, {0, j, 0, 1}, c[2][j]);
      add<3>(space_, {j, 0, 2, 1}, c[j][2]);
    }
    add<3>(space_, {0, 0, 2, 2}, c[2][2]);
  }

  Chart chart_;
  TaylorNet<Ball> power_;
  ChartNet<Ball, 2> equation_;
  ChartNet<Ball, 3> space_;
};

/// The Taylor coefficients of the same polynomial at p, in place.
template <class Ball, std::size_t W>
void shift(ChartNet<Ball, W>& net, const BallPoint<Ball>& p) {
  const auto stride = chart_strides(W);
  for (std::size_t j = 0; j < 4; ++j) {
    const std::size_t degree = j == 3 ? W - 1 : 2;
    for (std::size_t i = 0; i < net.size(); ++i) {
      if (exponent<W>(i, j) != 0) {
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        if (degree == 2) {
          Ball& c1 = net[i + stride[j]][c];
          const Ball upper = c1 + p[j] * net[i + 2 * stride[j]][c];
          net[i][c] += p[j] * upper;
          c1 = upper + p[j] * net[i + 2 * stride[j]][c];
        } else {
          net[i][c] += p[j] * net[i + stride[j]][c];
        }
      }
    }
  }
}

/// Encloses sqrt of every positive member; requires x.is_positive().
template <class Ball>
Ball square_root(const Ball& x) {
  // |sqrt x - s| = |x - s^2| / (sqrt x + s) <= |x - s^2| / s for s > 0.
  const double first = std::sqrt(x.approximation());
  Ball s(first);
  double error = (x - s * s).upper_magnitude() / first;
  for (int i = 0; i < 8; ++i) {
    const Ball next = (s + (x - s * s) * Ball(0.5 / first)).midpoint();
    const double finer = (x - next * next).upper_magnitude() / (first * (1 - 0x1p-30));
    if (!next.is_positive() || !(finer < 0.5 * error)) {
      break;
    }
    s = next;
    error = finer;
  }
  return s.widened(error * kSlack);
}

/// Encloses the reciprocals; requires a certain sign.
template <class Ball>
Ball reciprocal(const Ball& x) {
  // |1/x - y| = |1 - x y| / |x|.
  const double first = 1 / x.approximation();
  Ball y(first);
  double error = (Ball(1) - x * y).upper_magnitude();
  for (int i = 0; i < 8; ++i) {
    const Ball next = (y + y * (Ball(1) - x * y)).midpoint();
    const double finer = (Ball(1) - x * next).upper_magnitude();
    if (!(finer < 0.5 * error)) {
      break;
    }
    y = next;
    error = finer;
  }
  return y.widened(error / x.lower_magnitude() * kSlack);
}

/// The parameters (u1,v1,u2,v2) with t = sqrt w > 0; requires p[3].is_positive().
template <class Ball>
BallPoint<Ball> pair_of(Chart chart, const BallPoint<Ball>& p) {
  const Ball t = square_root(p[3]);
  const Ball mt = p[2] * t;
  return chart == Chart::first ? BallPoint<Ball>{p[0] + t, p[1] + mt, p[0] - t, p[1] - mt}
                               : BallPoint<Ball>{p[1] + mt, p[0] + t, p[1] - mt, p[0] - t};
}

/// The same point in the other chart; requires that m has a certain sign.
template <class Ball>
BallPoint<Ball> in_other_chart(const BallPoint<Ball>& p) {
  return {p[1], p[0], reciprocal(p[2]), p[2] * p[2] * p[3]};
}

/// (u2,v2,u1,v1).
template <class T>
std::array<T, 4> exchanged_pair(const std::array<T, 4>& p) {
  return {p[2], p[3], p[0], p[1]};
}

}  // namespace exsect

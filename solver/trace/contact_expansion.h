// The equations (F_a, F_b, T_k) = 0 of a curve along which the patches touch, as Taylor polynomials in all
// four parameters. Internal to solver/.
#pragma once

#include <cmath>

#include "trace/preconditioned_newton.h"

namespace exsect {

/// c[index(i,j,k,l)]: coefficient of a^i b^j c^k d^l, where a, b are the offsets in the parameters of the
/// patch that owns parameter `axis`, c and d those of the other patch; i, j in 0..2, k, l in 0..3.
template <class Ball>
struct ContactPolynomial {
  static constexpr std::size_t size = 144;
  static constexpr std::size_t index(std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return 48 * i + 16 * j + 4 * k + l;
  }
  std::array<Ball, size> c;
};

/// The parameter (0..3 for u, v, r, s) of the variables a, b, c, d.
inline std::array<std::size_t, 4> contact_variables(std::size_t axis) {
  return axis < 2 ? std::array<std::size_t, 4>{0, 1, 2, 3} : std::array<std::size_t, 4>{2, 3, 0, 1};
}

/// Calls f(term index, exponents) for every term.
template <class F>
void for_each_term(const F& f) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = 0; l < 4; ++l) {
          f(ContactPolynomial<double>::index(i, j, k, l), std::array<std::size_t, 4>{i, j, k, l});
        }
      }
    }
  }
}

/// x_u x x_v of a biquadratic Taylor net, of bidegree (3,3): [4 * k + l].
template <class Ball>
std::array<BallVector<Ball>, 16> normal_net(const TaylorNet<Ball>& net) {
  std::array<BallVector<Ball>, 16> n;
  for (std::size_t i = 1; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 1; l < 3; ++l) {
          const BallVector<Ball> product = cross(net[3 * i + j], net[3 * k + l]);
          const Ball factor = static_cast<double>(i * l);
          for (std::size_t c = 0; c < 3; ++c) {
            n[4 * (i - 1 + k) + j + l - 1][c] += factor * product[c];
          }
        }
      }
    }
  }
  return n;
}

/// T_k = +- D_o . N (Expansion::tangent), D_o the derivative by the other parameter of the patch that owns k,
/// N the normal of the other patch.
template <class Ball>
ContactPolynomial<Ball> tangent_component(const Expansion<Ball>& at, std::size_t k) {
  const TaylorNet<Ball>& own = k < 2 ? at.x : at.y;
  const auto n = normal_net(k < 2 ? at.y : at.x);
  const std::size_t o = 1 - k % 2;
  const double sign = k == 1 || k == 2 ? -1 : 1;
  ContactPolynomial<Ball> result;
  for (std::size_t i = o == 0 ? 1 : 0; i < 3; ++i) {
    for (std::size_t j = o == 1 ? 1 : 0; j < 3; ++j) {
      const Ball factor = sign * static_cast<double>(o == 0 ? i : j);
      const BallVector<Ball>& c = own[3 * i + j];
      const BallVector<Ball> d = {factor * c[0], factor * c[1], factor * c[2]};
      for (std::size_t m = 0; m < 16; ++m) {
        result.c[ContactPolynomial<Ball>::index(o == 0 ? i - 1 : i, o == 1 ? j - 1 : j, m / 4, m % 4)] =
            dot(d, n[m]);
      }
    }
  }
  return result;
}

/// A coordinate of F = x - y.
template <class Ball>
ContactPolynomial<Ball> coordinate_of_f(const Expansion<Ball>& at, std::size_t row, std::size_t axis) {
  const bool own_is_x = axis < 2;
  ContactPolynomial<Ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Ball x = at.x[3 * i + j][row];
      const Ball y = -at.y[3 * i + j][row];
      result.c[ContactPolynomial<Ball>::index(i, j, 0, 0)] += own_is_x ? x : y;
      result.c[ContactPolynomial<Ball>::index(0, 0, i, j)] += own_is_x ? y : x;
    }
  }
  return result;
}

/// The three equations, c[t][row] (straight_tube.h).
template <class Ball>
struct ContactEquations {
  using Number = Ball;
  std::size_t axis;
  std::array<BallVector<Ball>, ContactPolynomial<Ball>::size> c;

  template <class F>
  void for_each_term(const F& f) const {
    const auto variables = contact_variables(axis);
    exsect::for_each_term([&](std::size_t t, const std::array<std::size_t, 4>& e) {
      std::array<std::size_t, 4> exponents{};
      for (std::size_t v = 0; v < 4; ++v) exponents[variables[v]] = e[v];
      f(exponents, c[t]);
    });
  }
};

template <class Ball>
ContactEquations<Ball> contact_equations(const Expansion<Ball>& at, const std::array<std::size_t, 2>& rows,
                                         std::size_t axis) {
  const auto a = coordinate_of_f(at, rows[0], axis), b = coordinate_of_f(at, rows[1], axis),
             t = tangent_component(at, axis);
  ContactEquations<Ball> result{axis, {}};
  for (std::size_t i = 0; i < result.c.size(); ++i) result.c[i] = {a.c[i], b.c[i], t.c[i]};
  return result;
}

template <class Ball>
ContactEquations<Ball> preconditioned(const Matrix3& c, ContactEquations<Ball> phi) {
  for (BallVector<Ball>& coefficient : phi.c) coefficient = preconditioned(c, coefficient);
  return phi;
}

/// The first derivatives at the centre, by parameters.
template <class Ball>
std::array<BallVector<Ball>, 4> linear_part(const ContactEquations<Ball>& phi) {
  const auto variables = contact_variables(phi.axis);
  std::array<BallVector<Ball>, 4> result;
  constexpr std::array<std::size_t, 4> terms = {48, 16, 4, 1};
  for (std::size_t v = 0; v < 4; ++v) result[variables[v]] = phi.c[terms[v]];
  return result;
}

}  // namespace exsect

// The eliminant of a fibre, its first subresultant and the turning determinant, written once for every kind
// of number: docs/method.md, sections 3 and 4. Internal to solver/.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace exsect {

/// A polynomial with formal degree coefficients.size() - 1, constant term first; no coefficients: zero. T is
/// a commutative ring with operators +, -, * whose default value is zero.
template <class T>
struct FormalPolynomial {
  std::vector<T> coefficients;

  friend FormalPolynomial operator+(FormalPolynomial f, const FormalPolynomial& g) {
    if (f.coefficients.size() < g.coefficients.size()) f.coefficients.resize(g.coefficients.size());
    for (std::size_t i = 0; i < g.coefficients.size(); ++i)
      f.coefficients[i] = f.coefficients[i] + g.coefficients[i];
    return f;
  }
  friend FormalPolynomial operator-(FormalPolynomial f, const FormalPolynomial& g) {
    if (f.coefficients.size() < g.coefficients.size()) f.coefficients.resize(g.coefficients.size());
    for (std::size_t i = 0; i < g.coefficients.size(); ++i)
      f.coefficients[i] = f.coefficients[i] - g.coefficients[i];
    return f;
  }
  friend FormalPolynomial operator*(const FormalPolynomial& f, const FormalPolynomial& g) {
    FormalPolynomial product;
    if (f.coefficients.empty() || g.coefficients.empty()) return product;
    product.coefficients.resize(f.coefficients.size() + g.coefficients.size() - 1);
    for (std::size_t i = 0; i < f.coefficients.size(); ++i)
      for (std::size_t j = 0; j < g.coefficients.size(); ++j)
        product.coefficients[i + j] = product.coefficients[i + j] + f.coefficients[i] * g.coefficients[j];
    return product;
  }
};

template <class T>
using SpaceVector = std::array<T, 3>;

template <class T>
SpaceVector<T> cross_product(const SpaceVector<T>& a, const SpaceVector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
T dot_product(const SpaceVector<T>& a, const SpaceVector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
FormalPolynomial<T> dot_product(const SpaceVector<T>& a, const SpaceVector<FormalPolynomial<T>>& f) {
  const auto term = [&](std::size_t k) { return FormalPolynomial<T>{{a[k]}} * f[k]; };
  return term(0) + term(1) + term(2);
}

/// One line x(u,v) = a[0] + a[1] v + a[2] v^2, at a fixed or a symbolic u, and y = sum y[i][j] r^i s^j (4.1).
template <class T>
struct FibreCoefficients {
  std::array<SpaceVector<T>, 3> a;
  std::array<std::array<SpaceVector<T>, 3>, 3> y;

  /// The same with r and s exchanged.
  FibreCoefficients exchanged() const {
    FibreCoefficients result = *this;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) result.y[i][j] = y[j][i];
    return result;
  }
};

/// The polynomials in s of docs/method.md, section 4: the plane P = pa r^2 + pb r + pc and the brackets
/// a_i . (w_j x w_k), where y - a_0 = w_0 + w_1 r + w_2 r^2.
template <class T>
struct FibreForms {
  SpaceVector<T> n;  // a_1 x a_2
  std::array<SpaceVector<FormalPolynomial<T>>, 3> w;
  FormalPolynomial<T> pa, pb, pc;
  FormalPolynomial<T> la, lb, lc;  // a_2 . (w_0 x w_2), a_2 . (w_1 x w_2), a_2 . (w_0 x w_1)
  FormalPolynomial<T> ma, mb, mc;  // the same with a_1

  explicit FibreForms(const FibreCoefficients<T>& f) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) w[i][k].coefficients = {f.y[i][0][k], f.y[i][1][k], f.y[i][2][k]};
    for (std::size_t k = 0; k < 3; ++k) w[0][k].coefficients[0] = w[0][k].coefficients[0] - f.a[0][k];
    n = cross_product(f.a[1], f.a[2]);
    pa = dot_product(n, w[2]);
    pb = dot_product(n, w[1]);
    pc = dot_product(n, w[0]);
    const auto w02 = cross_product(w[0], w[2]);
    const auto w12 = cross_product(w[1], w[2]);
    const auto w01 = cross_product(w[0], w[1]);
    la = dot_product(f.a[2], w02);
    lb = dot_product(f.a[2], w12);
    lc = dot_product(f.a[2], w01);
    ma = dot_product(f.a[1], w02);
    mb = dot_product(f.a[1], w12);
    mc = dot_product(f.a[1], w01);
  }
};

/// R = Res_r(P, zeta) and S1 with A^3 zeta = S1 r + S0 modulo P, of formal degrees 16 and 10 (4.4).
template <class T>
struct FibreEliminant {
  FormalPolynomial<T> r;
  FormalPolynomial<T> s1;
};

template <class T>
FibreEliminant<T> fibre_eliminant(const FibreForms<T>& f) {
  const auto rl = f.la * f.la - f.lb * f.lc;
  const auto rm = f.ma * f.ma - f.mb * f.mc;
  const auto two_la = f.la + f.la;
  const auto pml = two_la * f.ma - f.lb * f.mc - f.mb * f.lc;
  const auto pul = two_la * f.pa - f.lb * f.pb;
  const auto pmu = (f.ma + f.ma) * f.pa - f.mb * f.pb;
  return {f.pa * f.pa * rm - pml * pul + rl * pmu + rl * rl,
          f.pa * (f.pa * f.mb - two_la * f.lb) + f.pb * (f.lb * f.lb)};
}

template <class T>
T multiple(std::size_t factor, const T& a) {
  T sum = a;
  for (std::size_t i = 1; i < factor; ++i) sum = sum + a;
  return sum;
}

/// a . (y_r x y_s), as in (4.2), a polynomial of bidegree (3,3): the coefficient of r^p s^q at index 4 p + q.
template <class T>
std::vector<T> normal_form(const FibreCoefficients<T>& f, const SpaceVector<T>& a) {
  std::vector<T> result(16);
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t l = 0; l < 3; ++l)
        for (std::size_t m = 1; m < 3; ++m) {
          T& sum = result[4 * (i + l - 1) + j + m - 1];
          sum = sum + multiple(i * m, dot_product(a, cross_product(f.y[i][j], f.y[l][m])));
        }
  return result;
}

/// n_k J for k = 0, 1, 2, J = x_v . (y_r x y_s) with v from the axis k, a polynomial of bidegree (5,5): the
/// coefficient of r^p s^q at index 6 p + q (4.14).
template <class T>
std::array<std::vector<T>, 3> turning_forms(const FibreCoefficients<T>& f) {
  const SpaceVector<T> n = cross_product(f.a[1], f.a[2]);
  const std::vector<T> d1 = normal_form(f, f.a[1]);
  const std::vector<T> d2 = normal_form(f, f.a[2]);
  std::array<std::vector<T>, 3> result;
  result.fill(std::vector<T>(36));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      SpaceVector<T> w = f.y[i][j];
      if (i + j == 0)
        for (std::size_t c = 0; c < 3; ++c) w[c] = w[c] - f.a[0][c];
      const SpaceVector<T> moment = cross_product(w, f.a[2]);
      for (std::size_t k = 0; k < 3; ++k) {
        const T twice = moment[k] + moment[k];
        for (std::size_t p = 0; p < 4; ++p)
          for (std::size_t q = 0; q < 4; ++q) {
            T& sum = result[k][6 * (p + i) + q + j];
            sum = sum + twice * d2[4 * p + q];
            if (i + j == 0) sum = sum + n[k] * d1[4 * p + q];
          }
      }
    }
  return result;
}

}  // namespace exsect

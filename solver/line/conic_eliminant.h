// The closed formula for the eliminant of a conic parameter line with a patch, for integers and for balls.
#pragma once

#include <exsect/algebra/rational.h>

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>

namespace exsect {

/// docs/method.md, section 9, in any ring of numbers: Scalar has +=, -=, *, unary -, and the value 0 of int.
template <class Scalar>
class ConicEliminant {
 public:
  /// A polynomial in s, constant term first, of formal degree size - 1.
  using Form = boost::container::static_vector<Scalar, 17>;
  using FormVector = std::array<Form, 3>;
  using Vector = std::array<Scalar, 3>;

  Form a;  // the pull-back of the plane is A r^2 + B r + C
  Form b;
  Form c;
  Form eliminant;  // of degree 16
  Form s1;         // over a root of the eliminant r = -s0/s1, t = -t_numerator/s1
  Form s0;
  Form t_numerator;

  /// Of the line a0 + a1 t + a2 t^2; w[i] is the coefficient of r^i in y - a0.
  ConicEliminant(const Vector& a1, const Vector& a2, const std::array<FormVector, 3>& w) {
    const Vector n = cross(a1, a2);
    a = dot(n, w[2]);
    b = dot(n, w[1]);
    c = dot(n, w[0]);
    const FormVector w02 = cross(w[0], w[2]);
    const FormVector w12 = cross(w[1], w[2]);
    const FormVector w01 = cross(w[0], w[1]);
    Form la = dot(a2, w02);
    const Form lb = dot(a2, w12);
    const Form lc = dot(a2, w01);
    Form ma = dot(a1, w02);
    const Form mb = dot(a1, w12);
    const Form mc = dot(a1, w01);

    const Form aa = square(a);
    const Form lala = square(la);
    const Form lblb = square(lb);
    Form rl = lala;
    subtract_product(rl, lb, lc);
    Form rm = square(ma);
    subtract_product(rm, mb, mc);
    const Form lamb_lbma = determinant(la, mb, lb, ma);
    s0 = determinant(aa, ma, a, lala);  // A (A Ma - La^2) + C Lb^2
    add_product(s0, c, lblb);
    double_form(la);
    Form pml = product(la, ma);
    subtract_product(pml, lb, mc);
    subtract_product(pml, mb, lc);
    const Form pul = determinant(la, a, lb, b);
    double_form(ma);
    const Form pmu = determinant(ma, a, mb, b);

    eliminant = square(rl);  // aa rm - pml pul + rl pmu + rl^2
    add_product(eliminant, aa, rm);
    subtract_product(eliminant, pml, pul);
    add_product(eliminant, rl, pmu);
    s1 = product(b, lblb);  // A (A Mb - 2 La Lb) + B Lb^2
    add_product(s1, a, determinant(a, mb, la, lb));
    t_numerator = determinant(a, lamb_lbma, lb, rl);
  }

  static Vector cross(const Vector& f, const Vector& g) {
    return {minor(f, g, 1, 2), minor(f, g, 2, 0), minor(f, g, 0, 1)};
  }

 private:
  static void accumulate(Scalar& sum, const Scalar& f, const Scalar& g) { sum += f * g; }
  static void accumulate_negative(Scalar& sum, const Scalar& f, const Scalar& g) { sum -= f * g; }

  static Scalar minor(const Vector& f, const Vector& g, std::size_t i, std::size_t j) {
    Scalar result = f[i] * g[j];
    accumulate_negative(result, f[j], g[i]);
    return result;
  }
  static void add_product(Form& sum, const Form& f, const Form& g) {
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < g.size(); ++j) accumulate(sum[i + j], f[i], g[j]);
  }
  static void subtract_product(Form& sum, const Form& f, const Form& g) {
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < g.size(); ++j) accumulate_negative(sum[i + j], f[i], g[j]);
  }
  static void double_form(Form& f) {
    for (Scalar& x : f) x += Scalar(x);
  }
  /// Zero, for sums of products of coefficients as long as those of f and g.
  static Form zero_for(const Form&, const Form&, std::size_t size) { return Form(size, Scalar(0)); }

  static Form product(const Form& f, const Form& g) {
    Form result = zero_for(f, g, f.size() + g.size() - 1);
    add_product(result, f, g);
    return result;
  }
  static Form square(const Form& f) {
    Form result = zero_for(f, f, 2 * f.size() - 1);
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) accumulate(result[i + j], f[i], f[j]);
    double_form(result);
    for (std::size_t i = 0; i < f.size(); ++i) accumulate(result[2 * i], f[i], f[i]);
    return result;
  }
  /// f g - p q.
  static Form determinant(const Form& f, const Form& g, const Form& p, const Form& q) {
    Form result = zero_for(f, g, std::max(f.size() + g.size(), p.size() + q.size()) - 1);
    add_product(result, f, g);
    subtract_product(result, p, q);
    return result;
  }
  static FormVector cross(const FormVector& f, const FormVector& g) {
    return {determinant(f[1], g[2], f[2], g[1]), determinant(f[2], g[0], f[0], g[2]),
            determinant(f[0], g[1], f[1], g[0])};
  }
  static Form dot(const Vector& n, const FormVector& f) {
    Form sum(f[0].size(), Scalar(0));
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < f[k].size(); ++i) accumulate(sum[i], n[k], f[k][i]);
    return sum;
  }
};

// Integers, without temporaries.

template <>
inline void ConicEliminant<Integer>::accumulate(Integer& sum, const Integer& f, const Integer& g) {
  mpz_addmul(sum.backend().data(), f.backend().data(), g.backend().data());
}
template <>
inline void ConicEliminant<Integer>::accumulate_negative(Integer& sum, const Integer& f, const Integer& g) {
  mpz_submul(sum.backend().data(), f.backend().data(), g.backend().data());
}
template <>
inline ConicEliminant<Integer>::Form ConicEliminant<Integer>::zero_for(const Form& f, const Form& g,
                                                                       std::size_t size) {
  Form result(size);
  const std::size_t limbs = mpz_size(f.front().backend().data()) + mpz_size(g.front().backend().data()) + 1;
  for (Integer& x : result) mpz_realloc2(x.backend().data(), limbs * GMP_NUMB_BITS);
  return result;
}

}  // namespace exsect

#include "line_forms.h"

#include <exsect/algebra/fixed_point_interval.h>

#include <algorithm>
#include <array>
#include <vector>

namespace exsect {
namespace {

/// A polynomial in s with integer coefficients, constant term first, of formal degree size - 1.
using Form = std::vector<Integer>;
using FormVector = std::array<Form, 3>;

mpz_ptr raw(Integer& a) { return a.backend().data(); }
mpz_srcptr raw(const Integer& a) { return a.backend().data(); }

void add_product(Form& sum, const Form& f, const Form& g) {
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j) mpz_addmul(raw(sum[i + j]), raw(f[i]), raw(g[j]));
}

void subtract_product(Form& sum, const Form& f, const Form& g) {
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j) mpz_submul(raw(sum[i + j]), raw(f[i]), raw(g[j]));
}

void add_multiple(Form& sum, const Integer& a, const Form& f) {
  for (std::size_t i = 0; i < f.size(); ++i) mpz_addmul(raw(sum[i]), raw(a), raw(f[i]));
}

void double_form(Form& f) {
  for (Integer& c : f) mpz_mul_2exp(raw(c), raw(c), 1);
}

/// Zero, with memory for sums of products of coefficients as long as those of f and g.
Form zero_for(const Form& f, const Form& g, std::size_t size) {
  Form result(size);
  const std::size_t limbs = mpz_size(raw(f.front())) + mpz_size(raw(g.front())) + 1;
  for (Integer& c : result) mpz_realloc2(raw(c), limbs * GMP_NUMB_BITS);
  return result;
}

Form product(const Form& f, const Form& g) {
  Form result = zero_for(f, g, f.size() + g.size() - 1);
  add_product(result, f, g);
  return result;
}

Form square(const Form& f) {
  Form result = zero_for(f, f, 2 * f.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) mpz_addmul(raw(result[i + j]), raw(f[i]), raw(f[j]));
  double_form(result);
  for (std::size_t i = 0; i < f.size(); ++i) mpz_addmul(raw(result[2 * i]), raw(f[i]), raw(f[i]));
  return result;
}

/// f g - p q.
Form determinant(const Form& f, const Form& g, const Form& p, const Form& q) {
  Form result = zero_for(f, g, std::max(f.size() + g.size(), p.size() + q.size()) - 1);
  add_product(result, f, g);
  subtract_product(result, p, q);
  return result;
}

FormVector cross(const FormVector& a, const FormVector& b) {
  return {determinant(a[1], b[2], a[2], b[1]), determinant(a[2], b[0], a[0], b[2]),
          determinant(a[0], b[1], a[1], b[0])};
}

Form dot(const IntegerVector& n, const FormVector& a) {
  Form sum(a[0].size());
  for (std::size_t k = 0; k < 3; ++k) add_multiple(sum, n[k], a[k]);
  return sum;
}

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// w[i]: the coefficient of r^i in weight y - a0.
std::array<FormVector, 3> coefficients_of_r(const IntegerLineAndPatch& problem) {
  std::array<FormVector, 3> w;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 3; ++j) w[i][k].push_back(problem.line.weight * problem.patch[i][j][k]);
      if (i == 0) w[i][k][0] -= problem.line.a[0][k];
    }
  return w;
}

}  // namespace

ConicForms conic_forms(const IntegerLineAndPatch& problem) {
  const IntegerVector& a1 = problem.line.a[1];
  const IntegerVector& a2 = problem.line.a[2];
  const std::array<FormVector, 3> w = coefficients_of_r(problem);
  const IntegerVector n = cross(a1, a2);
  const Form a = dot(n, w[2]);
  const Form b = dot(n, w[1]);
  const Form c = dot(n, w[0]);
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
  Form s0 = determinant(aa, ma, a, lala);  // A (A Ma - La^2) + C Lb^2
  add_product(s0, c, lblb);
  double_form(la);
  Form pml = product(la, ma);
  subtract_product(pml, lb, mc);
  subtract_product(pml, mb, lc);
  const Form pul = determinant(la, a, lb, b);
  double_form(ma);
  const Form pmu = determinant(ma, a, mb, b);

  Form eliminant = square(rl);  // aa rm - pml pul + rl pmu + rl^2
  add_product(eliminant, aa, rm);
  subtract_product(eliminant, pml, pul);
  add_product(eliminant, rl, pmu);
  Form s1 = product(b, lblb);  // A (A Mb - 2 La Lb) + B Lb^2
  add_product(s1, a, determinant(a, mb, la, lb));
  const Form t_numerator = determinant(a, lamb_lbma, lb, rl);
  return {polynomial_of(a),  polynomial_of(b),  polynomial_of(c),          polynomial_of(eliminant),
          polynomial_of(s1), polynomial_of(s0), polynomial_of(t_numerator)};
}

}  // namespace exsect

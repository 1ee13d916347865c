#include "fibre_projection.h"

#include <exsect/algebra/bivariate_polynomial.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace exsect {

namespace {

bool is_zero(const SpaceVector<Polynomial>& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

void trim(FibrePolynomial& f) {
  while (!f.coefficients.empty() && f.coefficients.back().is_zero()) f.coefficients.pop_back();
}

/// R and S1 where y has degree 2 in r but P = B r + C, B != 0 (4.15d): from an axis k with n_k != 0,
/// n_k^2 zeta = n_k mu - lambda^2 of degree 2 or 4 in r at r = -C/B.
FibreEliminant<Polynomial> flat_eliminant(const FibreCoefficients<Polynomial>& f,
                                          const FibreForms<Polynomial>& forms) {
  std::size_t k = 0;
  while (forms.n[k].is_zero()) ++k;
  const std::size_t p = (k + 1) % 3;
  const std::size_t q = (k + 2) % 3;
  std::array<FibrePolynomial, 3> lambda;
  std::array<FibrePolynomial, 3> mu;
  for (std::size_t i = 0; i < 3; ++i) {
    lambda[i] = forms.w[i][p] * FibrePolynomial{{f.a[2][q]}} - forms.w[i][q] * FibrePolynomial{{f.a[2][p]}};
    mu[i] = forms.w[i][q] * FibrePolynomial{{f.a[1][p]}} - forms.w[i][p] * FibrePolynomial{{f.a[1][q]}};
  }
  const FibrePolynomial n{{forms.n[k]}};
  const FibrePolynomial& b = forms.pb;
  const FibrePolynomial& c = forms.pc;
  const FibrePolynomial mu_value = mu[0] * b * b - mu[1] * b * c + mu[2] * c * c;  // B^2 mu(-C/B)
  if (is_zero(lambda[2])) {
    const FibrePolynomial lambda_value = lambda[0] * b - lambda[1] * c;
    return {n * mu_value - lambda_value * lambda_value, n * n * b};
  }
  const FibrePolynomial lambda_value = lambda[0] * b * b - lambda[1] * b * c + lambda[2] * c * c;
  return {n * b * b * mu_value - lambda_value * lambda_value, n * n * b * b * b};
}

bool is_straight(const FibreCoefficients<Polynomial>& f) { return is_zero(f.a[2]); }

bool is_linear_in_r(const FibreCoefficients<Polynomial>& f) {
  return is_zero(f.y[2][0]) && is_zero(f.y[2][1]) && is_zero(f.y[2][2]);
}

/// The eliminant where y is linear in r (4.15a, b).
FibrePolynomial linear_eliminant(const FibreCoefficients<Polynomial>& f,
                                 const FibreForms<Polynomial>& forms) {
  if (is_straight(f)) return forms.mc;
  return forms.mc * forms.pb - forms.lc * forms.lc;
}

/// R and S1 by the degrees in r that the two equations of the fibre really have.
FibreEliminant<Polynomial> eliminant(const FibreCoefficients<Polynomial>& f,
                                     const FibreForms<Polynomial>& forms) {
  const FibrePolynomial one{{Polynomial(1)}};
  if (is_straight(f)) {
    if (is_zero(forms.ma) && is_zero(forms.mb)) {
      // y is linear in r modulo a_1, or constant: then a fibre with one point has infinitely many, and R in
      // the other parameter says so.
      if (is_zero(forms.mc)) return {one, {}};
      return {forms.mc, one};  // (4.15a)
    }
    return {forms.ma * forms.ma - forms.mb * forms.mc, forms.mb};  // (4.15c)
  }
  if (is_zero(forms.pa) && is_zero(forms.pb)) {
    // P = C(s): at most four points over each root. No S1: only the other projection can separate them.
    const FibrePolynomial square = forms.pc * forms.pc;
    return {square * square, {}};
  }
  if (is_linear_in_r(f)) return {linear_eliminant(f, forms), forms.pb};  // (4.15b)
  if (is_zero(forms.pa)) return flat_eliminant(f, forms);                // (4.15d)
  return fibre_eliminant(forms);
}

/// f / q for constant coefficients of q, or nothing if q does not divide f.
std::optional<FibrePolynomial> quotient_if_exact(FibrePolynomial f, const Polynomial& q) {
  const auto n = static_cast<std::size_t>(q.degree());
  if (f.coefficients.size() <= n) return std::nullopt;
  FibrePolynomial quotient;
  quotient.coefficients.resize(f.coefficients.size() - n);
  for (std::size_t i = quotient.coefficients.size(); i-- > 0;) {
    const Polynomial c = f.coefficients[i + n] * Polynomial(1 / q.leading_coefficient());
    quotient.coefficients[i] = c;
    for (std::size_t j = 0; j <= n; ++j)
      f.coefficients[i + j] -= c * Polynomial(q.coefficient(static_cast<int>(j)));
  }
  if (!is_zero(f)) return std::nullopt;
  return quotient;
}

/// The common factor in Q[s] of the coordinates of the coefficient of r^2 in y: at its roots r = infinity may
/// belong to every fibre.
Polynomial points_at_infinity(const FibreCoefficients<Polynomial>& f) {
  Polynomial q;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Rational> coordinate;
    for (std::size_t j = 0; j < 3; ++j) coordinate.push_back(f.y[2][j][k].coefficient(0));
    q = gcd(q, Polynomial(coordinate));
  }
  return q;
}

FibrePolynomial constant_in_u(const Polynomial& f) {
  FibrePolynomial result;
  for (const auto& c : f.coefficients()) result.coefficients.emplace_back(c);
  return result;
}

/// Divides by the greatest common divisor of the coefficients, which is returned, and makes the quotient
/// primitive in Z[u][s].
Polynomial remove_content(FibrePolynomial& f) {
  Polynomial content;
  for (const auto& c : f.coefficients) content = gcd(content, c);
  Integer common_denominator = 1;
  for (auto& c : f.coefficients) {
    c = exact_quotient(c, content);
    for (const auto& a : c.coefficients())
      common_denominator = lcm(common_denominator, Integer(denominator(a)));
  }
  for (auto& c : f.coefficients) c *= Polynomial(Rational(common_denominator));
  Integer common_factor = 0;
  for (const auto& a : integer_coefficients(f)) common_factor = gcd(common_factor, a);
  for (auto& c : f.coefficients) c *= Polynomial(Rational(1, common_factor));
  return content;
}

}  // namespace

bool is_zero(const FibrePolynomial& f) {
  return std::all_of(f.coefficients.begin(), f.coefficients.end(),
                     [](const Polynomial& c) { return c.is_zero(); });
}

FibrePolynomial derivative(const FibrePolynomial& f) {
  FibrePolynomial result;
  for (std::size_t i = 1; i < f.coefficients.size(); ++i)
    result.coefficients.push_back(f.coefficients[i] * Polynomial(static_cast<int>(i)));
  return result;
}

bool coprime(const FibrePolynomial& f, const FibrePolynomial& g) {
  return gcd(BivariatePolynomial(f.coefficients), BivariatePolynomial(g.coefficients)).degree_r() == 0;
}

std::vector<Integer> integer_coefficients(const FibrePolynomial& f) {
  std::vector<Integer> result;
  for (const auto& polynomial : f.coefficients)
    for (const auto& c : polynomial.coefficients()) result.push_back(Integer(numerator(c)));
  return result;
}

FibreCoefficients<Polynomial> symbolic_fibre(const IntegerPair& pair) {
  FibreCoefficients<Polynomial> f;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      f.a[j][k] =
          Polynomial({Rational(pair.x[0][j][k]), Rational(pair.x[1][j][k]), Rational(pair.x[2][j][k])});
      for (std::size_t i = 0; i < 3; ++i) f.y[i][j][k] = Rational(pair.y[i][j][k]);
    }
  return f;
}

FibreProjection project_fibre(const FibreCoefficients<Polynomial>& f) {
  const FibreForms<Polynomial> forms(f);
  FibreProjection result;
  auto [r, s1] = eliminant(f, forms);
  trim(r);
  trim(s1);
  result.r = r;
  result.s1 = s1;
  result.complete = true;
  if (is_zero(r)) return result;
  const Polynomial q = points_at_infinity(f);
  if (q.degree() > 0) {
    // At a root of q the patch is linear in r; a finite point of the fibre there is a root of the linear
    // eliminant.
    const FibrePolynomial linear = linear_eliminant(f, forms);
    result.complete = !is_zero(linear) && coprime(constant_in_u(q), linear);
    if (result.complete)
      while (const auto quotient = quotient_if_exact(r, q)) r = *quotient;
  }
  result.content = remove_content(r);
  result.finite = std::move(r);
  return result;
}

}  // namespace exsect

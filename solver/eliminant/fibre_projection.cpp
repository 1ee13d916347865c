#include "eliminant/fibre_projection.h"

#include <exsect/algebra/bivariate_polynomial.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace exsect {

namespace {

void trim(FibrePolynomial& f) {
  while (!f.coefficients.empty() && f.coefficients.back().is_zero()) f.coefficients.pop_back();
}

using Vector = SpaceVector<Polynomial>;
using FormVector = SpaceVector<FibrePolynomial>;

FibrePolynomial one() { return {{Polynomial(1)}}; }

bool is_zero(const FormVector& w) { return is_zero(w[0]) && is_zero(w[1]) && is_zero(w[2]); }

FormVector cross_product(const Vector& a, const FormVector& w) {
  FormVector b;
  for (std::size_t k = 0; k < 3; ++k) b[k] = {{a[k]}};
  return cross_product(b, w);
}

/// pi and zeta at r = -C/B (4.17): lambda and mu stand for n_k times those of (1.3).
class PlaneRoot {
 public:
  PlaneRoot(const FibreCoefficients<Polynomial>& f, const FibreForms<Polynomial>& forms) : forms_(forms) {
    std::size_t k = 0;
    while (forms.n[k].is_zero()) ++k;
    n_ = {{forms.n[k]}};
    for (std::size_t i = 0; i < 3; ++i) {
      lambda_[i] = FibrePolynomial{} - cross_product(f.a[2], forms.w[i])[k];
      mu_[i] = cross_product(f.a[1], forms.w[i])[k];
    }
  }
  bool lambda_is_linear() const { return is_zero(lambda_[2]); }
  /// B^2 (n_k mu - lambda^2) without the square term of lambda.
  FibreEliminant<Polynomial> quadratic() const {
    const FibrePolynomial lambda = lambda_[0] * forms_.pb - lambda_[1] * forms_.pc;
    return {n_ * mu() - lambda * lambda, n_ * n_ * forms_.pb};
  }
  /// B^4 (n_k mu - lambda^2).
  FibreEliminant<Polynomial> quartic() const {
    const FibrePolynomial& b = forms_.pb;
    const FibrePolynomial& c = forms_.pc;
    const FibrePolynomial lambda = lambda_[0] * b * b - lambda_[1] * b * c + lambda_[2] * c * c;
    return {n_ * b * b * mu() - lambda * lambda, n_ * n_ * b * b * b};
  }

 private:
  FibrePolynomial mu() const {  // B^2 mu
    const FibrePolynomial& b = forms_.pb;
    const FibrePolynomial& c = forms_.pc;
    return mu_[0] * b * b - mu_[1] * b * c + mu_[2] * c * c;
  }

  const FibreForms<Polynomial>& forms_;
  FibrePolynomial n_;
  std::array<FibrePolynomial, 3> lambda_;
  std::array<FibrePolynomial, 3> mu_;
};

/// The fibre's two equations in r.
struct Equations {
  FibreEliminant<Polynomial> eliminant;
  /// The vector of polynomials in s that vanishes where r = infinity solves both; empty if that is not used.
  std::optional<FormVector> at_infinity;
  /// Where at_infinity vanishes, the fibre can have a finite point only if all of these vanish.
  std::vector<FibrePolynomial> finite_there;
};

Equations straight_equations(const FibreCoefficients<Polynomial>& f, const FibreForms<Polynomial>& forms) {
  const auto along = [&](std::size_t i) { return cross_product(f.a[1], forms.w[i]); };
  if (!is_zero(along(2)))  // (4.17b)
    return {{forms.ma * forms.ma - forms.mb * forms.mc, forms.mb}, along(2), {forms.mc}};
  // Where y is constant in r modulo a_1, a fibre with one point has infinitely many, and R in the other
  // parameter says so.
  if (is_zero(along(1))) return {{one(), {}}, {}, {}};
  const FormVector constant = along(0);
  return {{forms.mc, one()}, along(1), {constant.begin(), constant.end()}};  // (4.17a)
}

Equations conic_equations(const FibreCoefficients<Polynomial>& f, const FibreForms<Polynomial>& forms) {
  const auto along = [&](std::size_t i) { return cross_product(f.a[2], forms.w[i]); };
  if (is_zero(forms.pa) && is_zero(forms.pb)) {
    // P = C(s): at most four points over each root. No S1: only the other projection can separate them.
    const FibrePolynomial square = forms.pc * forms.pc;
    return {{square * square, {}}, {}, {}};
  }
  if (is_zero(forms.w[2]))  // (4.17c)
    return {{forms.mc * forms.pb - forms.lc * forms.lc, forms.pb}, along(1), {forms.pc}};
  const PlaneRoot root(f, forms);
  if (!is_zero(forms.pa)) return {fibre_eliminant(forms), along(2), {root.quadratic().r}};
  return {root.lambda_is_linear() ? root.quadratic() : root.quartic(), {}, {}};  // (4.17d, e)
}

BivariatePolynomial bivariate(const FibrePolynomial& f) { return BivariatePolynomial(f.coefficients); }

/// The common factor of the three, primitive as a polynomial in s over Q[u].
BivariatePolynomial common_factor(const FormVector& w) {
  const BivariatePolynomial factor = gcd(gcd(bivariate(w[0]), bivariate(w[1])), bivariate(w[2]));
  Polynomial content;
  for (int i = 0; i <= factor.degree_r(); ++i) content = gcd(content, factor.coefficient(i));
  return exact_quotient(factor, BivariatePolynomial({content}));
}

FibrePolynomial fibre_polynomial(const BivariatePolynomial& f) {
  FibrePolynomial result;
  for (int i = 0; i <= f.degree_r(); ++i) result.coefficients.push_back(f.coefficient(i));
  return result;
}

/// f without all factors that it has in common with a power of g.
FibrePolynomial without_factors(const FibrePolynomial& f, const BivariatePolynomial& g) {
  BivariatePolynomial rest = bivariate(f);
  for (BivariatePolynomial factor = gcd(rest, g); factor.degree_r() > 0; factor = gcd(rest, g))
    rest = exact_quotient(rest, factor);
  return fibre_polynomial(rest);
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
  return gcd(bivariate(f), bivariate(g)).degree_r() == 0;
}

FibreFactors split_multiple(const FibrePolynomial& f) {
  const BivariatePolynomial whole = bivariate(f);
  const BivariatePolynomial repeated = gcd(whole, bivariate(derivative(f)));
  const BivariatePolynomial squarefree = exact_quotient(whole, repeated);
  const BivariatePolynomial multiple = gcd(squarefree, repeated);
  FibreFactors result{fibre_polynomial(exact_quotient(squarefree, multiple)), fibre_polynomial(multiple)};
  remove_content(result.simple);
  remove_content(result.multiple);
  return result;
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
  const bool straight = f.a[2][0].is_zero() && f.a[2][1].is_zero() && f.a[2][2].is_zero();
  auto [eliminant, at_infinity, finite_there] =
      straight ? straight_equations(f, forms) : conic_equations(f, forms);
  trim(eliminant.r);
  trim(eliminant.s1);
  FibreProjection result{eliminant.r, eliminant.s1, eliminant.r, {}, true};
  if (is_zero(eliminant.r)) return result;
  const BivariatePolynomial infinite =
      at_infinity ? common_factor(*at_infinity) : BivariatePolynomial::constant(1);
  if (infinite.degree_r() > 0) {
    result.complete = std::any_of(finite_there.begin(), finite_there.end(), [&](const FibrePolynomial& g) {
      return !is_zero(g) && gcd(infinite, bivariate(g)).degree_r() == 0;
    });
    if (result.complete) result.finite = without_factors(result.finite, infinite);
  }
  result.content = remove_content(result.finite);
  return result;
}

}  // namespace exsect

#include "fibre_polynomial.h"

#include <algorithm>
#include <utility>

#include "determinant.h"
#include "flint_polynomial.h"
#include "quadratic_refinement.h"
#include "resultant.h"
#include "triangular_point.h"

namespace exsect {
namespace {

/// Narrow enough for almost every sign to be decided by an enclosure.
RealAlgebraic narrowed(const RealAlgebraic& s) { return s.refined_to(power_of_two(-64)); }

BivariatePolynomial in_r(const Polynomial& f) {
  std::vector<Polynomial> coefficients;
  for (const Rational& c : f.coefficients()) coefficients.emplace_back(c);
  return BivariatePolynomial(std::move(coefficients));
}

/// The coefficients modulo the polynomial of s; a leading one may vanish at s.
std::vector<Polynomial> remainders(const BivariatePolynomial& f, const RealAlgebraic& s) {
  std::vector<Polynomial> result;
  for (int i = 0; i <= f.degree_r(); ++i) {
    Polynomial c = f.coefficient(i);
    if (c.degree() >= s.polynomial().degree()) c = divide(c, s.polynomial()).remainder;
    result.push_back(std::move(c));
  }
  return result;
}

/// Euclid's algorithm in balls: f and g become the last two remainders, the second one constant. Every
/// leading coefficient that was divided by is certainly not 0. False if one is not.
bool reach_constant(FlintBallPolynomial& f, FlintBallPolynomial& g, slong precision) {
  FlintBallPolynomial quotient, remainder;
  while (arb_poly_length(g.value) > 1) {
    // Refused if the leading coefficient of g is not certainly nonzero.
    if (!arb_poly_divrem(quotient.value, remainder.value, f.value, g.value, precision)) return false;
    arb_poly_swap(f.value, g.value);
    arb_poly_swap(g.value, remainder.value);
  }
  return true;
}

bool is_certainly_nonzero(const FlintBallPolynomial& constant) {
  return arb_poly_length(constant.value) == 1 &&
         !arb_contains_zero(arb_poly_get_coeff_ptr(constant.value, 0));
}

/// True proves that f(., s) and g(., s) have no common root; false proves nothing.
bool coprime_in_balls(const BivariatePolynomial& f, const BivariatePolynomial& g, const RealAlgebraic& s) {
  constexpr slong precision = 128;
  FlintBallPolynomial a, b;
  enclose(a.value, f, s, precision);
  enclose(b.value, g, s, precision);
  return reach_constant(a, b, precision) && is_certainly_nonzero(b);
}

/// gcd of f and g, reduced at s and not constant: the subresultant of the least index j whose coefficient of
/// r^j does not vanish at s. (Subresultants are determinants in the coefficients and the degrees are those at
/// s, so they are those of f(., s) and g(., s).) If none is left, the polynomial of lower degree divides the
/// other.
BivariatePolynomial gcd_of_reduced(const BivariatePolynomial& f, const BivariatePolynomial& g,
                                   const RealAlgebraic& s) {
  if (coprime_in_balls(f, g, s)) return BivariatePolynomial::constant(1);
  const BivariatePolynomial a = primitive(f), b = primitive(g);
  const int degree = std::min(f.degree_r(), g.degree_r());
  int j = 0;
  Polynomial principal;
  for (; j < degree; ++j) {
    principal = j == 0 ? resultant_r(a, b) : subresultant_coefficient_r(a, b, j, j);
    if (sign_at(principal, s) != 0) break;
  }
  if (j == 0) return BivariatePolynomial::constant(1);
  if (j == degree) return f.degree_r() < g.degree_r() ? f : g;
  std::vector<Polynomial> coefficients;
  for (int k = 0; k < j; ++k) coefficients.push_back(subresultant_coefficient_r(a, b, j, k));
  coefficients.push_back(std::move(principal));
  return primitive(BivariatePolynomial(remainders(BivariatePolynomial(std::move(coefficients)), s)));
}

/// f / h over Q(s), up to a factor in Q(s), where h divides f and is reduced at s: pseudo-division.
BivariatePolynomial quotient_at(const BivariatePolynomial& f, const BivariatePolynomial& h,
                                const RealAlgebraic& s) {
  const int degree = h.degree_r();
  const Polynomial lead = h.coefficient(degree);
  BivariatePolynomial quotient, rest = f;
  for (int k = f.degree_r() - degree; k >= 0; --k) {
    std::vector<Polynomial> term(static_cast<std::size_t>(k + 1));
    term.back() = rest.coefficient(degree + k);
    const BivariatePolynomial monomial(std::move(term));
    quotient = quotient * lead + monomial;
    rest = BivariatePolynomial(remainders(rest * lead - monomial * h, s));
  }
  return primitive(reduced_at(quotient, s));
}

}  // namespace

void enclose(arb_t value, const Polynomial& f, const arb_t s, slong precision) {
  const fmpq_poly_struct* rep = f.rep().value;
  arb_zero(value);
  for (slong i = fmpq_poly_degree(rep); i >= 0; --i) {
    arb_mul(value, value, s, precision);
    arb_add_fmpz(value, value, rep->coeffs + i, precision);
  }
  if (!fmpz_is_one(rep->den)) arb_div_fmpz(value, value, rep->den, precision);
}

void enclose(arb_poly_t value, const BivariatePolynomial& f, const RealAlgebraic& s, slong precision) {
  FlintBall point, coefficient;
  set_ball(point.value, s.interval(), precision);
  arb_poly_zero(value);
  for (int i = f.degree_r(); i >= 0; --i) {
    enclose(coefficient.value, f.coefficient(i), point.value, precision);
    arb_poly_set_coeff_arb(value, i, coefficient.value);
  }
}

BivariatePolynomial reduced_at(const BivariatePolynomial& f, const RealAlgebraic& s) {
  if (s.is_rational()) return in_r(f.at_s(s.rational()));
  std::vector<Polynomial> coefficients = remainders(f, s);
  while (!coefficients.empty() && sign_at(coefficients.back(), s) == 0) coefficients.pop_back();
  return BivariatePolynomial(std::move(coefficients));
}

BivariatePolynomial gcd_at(const BivariatePolynomial& f, const BivariatePolynomial& g,
                           const RealAlgebraic& s) {
  const RealAlgebraic fine = narrowed(s);
  if (fine.is_rational()) return in_r(gcd(f.at_s(fine.rational()), g.at_s(fine.rational())));
  const BivariatePolynomial a = reduced_at(f, fine);
  const BivariatePolynomial b = reduced_at(g, fine);
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  if (a.degree_r() == 0 || b.degree_r() == 0) return BivariatePolynomial::constant(1);
  return gcd_of_reduced(a, b, fine);
}

namespace {

/// f, or reduced_at() where f has a smaller degree in r at s or a great one in s: in reduced coefficients the
/// integers are far longer.
BivariatePolynomial short_at(const BivariatePolynomial& f, const RealAlgebraic& s) {
  const bool is_short = !s.is_rational() && !f.is_zero() && f.degree_s() < 2 * s.polynomial().degree();
  return is_short && sign_at(f.coefficient(f.degree_r()), s) != 0 ? f : reduced_at(f, s);
}

}  // namespace

// A linear remainder whose leading coefficient is not 0 is the gcd if the one after it is 0, and else there
// is none; the resultant of polynomials of these degrees at s is 0 in the first case alone.
void find_common_roots(CommonRoots& roots, const BivariatePolynomial& f, const BivariatePolynomial& g,
                       const RealAlgebraic& s) {
  constexpr slong precision = 1024;
  roots.number = CommonRoots::Number::unknown;
  const BivariatePolynomial first = short_at(f, s), second = short_at(g, s);
  if (first.degree_r() < 1 || second.degree_r() < 1) return;
  FlintBallPolynomial a, b;
  enclose(a.value, first, s, precision);
  enclose(b.value, second, s, precision);
  if (!reach_constant(a, b, precision)) return;
  if (is_certainly_nonzero(b)) {
    roots.number = CommonRoots::Number::none;
  } else if (arb_poly_length(a.value) == 2) {
    const bool is_common = sign_at(resultant_r(primitive(first), primitive(second)), s) == 0;
    roots.number = is_common ? CommonRoots::Number::one : CommonRoots::Number::none;
    arb_div(roots.root.value, arb_poly_get_coeff_ptr(a.value, 0), arb_poly_get_coeff_ptr(a.value, 1),
            precision);
    arb_neg(roots.root.value, roots.root.value);
  }
}

BivariatePolynomial squarefree_part_at(const BivariatePolynomial& f, const RealAlgebraic& s) {
  if (s.is_rational()) return in_r(squarefree_part(f.at_s(s.rational())));
  if (f.degree_r() == 1) return f;
  const BivariatePolynomial common = gcd_at(f, f.derivative_r(), s);
  return common.degree_r() == 0 ? f : quotient_at(f, common, s);
}

}  // namespace exsect

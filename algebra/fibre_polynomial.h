// Polynomials in r over the field Q(s), s a real algebraic number, written as elements of Q[s][r]: exact zero
// tests and enclosures. Not a public header.
#pragma once

#include "bivariate_polynomial.h"
#include "flint.h"
#include "real_algebraic.h"
// after flint.h
#if __FLINT_RELEASE >= 30000
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

namespace exsect {

/// Owner of one arb_poly.
struct FlintBallPolynomial {
  arb_poly_t value;
  FlintBallPolynomial() { arb_poly_init(value); }
  ~FlintBallPolynomial() { arb_poly_clear(value); }
  FlintBallPolynomial(const FlintBallPolynomial&) = delete;
  FlintBallPolynomial& operator=(const FlintBallPolynomial&) = delete;
};

/// Encloses f(s) for every s in the ball.
void enclose(arb_t value, const Polynomial& f, const arb_t s, slong precision);
/// Encloses the coefficients of f(., s), its formal degree kept.
void enclose(arb_poly_t value, const BivariatePolynomial& f, const RealAlgebraic& s, slong precision);

/// What is known of the common roots of f(., s) and g(., s).
struct CommonRoots {
  enum class Number { none, one, unknown };
  Number number = Number::unknown;
  FlintBall root;  // encloses the one
};
/// By Euclid's algorithm in balls and a resultant: without the gcd, which takes far longer. The narrower the
/// interval of s, the more is known.
void find_common_roots(CommonRoots& roots, const BivariatePolynomial& f, const BivariatePolynomial& g,
                       const RealAlgebraic& s);

/// f(., s) divided by gcd(f, f_r) over Q(s), up to a factor in Q(s); f reduced at s and not constant.
BivariatePolynomial squarefree_part_at(const BivariatePolynomial& f, const RealAlgebraic& s);

}  // namespace exsect

// The fibre of a pair, with u as a variable, projected to one parameter of the second patch.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/integer_pair.h>

#include "eliminant/fibre_forms.h"

namespace exsect {

/// A polynomial in one parameter of y with coefficients in Q[u].
using FibrePolynomial = FormalPolynomial<Polynomial>;

FibreCoefficients<Polynomial> symbolic_fibre(const IntegerPair& pair);

bool is_zero(const FibrePolynomial& f);
FibrePolynomial derivative(const FibrePolynomial& f);
/// No common root over the algebraic closure of Q(u).
bool coprime(const FibrePolynomial& f, const FibrePolynomial& g);
/// The product of the simple prime factors of f over Q(u), and that of the different multiple ones; both
/// primitive in Z[u][s], of positive degree or 1.
struct FibreFactors {
  FibrePolynomial simple;
  FibrePolynomial multiple;
};
FibreFactors split_multiple(const FibrePolynomial& f);
/// All coefficients of all coefficients; each must be an integer.
std::vector<Integer> integer_coefficients(const FibrePolynomial& f);

/// The projection of the generic fibre to s (docs/method.md, section 4.6). For each root s of `finite` with
/// S1(s) != 0 there is exactly one finite point (v,r,s) of the fibre, and R'(s) = S1(s) J (4.6) up to a sign
/// that depends on the pair only.
struct FibreProjection {
  FibrePolynomial r;   // R in Z[u][s], zero if it vanishes identically
  FibrePolynomial s1;  // S1 in Z[u][s]
  /// R without the roots where points of the fibre lie at r = infinity for all u, coefficients in Z[u]
  /// without common factor.
  FibrePolynomial finite;
  Polynomial content;  // of R in Q[u], apart from a constant; 0 for R = 0
  /// Every root of R over which there is a finite point is a root of `finite`, and there are no points at
  /// infinity among those.
  bool complete;
};

/// Requires that y_r x y_s is not identically zero, and a_1 x a_2 != 0 or a_2 = 0 != a_1.
FibreProjection project_fibre(const FibreCoefficients<Polynomial>& f);

}  // namespace exsect

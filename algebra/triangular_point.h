// Points (r,s) of the plane given by a triangular set: s a real algebraic number, r a root of a polynomial
// over Q(s). The tool for every degenerate fibre: nothing is decided by size.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/algebra/real_algebraic.h>

#include <memory>
#include <vector>

namespace exsect {

/// Invariant: over the field Q(s), `g(., s)` is squarefree with exactly one root r in `r_interval`: the open
/// interval between its ends, or the single number where both ends agree; in the open case g has opposite
/// nonzero signs at the ends.
class TriangularPoint {
 public:
  /// Throws std::invalid_argument unless g has opposite nonzero signs at the ends, or vanishes where they
  /// agree. The caller promises the rest (roots_at proves it).
  TriangularPoint(RealAlgebraic s, BivariatePolynomial g, RationalInterval r_interval);
  /// `whole` has the roots of g over s, some of them more than once perhaps, and is shorter.
  TriangularPoint(RealAlgebraic s, BivariatePolynomial g, RationalInterval r_interval,
                  std::shared_ptr<const BivariatePolynomial> whole);

  const RealAlgebraic& s() const { return s_; }
  const BivariatePolynomial& g() const { return g_; }
  const BivariatePolynomial& whole() const { return whole_ ? *whole_ : g_; }
  const RationalInterval& r_interval() const { return r_; }
  /// The same point with both intervals of width at most `width`, inside the present ones; an interval is the
  /// number itself if it is met on the way. Throws std::invalid_argument unless width > 0.
  TriangularPoint refined_to(const Rational& width) const;

 private:
  RealAlgebraic s_;
  BivariatePolynomial g_;
  RationalInterval r_;
  int sign_lower_;                                    // of g at the lower end of r_; 0 if r is known
  std::shared_ptr<const BivariatePolynomial> whole_;  // null: g
};

/// f(.,s) reduced over Q(s): the true degree in r, leading coefficient nonzero at s, coefficients reduced
/// modulo the polynomial of s.
BivariatePolynomial reduced_at(const BivariatePolynomial& f, const RealAlgebraic& s);
/// gcd in Q(s)[r] of f(.,s) and g(.,s), up to a factor in Q(s), reduced at s; zero if both vanish identically
/// at s.
BivariatePolynomial gcd_at(const BivariatePolynomial& f, const BivariatePolynomial& g,
                           const RealAlgebraic& s);
/// The points (r,s) with f(r,s) = 0 and r in the closed interval [a,b], ascending in r, each once. Rational
/// roots at a and b and those met by bisection are known to be rational. Throws std::domain_error if f(.,s)
/// vanishes identically, std::invalid_argument for a > b.
std::vector<TriangularPoint> roots_at(const BivariatePolynomial& f, const RealAlgebraic& s, const Rational& a,
                                      const Rational& b);
/// Exact sign of h at the point: -1, 0, +1.
int sign_at(const BivariatePolynomial& h, const TriangularPoint& p);

}  // namespace exsect

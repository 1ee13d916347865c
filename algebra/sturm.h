// Sturm sequences: the classical count of distinct real roots.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

namespace exsect {

/// f, f', and the negated remainders, all divided by the last of them, gcd(f, f'), and each primitive: so the
/// first is the squarefree part of f and the last a nonzero constant, and the sequence counts at multiple
/// roots too. Counts *distinct* real roots of f, which need not be squarefree. Zeros in a list of signs are
/// skipped, never counted as a change.
class SturmSequence {
 public:
  /// Throws std::domain_error for f = 0.
  explicit SturmSequence(const Polynomial& f);

  const std::vector<Polynomial>& chain() const { return chain_; }
  /// Sign changes of the chain at t.
  int variations_at(const Rational& t) const;
  int variations_at_minus_infinity() const;
  int variations_at_plus_infinity() const;

  /// Number of distinct roots in the half-open interval (a,b]; requires a <= b, else std::invalid_argument.
  int count(const Rational& a, const Rational& b) const;
  /// Number of distinct roots in the closed interval [a,b].
  int count_closed(const Rational& a, const Rational& b) const;
  /// Number of distinct real roots.
  int count_all() const;

 private:
  std::vector<Polynomial> chain_;
};

}  // namespace exsect

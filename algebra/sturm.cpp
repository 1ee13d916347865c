#include "sturm.h"

#include <stdexcept>

#include "flint_polynomial.h"

namespace exsect {
namespace {

template <class SignOf>
int variations(const std::vector<Polynomial>& chain, SignOf sign_of) {
  int count = 0;
  int last = 0;
  for (const Polynomial& f : chain) {
    const int s = sign_of(f);
    if (s == 0) continue;
    if (last == -s) ++count;
    last = s;
  }
  return count;
}

int sign_at_plus_infinity(const Polynomial& f) { return sign(f.leading_coefficient()); }

int sign_at_minus_infinity(const Polynomial& f) {
  return f.degree() % 2 == 0 ? sign_at_plus_infinity(f) : -sign_at_plus_infinity(f);
}

/// -(a mod b), primitive, for integer polynomials: lc(b)^d a = q b + pseudo-remainder.
Polynomial negated_remainder(const Polynomial& a, const Polynomial& b) {
  FlintPolynomial remainder;
  ulong d = 0;
  fmpz_poly_pseudo_rem(remainder.value, &d, NumeratorView(a).get(), NumeratorView(b).get());
  make_primitive(remainder.value);
  if (d % 2 == 0 || b.leading_coefficient() > 0) fmpz_poly_neg(remainder.value, remainder.value);
  return to_polynomial(remainder.value);
}

}  // namespace

SturmSequence::SturmSequence(const Polynomial& f) {
  if (f.is_zero()) throw std::domain_error("SturmSequence: the polynomial is zero");
  chain_.push_back(f.primitive());
  Polynomial next = f.derivative().primitive();
  while (!next.is_zero()) {
    chain_.push_back(std::move(next));
    next = negated_remainder(chain_[chain_.size() - 2], chain_.back());
  }
  const Polynomial common = chain_.back();
  if (common.degree() == 0) return;
  // Dividing by one polynomial changes no variation where it is not zero.
  for (Polynomial& member : chain_) member = exact_quotient(member, common).primitive();
}

int SturmSequence::variations_at(const Rational& t) const {
  return variations(chain_, [&t](const Polynomial& f) { return f.sign_at(t); });
}

int SturmSequence::variations_at_minus_infinity() const { return variations(chain_, sign_at_minus_infinity); }

int SturmSequence::variations_at_plus_infinity() const { return variations(chain_, sign_at_plus_infinity); }

int SturmSequence::count(const Rational& a, const Rational& b) const {
  if (a > b) throw std::invalid_argument("SturmSequence::count: a <= b is required");
  return variations_at(a) - variations_at(b);
}

int SturmSequence::count_closed(const Rational& a, const Rational& b) const {
  return count(a, b) + (chain_.front().sign_at(a) == 0 ? 1 : 0);
}

int SturmSequence::count_all() const {
  return variations_at_minus_infinity() - variations_at_plus_infinity();
}

}  // namespace exsect

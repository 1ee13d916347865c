#include "polynomial.h"

#include <algorithm>
#include <stdexcept>

#include "flint_polynomial.h"

namespace exsect {
namespace {

/// From this size of the exact value on (bits that t alone contributes) balls are tried first.
constexpr slong ball_threshold = 2048;

/// p^n f(t) for t = p / 2^k: Horner's rule with shifts.
void evaluate_dyadic(fmpz_t sum, const fmpz_poly_t f, const fmpz_t p, ulong k) {
  const slong n = f->length - 1;
  fmpz_set(sum, f->coeffs + n);
  FlintInteger shifted;
  for (slong i = n - 1; i >= 0; --i) {
    fmpz_mul(sum, sum, p);
    if (fmpz_is_zero(f->coeffs + i)) continue;
    fmpz_mul_2exp(shifted.value, f->coeffs + i, static_cast<ulong>(n - i) * k);
    fmpz_add(sum, sum, shifted.value);
  }
}

/// q^n f(p/q).
void evaluate_homogeneous(fmpz_t sum, const fmpz_poly_t f, const fmpz_t p, const fmpz_t q) {
  const slong n = f->length - 1;
  fmpz_set(sum, f->coeffs + n);
  FlintInteger power;
  fmpz_one(power.value);
  for (slong i = n - 1; i >= 0; --i) {
    fmpz_mul(sum, sum, p);
    fmpz_mul(power.value, power.value, q);
    fmpz_addmul(sum, f->coeffs + i, power.value);
  }
}

/// The sign of f(t) if a ball evaluation with `precision` bits decides it, else 0.
int sign_by_ball(const fmpz_poly_t f, const fmpq_t t, slong precision) {
  FlintBall point, value, coefficient;
  arb_set_fmpq(point.value, t, precision);
  for (slong i = f->length - 1; i >= 0; --i) {
    arb_mul(value.value, value.value, point.value, precision);
    arb_set_round_fmpz(coefficient.value, f->coeffs + i, precision);
    arb_add(value.value, value.value, coefficient.value, precision);
  }
  return arb_is_positive(value.value) ? 1 : arb_is_negative(value.value) ? -1 : 0;
}

}  // namespace

Polynomial::Polynomial() : rep_(std::make_unique<Rep>()) {}

Polynomial::Polynomial(const Rational& constant) : Polynomial() {
  fmpq_poly_set_fmpq(rep_->value, FlintRational(constant).value);
}

Polynomial::Polynomial(int constant) : Polynomial() { fmpq_poly_set_si(rep_->value, constant); }

Polynomial::Polynomial(const std::vector<Rational>& coefficients) : Polynomial() {
  const auto length = static_cast<slong>(coefficients.size());
  fmpq_poly_struct* f = rep_->value;
  fmpq_poly_fit_length(f, length);
  // Over the least common denominator the fractions, reduced each, are reduced together.
  FlintInteger part;
  for (const Rational& c : coefficients) {
    fmpz_set_mpz(part.value, mpq_denref(c.backend().data()));
    fmpz_lcm(f->den, f->den, part.value);
  }
  for (slong i = 0; i < length; ++i) {
    const Rational& c = coefficients[static_cast<std::size_t>(i)];
    fmpz_set_mpz(f->coeffs + i, mpq_numref(c.backend().data()));
    if (fmpz_is_one(f->den)) continue;
    fmpz_set_mpz(part.value, mpq_denref(c.backend().data()));
    fmpz_divexact(part.value, f->den, part.value);
    fmpz_mul(f->coeffs + i, f->coeffs + i, part.value);
  }
  _fmpq_poly_set_length(f, length);
  _fmpq_poly_normalise(f);
}

Polynomial::Polynomial(const Polynomial& other) : rep_(std::make_unique<Rep>(*other.rep_)) {}
Polynomial::Polynomial(Polynomial&&) noexcept = default;
Polynomial& Polynomial::operator=(const Polynomial& other) {
  if (!rep_)
    rep_ = std::make_unique<Rep>(*other.rep_);
  else
    *rep_ = *other.rep_;
  return *this;
}
Polynomial& Polynomial::operator=(Polynomial&&) noexcept = default;
Polynomial::~Polynomial() = default;

Polynomial Polynomial::variable() {
  Polynomial result;
  fmpq_poly_set_coeff_si(result.rep_->value, 1, 1);
  return result;
}

int Polynomial::degree() const { return static_cast<int>(fmpq_poly_degree(rep_->value)); }

Rational Polynomial::coefficient(int i) const {
  if (i < 0 || i > degree()) return 0;
  FlintRational c;
  fmpq_poly_get_coeff_fmpq(c.value, rep_->value, i);
  return c.to_rational();
}

Rational Polynomial::leading_coefficient() const { return coefficient(degree()); }

std::vector<Rational> Polynomial::coefficients() const {
  std::vector<Rational> result;
  result.reserve(static_cast<std::size_t>(degree() + 1));
  for (int i = 0; i <= degree(); ++i) result.push_back(coefficient(i));
  return result;
}

Rational Polynomial::operator()(const Rational& t) const {
  FlintRational result;
  fmpq_poly_evaluate_fmpq(result.value, rep_->value, FlintRational(t).value);
  return result.to_rational();
}

int Polynomial::sign_at(const Rational& t) const {
  if (is_zero()) return 0;
  const NumeratorView f(*this);
  if (t == 0 || degree() == 0) return fmpz_sgn(f.get()->coeffs);
  const FlintRational point(t);
  const fmpz* p = fmpq_numref(point.value);
  const fmpz* q = fmpq_denref(point.value);
  const slong exact_bits = degree() * static_cast<slong>(std::max(fmpz_bits(p), fmpz_bits(q)));
  if (exact_bits > ball_threshold)
    for (slong precision = 128; precision < exact_bits; precision *= 4)
      if (const int s = sign_by_ball(f.get(), point.value, precision); s != 0) return s;
  FlintInteger sum;
  const auto k = static_cast<ulong>(fmpz_val2(q));
  if (fmpz_bits(q) == k + 1)
    evaluate_dyadic(sum.value, f.get(), p, k);
  else
    evaluate_homogeneous(sum.value, f.get(), p, q);
  return fmpz_sgn(sum.value);
}

Polynomial Polynomial::compose(const Polynomial& inner) const {
  Polynomial result;
  fmpq_poly_compose(result.rep_->value, rep_->value, inner.rep_->value);
  return result;
}

Polynomial Polynomial::derivative() const {
  Polynomial result;
  fmpq_poly_derivative(result.rep_->value, rep_->value);
  return result;
}

Polynomial Polynomial::reversed(int n) const {
  if (n < degree()) throw std::invalid_argument("Polynomial::reversed: n is below the degree");
  Polynomial result;
  fmpq_poly_reverse(result.rep_->value, rep_->value, n + 1);
  return result;
}

Polynomial Polynomial::primitive() const {
  FlintPolynomial numerator;
  fmpz_poly_set(numerator.value, NumeratorView(*this).get());
  make_primitive(numerator.value);
  return to_polynomial(numerator.value);
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  fmpq_poly_add(rep_->value, rep_->value, other.rep_->value);
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  fmpq_poly_sub(rep_->value, rep_->value, other.rep_->value);
  return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& other) { return *this = *this * other; }

Polynomial Polynomial::operator-() const {
  Polynomial result;
  fmpq_poly_neg(result.rep_->value, rep_->value);
  return result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  fmpq_poly_add(result.rep_->value, a.rep_->value, b.rep_->value);
  return result;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  fmpq_poly_sub(result.rep_->value, a.rep_->value, b.rep_->value);
  return result;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  fmpq_poly_mul(result.rep_->value, a.rep_->value, b.rep_->value);
  return result;
}

bool operator==(const Polynomial& a, const Polynomial& b) {
  return fmpq_poly_equal(a.rep_->value, b.rep_->value) != 0;
}

Division divide(const Polynomial& a, const Polynomial& b) {
  if (b.is_zero()) throw std::domain_error("divide: the divisor is the zero polynomial");
  Division result;
  fmpq_poly_divrem(result.quotient.rep().value, result.remainder.rep().value, a.rep().value, b.rep().value);
  return result;
}

Polynomial exact_quotient(const Polynomial& a, const Polynomial& b) {
  Division division = divide(a, b);
  if (!division.remainder.is_zero()) throw std::domain_error("exact_quotient: the divisor does not divide");
  return division.quotient;
}

}  // namespace exsect

#include "fixed_point_interval.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "flint_polynomial.h"

namespace exsect {
namespace {

mpz_ptr raw(Integer& x) { return x.backend().data(); }
mpz_srcptr raw(const Integer& x) { return x.backend().data(); }
mp_bitcnt_t count(long bits) { return static_cast<mp_bitcnt_t>(bits); }

Integer shifted_down(const Integer& x, long bits) {
  Integer result;
  mpz_fdiv_q_2exp(raw(result), raw(x), count(bits));
  return result;
}

Integer shifted_up(const Integer& x, long bits) {
  Integer result;
  mpz_cdiv_q_2exp(raw(result), raw(x), count(bits));
  return result;
}

Integer floor_quotient(const Integer& a, const Integer& b) {
  Integer result;
  mpz_fdiv_q(raw(result), raw(a), raw(b));
  return result;
}

Integer ceiling_quotient(const Integer& a, const Integer& b) {
  Integer result;
  mpz_cdiv_q(raw(result), raw(a), raw(b));
  return result;
}

Integer floor_scaled(const Rational& x, long bits) {
  return floor_quotient(numerator(x) << static_cast<unsigned long>(bits), denominator(x));
}

Integer ceiling_scaled(const Rational& x, long bits) {
  return ceiling_quotient(numerator(x) << static_cast<unsigned long>(bits), denominator(x));
}

/// Smallest and largest of the four products of ends.
std::pair<Integer, Integer> product_range(const Integer& a, const Integer& b, const Integer& c,
                                          const Integer& d) {
  const std::array<Integer, 4> products = {a * c, a * d, b * c, b * d};
  const auto [least, largest] = std::minmax_element(products.begin(), products.end());
  return {*least, *largest};
}

}  // namespace

FixedPointInterval::FixedPointInterval(const RationalInterval& x, long bits)
    : lower_(floor_scaled(x.lower, bits)), upper_(ceiling_scaled(x.upper, bits)), bits_(bits) {}

FixedPointInterval::FixedPointInterval(const Integer& x, long bits)
    : lower_(x << static_cast<unsigned long>(bits)), upper_(lower_), bits_(bits) {}

RationalInterval FixedPointInterval::interval() const {
  const auto end = [&](const Integer& n) {
    Rational x(n);
    mpq_div_2exp(x.backend().data(), x.backend().data(), count(bits_));
    return x;
  };
  return {end(lower_), end(upper_)};
}

FixedPointInterval operator+(const FixedPointInterval& a, const FixedPointInterval& b) {
  return {a.lower_ + b.lower_, a.upper_ + b.upper_, a.bits_};
}

FixedPointInterval operator-(const FixedPointInterval& a, const FixedPointInterval& b) {
  return {a.lower_ - b.upper_, a.upper_ - b.lower_, a.bits_};
}

FixedPointInterval operator*(const FixedPointInterval& a, const FixedPointInterval& b) {
  if (a.lower_ >= 0 && b.lower_ >= 0)
    return {shifted_down(a.lower_ * b.lower_, a.bits_), shifted_up(a.upper_ * b.upper_, a.bits_), a.bits_};
  const auto [least, largest] = product_range(a.lower_, a.upper_, b.lower_, b.upper_);
  return {shifted_down(least, a.bits_), shifted_up(largest, a.bits_), a.bits_};
}

FixedPointInterval operator/(const FixedPointInterval& a, const FixedPointInterval& b) {
  if (b.contains_zero()) throw std::domain_error("FixedPointInterval: the divisor contains zero");
  if (b.upper_ < 0) return -a / -b;
  const auto scale = static_cast<unsigned long>(a.bits_);
  const Integer& below = a.lower_ >= 0 ? b.upper_ : b.lower_;
  const Integer& above = a.upper_ >= 0 ? b.lower_ : b.upper_;
  return {floor_quotient(a.lower_ << scale, below), ceiling_quotient(a.upper_ << scale, above), a.bits_};
}

FixedPointInterval FixedPointInterval::operator-() const { return {-upper_, -lower_, bits_}; }

FixedPointInterval sqrt(const FixedPointInterval& a) {
  if (a.upper_ < 0) throw std::domain_error("FixedPointInterval: square root of negative numbers");
  const auto scale = static_cast<unsigned long>(a.bits_);
  const Integer floor_root = a.lower_ > 0 ? sqrt(Integer(a.lower_ << scale)) : Integer(0);
  Integer remainder;
  Integer ceiling_root = sqrt(Integer(a.upper_ << scale), remainder);
  if (remainder != 0) ++ceiling_root;
  return {floor_root, ceiling_root, a.bits_};
}

IntegerPolynomial::IntegerPolynomial(const Polynomial& f)
    : numerators(static_cast<std::size_t>(f.degree() + 1)) {
  const fmpq_poly_struct* const fractions = f.rep().value;
  for (std::size_t i = 0; i < numerators.size(); ++i) fmpz_get_mpz(raw(numerators[i]), fractions->coeffs + i);
  fmpz_get_mpz(raw(denominator), fractions->den);
}

Polynomial polynomial_of(const std::vector<Integer>& coefficients) {
  Polynomial result;
  const auto length = static_cast<slong>(coefficients.size());
  fmpq_poly_struct* const f = result.rep().value;
  fmpq_poly_fit_length(f, length);
  for (slong i = 0; i < length; ++i)
    fmpz_set_mpz(f->coeffs + i, raw(coefficients[static_cast<std::size_t>(i)]));
  _fmpq_poly_set_length(f, length);
  _fmpq_poly_normalise(f);
  return result;
}

FixedPointInterval enclose_numerator(const IntegerPolynomial& f, const FixedPointInterval& t) {
  FixedPointInterval result(Integer(0), t.bits());
  for (auto c = f.numerators.rbegin(); c != f.numerators.rend(); ++c)
    result = result * t + FixedPointInterval(*c, t.bits());
  return result;
}

FixedPointInterval enclose(const BivariatePolynomial& f, const FixedPointInterval& r,
                           const FixedPointInterval& s) {
  FixedPointInterval result(Integer(0), s.bits());
  for (int i = f.degree_r(); i >= 0; --i) {
    const IntegerPolynomial c(f.coefficient(i));
    result = result * r + enclose_numerator(c, s) / FixedPointInterval(c.denominator, s.bits());
  }
  return result;
}

RationalInterval rounded_outward(const RationalInterval& x, const Rational& width) {
  const long bits = bits_below(width) + 2;
  return FixedPointInterval(x, bits).interval();
}

long bits_below(const Rational& width) {
  if (width <= 0) throw std::invalid_argument("bits_below: the width must be positive");
  const Integer quotient = ceiling_quotient(denominator(width), numerator(width));
  return quotient <= 1 ? 0 : static_cast<long>(msb(Integer(quotient - 1))) + 1;
}

}  // namespace exsect

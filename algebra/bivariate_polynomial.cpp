#include "bivariate_polynomial.h"

#include <algorithm>
#include <stdexcept>

#include "flint_bivariate.h"

namespace exsect {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FlintBivariate::FlintBivariate(const BivariateContext& ring, const BivariatePolynomial& f)
    : FlintBivariate(ring) {
  FlintRational c;
  FlintInteger common;  // denominator: setting fractions one by one would reduce all of them each time
  fmpz_one(common.value);
  for (int i = 0; i <= f.degree_r(); ++i) {
    const Polynomial in_s = f.coefficient(i);
    for (int j = 0; j <= in_s.degree(); ++j) {
      fmpq_set_mpq(c.value, in_s.coefficient(j).backend().data());
      fmpz_lcm(common.value, common.value, fmpq_denref(c.value));
    }
  }
  for (int i = f.degree_r(); i >= 0; --i) {
    const Polynomial in_s = f.coefficient(i);
    for (int j = in_s.degree(); j >= 0; --j) {
      fmpq_set_mpq(c.value, in_s.coefficient(j).backend().data());
      if (fmpq_is_zero(c.value)) continue;
      fmpq_mul_fmpz(c.value, c.value, common.value);
      const ulong exponents[] = {static_cast<ulong>(i), static_cast<ulong>(j)};
      fmpz_mpoly_push_term_fmpz_ui(value->zpoly, fmpq_numref(c.value), exponents, ring_.get()->zctx);
    }
  }
  fmpz_one(fmpq_numref(value->content));
  fmpz_set(fmpq_denref(value->content), common.value);
  fmpq_mpoly_reduce(value, ring_.get());
}

BivariatePolynomial FlintBivariate::to_bivariate() const {
  std::vector<std::vector<Rational>> table;
  FlintRational c;
  for (slong term = 0; term < fmpq_mpoly_length(value, ring_.get()); ++term) {
    ulong exponents[2];
    fmpq_mpoly_get_term_exp_ui(exponents, value, term, ring_.get());
    fmpq_mpoly_get_term_coeff_fmpq(c.value, value, term, ring_.get());
    if (table.size() <= exponents[0]) table.resize(exponents[0] + 1);
    std::vector<Rational>& in_s = table[exponents[0]];
    if (in_s.size() <= exponents[1]) in_s.resize(exponents[1] + 1);
    in_s[exponents[1]] = c.to_rational();
  }
  std::vector<Polynomial> coefficients;
  coefficients.reserve(table.size());
  for (const std::vector<Rational>& in_s : table) coefficients.emplace_back(in_s);
  return BivariatePolynomial(std::move(coefficients));
}

BivariatePolynomial::BivariatePolynomial(std::vector<Polynomial> coefficients_of_r)
    : coefficients_(std::move(coefficients_of_r)) {
  trim();
}

BivariatePolynomial BivariatePolynomial::constant(const Rational& c) {
  return BivariatePolynomial(std::vector<Polynomial>{Polynomial(c)});
}

BivariatePolynomial BivariatePolynomial::r() {
  return BivariatePolynomial(std::vector<Polynomial>{Polynomial(), Polynomial(1)});
}

BivariatePolynomial BivariatePolynomial::s() {
  return BivariatePolynomial(std::vector<Polynomial>{Polynomial::variable()});
}

int BivariatePolynomial::degree_s() const {
  int degree = -1;
  for (const Polynomial& c : coefficients_) degree = std::max(degree, c.degree());
  return degree;
}

int BivariatePolynomial::total_degree() const {
  int degree = -1;
  for (int i = 0; i <= degree_r(); ++i)
    if (!coefficients_[at(i)].is_zero()) degree = std::max(degree, i + coefficients_[at(i)].degree());
  return degree;
}

Polynomial BivariatePolynomial::coefficient(int i) const {
  return i < 0 || i > degree_r() ? Polynomial() : coefficients_[at(i)];
}

Rational BivariatePolynomial::operator()(const Rational& r, const Rational& s) const {
  Rational value = 0;
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) value = value * r + (*c)(s);
  return value;
}

Polynomial BivariatePolynomial::at_s(const Rational& s) const {
  std::vector<Rational> values;
  values.reserve(coefficients_.size());
  for (const Polynomial& c : coefficients_) values.push_back(c(s));
  return Polynomial(values);
}

Polynomial BivariatePolynomial::at_r(const Rational& r) const {
  Polynomial value;
  const Polynomial factor(r);
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) {
    value *= factor;
    value += *c;
  }
  return value;
}

BivariatePolynomial BivariatePolynomial::derivative_r() const {
  std::vector<Polynomial> result;
  for (int i = 1; i <= degree_r(); ++i) result.push_back(coefficients_[at(i)] * Polynomial(i));
  return BivariatePolynomial(std::move(result));
}

BivariatePolynomial BivariatePolynomial::derivative_s() const {
  std::vector<Polynomial> result;
  for (const Polynomial& c : coefficients_) result.push_back(c.derivative());
  return BivariatePolynomial(std::move(result));
}

BivariatePolynomial BivariatePolynomial::exchanged() const {
  std::vector<std::vector<Rational>> table(at(degree_s() + 1), std::vector<Rational>(coefficients_.size()));
  for (int i = 0; i <= degree_r(); ++i)
    for (int j = 0; j <= coefficients_[at(i)].degree(); ++j)
      table[at(j)][at(i)] = coefficients_[at(i)].coefficient(j);
  std::vector<Polynomial> result;
  result.reserve(table.size());
  for (const std::vector<Rational>& row : table) result.emplace_back(row);
  return BivariatePolynomial(std::move(result));
}

BivariatePolynomial& BivariatePolynomial::operator+=(const BivariatePolynomial& other) {
  if (coefficients_.size() < other.coefficients_.size()) coefficients_.resize(other.coefficients_.size());
  for (std::size_t i = 0; i < other.coefficients_.size(); ++i) coefficients_[i] += other.coefficients_[i];
  trim();
  return *this;
}

BivariatePolynomial& BivariatePolynomial::operator-=(const BivariatePolynomial& other) {
  if (coefficients_.size() < other.coefficients_.size()) coefficients_.resize(other.coefficients_.size());
  for (std::size_t i = 0; i < other.coefficients_.size(); ++i) coefficients_[i] -= other.coefficients_[i];
  trim();
  return *this;
}

BivariatePolynomial& BivariatePolynomial::operator*=(const Polynomial& factor_in_s) {
  const Polynomial factor = factor_in_s;  // may be one of the coefficients
  for (Polynomial& c : coefficients_) c *= factor;
  trim();
  return *this;
}

BivariatePolynomial operator*(const BivariatePolynomial& a, const BivariatePolynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<Polynomial> product(at(a.degree_r() + b.degree_r() + 1));
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i)
    for (std::size_t j = 0; j < b.coefficients_.size(); ++j)
      product[i + j] += a.coefficients_[i] * b.coefficients_[j];
  return BivariatePolynomial(std::move(product));
}

void BivariatePolynomial::trim() {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

BivariatePolynomial exact_quotient(const BivariatePolynomial& a, const BivariatePolynomial& b) {
  if (b.is_zero()) throw std::domain_error("exact_quotient: the divisor is the zero polynomial");
  const BivariateContext ring;
  const FlintBivariate dividend(ring, a), divisor(ring, b);
  FlintBivariate quotient(ring);
  if (fmpq_mpoly_divides(quotient.value, dividend.value, divisor.value, ring.get()) == 0)
    throw std::domain_error("exact_quotient: the divisor does not divide");
  return quotient.to_bivariate();
}

BivariatePolynomial gcd(const BivariatePolynomial& a, const BivariatePolynomial& b) {
  const BivariateContext ring;
  const FlintBivariate first(ring, a), second(ring, b);
  FlintBivariate common(ring);
  if (fmpq_mpoly_gcd(common.value, first.value, second.value, ring.get()) == 0)
    throw std::runtime_error("gcd: the bivariate gcd failed");
  if (fmpq_mpoly_is_zero(common.value, ring.get()) != 0) return {};
  // FLINT's is monic; its primitive integer part has positive leading coefficient.
  fmpq_one(common.value->content);
  return common.to_bivariate();
}

}  // namespace exsect

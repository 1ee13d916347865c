#include "eliminant/stripped_eliminant.h"

#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <vector>

#include "eliminant/special_eliminant.h"
#include "eliminant/turning_eliminant_modular.h"

namespace exsect {

namespace {

using Residues = std::vector<Residue>;

/// y_i of Y = y_0 + y_1 r + ..., coordinate k.
Polynomial coordinate(const WeightedPair::Net& y, std::size_t i, std::size_t k) {
  std::vector<Rational> coefficients;
  for (const WeightedPair::Vector& c : y[i]) coefficients.emplace_back(c[k]);
  return Polynomial(std::move(coefficients));
}

/// f / g, which is a polynomial; the leading coefficient of g is not zero.
Residues exact_quotient(const PrimeField& field, Residues f, const Residues& g) {
  const std::size_t degree = g.size() - 1;
  const Residue inverse = field.inverse(g.back());
  Residues quotient(f.size() - degree);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = field.multiply(f[k + degree], inverse);
    for (std::size_t i = 0; i <= degree; ++i)
      f[k + i] = field.subtract(f[k + i], field.multiply(quotient[k], g[i]));
  }
  return quotient;
}

/// The powers of D in R, S1, and of res(R/D^a, D) in E.
template <class Kind>
struct Powers {
  static constexpr bool conic = Kind::v_degree == 2;
  static constexpr std::size_t r = conic ? 4 : Kind::r_degree;
  static constexpr std::size_t s1 = conic ? 2 : Kind::r_degree - 1;
  static constexpr std::size_t factor = conic ? 2 : 1;
};

/// Values of E (16.20).
template <class Kind>
class StrippedEliminant {
 public:
  StrippedEliminant(const PrimeField& field, const WeightedPair& pair, const Polynomial& factor)
      : field_(field), whole_(field, pair) {
    for (const Rational& c : factor.coefficients()) factor_.push_back(field.residue(Integer(numerator(c))));
  }

  ResidueFraction value(Residue u) const {
    if (factor_.back() == 0) return {0, 0};
    FibrePolynomials f = whole_.fibre(u);
    for (std::size_t i = 0; i < Powers<Kind>::r; ++i) f.r = exact_quotient(field_, std::move(f.r), factor_);
    for (std::size_t i = 0; i < Powers<Kind>::s1; ++i)
      f.s1 = exact_quotient(field_, std::move(f.s1), factor_);
    const Residue at_factor = field_.power(resultant(field_, f.r, factor_), Powers<Kind>::factor);
    const Residue lead = field_.multiply(field_.power(f.lead_r, Kind::lead_power), at_factor);
    return {field_.multiply(lead, resultant(field_, f.r, derivative(field_, f.r))),
            field_.multiply(f.r.back(), resultant(field_, f.r, f.s1))};
  }

  std::vector<ResidueFraction> values(Residue first, std::size_t count) const {
    std::vector<ResidueFraction> result;
    for (; result.size() < count; first = field_.add(first, field_.one())) result.push_back(value(first));
    return result;
  }

 private:
  PrimeField field_;
  WeightedModularEliminant<Kind> whole_;
  Residues factor_;
};

/// As is_generic.
template <class Kind>
bool is_defined(const WeightedPair& pair, const Polynomial& factor) {
  const PrimeField field(prime_below(prime_field_limit));
  const Residue u = field.residue(static_cast<std::int64_t>(field.prime() / 3));
  const ResidueFraction value = StrippedEliminant<Kind>(field, pair, factor).value(u);
  return value.numerator != 0 && value.denominator != 0;
}

bool has_root_inside(const Polynomial& f) {
  return std::ranges::any_of(real_roots(f, 0, 1), [](const RealAlgebraic& root) {
    return root.compare(0) > 0 && root.compare(1) < 0;
  });
}

}  // namespace

Polynomial point_lines(const WeightedPair::Net& y) {
  Polynomial common;
  for (std::size_t i = 0; i < y.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; l < k; ++l)
          common = gcd(common,
                       coordinate(y, i, k) * coordinate(y, j, l) - coordinate(y, i, l) * coordinate(y, j, k));
  return common.is_zero() ? common : primitive_with_positive_lead(common);
}

std::optional<ModularIntegers> stripped_eliminant(const WeightedPair& pair, std::size_t bits) {
  const Polynomial factor = point_lines(pair.y);
  if (factor.degree() < 1 || has_root_inside(factor)) return std::nullopt;
  return by_kind(pair, [&]<class Kind>(Kind) -> std::optional<ModularIntegers> {
    // Orders of two at fibres that are not finite need it.
    if (Kind::s_degree < 2 || !is_defined<Kind>(pair, factor)) return std::nullopt;
    return interpolate_modular_polynomial(
        Kind::degree(pair.x.size() - 1), bits,
        [&](const PrimeField& field, Residue first, std::size_t count) {
          return StrippedEliminant<Kind>(field, pair, factor).values(first, count);
        });
  });
}

}  // namespace exsect

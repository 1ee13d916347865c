#include "eliminant/turning_eliminant_modular.h"

#include <vector>

namespace exsect {

static_assert(PrimeField::max_products >= 28, "what EliminantForms asks of a sum");

namespace {

using ModularForms = EliminantForms<ScalarArithmetic>;

ModularForms::Net reduced(const PrimeField& field, const IntegerNet& net) {
  ModularForms::Net result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result.c[i][j].c[k] = field.residue(net[i][j][k]);
  return result;
}

ModularForms forms_modulo(const PrimeField& field, const IntegerPair& pair) {
  Residue small[17];
  for (std::size_t i = 0; i < 17; ++i) small[i] = field.residue(static_cast<std::int64_t>(i));
  return ModularForms(ScalarArithmetic(field), reduced(field, pair.x), reduced(field, pair.y), small);
}

}  // namespace

ModularEliminant::ModularEliminant(const PrimeField& field, const IntegerPair& pair)
    : forms_(forms_modulo(field, pair)) {}

std::vector<ResidueFraction> ModularEliminant::fast_values(Residue first, std::size_t count) const {
  ModularForms::Fibre fibres[17];
  for (ModularForms::Fibre& fibre : fibres) {
    fibre = forms_.fibre(first);
    first = forms_.field().add(first, forms_.field().prime_field().one());
  }
  FibreTable<ScalarArithmetic> table(forms_.field(), fibres);
  std::vector<ResidueFraction> values;
  values.reserve(count);
  while (values.size() < count) {
    ModularForms::Fibre next[4];
    table.next(next);
    for (std::size_t k = 0; k < 4 && values.size() < count; ++k) {
      const ModularForms::Fraction value = forms_.value(next[k]);
      values.push_back({value.numerator, value.denominator});
    }
  }
  return values;
}

ResidueFraction ModularEliminant::value(Residue u) const {
  const PrimeField& field = forms_.field().prime_field();
  const ModularForms::Fibre f = forms_.fibre(u);
  const std::vector<Residue> r(std::begin(f.r), std::end(f.r));
  const std::vector<Residue> s1(std::begin(f.s1), std::end(f.s1));
  std::vector<Residue> derivative;
  for (std::size_t i = 1; i < r.size(); ++i)
    derivative.push_back(field.multiply(r[i], field.residue(static_cast<std::int64_t>(i))));
  return {field.multiply(field.power(f.g_r, 6), resultant(field, r, derivative)),
          field.multiply(field.power(f.g_s, 4), resultant(field, r, s1))};
}

}  // namespace exsect

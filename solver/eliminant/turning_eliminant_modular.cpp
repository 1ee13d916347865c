#include "eliminant/turning_eliminant_modular.h"

#include <iterator>
#include <vector>

#include "eliminant/fibre_table.h"

namespace exsect {

static_assert(PrimeField::max_products >= 28, "what FibreResultants asks of a sum");

namespace {

/// Zeros where the net has lower degrees.
template <class Net, class Integers>
Net reduced(const PrimeField& field, const Integers& integers) {
  Net result = {};
  for (std::size_t i = 0; i < integers.size(); ++i)
    for (std::size_t j = 0; j < integers[i].size(); ++j)
      for (std::size_t k = 0; k < integers[i][j].size(); ++k)
        result.c[i][j].c[k] = field.residue(integers[i][j][k]);
  return result;
}

template <class Forms, class Pair>
Forms forms_modulo(const PrimeField& field, const Pair& pair) {
  typename Forms::SmallNumbers small;
  for (std::size_t i = 0; i < std::size(small); ++i) small[i] = field.residue(static_cast<std::int64_t>(i));
  return Forms(ScalarArithmetic(field), reduced<typename Forms::FirstNet>(field, pair.x),
               reduced<typename Forms::SecondNet>(field, pair.y), small);
}

}  // namespace

std::vector<Residue> derivative(const PrimeField& field, const std::vector<Residue>& f) {
  std::vector<Residue> result;
  for (std::size_t i = 1; i < f.size(); ++i)
    result.push_back(field.multiply(f[i], field.residue(static_cast<std::int64_t>(i))));
  return result;
}

template <class Forms>
template <class Pair>
ModularEliminantOf<Forms>::ModularEliminantOf(const PrimeField& field, const Pair& pair)
    : forms_(forms_modulo<Forms>(field, pair)) {}

template <class Forms>
std::vector<ResidueFraction> ModularEliminantOf<Forms>::fast_values(Residue first, std::size_t count) const {
  using Fibre = typename Forms::Fibre;
  using Table = FibreTable<ScalarArithmetic, typename Fibre::Kind>;
  Fibre fibres[Table::size];
  for (Fibre& fibre : fibres) {
    fibre = forms_.fibre(first);
    first = forms_.field().add(first, forms_.field().prime_field().one());
  }
  Table table(forms_.field(), fibres);
  std::vector<ResidueFraction> values;
  values.reserve(count);
  while (values.size() < count) {
    Fibre next[4];
    table.next(next);
    for (std::size_t k = 0; k < 4 && values.size() < count; ++k) {
      const typename Forms::Fraction value = forms_.value(next[k]);
      values.push_back({value.numerator, value.denominator});
    }
  }
  return values;
}

template <class Forms>
ResidueFraction ModularEliminantOf<Forms>::value(Residue u) const {
  const PrimeField& field = forms_.field().prime_field();
  const FibrePolynomials f = fibre(u);
  const typename Forms::Fraction lead = forms_.leading_factor(f.lead_r, f.lead_s);
  return {field.multiply(lead.numerator, resultant(field, f.r, derivative(field, f.r))),
          field.multiply(lead.denominator, resultant(field, f.r, f.s1))};
}

template <class Forms>
FibrePolynomials ModularEliminantOf<Forms>::fibre(Residue u) const {
  const typename Forms::Fibre f = forms_.fibre(u);
  return {{std::begin(f.r), std::end(f.r)}, {std::begin(f.s1), std::end(f.s1)}, f.lead_r, f.lead_s};
}

template <class Forms>
std::vector<ResidueFraction> ModularEliminantOf<Forms>::values(Residue first, std::size_t count) const {
  std::vector<ResidueFraction> result = fast_values(first, count);
  for (ResidueFraction& each : result) {
    if (each.denominator == 0) each = value(first);
    first = forms_.field().add(first, forms_.field().prime_field().one());
  }
  return result;
}

template class ModularEliminantOf<EliminantForms<ScalarArithmetic>>;
template ModularEliminant::ModularEliminantOf(const PrimeField&, const IntegerPair&);
#define EXSECT_INSTANTIATE(KIND)                                                                      \
  template class ModularEliminantOf<FormsOf<ScalarArithmetic, KIND>>;                                 \
  template ModularEliminantOf<FormsOf<ScalarArithmetic, KIND>>::ModularEliminantOf(const PrimeField&, \
                                                                                   const WeightedPair&);
EXSECT_WEIGHTED_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect

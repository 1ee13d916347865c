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
  const auto with = [&](const auto&... factor) {
    return Forms(ScalarArithmetic(field), reduced<typename Forms::FirstNet>(field, pair.x),
                 reduced<typename Forms::SecondNet>(field, pair.y), small, factor...);
  };
  if constexpr (requires { typename Forms::Factor; }) {
    typename Forms::Factor factor;
    for (std::size_t i = 0; i < std::size(factor.c); ++i) factor.c[i] = field.residue(pair.factor[i]);
    const Residue lead = factor.c[std::size(factor.c) - 1];
    factor.inverse = lead == 0 ? 0 : field.inverse(lead);  // R~ and E are zero then: not defined
    return with(factor);
  } else {
    return with();
  }
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
  const typename Forms::Fibre at = forms_.fibre(u);
  const std::vector<Residue> r(std::begin(at.r), std::end(at.r)), s1(std::begin(at.s1), std::end(at.s1));
  const typename Forms::Fraction lead = forms_.leading_factor(at.lead_r, at.lead_s);
  const Residue factor = field.multiply(lead.numerator, forms_.fixed_factor(at));
  return {field.multiply(factor, resultant(field, r, derivative(field, r))),
          field.multiply(lead.denominator, resultant(field, r, s1))};
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
#define EXSECT_INSTANTIATE(PAIR, ...)                                                                        \
  template class ModularEliminantOf<FormsOf<ScalarArithmetic, __VA_ARGS__>>;                                 \
  template ModularEliminantOf<FormsOf<ScalarArithmetic, __VA_ARGS__>>::ModularEliminantOf(const PrimeField&, \
                                                                                          const PAIR&);
#define EXSECT_WEIGHTED(...) EXSECT_INSTANTIATE(WeightedPair, __VA_ARGS__)
#define EXSECT_STRIPPED(...) EXSECT_INSTANTIATE(StrippedPair, __VA_ARGS__)
EXSECT_WEIGHTED_KINDS(EXSECT_WEIGHTED)
EXSECT_STRIPPED_KINDS(EXSECT_STRIPPED)
#undef EXSECT_STRIPPED
#undef EXSECT_WEIGHTED
#undef EXSECT_INSTANTIATE

}  // namespace exsect

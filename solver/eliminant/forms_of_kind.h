// The formulas of the fibre by the kind of the pair. Internal to solver/.
#pragma once

#include "eliminant/ruled_eliminant_forms.h"
#include "eliminant/turning_eliminant_forms.h"
#include "eliminant/weighted_eliminant_forms.h"

namespace exsect {

template <class Field, class Kind>
struct FormsOfKind;
template <class Field>
struct FormsOfKind<Field, PolynomialKind> {
  using Type = EliminantForms<Field>;
};
template <class Field>
struct FormsOfKind<Field, WeightedKind> {
  using Type = WeightedEliminantForms<Field>;
};
template <class Field, std::size_t m, std::size_t n>
struct FormsOfKind<Field, RuledKind<m, n>> {
  using Type = RuledEliminantForms<Field, m, n>;
};
template <class Field, class Kind>
using FormsOf = typename FormsOfKind<Field, Kind>::Type;

}  // namespace exsect

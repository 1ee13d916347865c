#include "line/line_forms.h"

#include <exsect/algebra/fixed_point_interval.h>

#include <vector>

#include "line/conic_eliminant.h"

namespace exsect {
namespace {

using IntegerForms = ConicEliminant<Integer>;

/// w[i]: the coefficient of r^i in weight y - a0.
std::array<IntegerForms::FormVector, 3> coefficients_of_r(const IntegerLineAndPatch& problem) {
  std::array<IntegerForms::FormVector, 3> w;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 3; ++j) w[i][k].push_back(problem.line.weight * problem.patch[i][j][k]);
      if (i == 0) w[i][k][0] -= problem.line.a[0][k];
    }
  return w;
}

}  // namespace

ConicForms conic_forms(const IntegerLineAndPatch& problem) {
  const IntegerForms forms(problem.line.a[1], problem.line.a[2], coefficients_of_r(problem));
  const auto polynomial = [](const IntegerForms::Form& f) {
    return polynomial_of(std::vector<Integer>(f.begin(), f.end()));
  };
  return {polynomial(forms.a),          polynomial(forms.b),  polynomial(forms.c),
          polynomial(forms.eliminant),  polynomial(forms.s1), polynomial(forms.s0),
          polynomial(forms.t_numerator)};
}

}  // namespace exsect

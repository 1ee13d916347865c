#include "symbolic_line.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "line_forms.h"

namespace exsect {

ParameterLine SymbolicLine::at(const Rational& u) const {
  ParameterLine line;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) line.a[j][k] = a[j][k](u);
  return line;
}

SymbolicLine symbolic_line(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  SymbolicLine line;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) line.a[j][k] = Polynomial({c[0][j][k], c[1][j][k], c[2][j][k]});
  return line;
}

SymbolicLineForms orthogonal_forms(const SymbolicLine& line) {
  const VectorOver<Polynomial> n = cross_over(line.a[1], line.a[2]);
  if (n[0].is_zero() && n[1].is_zero() && n[2].is_zero())
    throw std::domain_error("patch: a1 x a2 = 0 for all u, every parameter line is straight");
  return orthogonal_forms_over(line.a, n);
}

AffineForm at(const SymbolicForm& form, const Rational& u) {
  return {{form.normal[0](u), form.normal[1](u), form.normal[2](u)}, form.constant(u)};
}

LineForms at(const SymbolicLineForms& forms, const Rational& u) {
  return {at(forms.plane, u), at(forms.e0, u), at(forms.e1, u), at(forms.e2, u)};
}

TrivariatePolynomial pull_back(const SymbolicForm& form, const BezierPatch& y) {
  const ControlNet c = y.power_basis();
  std::vector<std::vector<Polynomial>> coefficients(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      coefficients[i].push_back(form.normal[0] * c[i][j][0] + form.normal[1] * c[i][j][1] +
                                form.normal[2] * c[i][j][2]);
  coefficients[0][0] += form.constant;
  return TrivariatePolynomial(std::move(coefficients));
}

SymbolicPullBack pull_back(const SymbolicLineForms& forms, const BezierPatch& y) {
  return {pull_back(forms.plane, y), pull_back(forms.e0, y), pull_back(forms.e1, y), pull_back(forms.e2, y)};
}

TrivariatePolynomial tangency_determinant(const SymbolicPullBack& pullback) {
  const TrivariatePolynomial z = pullback.cylinder();
  return pullback.plane.derivative_r() * z.derivative_s() - pullback.plane.derivative_s() * z.derivative_r();
}

}  // namespace exsect

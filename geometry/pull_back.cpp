#include "pull_back.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "line_forms.h"

namespace exsect {
namespace {

/// `c` is the power basis of the patch.
BivariatePolynomial pull_back(const AffineForm& form, const ControlNet& c) {
  std::vector<Polynomial> coefficients;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Rational> in_s;
    for (std::size_t j = 0; j < 3; ++j) in_s.push_back(dot(form.normal, c[i][j]));
    if (i == 0) in_s[0] += form.constant;
    coefficients.emplace_back(in_s);
  }
  return BivariatePolynomial(std::move(coefficients));
}

Point conic_normal(const ParameterLine& line) {
  Point n = cross(line.a[1], line.a[2]);
  if (is_zero(n)) throw std::domain_error("parameter line: a1 x a2 = 0, the line is straight, not a conic");
  return n;
}

}  // namespace

BivariatePolynomial pull_back(const AffineForm& form, const BezierPatch& y) {
  return pull_back(form, y.power_basis());
}

LineForms orthogonal_forms(const ParameterLine& line) {
  return orthogonal_forms_over(line.a, conic_normal(line));
}

LineForms axis_forms(const ParameterLine& line) {
  const Point n = conic_normal(line);
  return axis_forms_over(line.a, n, largest_coordinate(n));
}

PullBack pull_back(const LineForms& forms, const BezierPatch& y) {
  const ControlNet c = y.power_basis();
  return {pull_back(forms.plane, c), pull_back(forms.e0, c), pull_back(forms.e1, c), pull_back(forms.e2, c)};
}

}  // namespace exsect

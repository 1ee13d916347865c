#include "pull_back.h"

#include <stdexcept>
#include <vector>

namespace exsect {
namespace {

Point conic_normal(const ParameterLine& line) {
  Point n = cross(line.a[1], line.a[2]);
  if (is_zero(n)) throw std::domain_error("parameter line: a1 x a2 = 0, the line is straight, not a conic");
  return n;
}

/// normal . (P - a0)
AffineForm form_through(const Point& a0, const Point& normal) { return {normal, -dot(normal, a0)}; }

AffineForm constant_form(const Rational& c) { return {{0, 0, 0}, c}; }

}  // namespace

BivariatePolynomial pull_back(const AffineForm& form, const BezierPatch& y) {
  const ControlNet c = y.power_basis();
  std::vector<Polynomial> coefficients;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Rational> in_s;
    for (std::size_t j = 0; j < 3; ++j) in_s.push_back(dot(form.normal, c[i][j]));
    if (i == 0) in_s[0] += form.constant;
    coefficients.emplace_back(in_s);
  }
  return BivariatePolynomial(std::move(coefficients));
}

LineForms orthogonal_forms(const ParameterLine& line) {
  const Point n = conic_normal(line);
  const auto& [a0, a1, a2] = line.a;
  return {form_through(a0, n), constant_form(dot(n, n)), form_through(a0, cross(a2, n)),
          form_through(a0, cross(n, a1))};
}

LineForms axis_forms(const ParameterLine& line) {
  const Point n = conic_normal(line);
  const auto& [a0, a1, a2] = line.a;
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (abs(n[i]) > abs(n[k])) k = i;
  Point axis = {0, 0, 0};
  axis[k] = 1;
  // (w x a2)_k = (a2 x axis).w and (a1 x w)_k = (axis x a1).w
  return {form_through(a0, n), constant_form(n[k]), form_through(a0, cross(a2, axis)),
          form_through(a0, cross(axis, a1))};
}

PullBack pull_back(const LineForms& forms, const BezierPatch& y) {
  return {pull_back(forms.plane, y), pull_back(forms.e0, y), pull_back(forms.e1, y), pull_back(forms.e2, y)};
}

}  // namespace exsect

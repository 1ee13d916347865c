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

/// The plane through three homogeneous vectors: its coefficients are their 3 x 3 minors.
AffineForm plane_through(const std::array<HomogeneousPoint, 3>& a) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) -> Rational {
    const auto row = [&](std::size_t m) { return Point{a[m][i], a[m][j], a[m][k]}; };
    return dot(row(0), cross(row(1), row(2)));
  };
  return {{minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3)}, -minor(0, 1, 2)};
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

BivariatePolynomial pull_back(const AffineForm& form, const RationalPatch& y) {
  BivariatePolynomial result = y.component(3) * Polynomial(form.constant);
  for (int k = 0; k < 3; ++k) result += y.component(k) * Polynomial(form.normal[static_cast<std::size_t>(k)]);
  return result;
}

LineForms orthogonal_forms(const ParameterLine& line) {
  return orthogonal_forms_over(line.a, conic_normal(line));
}

LineForms axis_forms(const ParameterLine& line) {
  const Point n = conic_normal(line);
  return axis_forms_over(line.a, n, largest_coordinate(n));
}

LineForms axis_forms(const std::array<HomogeneousPoint, 3>& a) {
  const AffineForm plane = plane_through(a);
  if (is_zero(plane.normal))
    throw std::domain_error(
        "parameter line: its homogeneous vectors lie in a plane at infinity or on a line");
  const std::size_t k = largest_coordinate(plane.normal), i = (k + 1) % 3, j = (k + 2) % 3;
  const auto form = [&](std::size_t first, std::size_t second) -> AffineForm {
    const auto row = [&](std::size_t m) { return Point{a[m][i], a[m][j], a[m][3]}; };
    const Point e = cross(row(first), row(second));
    AffineForm result{{0, 0, 0}, e[2]};
    result.normal[i] = e[0];
    result.normal[j] = e[1];
    return result;
  };
  return {plane, form(1, 2), form(2, 0), form(0, 1)};
}

PullBack pull_back(const LineForms& forms, const RationalPatch& y) {
  return {pull_back(forms.plane, y), pull_back(forms.e0, y), pull_back(forms.e1, y), pull_back(forms.e2, y)};
}

PullBack pull_back(const LineForms& forms, const BezierPatch& y) {
  const ControlNet c = y.power_basis();
  return {pull_back(forms.plane, c), pull_back(forms.e0, c), pull_back(forms.e1, c), pull_back(forms.e2, c)};
}

}  // namespace exsect

#include "quadratic_cylinder.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace exsect {
namespace {

constexpr const auto& monomials = Quadric::monomials;

std::size_t position_of(std::array<int, 3> exponents) {
  return static_cast<std::size_t>(std::find(monomials.begin(), monomials.end(), exponents) -
                                  monomials.begin());
}

/// Index of the product of two of the variables x, y, z, 1 numbered 0 to 3.
std::size_t product_position(std::size_t a, std::size_t b) {
  std::array<int, 3> exponents = {0, 0, 0};
  if (a < 3) ++exponents[a];
  if (b < 3) ++exponents[b];
  return position_of(exponents);
}

/// sum += sign a b
template <class Ring>
void add_product(std::array<Ring, 10>& sum, const Ring& sign, const AffineFormOver<Ring>& a,
                 const AffineFormOver<Ring>& b) {
  const auto coefficient = [](const AffineFormOver<Ring>& form, std::size_t i) {
    return i < 3 ? form.normal[i] : form.constant;
  };
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      sum[product_position(i, j)] += sign * coefficient(a, i) * coefficient(b, j);
}

template <class Ring>
QuadricOver<Ring> cylinder_over(const LineFormsOver<Ring>& forms) {
  std::array<Ring, 10> coefficients;
  coefficients.fill(Ring(0));
  add_product(coefficients, Ring(1), forms.e0, forms.e2);
  add_product(coefficients, Ring(-1), forms.e1, forms.e1);
  return QuadricOver<Ring>(coefficients);
}

AffineForm scaled(const Rational& c, const AffineForm& form) { return {c * form.normal, c * form.constant}; }

}  // namespace

template <class Ring>
Ring QuadricOver<Ring>::operator()(const Point& p) const {
  Ring sum(0);
  for (const QuadricTermOver<Ring>& term : terms()) {
    Rational monomial = 1;
    for (std::size_t k = 0; k < 3; ++k)
      for (int n = 0; n < term.exponents[k]; ++n) monomial *= p[k];
    sum += term.coefficient * Ring(monomial);
  }
  return sum;
}

template <class Ring>
std::vector<QuadricTermOver<Ring>> QuadricOver<Ring>::terms() const {
  std::vector<QuadricTermOver<Ring>> result;
  for (std::size_t i = 0; i < coefficients_.size(); ++i)
    if (!coefficients_[i].is_zero()) result.push_back({coefficients_[i], monomials[i]});
  return result;
}

template class QuadricOver<Rational>;
template class QuadricOver<Polynomial>;

Quadric quadratic_cylinder(const LineForms& forms) { return cylinder_over(forms); }

SymbolicQuadric quadratic_cylinder(const LineFormsOver<Polynomial>& forms) { return cylinder_over(forms); }

BoundingPlanes bounding_planes(const LineForms& forms) {
  if (!is_zero(forms.e0.normal) || forms.e0.constant.is_zero())
    throw std::domain_error("bounding planes: the form e0 is not a constant other than zero");
  const Rational orientation = sign(forms.e0.constant);
  const AffineForm end = {forms.e1.normal, forms.e1.constant - forms.e0.constant};
  return {scaled(orientation, forms.e1), scaled(orientation, end)};
}

}  // namespace exsect

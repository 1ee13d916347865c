#include "space_forms.h"

namespace exsect {

SpacePolynomial affine_form(const Point& normal, const Rational& constant) {
  SpacePolynomial form = SpacePolynomial::constant(constant);
  for (std::size_t k = 0; k < 3; ++k) form += normal[k] * SpacePolynomial::variable(k);
  return form;
}

SpacePolynomial height_form(const Point& c, const Point& d) { return affine_form(d, -dot(c, d)); }

SpacePolynomial squared_distance(const Point& c) {
  SpacePolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const SpacePolynomial difference = SpacePolynomial::variable(k) - SpacePolynomial::constant(c[k]);
    sum += difference * difference;
  }
  return sum;
}

}  // namespace exsect

#include "curve/polynomial_vector.h"

#include <exsect/geometry/pull_back.h>

namespace exsect {

PolynomialVector coordinates_from(const BezierPatch& patch, const Point& origin) {
  PolynomialVector result;
  for (std::size_t k = 0; k < 3; ++k) {
    Point axis = {0, 0, 0};
    axis[k] = 1;
    result[k] = pull_back(AffineForm{axis, -origin[k]}, patch);
  }
  return result;
}

PolynomialVector coordinates_from(const RationalPatch& patch, const Point& origin) {
  const BivariatePolynomial weight = patch.component(3);
  PolynomialVector result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = patch.component(static_cast<int>(k)) + weight * Polynomial(-origin[k]);
  return result;
}

}  // namespace exsect

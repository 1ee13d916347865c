#include "line/moving_planes.h"

#include <exsect/algebra/rational_matrix.h>

#include <algorithm>

namespace exsect {

int degree(const HomogeneousCurve& curve) {
  int result = -1;
  for (const Polynomial& c : curve) result = std::max(result, c.degree());
  return result;
}

HomogeneousCurve without_common_factor(const HomogeneousCurve& curve) {
  Polynomial common;
  for (const Polynomial& c : curve) common = gcd(common, c);
  HomogeneousCurve result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = exact_quotient(curve[k], common);
  return result;
}

std::vector<MovingPlane> moving_planes(const HomogeneousCurve& curve, int degree_of_plane) {
  const auto planes = static_cast<std::size_t>(degree_of_plane) + 1;
  const auto terms = static_cast<std::size_t>(degree(curve)) + 1;
  RationalMatrix conditions(planes + terms - 1, 4 * planes);
  for (std::size_t i = 0; i < planes; ++i)
    for (std::size_t j = 0; j < terms; ++j)
      for (std::size_t k = 0; k < 4; ++k)
        conditions(i + j, 4 * i + k) = curve[k].coefficient(static_cast<int>(j));
  std::vector<MovingPlane> result;
  for (const std::vector<Integer>& vector : null_space(conditions)) {
    MovingPlane plane(planes);
    for (std::size_t i = 0; i < planes; ++i)
      for (std::size_t k = 0; k < 4; ++k) plane[i][k] = Rational(vector[4 * i + k]);
    result.push_back(std::move(plane));
  }
  return result;
}

}  // namespace exsect

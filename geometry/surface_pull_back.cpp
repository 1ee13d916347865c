#include "surface_pull_back.h"

#include <algorithm>

#include "homogeneous_composition.h"

namespace exsect {
namespace {

/// w^e f(x/w, y/w, z/w) for X = (x, y, z, w).
template <class Ring>
Ring inserted(const SpacePolynomial& f, const std::array<Ring, 4>& coordinates) {
  const int e = std::max(f.degree(), 0);
  std::array<std::vector<Ring>, 4> power;
  for (std::size_t k = 0; k < 4; ++k) {
    power[k] = powers_up_to(coordinates[k], k < 3 ? f.degree_in(k) : e, ring_constant(coordinates[k], 1));
  }
  const auto raised = [&](std::size_t k, int exponent) {
    return power[k][static_cast<std::size_t>(exponent)];
  };
  Ring sum;
  for (const auto& [exponents, coefficient] : f.terms()) {
    const int rest = e - exponents[0] - exponents[1] - exponents[2];
    sum += (ring_constant(coordinates[0], coefficient) * raised(0, exponents[0]) * raised(1, exponents[1])) *
           (raised(2, exponents[2]) * raised(3, rest));
  }
  return sum;
}

}  // namespace

BivariatePolynomial pull_back(const SpacePolynomial& f, const RationalPatch& x) {
  return inserted<BivariatePolynomial>(f, {x.component(0), x.component(1), x.component(2), x.component(3)});
}

Polynomial pull_back(const SpacePolynomial& f, const Point& origin, const Point& direction) {
  const auto coordinate = [&](std::size_t k) { return Polynomial{origin[k], direction[k]}; };
  return inserted<Polynomial>(f, {coordinate(0), coordinate(1), coordinate(2), Polynomial(1)});
}

}  // namespace exsect

#include "line/exact_tangent.h"

#include "curve/polynomial_vector.h"

namespace exsect {

namespace {

using Vector = PolynomialVector;

/// The derivatives of a patch by both parameters, times powers of the parameters' denominators.
struct Derivatives {
  Vector first;
  Vector second;
};

Derivatives derivatives(const BezierPatch& patch, const ExactParameters& point, std::size_t first) {
  const ControlNet c = patch.power_basis();
  const auto powers = [&](std::size_t j) {  // n^i d^(2-i)
    const BivariatePolynomial& n = point.numerator[j];
    const BivariatePolynomial& d = point.denominator[j];
    return Vector{d * d, n * d, n * n};
  };
  const auto slopes = [&](std::size_t j) {  // i n^(i-1) d^(2-i)
    return Vector{BivariatePolynomial(), point.denominator[j],
                  BivariatePolynomial::constant(2) * point.numerator[j]};
  };
  const auto sum = [&](const Vector& a, const Vector& b) {
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const BivariatePolynomial term = a[i] * b[j];
        for (std::size_t k = 0; k < 3; ++k)
          if (c[i][j][k] != 0) result[k] += BivariatePolynomial::constant(c[i][j][k]) * term;
      }
    return result;
  };
  return {sum(slopes(first), powers(first + 1)), sum(powers(first), slopes(first + 1))};
}

}  // namespace

std::array<bool, 4> zero_tangent_components(const BezierPatch& x, const BezierPatch& y,
                                            const ExactParameters& point) {
  const Derivatives of_x = derivatives(x, point, 0);
  const Derivatives of_y = derivatives(y, point, 2);
  const Vector nx = cross(of_x.first, of_x.second);
  const Vector ny = cross(of_y.first, of_y.second);
  const auto is_zero = [&](const BivariatePolynomial& f) { return sign_at(f, point.at) == 0; };
  return {is_zero(dot(of_x.second, ny)), is_zero(dot(of_x.first, ny)), is_zero(dot(of_y.second, nx)),
          is_zero(dot(of_y.first, nx))};
}

}  // namespace exsect

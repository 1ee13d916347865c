#include "star/pinch_points.h"

#include "answer/parameter_box.h"
#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"
#include "line/half_rational_point.h"

namespace exsect {

namespace {

/// The coordinates of the product of both derivatives.
std::vector<BivariatePolynomial> normal(const BezierPatch& patch) {
  const PolynomialVector c = coordinates_from(patch, {0, 0, 0});
  return {jacobian(c[1], c[2]), jacobian(c[2], c[0]), jacobian(c[0], c[1])};
}

/// Both coordinates of the point, if they are rational.
std::optional<std::array<Rational, 2>> rational_coordinates(const TriangularPoint& point) {
  const Rational width = power_of_two(-200);
  const TriangularPoint fine = point.refined_to(width);
  const std::array<Rational, 2> result = {simplest_near(fine.r_interval(), width),
                                          simplest_near(fine.s().interval(), width)};
  const auto r = BivariatePolynomial::r() - BivariatePolynomial::constant(result[0]);
  const bool exact = fine.s().compare(result[1]) == 0 && sign_at(r, fine) == 0;
  return exact ? std::optional(result) : std::nullopt;
}

}  // namespace

std::vector<CertifiedPoint> pinch_points(const BezierPatch& x, const BezierPatch& y) {
  std::vector<CertifiedPoint> result;
  for (const bool of_x : {true, false}) {
    for (const TriangularPoint& point : common_zeros(normal(of_x ? x : y)).points) {
      const auto at = rational_coordinates(point);
      if (!at) continue;
      for (HalfRationalPoint& solution : half_rational_points(x, y, of_x, *at))
        result.push_back(std::move(solution.point));
    }
  }
  return result;
}

}  // namespace exsect

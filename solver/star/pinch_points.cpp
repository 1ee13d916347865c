#include "star/pinch_points.h"

#include <exsect/geometry/pull_back.h>

#include "answer/parameter_box.h"
#include "curve/plane_curve.h"
#include "line/half_rational_point.h"

namespace exsect {

namespace {

/// The coordinates of the product of both derivatives.
std::vector<BivariatePolynomial> normal(const BezierPatch& patch) {
  const auto coordinate = [&](std::size_t k) {
    Point axis = {0, 0, 0};
    axis[k] = 1;
    return pull_back(AffineForm{axis, 0}, patch);
  };
  const std::array<BivariatePolynomial, 3> c = {coordinate(0), coordinate(1), coordinate(2)};
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

#include "pinch_points.h"

#include <exsect/geometry/pull_back.h>

#include "half_rational_point.h"
#include "plane_curve.h"

namespace exsect {

namespace {

/// The coordinates of the product of both derivatives.
std::vector<BivariatePolynomial> normal(const BezierPatch& patch) {
  std::array<BivariatePolynomial, 3> first;
  std::array<BivariatePolynomial, 3> second;
  for (std::size_t k = 0; k < 3; ++k) {
    Point axis = {0, 0, 0};
    axis[k] = 1;
    const BivariatePolynomial coordinate = pull_back(AffineForm{axis, 0}, patch);
    first[k] = coordinate.derivative_r();
    second[k] = coordinate.derivative_s();
  }
  std::vector<BivariatePolynomial> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3;
    const std::size_t b = (k + 2) % 3;
    result.push_back(first[a] * second[b] - first[b] * second[a]);
  }
  return result;
}

/// Both coordinates of the point, if they are rational.
std::optional<std::array<Rational, 2>> rational_coordinates(const TriangularPoint& point) {
  const TriangularPoint fine = point.refined_to(power_of_two(-200));
  std::array<Rational, 2> result;
  for (const std::size_t k : {0U, 1U}) {
    const RationalInterval i = k == 0 ? fine.r_interval() : fine.s().interval();
    result[k] = i.width() == 0 ? i.lower
                               : simplest_between(i.lower - power_of_two(-200), i.upper + power_of_two(-200));
  }
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

#include "verify.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/bounding_box.h>
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "rounds.h"
#include "scale.h"
#include "verifier.h"

namespace exsect {

namespace {

void require_tolerance(double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw std::invalid_argument("the tolerance must be positive and finite");
}

/// Throws std::invalid_argument where an invariant of the candidate is broken.
void check(const Candidate& candidate) {
  const auto check_square = [](double p) {
    if (!(p >= -1 && p <= 2)) throw std::invalid_argument("a parameter of the candidate is not in [-1,2]");
  };
  for (const CandidateCurve& curve : candidate.curves) {
    for (const auto* spline : {&curve.space, &curve.first, &curve.second}) {
      if (!*spline) continue;
      const std::string wrong = violation(**spline);
      if (!wrong.empty()) throw std::invalid_argument("a curve of the candidate: " + wrong);
      for (const auto& point : (*spline)->points)
        for (std::size_t k = 0; spline != &curve.space && k < 2; ++k) check_square(point[k]);
    }
  }
  for (const CandidatePoint& point : candidate.points) {
    for (std::size_t k = 0; point.point && k < 3; ++k)
      if (!(std::fabs((*point.point)[k]) <= max_candidate_number))
        throw std::invalid_argument("a coordinate of the candidate is beyond 2^500");
    for (const auto* square : {&point.first, &point.second})
      if (*square) std::for_each((*square)->begin(), (*square)->end(), check_square);
  }
}

/// Throws BeyondDoubles if a patch is not in the range of doubles.
double extent_of(const RationalPatch& x, const RationalPatch& y) {
  const BoundingBox box = united(bounding_box(x), bounding_box(y));
  for (const Point& p : {box.lower, box.upper})
    for (const Rational& c : p)
      if (!std::isfinite(to_double(c)))
        throw BeyondDoubles("control points must lie in the range of doubles");
  return to_double(largest_extent(box));
}

}  // namespace

Verdict judged(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
               const IntersectResult& exact, double tolerance, const StopRequest& stop) {
  require_tolerance(tolerance);
  check(candidate);
  const int e = exponent_of_size(x, y);
  if (e == 0) return Verifier(candidate, x, y, exact, tolerance, stop)();
  const double scaled = std::ldexp(tolerance, -e);
  require_tolerance(scaled);
  const Candidate near_unit = scaled_down(candidate, e);
  const IntersectResult truth = scaled_down(exact, e);
  return scaled_up(Verifier(near_unit, scaled_down(x, e), scaled_down(y, e), truth, scaled, stop)(), e);
}

Verdict verify(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
               const IntersectResult& exact, double tolerance) {
  return in_nearest_rounding([&] { return judged(candidate, x, y, exact, tolerance, {}); });
}

Verification verify(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
                    const VerifyOptions& options) {
  return in_nearest_rounding([&]() -> Verification {
    require_tolerance(options.tolerance);
    check(candidate);
    const VerifyQuestion question = {
        extent_of(x, y), [&](const IntersectOptions& fine) { return intersect(x, y, fine); },
        [&](const IntersectResult& exact, double tolerance, const StopRequest& stop) {
          return judged(candidate, x, y, exact, tolerance, stop);
        },
        !x.biquadratic() || !y.biquadratic()};  // solved in doubles alone
    return verified(question, options);
  });
}

}  // namespace exsect

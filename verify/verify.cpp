#include "verify.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/rounding_bounds.h>
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

Verdict judged(const ComparedPair& pair) {
  require_tolerance(pair.tolerance);
  check(pair.candidate);
  const int e = exponent_of_size(pair.surfaces, pair.exact.graph);
  if (e == 0) return Verifier(pair)();
  const Candidate candidate = scaled_down(pair.candidate, e);
  const IntersectResult truth = scaled_down(pair.exact, e);
  ComparedPair near_unit = {{scaled_down(pair.surfaces[0], e), scaled_down(pair.surfaces[1], e)},
                            candidate,
                            truth,
                            pair.point_bounds,
                            std::ldexp(pair.tolerance, -e),
                            pair.stop};
  for (double& bound : near_unit.point_bounds) bound = std::ldexp(bound, -e) + kUnderflowLoss;
  require_tolerance(near_unit.tolerance);
  return scaled_up(Verifier(near_unit)(), e);
}

Verdict verify(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
               const IntersectResult& exact, double tolerance) {
  return in_nearest_rounding([&] { return judged({{x, y}, candidate, exact, {}, tolerance, {}}); });
}

Verification verify(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
                    const VerifyOptions& options) {
  return in_nearest_rounding([&]() -> Verification {
    require_tolerance(options.tolerance);
    check(candidate);
    const double extent = extent_of(x, y);
    const VerifyQuestion question = {
        [&](const IntersectResult&) { return extent; },
        [&](const IntersectOptions& fine) { return intersect(x, y, fine); },
        [&](const IntersectResult& exact, double tolerance, const StopRequest& stop) {
          return judged({{x, y}, candidate, exact, {}, tolerance, stop});
        },
        !x.biquadratic() || !y.biquadratic()};  // solved in doubles alone
    return verified(question, options);
  });
}

}  // namespace exsect

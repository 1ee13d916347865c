#include "verify_equation.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/bounding_box.h>
#include <exsect/solver/intersect_equations.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "rounds.h"
#include "space_graph.h"

namespace exsect {

namespace {

template <class Claim>
void require_no_parameters(const std::vector<Claim>& claims, bool of_first) {
  for (const Claim& claim : claims)
    if (claim.second || (of_first && claim.first))
      throw NotComparable("the candidate has parameters of a surface given by its equation, which has none");
}

/// The intersection of two surfaces, and what a comparison needs of it beside its graph.
class EquationsQuestion {
 public:
  EquationsQuestion(const Candidate& candidate, const ImplicitSurface& first, const ImplicitSurface& second)
      : candidate_(candidate), first_(first), second_(second) {}

  /// With polylines that keep within the tolerance times the extent of the common points: intersect() takes
  /// it times the extent of what they are drawn on, which may be larger.
  IntersectResult solved(const IntersectOptions& options) {
    IntersectOptions fine = options;
    found_ = intersect(first_, second_, fine);
    require_judged();
    const double wanted = options.tolerance * extent_in_space(found_), drawn = largest_bound(found_);
    if (wanted > 0 && drawn > wanted) {
      fine.tolerance *= wanted / (2 * drawn);
      found_ = intersect(first_, second_, fine);
    }
    tolerance_ = fine.tolerance;
    return graph_in_space(found_);
  }

  Verdict judged_by(const IntersectResult& exact, double tolerance, const StopRequest& stop) const {
    return judged({{first_, second_}, candidate_, exact, point_bounds(found_), tolerance, stop});
  }

  const SurfaceIntersection& found() const { return found_; }
  double tolerance() const { return tolerance_; }

 private:
  void require_judged() const {
    if (found_.is_same) throw NotComparable("the surfaces are one: there is no curve to compare");
    if (found_.count(SpaceNodeKind::cut) > 0)
      throw NotComparable(
          "a common curve goes on to infinity, which no candidate does: a surface in a box is needed");
  }

  const Candidate& candidate_;
  const ImplicitSurface& first_;
  const ImplicitSurface& second_;
  SurfaceIntersection found_{Status::incomplete};
  double tolerance_ = 0;
};

}  // namespace

Verification verify(const Candidate& candidate, const ImplicitSurface& surface, const RationalPatch& x,
                    const VerifyOptions& options) {
  return in_nearest_rounding([&]() -> Verification {
    require_no_parameters(candidate.curves, false);
    require_no_parameters(candidate.points, false);
    const double extent = to_double(largest_extent(bounding_box(x)));
    const VerifyQuestion question = {
        [&](const IntersectResult&) { return extent; },
        [&](const IntersectOptions& fine) { return intersect(surface, x, fine); },
        [&](const IntersectResult& exact, double tolerance, const StopRequest& stop) {
          return judged({{x, surface}, candidate, exact, {}, tolerance, stop});
        }};
    Verification result = verified(question, options);
    result.exact_turning = {Parameter::u, Parameter::v};
    return result;
  });
}

EquationsVerification verify(const Candidate& candidate, const ImplicitSurface& first,
                             const ImplicitSurface& second, const VerifyOptions& options) {
  return in_nearest_rounding([&]() -> EquationsVerification {
    require_no_parameters(candidate.curves, true);
    require_no_parameters(candidate.points, true);
    EquationsQuestion asked(candidate, first, second);
    const VerifyQuestion question = {
        [&](const IntersectResult&) { return extent_in_space(asked.found()); },
        [&](const IntersectOptions& fine) { return asked.solved(fine); },
        [&](const IntersectResult& exact, double tolerance, const StopRequest& stop) {
          return asked.judged_by(exact, tolerance, stop);
        }};
    EquationsVerification result{verified(question, options), asked.found()};
    result.exact_tolerance = asked.tolerance();
    result.exact_turning.clear();
    return result;
  });
}

}  // namespace exsect

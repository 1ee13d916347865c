#include "verify_equation.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/bounding_box.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "rounds.h"

namespace exsect {

namespace {

/// The curve as that of the patch with itself: r and s are u and v. Its points are the same, so is all that
/// is said of places of space and of parameters of the patch.
IntersectResult with_itself(IntersectResult exact) {
  const auto repeat = [](auto& values) {
    values[2] = values[0];
    values[3] = values[1];
  };
  const auto repeat_in = [&](std::vector<Arc>& arcs) {
    for (Arc& arc : arcs)
      for (PolylineVertex& vertex : arc.polyline) repeat(vertex.parameters);
  };
  for (Node& node : exact.graph.nodes) {
    repeat(node.box);
    repeat(node.approx);
  }
  repeat_in(exact.graph.arcs);
  for (Overlap& overlap : exact.graph.overlaps)
    for (std::vector<Arc>& chain : overlap.chains) repeat_in(chain);
  for (Incomplete& region : exact.incomplete) repeat(region.where);
  return exact;
}

/// r and s are u and v in gaps as well.
void name_by_patch(Verdict& verdict) {
  const auto rename = [](ArcGap& gap) {
    gap.parameter = index(gap.parameter) % 2 == 0 ? Parameter::u : Parameter::v;
  };
  for (ArcFinding& arc : verdict.arcs) std::ranges::for_each(arc.gaps, rename);
  for (Difference& difference : verdict.differences)
    if (difference.gap) rename(*difference.gap);
}

void require_no_second(const Candidate& candidate) {
  const auto has_second = [](const auto& claim) { return claim.second.has_value(); };
  if (std::ranges::any_of(candidate.curves, has_second) || std::ranges::any_of(candidate.points, has_second))
    throw std::invalid_argument(
        "the candidate has parameters of a surface given by its equation, which has none");
}

}  // namespace

Verification verify(const Candidate& candidate, const ImplicitSurface& surface, const RationalPatch& x,
                    const VerifyOptions& options) {
  return in_nearest_rounding([&]() -> Verification {
    require_no_second(candidate);
    const VerifyQuestion question = {
        to_double(largest_extent(bounding_box(x))),
        [&](const IntersectOptions& fine) { return intersect(surface, x, fine); },
        [&](const IntersectResult& exact, double tolerance, const StopRequest& stop) {
          Verdict verdict = judged(candidate, x, x, with_itself(exact), tolerance, stop);
          name_by_patch(verdict);
          return verdict;
        }};
    Verification result = verified(question, options);
    result.exact_turning = {Parameter::u, Parameter::v};
    return result;
  });
}

}  // namespace exsect

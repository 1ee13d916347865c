#include "verify_equation.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/bounding_box.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "verifier.h"

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
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const auto left = [&] {
      return *options.max_seconds - std::chrono::duration<double>(Clock::now() - start).count();
    };
    const StopRequest stop = options.max_seconds ? StopRequest([&] { return left() <= 0; }) : StopRequest();
    const double extent = to_double(largest_extent(bounding_box(x)));
    const double tolerance = options.tolerance * (extent > 0 ? extent : 1);
    IntersectOptions fine;
    fine.progress = options.progress;
    constexpr int most_rounds = 3;
    for (int round = 1;; ++round) {
      fine.tolerance = std::ldexp(options.tolerance, -1 - 3 * round);
      if (options.max_seconds) fine.max_seconds = std::max(0.75 * left(), 1e-9);  // the rest to compare
      IntersectResult exact = intersect(surface, x, fine);
      Verdict verdict = judged(candidate, x, x, with_itself(exact), tolerance, stop);
      name_by_patch(verdict);
      if (verdict.agreement != Agreement::undecided || !verdict.exact_is_complete || round == most_rounds ||
          is_stopped(stop))
        return {std::move(verdict), std::move(exact), fine.tolerance, {Parameter::u, Parameter::v}};
    }
  });
}

}  // namespace exsect

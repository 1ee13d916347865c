#include "intersect.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/beyond_doubles.h>

#include "answer/finished_result.h"
#include "answer/placed_result.h"
#include "answer/proof.h"
#include "confirmed_curves.h"
#include "filter/filter.h"
#include "intersect_as_curve.h"
#include "intersect_at_pole.h"
#include "intersect_exactly.h"
#include "intersect_within.h"
#include "overlap/rational_pieces.h"
#include "signs_beside.h"

namespace exsect {

namespace {

/// Where doubles cannot decide, or are not asked.
IntersectResult intersect_beyond_filter(const Run& run, const BezierPatch& x, const BezierPatch& y) {
  ExactPair pair(x, y, run.stop());
  if (!run.exact()) {
    run.add_time_until_now("filter");
  } else if (auto found = confirmed_curves(x, y, run, pair)) {
    return *std::move(found);
  }
  return intersect_exactly(x, y, run, pair);
}

IntersectResult intersect_biquadratic(const Run& run, const BezierPatch& x, const BezierPatch& y);

/// What the sweep leaves as it is in `result`, by the inverse of a patch (method 17), what is proved near a
/// pole (14.24), or as pieces of one surface (14.10).
IntersectResult intersect_as_others(const Run& run, const BezierPatch& x, const BezierPatch& y,
                                    const IntersectResult& result) {
  if (auto as_curve = intersect_as_curve(x, y, run)) return *std::move(as_curve);
  const auto solve = [](const RationalPatch& first, const RationalPatch& second, const Run& part) {
    return intersect_biquadratic(part, *first.biquadratic(), *second.biquadratic());
  };
  if (auto at_pole = intersect_at_pole(x, y, run, solve)) return *std::move(at_pole);
  if (run.exact()) return result;
  IntersectResult pieces = intersect_rational_pieces(x, y, run);
  return pieces.status == Status::complete ? pieces : result;
}

/// Points beyond doubles cannot be drawn: then what the sweep has found is the answer.
IntersectResult intersect_biquadratic(const Run& run, const BezierPatch& x, const BezierPatch& y) {
  IntersectResult result = intersect_in_place(run, x, y);
  if (result.status == Status::complete || run.out_of_time()) return result;
  try {
    return intersect_as_others(run, x, y, result);
  } catch (const BeyondDoubles&) {
    return result;
  }
}

}  // namespace

IntersectResult intersect(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options) {
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    IntersectResult answer = run.finished(with_signs_beside(x, y, run, [&](const Run& part) {
      return answered(part, [&] { return intersect_biquadratic(part, x, y); });
    }));
    const auto again = [x, y](const IntersectOptions& other) { return intersect(x, y, other); };
    return answer_to(options, std::move(answer), again);
  });
}

IntersectResult intersect_within(const Run& run, const BezierPatch& x, const BezierPatch& y) {
  if (!run.exact())
    if (auto found = intersect_filtered(x, y, run)) return *std::move(found);
  return intersect_beyond_filter(run, x, y);
}

IntersectResult intersect_in_place(const Run& run, const BezierPatch& x, const BezierPatch& y) {
  if (!run.exact())
    if (auto found = intersect_filtered(x, y, run)) return *std::move(found);
  const auto place = Placement::of(x, y);
  const auto solve = [&](const Run& in_place) {
    return place ? intersect_within(in_place, place->placed(x), place->placed(y))
                 : intersect_beyond_filter(in_place, x, y);
  };
  return solved_in_place(place, to_double(model_extent(x, y)), run, solve);
}

}  // namespace exsect

#include "intersect.h"

#include <exsect/algebra/nearest_rounding.h>

#include "answer/finished_result.h"
#include "confirmed_curves.h"
#include "filter/filter.h"
#include "intersect_exactly.h"
#include "intersect_within.h"

namespace exsect {

IntersectResult intersect(const BezierPatch& x, const BezierPatch& y, const IntersectOptions& options) {
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    return run.finished(answered([&] { return intersect_within(run, x, y); }));
  });
}

IntersectResult intersect_within(const Run& run, const BezierPatch& x, const BezierPatch& y) {
  auto result = run.exact() ? confirmed_curves(x, y, run) : intersect_filtered(x, y, run);
  if (result) return std::move(*result);
  if (!run.exact()) run.add_time_until_now("filter");
  return intersect_exactly(x, y, run);
}

}  // namespace exsect

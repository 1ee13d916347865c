#include "intersect_rational.h"

#include <exsect/algebra/nearest_rounding.h>

#include "answer/finished_result.h"
#include "answer/run.h"
#include "filter/filter.h"
#include "intersect.h"
#include "self/self_intersect.h"

namespace exsect {

IntersectResult intersect(const RationalPatch& x, const RationalPatch& y, const IntersectOptions& options) {
  const auto first = x.biquadratic();
  const auto second = y.biquadratic();
  if (first && second) return intersect(*first, *second, options);
  if (options.exact) throw NotSupported(first ? y : x);
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    return run.finished(answered(run, [&] {
      IntersectResult result = intersect_in_doubles(x, y, run);
      if (result.status != Status::complete) run.count("filtered", 1);
      return result;
    }));
  });
}

IntersectResult self_intersect(const RationalPatch& x, const IntersectOptions& options) {
  const auto patch = x.biquadratic();
  if (!patch) throw NotSupported(x);
  return self_intersect(*patch, options);
}

}  // namespace exsect

#include "intersect_rational.h"

#include <exsect/algebra/nearest_rounding.h>

#include <utility>
#include <vector>

#include "answer/finished_result.h"
#include "answer/parameter_names.h"
#include "answer/proof.h"
#include "answer/run.h"
#include "filter/filter.h"
#include "intersect.h"
#include "self/self_intersect.h"
#include "self/self_intersect_in_doubles.h"
#include "signs_beside.h"

namespace exsect {

namespace {

/// Doubles may decide in one order of the patches what they do not in the other one.
IntersectResult intersect_in_either_order(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  IntersectResult result = intersect_in_doubles(x, y, run);
  if (result.status == Status::complete || run.out_of_time()) return result;
  const OtherRun exchanged = [](const Run& given) {
    std::vector<Parameter> turning;
    for (const Parameter p : given.turning()) turning.push_back(all_parameters[(index(p) + 2) % 4]);
    return given.with_turning(std::move(turning));
  };
  IntersectResult other = intersect_in_doubles(y, x, exchanged(run));
  if (other.status != Status::complete) return result;
  const auto rename = [](IntersectResult& renamed, const Run&) {
    rename_parameters(renamed, {Parameter::r, Parameter::s, Parameter::u, Parameter::v});
  };
  return changed(std::move(other), run, rename, exchanged);
}

}  // namespace

IntersectResult intersect(const RationalPatch& x, const RationalPatch& y, const IntersectOptions& options) {
  const auto first = x.biquadratic();
  const auto second = y.biquadratic();
  if (first && second) return intersect(*first, *second, options);
  if (options.exact) throw NotSupported(first ? y : x);
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    IntersectResult result = with_signs_beside(x, y, run, [&](const Run& part) {
      return answered(part, [&] { return intersect_in_either_order(x, y, part); });
    });
    if (result.status != Status::complete) run.count("filtered", 1);
    const auto again = [x, y](const IntersectOptions& other) { return intersect(x, y, other); };
    return answer_to(options, run.finished(std::move(result)), again);
  });
}

IntersectResult self_intersect(const RationalPatch& x, const IntersectOptions& options) {
  const auto patch = x.biquadratic();
  if (patch) return self_intersect(*patch, options);
  if (options.exact) throw NotSupported(x);
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    IntersectResult result = answered(run, [&] {
      run.count("filtered", 1);
      return self_intersect_in_doubles(x, run);
    });
    const auto again = [x](const IntersectOptions& other) { return self_intersect(x, other); };
    return answer_to(options, run.finished(std::move(result)), again);
  });
}

}  // namespace exsect

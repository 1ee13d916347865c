#include "intersect_rational.h"

#include <exsect/algebra/nearest_rounding.h>

#include <utility>
#include <vector>

#include "answer/finished_result.h"
#include "answer/parameter_names.h"
#include "answer/run.h"
#include "filter/filter.h"
#include "intersect.h"
#include "self/self_intersect.h"
#include "signs_beside.h"

namespace exsect {

namespace {

/// Doubles may decide in one order of the patches what they do not in the other one.
IntersectResult intersect_in_either_order(const RationalPatch& x, const RationalPatch& y, const Run& run) {
  IntersectResult result = intersect_in_doubles(x, y, run);
  if (result.status == Status::complete || run.out_of_time()) return result;
  const auto exchanged = [](Parameter p) { return all_parameters[(index(p) + 2) % 4]; };
  std::vector<Parameter> turning;
  for (const Parameter p : run.turning()) turning.push_back(exchanged(p));
  IntersectResult other = intersect_in_doubles(y, x, run.with_turning(std::move(turning)));
  if (other.status != Status::complete) return result;
  rename_parameters(other, {Parameter::r, Parameter::s, Parameter::u, Parameter::v});
  return other;
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
    return run.finished(std::move(result));
  });
}

IntersectResult self_intersect(const RationalPatch& x, const IntersectOptions& options) {
  const auto patch = x.biquadratic();
  if (!patch) throw NotSupported(x);
  return self_intersect(*patch, options);
}

}  // namespace exsect

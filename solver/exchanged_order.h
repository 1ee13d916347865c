// A pair of patches solved in the other order. Internal to solver/.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/result.h>

#include <optional>
#include <utility>
#include <vector>

#include "answer/parameter_names.h"
#include "answer/proof.h"
#include "answer/run.h"

namespace exsect {

/// What `solve` finds of y and x, if it does, as a result of x and y.
template <class Solve>
std::optional<IntersectResult> in_exchanged_order(const RationalPatch& x, const RationalPatch& y,
                                                  const Run& run, const Solve& solve) {
  const OtherRun exchanged = [](const Run& given) {
    std::vector<Parameter> turning;
    for (const Parameter p : given.turning()) turning.push_back(all_parameters[(index(p) + 2) % 4]);
    return given.with_turning(std::move(turning));
  };
  std::optional<IntersectResult> other = solve(y, x, exchanged(run));
  if (!other || other->status != Status::complete) return std::nullopt;
  const auto rename = [](IntersectResult& renamed, const Run&) {
    rename_parameters(renamed, {Parameter::r, Parameter::s, Parameter::u, Parameter::v});
  };
  return changed(*std::move(other), run, rename, exchanged);
}

}  // namespace exsect

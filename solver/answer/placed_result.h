// Questions that are answered about the origin. Internal to solver/; docs/method.md, section 8.
#pragma once

#include <exsect/solver/result.h>

#include <functional>
#include <optional>

#include "answer/placement.h"
#include "answer/run.h"

namespace exsect {

/// What `solve` returns, of the model as it is or, if there is a placement, of the placed one: in the given
/// model, and coarse by the tolerance of the run for a model of this extent. So is what is drawn from its
/// proof.
IntersectResult solved_in_place(const std::optional<Placement>& place, double extent, const Run& run,
                                const std::function<IntersectResult(const Run&)>& solve);

}  // namespace exsect

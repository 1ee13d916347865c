// Lines and conics of the shadow of a lifted curve, and what lies above them. Internal to solver/;
// docs/method-equations.md, section 17.7.
#pragma once

#include <functional>
#include <optional>

#include "lift/lifted_curve.h"
#include "lift/surface_intersection.h"

namespace exsect {

/// Which arcs above a factor belong to one curve: those with equal numbers part(arc); and that curve without
/// its arcs.
struct NamedParts {
  std::function<int(const LiftedArc&)> part;
  std::function<SpaceCurve(int part)> curve;
};

/// What is above a factor of the shadow of total degree at most 2, or in u alone, or in v alone on a
/// cylinder; empty if it has no name.
std::optional<NamedParts> named_parts(const LiftedCurve& curve, const ShadowFactor& factor);

}  // namespace exsect

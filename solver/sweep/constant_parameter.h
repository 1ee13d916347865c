// Curves on which a parameter is constant. Internal to solver/; docs/method.md, section 6.5.
#pragma once

#include "sweep/sweep_data.h"
#include "trace/tangential_arc.h"

namespace exsect {

/// True only if the parameter is constant on the curve, a Trace or a TangentialArc. `width`: of the boxes of
/// exact points.
template <class Ball, class Curve>
bool is_constant(const PairSystem<Ball>& system, const SweepData& sweep, const Curve& curve, Parameter p,
                 const Rational& width);

/// All points of the line `across` at which p may be the value, within 2^-100; empty if the line's points are
/// not known, or parts of it lie on the other patch. They live as long as the sweep's pair.
std::optional<std::vector<const CertifiedPoint*>> points_with_value(const SweepData& sweep,
                                                                    const LineQuery& across, Parameter p,
                                                                    const Rational& value);

/// True if a point of the line `across` with p = value exactly is on the curve: one that is rational, or the
/// only one that may have that value where one must.
template <class Ball, class Curve>
bool meets_line(const SweepData& sweep, const Curve& curve, const LineQuery& across, Parameter p,
                const Rational& value, const Rational& width);

/// A parameter that is a function of a constant one is constant: `coincident` names the other one, or the
/// parameter itself (ExactPair::coincident).
void mark_coincident(std::array<bool, 4>& constant, const std::array<std::size_t, 4>& coincident);

}  // namespace exsect

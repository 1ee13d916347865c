// Root isolation for a polynomial of low degree whose coefficients are known as balls.
#pragma once

#include <exsect/algebra/double_double_ball.h>

#include <optional>
#include <span>
#include <vector>

namespace exsect {

/// Of the polynomial with the coefficients f, constant term first, at t (Horner).
DoubleDoubleBall evaluate(std::span<const DoubleDoubleBall> f, const DoubleDoubleBall& t);

/// Balls of points of (0,1), ascending: every polynomial with coefficients in the balls f, constant term
/// first, has exactly one root in each of them, a simple one, and no other in [0,1]. Empty if the balls do
/// not decide that. Radii are about 2^-90 for roots that are well conditioned. Requires at most 17
/// coefficients, else std::invalid_argument.
std::optional<std::vector<DoubleDoubleBall>> isolate_ball_roots(std::span<const DoubleDoubleBall> f);

}  // namespace exsect

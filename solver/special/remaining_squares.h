// Where no polynomial of some is positive, by subdivision. Internal to solver/.
#pragma once

#include <exsect/algebra/tensor_bernstein.h>

#include <functional>
#include <optional>
#include <vector>

namespace exsect {

/// Rectangles of [0,1]^2 that `is_small` takes, which hold all points of the square where none of the
/// polynomials is positive; empty if a point proves that there are no such rectangles, or that takes too many
/// steps. `is_small` has to take every rectangle, or point, inside of one that it takes.
std::optional<std::vector<Rectangle>> remaining_squares(
    const std::vector<BivariatePolynomial>& polynomials,
    const std::function<bool(const Rectangle&)>& is_small);

}  // namespace exsect

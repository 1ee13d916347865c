// The eliminant of pairs whose second patch has parameter lines that are single points, over the complex
// numbers, as a surface of revolution has. Internal to solver/; docs/method-equations.md, section 16.3.
#pragma once

#include <exsect/algebra/modular.h>
#include <exsect/algebra/polynomial.h>

#include <optional>

#include "eliminant/weighted_pair.h"

namespace exsect {

/// D(s) of (16.19), primitive; zero if every line Y(.,s) is a point. It divides R and S1 in powers.
Polynomial point_lines(const WeightedPair::Net& y);

/// E of (16.20) modulo primes, constant term first; of degree at most that of the kind of the pair, with less
/// than `bits` bits. Empty if it is zero or not defined, D is not of
/// degree 1 or 2, or has a root in (0,1).
std::optional<ModularIntegers> stripped_eliminant(const WeightedPair& pair, std::size_t bits);

}  // namespace exsect

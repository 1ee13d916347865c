// The turning eliminant of pairs whose generic fibre has fewer than 16 points: docs/method.md, section 4.6.
#pragma once

#include <exsect/geometry/integer_pair.h>
#include <exsect/solver/turning_eliminant.h>

namespace exsect {

/// E(u) (4.18), by exact elimination with u as a variable: for patches of lower degree, height fields,
/// symmetric pairs and every other shape whose generic fibre is finite and separated by one of its two
/// parameters r, s; (4.20) where it has multiple points. Otherwise `degenerate` says which condition fails,
/// exactly.
TurningEliminant special_eliminant(const IntegerPair& pair);

/// The primitive integer multiple of f != 0 with positive leading coefficient.
Polynomial primitive_with_positive_lead(const Polynomial& f);

}  // namespace exsect

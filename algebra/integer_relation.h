// Integer relations between real numbers.
#pragma once

#include <exsect/algebra/rational.h>

#include <optional>
#include <vector>

namespace exsect {

/// Integers c, not all zero and without a common divisor, of which |Σ c_i v_i| is at most about 2^-bits, for
/// numbers v_i known to this precision: from a reduced basis of a lattice. Empty if they are so long that
/// numbers without a relation would have such ones as well. Nothing is proved: what is found is to be
/// verified.
std::optional<std::vector<Integer>> integer_relation(const std::vector<Rational>& values, int bits);

}  // namespace exsect

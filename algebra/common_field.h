// Real numbers known to many digits, recognised as numbers of one field.
#pragma once

#include <exsect/algebra/real_field.h>

#include <optional>
#include <vector>

namespace exsect {

/// Numbers of one real field of degree at most `most_degree`, one for each value, of size 1 at most and known
/// to `bits` bits: within 2^-(bits/2) of it, and with so few digits that they are hardly there by chance.
/// Empty if none are found. That they are the numbers that are meant is a guess, to be verified; that the
/// field is one is proved.
std::optional<std::vector<FieldNumber>> recognised_in_field(const std::vector<Rational>& values, int bits,
                                                            int most_degree);

}  // namespace exsect

// Square roots and angles of numbers that are known by intervals, enclosed.
#pragma once

#include <exsect/algebra/rational.h>

#include <optional>

namespace exsect {

/// The roots >= 0 of all numbers >= 0 of the closed interval, enclosed to a relative 2^-120. Throws
/// std::domain_error if it has none.
RationalInterval root_of(const RationalInterval& q);

/// The angles of all (x,y) of the box, counter-clockwise from (1,0), in whole turns, enclosed to 2^-120: a
/// closed interval in [0,1], or about 0, with negative numbers for what is just short of a whole turn. Empty
/// if (0,0) is in the box.
std::optional<RationalInterval> turn_of(const RationalInterval& x, const RationalInterval& y);

}  // namespace exsect

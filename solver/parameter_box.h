// Boxes of the four parameters. Internal to solver/.
#pragma once

#include <exsect/solver/parameter.h>

namespace exsect {

/// The smallest interval, or box, around both.
RationalInterval hull(const RationalInterval& a, const RationalInterval& b);
ParameterBox hull(const ParameterBox& a, const ParameterBox& b);

/// The closed boxes have a common point.
bool meet(const ParameterBox& a, const ParameterBox& b);

/// The closed box `inner` is a part of `outer`.
bool lies_in(const ParameterBox& inner, const ParameterBox& outer);

/// Of the closed intervals; 0 if they meet.
Rational gap(const RationalInterval& a, const RationalInterval& b);
/// The largest distance of the closed boxes in one of the parameters.
Rational distance(const ParameterBox& a, const ParameterBox& b);

}  // namespace exsect

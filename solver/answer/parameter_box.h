// Boxes of the four parameters. Internal to solver/.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/parameter.h>

namespace exsect {

/// The smallest interval, or box, around both.
RationalInterval hull(const RationalInterval& a, const RationalInterval& b);
ParameterBox hull(const ParameterBox& a, const ParameterBox& b);

/// The number itself, if the interval holds one alone, else the simplest one within `room` around it.
Rational simplest_near(const RationalInterval& at, const Rational& room);

/// All 1 - t, t in the interval.
RationalInterval reversed(const RationalInterval& at);

/// The number lies in the closed interval.
bool is_in(const RealAlgebraic& value, const RationalInterval& range);

/// The closed boxes have a common point.
bool meet(const ParameterBox& a, const ParameterBox& b);

/// u1 or u2 (fixed: 0), v1 or v2 (1) takes the value in the closed box.
bool meets_side(const ParameterBox& box, std::size_t fixed, int value);

/// The closed box `inner` is a part of `outer`.
bool lies_in(const ParameterBox& inner, const ParameterBox& outer);

/// [0,1]^4.
ParameterBox whole_domain();

/// A small box for a report around a place (u,v,r,s) known in doubles, cut to the unit squares; a coordinate
/// that is not finite is taken as 1/2.
ParameterBox around(const std::array<double, 4>& where);

/// Of the closed intervals; 0 if they meet.
Rational gap(const RationalInterval& a, const RationalInterval& b);
/// The largest distance of the closed boxes in one of the parameters.
Rational distance(const ParameterBox& a, const ParameterBox& b);

}  // namespace exsect

// Decimals of which every digit is proved.
#pragma once

#include <exsect/algebra/rational.h>

#include <string>

namespace exsect::cli {

/// The largest k with 10^k <= |q|; requires q != 0, else std::invalid_argument.
long decimal_exponent(const Rational& q);

/// Digits that are true of every number of the closed interval: each of them, rounded to nearest at the last
/// digit shown, gives what is shown, with its trailing zeros; a number half way between two decimals rounds
/// to either. The last digit shown stands for 10^k with the least k >= `finest` for which that is so.
///
/// An interval of one point is shown as it is where it is a multiple of 10^finest, without trailing zeros
/// ("0.75"), or a fraction of at most twelve characters ("17/24"). An interval that determines fewer than
/// three digits below 10^scale is shown itself, "[0.12, 0.57]", its ends
/// rounded outwards. Numbers of a scale below 1e-4 or of 1e9 and more are written as "-1.234e+12". `scale` is
/// the largest power of ten that numbers beside this one reach, `finest` < `scale`. Throws
/// std::invalid_argument where lower > upper or finest >= scale.
std::string proved_decimal(const RationalInterval& interval, long finest, long scale = 0);

/// "[0.25, 0.5]": the ends rounded outwards to multiples of 10^finest, without trailing zeros.
std::string outward_decimal(const RationalInterval& interval, long finest, long scale = 0);

}  // namespace exsect::cli

// The JSON forms that all results share (docs/formats.md).
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/parameter.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "output/text/parameter_names.h"

namespace exsect::cli {

/// Keys stay in the order of insertion, so equal results give equal bytes.
using Json = nlohmann::ordered_json;

/// Ends of algebraic numbers and boxes of points are shown at most this wide: 2^-64.
const Rational& shown_width();

/// "p/q" or "p".
Json json_number(const Rational& q);
/// ["lower", "upper"].
Json json_interval(const RationalInterval& interval);
/// {"u": [..], "v": [..], "r": [..], "s": [..]}, or with other names.
Json json_box(const ParameterBox& box, const ParameterNames& names = pair_names);
/// {"u": .., "v": .., "r": .., "s": .., "point": [x, y, z]}, or with other names.
Json json_approx(const std::array<double, 4>& parameters, const std::array<double, 3>& point,
                 const ParameterNames& names = pair_names);
/// {"box": ["lower", "upper"], "approx": x, "closed": bool}.
Json json_end(const RealAlgebraic& end, bool closed);
/// "u=0".
std::string side_name(Side side, const ParameterNames& names = pair_names);

/// A number that JSON shows as a decimal not below the bound: the bound itself, or the next double above it
/// where the decimal of the bound is too small. Requires bound >= 0 and finite, else it is returned as it is.
double decimal_not_below(double bound);

/// The text of a file: whatever fits on a line of 200 characters is on one line, a longer list or object has
/// its elements indented by one. Ends with a line feed.
std::string json_text(const Json& json);

}  // namespace exsect::cli

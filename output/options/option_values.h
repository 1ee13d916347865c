// Values of command line options.
#pragma once

#include <exsect/geometry/point.h>
#include <exsect/solver/parameter.h>

#include <string>
#include <vector>

#include "output/text/parameter_names.h"

namespace exsect::cli {

/// What was given, printable and cut to 40 characters, for messages.
std::string shortened(const std::string& text);

/// A number in the syntax of patch files ("1/2", "0.5", "0x1p-1") within [0,1]. Throws UsageError.
Rational parameter_value(const std::string& option, const std::string& text);

/// A number > 0 in the same syntax as the greatest double that is not above it. Throws UsageError if that is
/// not positive and finite.
double positive_value(const std::string& option, const std::string& text);

/// "x,y,z", numbers in the same syntax. Throws UsageError.
Point vector_value(const std::string& option, const std::string& text);

/// "u,v,r,s" (or other names) or any part of it, or "none". Throws UsageError.
std::vector<Parameter> parameter_list(const std::string& option, const std::string& text,
                                      const ParameterNames& names = pair_names);

}  // namespace exsect::cli

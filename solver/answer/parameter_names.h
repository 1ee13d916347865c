// Results under other names of the parameters. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

namespace exsect {

/// Parameter i of a result becomes parameter names[i].
using ParameterNames = std::array<Parameter, 4>;
void rename_parameters(IntersectResult& result, const ParameterNames& names);
void rename_parameters(Node& node, const ParameterNames& names);
void rename_parameters(Arc& arc, const ParameterNames& names);

/// The result with 1 - p in the place of the parameter p.
void reverse_parameter(IntersectResult& result, Parameter p);

}  // namespace exsect

// Results under other names of the parameters, and in other parameters. Internal to solver/.
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

/// The result with p / (k (1 - p) + p) in the place of the parameter p. Requires k > 0.
void change_parameter(IntersectResult& result, Parameter p, const Rational& k);

/// The result of pieces over a box of the parameters: that of the box in the place of each parameter. No node
/// is on a side any more.
void place_parameters(IntersectResult& result, const ParameterBox& over);

}  // namespace exsect

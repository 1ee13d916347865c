// What the four parameters of a result are called.
#pragma once

#include <exsect/solver/parameter.h>

#include <array>

namespace exsect::cli {

/// In the order of Parameter.
using ParameterNames = std::array<const char*, 4>;

/// x(u,v) and y(r,s).
inline constexpr ParameterNames pair_names = {"u", "v", "r", "s"};
/// The two parameters of one patch, x(u1,v1) = x(u2,v2).
inline constexpr ParameterNames self_names = {"u1", "v1", "u2", "v2"};

constexpr const char* name(Parameter p, const ParameterNames& names) { return names[index(p)]; }

}  // namespace exsect::cli

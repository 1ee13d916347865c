// What the four parameters of a result are called.
#pragma once

#include <exsect/solver/parameter.h>

#include <array>
#include <vector>

namespace exsect::cli {

/// In the order of Parameter.
using ParameterNames = std::array<const char*, 4>;

/// x(u,v) and y(r,s).
inline constexpr ParameterNames pair_names = {"u", "v", "r", "s"};
/// The two parameters of one patch, x(u1,v1) = x(u2,v2).
inline constexpr ParameterNames self_names = {"u1", "v1", "u2", "v2"};

/// The parameters of a patch that meets a surface given by its equation: this one has none.
inline constexpr ParameterNames one_patch_names = {"u", "v", nullptr, nullptr};

/// Of a name that there is.
constexpr const char* name(Parameter p, const ParameterNames& names) { return names[index(p)]; }

/// Those that there are.
inline std::vector<Parameter> named_parameters(const ParameterNames& names) {
  std::vector<Parameter> named;
  for (const Parameter p : all_parameters)
    if (names[index(p)] != nullptr) named.push_back(p);
  return named;
}

}  // namespace exsect::cli

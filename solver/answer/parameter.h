// The four parameters of a pair of patches x(u,v), y(r,s).
#pragma once

#include <exsect/algebra/rational.h>

#include <array>

namespace exsect {

enum class Parameter { u = 0, v = 1, r = 2, s = 3 };
inline constexpr std::array<Parameter, 4> all_parameters = {Parameter::u, Parameter::v, Parameter::r,
                                                            Parameter::s};

constexpr std::size_t index(Parameter p) { return static_cast<std::size_t>(p); }
constexpr const char* name(Parameter p) {
  constexpr std::array<const char*, 4> names = {"u", "v", "r", "s"};
  return names[index(p)];
}

/// Closed intervals of u, v, r, s, in this order.
using ParameterBox = std::array<RationalInterval, 4>;

/// A side of one of the two parameter squares: parameter = value, value 0 or 1.
struct Side {
  Parameter parameter;
  int value;
  friend bool operator==(const Side&, const Side&) = default;
};

}  // namespace exsect

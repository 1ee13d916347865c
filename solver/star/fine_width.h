// How finely the places of singular points are enclosed. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>

namespace exsect {

/// 2^-200.
inline Rational fine_width() { return power_of_two(-200); }

}  // namespace exsect

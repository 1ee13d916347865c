// Enclosures of parameters. Internal to solver/.
#pragma once

#include <exsect/algebra/rational.h>

#include <algorithm>

namespace exsect {

/// The part of an enclosure of a parameter in [0,1] that is in [0,1]: it holds the parameter too.
inline RationalInterval in_domain(const RationalInterval& at) {
  return {std::max<Rational>(at.lower, 0), std::min<Rational>(at.upper, 1)};
}

}  // namespace exsect

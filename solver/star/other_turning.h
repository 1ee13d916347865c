// The values at which curves turn in the parameters that a sweep does not run along. Internal to solver/.
#pragma once

#include <vector>

#include "eliminant/exact_pair.h"

namespace exsect {

/// The turning values of the sweeps of a pair along the other parameters.
struct OtherTurning {
  std::vector<const TurningValues*> values;  // of those that do not turn with the sweep
  bool complete = true;                      // every one of these has some, or turns with one that has
};
OtherTurning other_turning(ExactPair& pair, Parameter sweep);

}  // namespace exsect

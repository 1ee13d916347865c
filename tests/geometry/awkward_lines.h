// Conic parameter lines for the tests: awkward ones first, and random ones.
#pragma once

#include <exsect/geometry/parameter_line.h>

#include <vector>

#include "random_shapes.h"

namespace exsect {

/// One line in each coordinate plane and in positions where two normal coordinates tie or nearly vanish.
inline std::vector<ParameterLine> awkward_conics() {
  return {{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}},
          {{{{1, 2, 3}, {0, 1, 0}, {0, 0, 1}}}},
          {{{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}}}},
          {{{{1, 0, 0}, {-1, 1, 0}, {0, -1, 1}}}},
          {{{{0, 0, 0}, {0, 1, 0}, {1, 0, power_of_two(-100)}}}}};
}

inline ParameterLine random_conic(Random& random) {
  ParameterLine line;
  do {
    line = line_at_first(random_patch(random), random_rational(random));
  } while (shape(line) != LineShape::conic);
  return line;
}

}  // namespace exsect

#include "option_limits.h"

#include <cmath>
#include <stdexcept>

namespace exsect {

void check(const IntersectOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw std::invalid_argument("tolerance must be a positive finite number");
  }
  if (options.max_seconds && !(*options.max_seconds > 0)) {
    throw std::invalid_argument("max_seconds must be positive");
  }
}

}  // namespace exsect

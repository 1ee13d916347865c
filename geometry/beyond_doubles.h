// Control points that doubles cannot hold.
#pragma once

#include <stdexcept>

namespace exsect {

/// Control points, or what they span, lie beyond the range of doubles, 1.8e308, in which the result has to be
/// written.
class BeyondDoubles : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace exsect

// Rational numbers to doubles, saying whether that is exact.
#pragma once

#include <exsect/algebra/rational.h>

namespace exsect {

/// to_double(q), and whether it is known to be q itself. Quick for numbers of few digits.
struct NearestDouble {
  double value;
  bool exact;
};
NearestDouble nearest_double(const Rational& q);

}  // namespace exsect

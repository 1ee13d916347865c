#include "nearest_double.h"

namespace exsect {

NearestDouble nearest_double(const Rational& q) { return {to_double(q), is_short_dyadic(q)}; }

}  // namespace exsect

#include "answer/model_scale.h"

#include <exsect/geometry/beyond_doubles.h>

#include <algorithm>
#include <cmath>

namespace exsect {

ModelScale model_scale(const BezierPatch& x, const BezierPatch& y) {
  ModelScale result{};
  double largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    Rational lower = x.net()[0][0][c];
    Rational upper = lower;
    for (const BezierPatch* patch : {&x, &y}) {
      for (const auto& row : patch->net()) {
        for (const Point& p : row) {
          lower = std::min(lower, p[c]);
          upper = std::max(upper, p[c]);
        }
      }
    }
    result.frame.origin[c] = to_double((lower + upper) / 2);
    if (!std::isfinite(result.frame.origin[c])) {
      throw BeyondDoubles("control points must lie in the range of doubles");
    }
    result.origin[c] = from_double(result.frame.origin[c]);
    largest = std::max(largest, to_double(upper - lower));
  }
  result.extent = largest;
  result.frame.exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
  return result;
}

}  // namespace exsect

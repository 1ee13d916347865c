#include "line/line_points.h"

#include <exsect/algebra/nearest_rounding.h>

#include "line/enclosed_line_points.h"
#include "line/exact_line_points.h"

namespace exsect {

LinePoints line_points(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  return in_nearest_rounding([&]() -> LinePoints {
    auto enclosed = enclosed_line_points(x, y, query);
    return enclosed ? std::move(*enclosed) : exact_line_points(x, y, query);
  });
}

}  // namespace exsect

// Comparison of two answers about one parameter line.
#pragma once

#include <exsect/solver/line_patch.h>

#include "support/catch.h"

namespace exsect::line_checks {

/// The same points in the same order: the boxes of `found`, at most 2^exponent wide, hold the exact points,
/// and so do refined ones.
inline void check_same_points(const LinePoints& found, const LinePoints& exact, int exponent) {
  CHECK(found.incomplete == exact.incomplete);
  CHECK(found.on_patch.size() == exact.on_patch.size());
  REQUIRE(found.points.size() == exact.points.size());
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const CertifiedPoint& point = found.points[i];
    const ParameterBox finer = exact.points[i].refined_to(power_of_two(-200)).box();
    const ParameterBox refined = point.refined_to(power_of_two(-100)).box();
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(point.box()[j].lower <= finer[j].lower);
      CHECK(finer[j].upper <= point.box()[j].upper);
      CHECK(point.box()[j].width() <= power_of_two(exponent));
      CHECK(refined[j].width() <= power_of_two(-100));
      CHECK((refined[j].lower <= finer[j].upper && finer[j].lower <= refined[j].upper));
    }
    CHECK(point.sides() == exact.points[i].sides());
    CHECK(point.multiplicity() == exact.points[i].multiplicity());
    CHECK(point.branch() == exact.points[i].branch());
    CHECK(point.exact().has_value() == exact.points[i].exact().has_value());
  }
}

}  // namespace exsect::line_checks

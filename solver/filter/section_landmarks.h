// Points of every part of the curve of an equation on a patch. Internal to solver/; docs/method-equations.md,
// section 17.22.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "answer/stop_request.h"
#include "filter/square_form.h"

namespace exsect {

/// The places (p,q) whose coordinates differ from those of `centre` by at most `reach`.
struct SectionBox {
  std::array<double, 2> centre;
  std::array<double, 2> reach{};
};

/// A point of the curve f = 0, alone in its box: on a side of the square, where the curve crosses it, or
/// inside of it where a coordinate turns.
struct SectionLandmark {
  SectionBox box;
  std::size_t coordinate;  // the one that is fixed on the side, or that turns
  int side;                // -1 or 1: the value of that coordinate; 0: it turns
};

/// Where the curve crosses the sides, and all its turning points with respect to p, and to q if
/// `with_second`. The boxes are apart, those of turning points inside of the square. Empty if doubles do not
/// decide it, as where the curve goes through a corner or touches a side, and where it is singular.
std::optional<std::vector<SectionLandmark>> section_landmarks(const SquareForm& f, bool with_second,
                                                              const StopRequest& stop);

}  // namespace exsect

// A pair in which a side of one patch lies on a line inside the other one.
#pragma once

#include "filter/side_path.h"
#include "support/catch.h"
#include "support/families.h"

namespace exsect::testing {

/// y's side r = 0 is the line u = 1/2 of x.
struct OnInteriorLine {
  ExactCase c = families::side_on_interior_line();
  filter::Pair pair = filter::make_pair(c.x, c.y).value();
  filter::SidePath path =
      filter::side_path_near<filter::Biquadratic>(c.x, c.y, pair, 2, false, {0, 0, -0.5, 0}).value();
};

}  // namespace exsect::testing

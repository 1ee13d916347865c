// Seeded control nets of any bidegree up to (3,3), and exact maps of them.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <vector>

#include "support/random_pairs.h"

namespace exsect::random_nets {

using Generator = random_pairs::Generator;
using Net = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Rational>>;

struct Nets {
  Net x;
  Net y;
  RationalPatch first() const { return RationalPatch(x); }
  RationalPatch second() const { return RationalPatch(y); }
};

/// Near two grids that cross, each coordinate moved: by doubles of 53 random bits, or by multiples of 1/16.
Nets crossing(Generator& generator, std::array<int, 4> degrees, bool doubles);
/// Multiples of 1/16 anywhere in the unit cube.
Nets scattered(Generator& generator, std::array<int, 4> degrees);
/// A cap and a nearly flat patch that meet in a small closed curve.
Nets loop(Generator& generator, std::array<int, 4> degrees);
/// The net with weights 5/8, 6/8, ..., 2.
RationalPatch weighted(Generator& generator, const Net& net);

}  // namespace exsect::random_nets

// Seeded control nets of any bidegree up to (3,3), and exact maps of them.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
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
/// Integers from -2 to 2 anywhere, of bidegree (m,n).
Net small(Generator& generator, int m, int n);
/// Integers from -1 to 1 anywhere.
Net tiny(Generator& generator, int m, int n);
/// Control points of the other net, with repetition: patches that have corners, sides and lines in common.
Net chosen(Generator& generator, const Net& other, int m, int n);
/// Doubles of 53 random bits in [0,1), anywhere.
Net doubles(Generator& generator, int m, int n);
/// The net with weights 5/8, 6/8, ..., 2.
RationalPatch weighted(Generator& generator, const Net& net);
/// The net with weights 1 and 2.
RationalPatch weighted_by_one_or_two(Generator& generator, const Net& net);
/// The net with weights of 53 bits in [1/2,2).
RationalPatch weighted_by_doubles(Generator& generator, const Net& net);

/// A projective map of space, given by the rows of a matrix of R^4.
using ProjectiveMap = std::array<HomogeneousPoint, 4>;
/// Near the identity: no point of the models above goes to infinity.
ProjectiveMap projective_map(Generator& generator);
/// Of the homogeneous control points.
RationalPatch image(const RationalPatch& patch, const ProjectiveMap& rows);
/// t -> t / (t + k (1 - t)) in the first parameter: weights alone change, by powers of k.
RationalPatch reparametrised(const RationalPatch& patch, const Rational& k);

}  // namespace exsect::random_nets

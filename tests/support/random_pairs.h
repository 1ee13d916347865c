// Seeded families of patch pairs whose intersections are generic with overwhelming probability, and exact
// maps that leave an intersection the same up to renaming.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <cstdint>
#include <random>

namespace exsect::random_pairs {

using Generator = std::mt19937_64;

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

/// Control points are multiples of 1/16 near two grids that cross.
Pair small_rationals(Generator& generator);
/// Control points are doubles with 53 random bits near two grids that cross.
Pair doubles(Generator& generator);
/// Control points are multiples of 1/16 anywhere in the unit cube: crumpled patches, several curves.
Pair scattered(Generator& generator);
/// A cap and a nearly flat patch that meet in a small closed curve, sheared by a random affine map.
Pair loop(Generator& generator);

/// P -> matrix P + translation.
struct AffineMap {
  std::array<Point, 3> rows;
  Point translation;

  Point operator()(const Point& p) const;
  BezierPatch operator()(const BezierPatch& patch) const;
};
/// Invertible, with small rational entries.
AffineMap affine_map(Generator& generator);

/// Uniform in {lowest, ..., highest}.
long integer(Generator& generator, long lowest, long highest);

}  // namespace exsect::random_pairs

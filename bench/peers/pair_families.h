// Seeded families of pairs for the comparison. Except for the small rationals all numbers are doubles,
// exactly, so that every program solves the same problem.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "random_numbers.h"

namespace peers {

struct ExactPair {
  exsect::RationalPatch x;
  exsect::RationalPatch y;
};

/// Control points near two grids that cross, denominators up to 16.
ExactPair random_rationals(Generator& generator);
/// Control points near two grids that cross, 53 random bits.
ExactPair random_doubles(Generator& generator);
/// As random_doubles, of bidegree (3,3); with weights between 1/2 and 2; both.
ExactPair bicubic(Generator& generator);
ExactPair weighted(Generator& generator);
ExactPair weighted_bicubic(Generator& generator);
/// Both patches are graphs over one plane, their difference a definite quadratic less a positive number: one
/// closed curve inside both.
ExactPair loop(Generator& generator);
/// As loop; the difference is a definite quadratic (a touch point), an indefinite one (a crossing of two
/// curves), or a square (a curve of contact).
ExactPair tangent(Generator& generator);
/// As tangent, with 2^-6 to 2^-14 added to the difference or taken away: small loops and near misses, curves
/// that nearly cross, two curves side by side and patches that nearly touch along a curve.
ExactPair near(Generator& generator);
/// As near, with 2^-14 to 2^-24: what only a proof tells from a tangent pair. Not part of the tables.
ExactPair nearer(Generator& generator);
/// A common side; a smooth continuation beyond a side; a common piece of one surface.
ExactPair overlap(Generator& generator);

/// The two entries of a patch file (docs/formats.md), named x and y, that a pair is.
nlohmann::ordered_json entries(const ExactPair& pair);

struct Family {
  std::string name;
  nlohmann::ordered_json (*member)(Generator&);  // its entries
};
/// All of them, those of round surfaces (round_families.h) included.
const std::vector<Family>& families();

}  // namespace peers

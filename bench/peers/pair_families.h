// Seeded families of pairs for the comparison. Except for the small rationals all control points are doubles,
// exactly, so that every program solves the same problem.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <random>
#include <string>
#include <vector>

namespace peers {

using Generator = std::mt19937_64;

struct ExactPair {
  exsect::BezierPatch x;
  exsect::BezierPatch y;
};

/// Control points near two grids that cross, denominators up to 16.
ExactPair random_rationals(Generator& generator);
/// Control points near two grids that cross, 53 random bits.
ExactPair random_doubles(Generator& generator);
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

struct Family {
  std::string name;
  ExactPair (*member)(Generator&);
};
/// All of them.
const std::vector<Family>& families();

}  // namespace peers

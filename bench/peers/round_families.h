// Seeded families of pairs of which one surface or both are given by equations: whole planes, cylinders,
// cones of one nappe, spheres and tori, all numbers doubles exactly.
#pragma once

#include <nlohmann/json.hpp>

#include "random_numbers.h"

namespace peers {

enum class Round { plane, cylinder, cone, sphere, torus };

/// Two surfaces about the origin, of radii between 1/2 and 5/4, as the entries x and y of a patch file. Their
/// intersection is bounded: axes are at least 60 degrees apart, normals of planes at most 30 degrees from
/// axes, and cones have the slope 1/2.
nlohmann::ordered_json round_pair(Generator& generator, Round first, Round second);

/// A random patch near the unit square, 53 bits in every coordinate, of bidegree (2,2) or (3,3), and a plane,
/// cylinder, cone or sphere of radius 1/4 to 1/2 through its middle.
nlohmann::ordered_json quadric_and_patch(Generator& generator, int degree);
/// The same with a torus of radii 3/8 and 1/8.
nlohmann::ordered_json torus_and_patch(Generator& generator, int degree);

}  // namespace peers

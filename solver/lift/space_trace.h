// From one known point of the curve of two polynomials in space to the next one, by tubes. Internal to
// solver/; docs/method-equations.md, section 17.15.
#pragma once

#include <cstddef>
#include <vector>

#include "lift/space_zero.h"

namespace exsect {

/// Points of the curve F = G = 0 that end arcs, apart from each other, and how finely arcs are drawn.
struct TraceProblem {
  SpacePolynomial f;
  SpacePolynomial g;
  std::vector<SpaceZero> landmarks;
  double extent;     // about the size of all, > 0
  double tolerance;  // > 0
};

/// An arc with no landmark inside, a polyline and a bound of their distance, both ways.
struct SpaceTrace {
  std::size_t end;
  std::vector<std::array<double, 3>> points;
  double error_bound;
};

/// From landmark `start` along grad F x grad G times `sense` to the next one, which has to be another one.
/// Throws ProofFailure if tubes of 2^-40 of the extent are not proved, or there are too many of them.
SpaceTrace space_trace(const TraceProblem& problem, std::size_t start, int sense);

}  // namespace exsect

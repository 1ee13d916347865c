// Straight and folded parameter lines: the segment they run through and the two planes that cut it out.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/plane.h>

namespace exsect {

/// A straight or folded line as p(t) = a0 + phi(t) direction, phi(0) = 0, phi monic of degree 1 or 2,
/// direction != 0.
struct StraightLine {
  Point a0;
  Point direction;
  Polynomial phi;
};
/// Throws std::domain_error unless shape(line) is straight or folded.
StraightLine straight_line(const ParameterLine& line);

/// Two planes through the line that are orthogonal to each other (1.4) (chapter, 9.5.1), normals n1 =
/// direction x e with e the axis least parallel to the direction and n2 = direction x n1, and the coordinate
/// along the line: lambda(p(t)) = phi(t). The points of space on the line with coordinate lambda have first =
/// second = 0.
struct StraightForms {
  AffineForm first;
  AffineForm second;
  AffineForm lambda;
  Polynomial phi;
};
/// Throws std::domain_error unless shape(line) is straight or folded.
StraightForms straight_forms(const ParameterLine& line);

}  // namespace exsect

// The pull-back of a parameter line on integers: the fast way into the solver.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/pull_back.h>

#include <array>

namespace exsect {

using IntegerVector = std::array<Integer, 3>;
/// c[i][j], the vector coefficient of the first parameter's power i times the second's power j.
using IntegerNet = std::array<std::array<IntegerVector, 3>, 3>;

/// The power bases of two patches in common coordinates: coordinate k of both is multiplied by scale[k] > 0,
/// which makes all coefficients integers without a common factor. Such a change of coordinates of space
/// changes no parameter of any intersection point.
struct IntegerPair {
  IntegerNet first;
  IntegerNet second;
  std::array<Rational, 3> scale;
};
IntegerPair integer_pair(const BezierPatch& x, const BezierPatch& y);

/// The net with its two parameters exchanged.
IntegerNet exchanged(const IntegerNet& net);

/// p(t) = (a[0] + a[1] t + a[2] t^2) / weight in the scaled coordinates; weight > 0.
struct IntegerLine {
  std::array<IntegerVector, 3> a;
  Integer weight;
};
/// The line where the net's first parameter is u0.
IntegerLine line_at_first(const IntegerNet& net, const Rational& u0);

/// True if a[1] x a[2] != 0: shape(line) is conic.
bool is_conic(const IntegerLine& line);

/// pull_back(axis_forms(line), y) in the scaled coordinates up to positive factors, one for P and a common
/// one for U, L, M; all coefficients are integers. Throws std::domain_error unless is_conic(line).
PullBack axis_pull_back(const IntegerLine& line, const IntegerNet& y);

}  // namespace exsect

// Tubes around pieces of the curve of an equation on a patch. Internal to solver/; docs/method-equations.md,
// section 17.22.
#pragma once

#include <exsect/algebra/ball.h>

#include <optional>

#include "filter/section_forms.h"
#include "filter/section_landmarks.h"

namespace exsect {

/// The places centre + s along the axis, |s| <= reach, and slope s + d along the other coordinate, |d| <=
/// width. Invariant: over each s there is exactly one zero of the section among them; these are an arc, along
/// which the derivative by the other coordinate is at least `least` in absolute value and has the sign
/// `sign`. They are within SquareForm::reach.
struct SectionTube {
  std::array<double, 2> centre;
  std::size_t axis;
  double slope;
  double reach;
  double width;
  double least;
  int sign;
  double gradient;     // about that derivative in the centre
  double contraction;  // of its quotient by that from 1
  DoubleBall slopes;   // of the arc as a graph over s
  DoubleBall bends;    // its second derivatives
};

/// About a place near the curve. Empty if there is no proof.
std::optional<SectionTube> section_tube(const SquareForm& f, const std::array<double, 2>& centre,
                                        std::size_t axis, double reach);

/// s of all places in a box.
DoubleBall offset(const SectionTube& tube, const SectionBox& box);
/// No place of the box is in the tube; all are.
bool excludes(const SectionTube& tube, const SectionBox& box);
bool contains(const SectionTube& tube, const SectionBox& box);

/// The place centre + s along the axis, rounded, and `off` from the centre along the other coordinate, and a
/// bound of its distance from the zero over the same number: as soon as it is at most `wanted`, or as small
/// as doubles make it; infinite if there is none. `guess` is about `off`.
struct PlaceNearCurve {
  std::array<double, 2> place;
  double off;
  double error;  // >= 0
};
PlaceNearCurve place_near_curve(const SquareForm& f, const SectionTube& tube, double s, double guess,
                                double wanted);

/// Bounds for the arc on a tube in space, as a function of s (17.36).
struct SectionSpeeds {
  double acceleration;  // of the second derivative of the position
  double normal;        // of its part across the arc
  double least_speed;   // of the first derivative, from below
  double rate;          // of the same from above
  double speed;         // of the derivative of the position by the other coordinate
  double rounding;      // of positions that section_point() makes of places in the tube
};
SectionSpeeds section_speeds(const std::array<SquareForm, 4>& patch, const SectionTube& tube);
/// The position of the patch in space.
std::array<double, 3> section_point(const SectionForms& forms, const std::array<double, 2>& place);

}  // namespace exsect

// Patches whose parameters are functions of their points that quotients of forms of degree 1 or 2 give:
// parallelograms, trapezoids, bilinear patches, rational cylinders and cones, spheres, tori, and other
// surfaces of revolution with conics for profiles. Internal to solver/; docs/method-equations.md, section
// 17.19.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>

#include "special/space_form.h"
#include "special/unit_map.h"

namespace exsect {

/// numerator / denominator is map(p) of a parameter p on the patch; with the weight w and the degree e of
/// both forms, denominator > bound w^e on the square, or bound is 0 and denominator >= 0.
struct ParameterQuotient {
  SpaceForm numerator;
  SpaceForm denominator;
  Rational bound;
  UnitMap map;
};

/// The vectors with w > 0 and positive denominators that are multiples of points of the patch are those with
/// equation = 0, quotients in [0,1] and denominators of at least bound w^e (Lemma 17.15).
struct PatchInverse {
  SpaceForm equation;
  std::array<ParameterQuotient, 2> parameters;
};

/// Empty if the patch has no such inverse, or none is found.
std::optional<PatchInverse> patch_inverse(const RationalPatch& y);

}  // namespace exsect

// The equation of a surface on a patch, and the patch, as polynomials in doubles. Internal to solver/;
// docs/method-equations.md, section 17.22.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/geometry/space_polynomial.h>

#include <array>
#include <optional>

#include "filter/square_form.h"

namespace exsect {

/// In p = 2u - 1 and q = 2v - 1.
struct SectionForms {
  SquareForm section;               // G of (17.2) times a positive number
  std::array<SquareForm, 4> patch;  // X of (16.1)
  bool has_no_weights;              // X_4 = 1
};

/// Empty where numbers are too large or too small for doubles, and for an equation
/// of a degree above 4.
std::optional<SectionForms> section_forms(const SpacePolynomial& equation, const RationalPatch& reduced);

}  // namespace exsect

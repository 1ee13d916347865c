// One of the two surfaces that are compared: a patch, or one given by its equation. Internal to verify/;
// docs/method-verify.md, section 15.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>

#include <optional>
#include <variant>

#include "patch_in_doubles.h"

namespace exsect {

using ComparedSurface = std::variant<RationalPatch, ImplicitSurface>;

/// What a comparison asks of the surface.
class ComparedSide {
 public:
  /// A patch on [-margin, 1 + margin]^2, margin from 0 to 1; an equation has no parameters.
  ComparedSide(const ComparedSurface& surface, const Rational& margin);

  /// nullptr for a surface given by its equation.
  const PatchInDoubles* patch() const { return patch_ ? &*patch_ : nullptr; }
  /// True only if every point of the surface is farther than `radius` from p (15.6).
  bool certainly_farther(const SpacePoint& p, double radius) const;

 private:
  std::optional<PatchInDoubles> patch_;
  std::optional<ImplicitSurface> equation_;
};

}  // namespace exsect

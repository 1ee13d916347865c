// Random boxes of the natural parameters of tiny surfaces, and where points are by angles and heights in
// doubles.
#pragma once

#include <exsect/geometry/surface_box.h>

#include <array>
#include <optional>
#include <string>

#include "support/random_pairs.h"
#include "support/surface_moves.h"

namespace exsect::tiny_boxes {

/// A whole surface, and the box that it is cut to.
struct Face {
  ImplicitSurface whole;
  std::optional<SurfaceBox> box;

  ImplicitSurface surface() const { return box ? boxed(whole, *box) : whole; }
  /// The polynomial alone, cut by the same bounds. Requires a surface that is no single nappe.
  ImplicitSurface unnamed() const;
};

/// Directions in {-1..1}, heights in {-3..3}/2; every fourth surface on average is whole.
Face tiny_face(random_pairs::Generator& generator);

Face moved(const surface_moves::Motion& motion, const Face& face);

std::string written(const Face& face);

/// How far a point of the surface is inside of the box: at least this far from its bounds, and outside if
/// negative. 1 without a box.
double depth_in(const Face& face, const std::array<double, 3>& p);

}  // namespace exsect::tiny_boxes

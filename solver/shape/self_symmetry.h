// Affine maps of the parameters that a patch does not feel. Internal to solver/; docs/method.md, section 7.9.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/rational_patch.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace exsect {

using PlanePoint = std::array<Rational, 2>;

/// c[0] + c[1] u + c[2] v.
using PlaneForm = std::array<Rational, 3>;

/// x(image(w)) = x(w) for all w = (u,v). If the map is its own inverse, cut(image(w)) = -cut(w), and one
/// order of each pair has cut(w) >= 0; otherwise cut is constant and positive.
struct Symmetry {
  std::array<PlaneForm, 2> image;
  PlaneForm cut;
};

/// The point inside the square in which x is reflected.
std::optional<PlanePoint> centre_of_symmetry(const BezierPatch& x);

/// Reflections in lines u, v = constant, in the diagonals of the square, and in points, each with a fixed
/// point inside the square, and all their products; of a map and its inverse one, and not the identity.
std::vector<Symmetry> symmetries(const BezierPatch& x);

/// Those of the square itself, of a patch of any kind: reflections, the half turn, and a quarter turn.
std::vector<Symmetry> symmetries_of_square(const RationalPatch& x);

/// "(v, u)"
std::string image_text(const Symmetry& symmetry);

/// What is said of a patch with these symmetries where its other pairs are not decided: "the patch covers its
/// image more than once: (u, v) and (v, u) are one point; ..."
std::string covered_more_than_once(const std::vector<Symmetry>& symmetries);

/// A pair w, image(w).
using ParameterPair = std::array<Rational, 4>;

/// The corners of the polygon of all w with cut(w) >= 0 and both points in the square, in order. On an edge
/// that is turned around its fixed point is among them.
std::vector<ParameterPair> rim(const Symmetry& symmetry);

/// rim(symmetry) runs from one pair to the next along cut = 0: through the inside of the region's unordered
/// pairs, or along the line where the two points of a pair agree.
bool is_on_cut(const Symmetry& symmetry, const ParameterPair& from, const ParameterPair& to);

}  // namespace exsect

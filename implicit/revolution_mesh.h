// A surface of revolution as a mesh of triangles with a proved distance.
#pragma once

#include <exsect/geometry/bezier_curve.h>

#include <array>
#include <string>
#include <vector>

namespace exsect {

struct TriangleMesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;  // 0-based
  /// Mesh and revolved profile curve are within this distance of each other, in both directions (12.2).
  Rational distance;
};

/// The profile curve (r,z), r >= 0, revolved about the z axis: `along` chords of equal parameter length times
/// `around` sectors, along >= 1, around >= 4, else std::invalid_argument. A vertex is a point of the surface
/// rounded to doubles.
TriangleMesh revolution_mesh(const BezierCurve& profile, int along, int around);

/// Wavefront OBJ with the given comment lines at the top.
std::string obj_text(const TriangleMesh& mesh, const std::vector<std::string>& comments);

}  // namespace exsect

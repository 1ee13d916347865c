// What the files for other tools show: sampled patches, polylines and nodes, in doubles.
#pragma once

#include <exsect/geometry/rational_patch.h>
#include <exsect/implicit/revolution_mesh.h>
#include <exsect/solver/line_patch.h>
#include <exsect/solver/result.h>

#include <string>
#include <vector>

#include "output/text/intersection_json.h"

namespace exsect::cli {

/// What a parameter is where a vertex has none.
inline constexpr double no_parameter = -1;
/// What the bound of a sampled patch is.
inline constexpr double nothing_proved = -1;

/// A surface as faces of three or more corners. Those of a sampled patch are the cells of a grid in its
/// square, counterclockwise; vertices without parameters belong to a surface of revolution.
struct SceneMesh {
  std::string name;
  std::vector<PolylineVertex> vertices;
  std::vector<std::vector<std::size_t>> faces;
  double error_bound;  // proved distance from the true surface, or `nothing_proved`
};

/// A polyline with its proved distance from the true curve, in both directions.
struct SceneCurve {
  std::string name;
  int arc;        // id; -1 for the parameter line of `exsect line`
  int component;  // -1 for the rim of an overlap and for a parameter line
  int overlap;    // id, or -1
  ArcPlace place;
  Contact contact;
  double error_bound;
  std::vector<PolylineVertex> vertices;
};

struct SceneNode {
  std::string name;
  int id;
  unsigned kinds;  // bit k is set for the k-th NodeKind; 0 for the points of a line
  PolylineVertex vertex;
};

/// Every coordinate is finite.
struct Scene {
  std::string title;
  ParameterNames parameters;
  std::vector<SceneMesh> meshes;
  std::vector<SceneCurve> curves;
  std::vector<SceneNode> nodes;
};

/// Throws std::invalid_argument if a coordinate of a patch is beyond the range of doubles.
Scene intersection_scene(const IntersectResult& result, const RationalPatch& x, const RationalPatch& y,
                         const PatchNames& names, const std::string& title, int cells);
/// The patch x and the curves and nodes; the surface given by its equation is not sampled.
Scene surface_scene(const IntersectResult& result, const RationalPatch& x, const PatchNames& names,
                    const std::string& title, int cells);
Scene self_scene(const IntersectResult& result, const RationalPatch& x, const std::string& name,
                 const std::string& title, int cells);
/// A surface of revolution with its distance from the true surface; names of parameters are those of a pair.
Scene mesh_scene(const TriangleMesh& mesh, double error_bound, const std::string& title);
/// Both patches, the parameter line as one polyline, and the isolated points.
Scene line_scene(const LineIntersection& line, const RationalPatch& x, const RationalPatch& y,
                 const PatchNames& names, const std::string& title, int cells);

}  // namespace exsect::cli

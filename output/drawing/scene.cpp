#include "output/drawing/scene.h"

#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "output/text/shown_line.h"

namespace exsect::cli {
namespace {

constexpr int line_chords = 64;
constexpr std::array<double, 4> no_parameters = {no_parameter, no_parameter, no_parameter, no_parameter};

std::array<double, 3> rounded(const Point& p) {
  const std::array<double, 3> point = {to_double(p[0]), to_double(p[1]), to_double(p[2])};
  for (double coordinate : point) {
    if (!std::isfinite(coordinate))
      throw BeyondDoubles("export: a patch has coordinates beyond the range of doubles");
  }
  return point;
}

/// `place` is 0 for the patch of (u,v), 2 for that of (r,s).
SceneMesh sampled(const RationalPatch& patch, const std::string& name, int cells, std::size_t place) {
  SceneMesh mesh{"patch " + name, {}, {}, nothing_proved};
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const Rational first(i, cells), second(j, cells);
      PolylineVertex vertex{no_parameters, rounded(patch(first, second))};
      vertex.parameters[place] = to_double(first);
      vertex.parameters[place + 1] = to_double(second);
      mesh.vertices.push_back(vertex);
    }
  }
  const auto n = static_cast<std::size_t>(cells);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t corner = i * (n + 1) + j;
      mesh.faces.push_back({corner, corner + n + 1, corner + n + 2, corner + 1});
    }
  }
  return mesh;
}

SceneCurve curve(const Arc& arc, int overlap) {
  const std::string where =
      overlap < 0 ? fmt::format("arc {}", arc.id) : fmt::format("overlap {} rim {}", overlap, arc.id);
  return {fmt::format("{} {} {}", where, name(arc.contact), name(arc.place)),
          arc.id,
          arc.component,
          overlap,
          arc.place,
          arc.contact,
          arc.error_bound,
          arc.polyline};
}

SceneNode scene_node(const Node& node) {
  SceneNode shown{fmt::format("node {}", node.id), node.id, 0, {node.approx, node.point}};
  for (NodeKind kind : node.kinds) {
    shown.name += fmt::format(" {}", name(kind));
    shown.kinds |= 1U << static_cast<unsigned>(kind);
  }
  return shown;
}

void add_graph(Scene& scene, const IntersectionGraph& graph) {
  for (const Arc& arc : graph.arcs) scene.curves.push_back(curve(arc, -1));
  for (const Overlap& overlap : graph.overlaps) {
    for (const std::vector<Arc>& chain : overlap.chains) {
      for (const Arc& arc : chain) {
        scene.curves.push_back(curve(arc, overlap.id));
        scene.curves.back().component = -1;
      }
    }
  }
  for (const Node& node : graph.nodes) scene.nodes.push_back(scene_node(node));
}

/// How far the piece of a line over [from,to] is from its chord at most, in both directions, by the sum of
/// the coordinates; the line is at a constant first parameter. The piece is a mean of its control points P_j,
/// the chord that of its points ((d-j) P_0 + j P_d)/d with the same factors: those other than the first and
/// the last sum up to 1 - 2^(1-d) at most where the weights are equal. Empty where a weight is not positive.
std::optional<Rational> chord_distance(const RationalPatch& owner, const Rational& value,
                                       const Rational& from, const Rational& to) {
  const RationalPatch piece = owner.restricted_to(value, value, from, to);
  const int d = piece.degree_v();
  bool equal_weights = true;
  for (int j = 0; j <= d; ++j) {
    if (piece.weight(0, j) <= 0) return std::nullopt;
    equal_weights = equal_weights && piece.weight(0, j) == piece.weight(0, 0);
  }
  Rational distance = 0;
  for (int j = 1; j < d; ++j) {
    Rational sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
      sum += abs(
          Rational(piece.point(0, j)[k] - ((d - j) * piece.point(0, 0)[k] + j * piece.point(0, d)[k]) / d));
    distance = std::max(distance, sum);
  }
  return equal_weights ? Rational(distance * (1 - power_of_two(1 - d))) : distance;
}

/// Of the chords at t = k/n, k = 0..n; a vertex is rounded by at most 2^-53 of each coordinate.
double chord_bound(const RationalPatch& owner, const Rational& value, const std::vector<Point>& points) {
  const auto n = static_cast<long>(points.size()) - 1;
  Rational distance = 0, largest = 0;
  for (long k = 0; k < n; ++k) {
    const auto piece = chord_distance(owner, value, Rational(k, n), Rational(k + 1, n));
    if (!piece) return nothing_proved;
    distance = std::max(distance, *piece);
  }
  for (const Point& p : points)
    for (const Rational& c : p) largest = std::max<Rational>(largest, abs(c));
  const Rational bound = distance + largest * power_of_two(-51);
  return std::nextafter(to_double(bound), std::numeric_limits<double>::infinity());
}

SceneCurve parameter_line(const LineQuery& query, const RationalPatch& owner) {
  const bool first = query.fixed == Parameter::u || query.fixed == Parameter::r;
  const RationalPatch along = first ? owner : owner.transposed();
  SceneCurve shown{fmt::format("line {} = {}", name(query.fixed), to_string(query.value)),
                   -1,
                   -1,
                   -1,
                   ArcPlace::interior,
                   Contact::transversal,
                   0,
                   {}};
  std::vector<Point> points;
  for (int k = 0; k <= line_chords; ++k) {
    const Rational t(k, line_chords);
    points.push_back(along(query.value, t));
    PolylineVertex vertex{no_parameters, rounded(points.back())};
    vertex.parameters[index(query.fixed)] = to_double(query.value);
    vertex.parameters[index(partner(query.fixed))] = to_double(t);
    shown.vertices.push_back(vertex);
  }
  shown.error_bound = chord_bound(along, query.value, points);
  return shown;
}

}  // namespace

Scene intersection_scene(const IntersectResult& result, const RationalPatch& x, const RationalPatch& y,
                         const PatchNames& names, const std::string& title, int cells) {
  Scene scene{title, names.parameters, {}, {}, {}};
  scene.meshes = {sampled(x, names.first, cells, 0), sampled(y, names.second, cells, 2)};
  add_graph(scene, result.graph);
  return scene;
}

Scene surface_scene(const IntersectResult& result, const RationalPatch& x, const PatchNames& names,
                    const std::string& title, int cells) {
  Scene scene{title, pair_names, {sampled(x, names.first, cells, 0)}, {}, {}};
  IntersectionGraph graph = result.graph;
  const auto leave_out = [](std::array<double, 4>& parameters) {
    parameters[index(Parameter::r)] = parameters[index(Parameter::s)] = no_parameter;
  };
  for (Node& node : graph.nodes) leave_out(node.approx);
  for (Arc& arc : graph.arcs)
    for (PolylineVertex& vertex : arc.polyline) leave_out(vertex.parameters);
  add_graph(scene, graph);
  return scene;
}

Scene self_scene(const IntersectResult& result, const RationalPatch& x, const std::string& name,
                 const std::string& title, int cells) {
  Scene scene{title, self_names, {sampled(x, name, cells, 0)}, {}, {}};
  add_graph(scene, result.graph);
  return scene;
}

Scene line_scene(const LineIntersection& line, const RationalPatch& x, const RationalPatch& y,
                 const PatchNames& names, const std::string& title, int cells) {
  Scene scene{title, names.parameters, {}, {}, {}};
  scene.meshes = {sampled(x, names.first, cells, 0), sampled(y, names.second, cells, 2)};
  const bool of_first = line.query.fixed == Parameter::u || line.query.fixed == Parameter::v;
  scene.curves = {parameter_line(line.query, of_first ? x : y)};
  for (const ShownPoint& shown : shown_points(line.solution, x)) {
    const int id = static_cast<int>(scene.nodes.size());
    scene.nodes.push_back({fmt::format("point {}", id), id, 0, {shown.parameters, shown.space}});
  }
  return scene;
}

Scene mesh_scene(const TriangleMesh& mesh, double error_bound, const std::string& title) {
  SceneMesh shown{"surface", {}, {}, error_bound};
  for (const std::array<double, 3>& vertex : mesh.vertices) shown.vertices.push_back({no_parameters, vertex});
  for (const std::array<int, 3>& triangle : mesh.triangles)
    shown.faces.emplace_back(triangle.begin(), triangle.end());
  return {title, pair_names, {shown}, {}, {}};
}

}  // namespace exsect::cli

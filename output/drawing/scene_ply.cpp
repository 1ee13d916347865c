#include "output/drawing/scene_ply.h"

#include <fmt/format.h>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

std::string ply_vertex(const PolylineVertex& vertex, int node) {
  const auto& [parameters, point] = vertex;
  return fmt::format("{} {} {} {} {} {} {} {}\n", point[0], point[1], point[2], parameters[0], parameters[1],
                     parameters[2], parameters[3], node);
}

std::string header(const Scene& scene, std::size_t vertices, std::size_t faces, std::size_t edges) {
  std::string text = fmt::format("ply\nformat ascii 1.0\ncomment exsect: {}\n", printable(scene.title));
  text +=
      fmt::format("comment a parameter is {} where a vertex has none, an id is -1 for none\n", no_parameter);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    text += fmt::format("comment patch {}: {}\n", i, printable(scene.meshes[i].name));
  text +=
      fmt::format("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n", vertices);
  for (const char* parameter : scene.parameters) text += fmt::format("property double {}\n", parameter);
  text += fmt::format("property int node\nelement face {}\nproperty list uchar int vertex_indices\n", faces);
  text += fmt::format(
      "property int patch\nproperty double bound\nelement edge {}\nproperty int vertex1\nproperty int "
      "vertex2\n",
      edges);
  return text + "property int arc\nproperty int component\nproperty double bound\nend_header\n";
}

}  // namespace

std::string ply_text(const Scene& scene) {
  std::string vertices, faces, edges;
  std::size_t vertex_count = 0, face_count = 0, edge_count = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    for (const std::vector<std::size_t>& face : scene.meshes[i].faces) {
      faces += fmt::format("{}", face.size());
      for (std::size_t k : face) faces += fmt::format(" {}", vertex_count + k);
      faces += fmt::format(" {} {}\n", i, decimal_not_below(scene.meshes[i].error_bound));
      ++face_count;
    }
    for (const PolylineVertex& vertex : scene.meshes[i].vertices) vertices += ply_vertex(vertex, -1);
    vertex_count += scene.meshes[i].vertices.size();
  }
  for (const SceneCurve& curve : scene.curves) {
    for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k) {
      edges += fmt::format("{} {} {} {} {}\n", vertex_count + k, vertex_count + k + 1, curve.arc,
                           curve.component, decimal_not_below(curve.error_bound));
      ++edge_count;
    }
    for (const PolylineVertex& vertex : curve.vertices) vertices += ply_vertex(vertex, -1);
    vertex_count += curve.vertices.size();
  }
  for (const SceneNode& node : scene.nodes) vertices += ply_vertex(node.vertex, node.id);
  vertex_count += scene.nodes.size();
  return header(scene, vertex_count, face_count, edge_count) + vertices + faces + edges;
}

}  // namespace exsect::cli

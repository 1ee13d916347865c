#include "output/drawing/scene_obj.h"

#include <fmt/format.h>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// Names of objects and comments: on one line, without blanks at the places where OBJ would split them.
std::string object_name(const std::string& name) {
  std::string text = printable(name);
  for (char& c : text) c = c == ' ' || c == '#' ? '_' : c;
  return text;
}

std::string vertex_line(const PolylineVertex& vertex) {
  return fmt::format("v {} {} {}\n", vertex.point[0], vertex.point[1], vertex.point[2]);
}

/// Faces with texture coordinates (the patch's parameters); `offset` vertices and `textures` texture
/// coordinates stand before.
std::string mesh_text(const SceneMesh& mesh, std::size_t offset, std::size_t textures) {
  std::string text = fmt::format("o {}\n", object_name(mesh.name));
  for (const PolylineVertex& vertex : mesh.vertices) text += vertex_line(vertex);
  for (const PolylineVertex& vertex : mesh.vertices) {
    const std::size_t place = vertex.parameters[0] == no_parameter ? 2 : 0;
    text += fmt::format("vt {} {}\n", vertex.parameters[place], vertex.parameters[place + 1]);
  }
  const auto corner = [&](std::size_t k) { return fmt::format(" {}/{}", offset + k + 1, textures + k + 1); };
  for (const std::vector<std::size_t>& face : mesh.faces) {
    text += "f";
    for (std::size_t k : face) text += corner(k);
    text += "\n";
  }
  return text;
}

std::string curve_text(const SceneCurve& curve, std::size_t offset) {
  std::string text = fmt::format("o {}\n# component {}, every point within {} of the true curve (proved)\n",
                                 object_name(curve.name), curve.component, rounded_up(curve.error_bound));
  for (const PolylineVertex& vertex : curve.vertices) text += vertex_line(vertex);
  text += "l";
  for (std::size_t k = 0; k < curve.vertices.size(); ++k) text += fmt::format(" {}", offset + k + 1);
  return text + "\n";
}

}  // namespace

std::string obj_text(const Scene& scene) {
  std::string text = fmt::format("# exsect: {}\n", printable(scene.title));
  std::size_t vertices = 0;
  std::size_t textures = 0;
  for (const SceneMesh& mesh : scene.meshes) {
    text += mesh_text(mesh, vertices, textures);
    vertices += mesh.vertices.size();
    textures += mesh.vertices.size();
  }
  for (const SceneCurve& curve : scene.curves) {
    text += curve_text(curve, vertices);
    vertices += curve.vertices.size();
  }
  for (const SceneNode& node : scene.nodes) {
    text += fmt::format("o {}\n{}p {}\n", object_name(node.name), vertex_line(node.vertex), ++vertices);
  }
  return text;
}

}  // namespace exsect::cli

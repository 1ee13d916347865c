#include <exsect/implicit/revolution_mesh.h>

#include <cmath>
#include <sstream>

#include "geometry/curve_specimens.h"
#include "support/catch.h"

namespace exsect::revolution_mesh_test {
namespace {

TEST_CASE("meshes need at least four sectors and a chord", "[revolution_mesh]") {
  CHECK_THROWS_AS(revolution_mesh(profile_cubic(), 0, 8), std::invalid_argument);
  CHECK_THROWS_AS(revolution_mesh(profile_cubic(), 1, 3), std::invalid_argument);
  CHECK_THROWS_AS(revolution_mesh(BezierCurve({{-1, 0}, {1, 1}}), 4, 8), std::invalid_argument);
}

TEST_CASE("points of the triangles of a cylinder keep the proved distance", "[revolution_mesh]") {
  const BezierCurve line({{1, 0}, {1, 2}});
  for (const int around : {4, 5, 8, 64}) {
    const TriangleMesh mesh = revolution_mesh(line, 2, around);
    CHECK(mesh.vertices.size() == static_cast<std::size_t>(3 * around));
    CHECK(mesh.triangles.size() == static_cast<std::size_t>(4 * around));
    double largest = 0;
    for (const auto& t : mesh.triangles)
      for (const auto& [a, b, c] :
           {std::array{1.0, 1.0, 1.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 1.0}, {1.0, 0.0, 1.0}}) {
        double x = 0, y = 0;
        const double weights[] = {a / (a + b + c), b / (a + b + c), c / (a + b + c)};
        for (std::size_t k = 0; k < 3; ++k) {
          x += weights[k] * mesh.vertices[static_cast<std::size_t>(t[k])][0];
          y += weights[k] * mesh.vertices[static_cast<std::size_t>(t[k])][1];
        }
        largest = std::max(largest, 1 - std::hypot(x, y));
      }
    CHECK(largest <= to_double(mesh.distance) + 1e-15);
    CHECK(to_double(mesh.distance) < 2.5 * largest);
  }
}

TEST_CASE("the distance falls with the square of the size of the triangles", "[revolution_mesh]") {
  const double coarse = to_double(revolution_mesh(profile_cubic(), 8, 16).distance);
  const double fine = to_double(revolution_mesh(profile_cubic(), 32, 64).distance);
  CHECK(fine < coarse / 12);
  CHECK(fine > 0);
}

TEST_CASE("meshes are written as OBJ", "[revolution_mesh]") {
  const TriangleMesh mesh = revolution_mesh(BezierCurve({{1, 0}, {1, 1}}), 1, 4);
  std::istringstream text(obj_text(mesh, {"a cylinder", "distance 1/2"}));
  std::string line;
  std::getline(text, line);
  CHECK(line == "# a cylinder");
  int vertices = 0, faces = 0;
  while (std::getline(text, line)) {
    vertices += line.starts_with("v ") ? 1 : 0;
    faces += line.starts_with("f ") ? 1 : 0;
  }
  CHECK(vertices == 8);
  CHECK(faces == 8);
}

}  // namespace
}  // namespace exsect::revolution_mesh_test

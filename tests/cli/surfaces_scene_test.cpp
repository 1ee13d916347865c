// Scenes and pictures of two surfaces given by their equations.
#include "output/drawing/surfaces_scene.h"

#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/number.h>
#include <exsect/solver/intersect_equations.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "output/drawing/sampled_equation.h"
#include "output/drawing/scene_obj.h"
#include "output/drawing/scene_ply.h"
#include "output/drawing/scene_vtp.h"
#include "output/drawing/surfaces_svg.h"
#include "output/text/node_csv.h"
#include "support/catch.h"

namespace exsect::cli::surfaces_scene_test {
namespace {

const SurfaceNames names = {"a b", "c", "cylinder", "cylinder"};

const ImplicitSurface pipe_x = ImplicitSurface::cylinder({0, 0, 0}, {1, 0, 0}, 1);
const ImplicitSurface pipe_z = ImplicitSurface::cylinder({0, 0, 0}, {0, 0, Rational(1, 1000)}, 1);

/// |F| at the point, in units of the sum of its terms' sizes.
double residual(const ImplicitSurface& surface, const std::array<double, 3>& p) {
  const Point at = {Rational(p[0]), Rational(p[1]), Rational(p[2])};
  Rational size = 0;
  for (const auto& [exponents, c] : surface.equation().terms()) {
    Rational term = abs(c);
    for (std::size_t k = 0; k < 3; ++k)
      for (int i = 0; i < exponents[k]; ++i) term *= abs(at[k]);
    size += term;
  }
  return size == 0 ? 0 : to_double(abs(Rational(surface.equation()(at) / size)));
}

void check_on(const ImplicitSurface& surface, const SceneMesh& mesh, double tolerance) {
  for (const PolylineVertex& vertex : mesh.vertices) {
    CHECK(residual(surface, vertex.point) < tolerance);
    if (surface.bound()) {
      const Point at = {Rational(vertex.point[0]), Rational(vertex.point[1]), Rational(vertex.point[2])};
      CHECK(to_double((*surface.bound())(at)) > -1e-9);
    }
  }
  for (const auto& face : mesh.faces)
    for (const std::size_t corner : face) CHECK(corner < mesh.vertices.size());
}

TEST_CASE("surfaces given by their equations: all vertices of their meshes are on them") {
  const SpacePoints around = {{1, 2, 3}, {-4, 0, 5}};
  const Point axis = {2, -1, Rational(1, 3)};
  for (const ImplicitSurface& surface :
       {ImplicitSurface::plane({1, 2, 3}, axis), ImplicitSurface::cylinder({0, 5, 1}, axis, 2),
        ImplicitSurface::cone({1, 0, 0}, axis, Rational(1, 2)),
        ImplicitSurface::cone({1, 0, 0}, axis, Length::of_squared(2), 2),
        ImplicitSurface::sphere({1, 2, 3}, Length::of_squared(7)),
        ImplicitSurface::torus({1, 2, 3}, axis, 3, 1)}) {
    INFO(name(surface.kind()));
    const auto mesh = sampled(surface, "s", around, 12);
    REQUIRE(mesh);
    CHECK(mesh->vertices.size() == 13 * 13);
    CHECK(mesh->faces.size() == 12 * 12);
    CHECK(mesh->error_bound == nothing_proved);
    check_on(surface, *mesh, 1e-13);
    const bool is_bounded = !extreme_points(surface).empty();
    CHECK(sampled(surface, "s", {}, 12).has_value() == is_bounded);
  }
  SpacePolynomial square = SpacePolynomial::variable(0);
  square = square * square;
  CHECK(!sampled(ImplicitSurface::polynomial(square), "s", around, 12));
  // Directions beyond the range of doubles are directions; places are not.
  const Rational huge = power_of_two(2000);
  CHECK(sampled(ImplicitSurface::plane({0, 0, 0}, {huge, huge, 0}), "s", around, 2));
  CHECK_THROWS_AS(sampled(ImplicitSurface::sphere({huge, 0, 0}, 1), "s", around, 2), BeyondDoubles);
}

TEST_CASE("the scene of two surfaces: curves on both, within the meshes, and the nodes that are there") {
  const SurfaceIntersection result = intersect(pipe_x, pipe_z);
  const Scene scene = surfaces_scene({result, pipe_x, pipe_z, names}, "Title", 16);
  REQUIRE(scene.meshes.size() == 2);
  CHECK(scene.meshes[0].name == "surface a b");
  CHECK(scene.curves.size() == result.arcs.size());
  double highest = 0;
  for (const PolylineVertex& vertex : scene.meshes[1].vertices) highest = std::max(highest, vertex.point[2]);
  for (const SceneCurve& curve : scene.curves) {
    CHECK(curve.error_bound >= 0);
    CHECK(curve.component == result.arcs[static_cast<std::size_t>(curve.arc)].curve);
    for (const PolylineVertex& vertex : curve.vertices) {
      CHECK(residual(pipe_x, vertex.point) < 1e-5);
      CHECK(residual(pipe_z, vertex.point) < 1e-5);
      CHECK(std::fabs(vertex.point[2]) < highest);
    }
  }
  REQUIRE(scene.nodes.size() == result.nodes.size());
  CHECK(std::ranges::count_if(scene.nodes, [](const SceneNode& node) { return node.kinds != 0; }) == 2);
  CHECK(obj_text(scene).find("o surface_a_b\n") != std::string::npos);
  CHECK(ply_text(scene).starts_with("ply\n"));
  CHECK(obj_text(scene).find("o arc_0_ellipse_") != std::string::npos);
  CHECK(vtp_text(scene).find("NumberOfLines") != std::string::npos);
}

TEST_CASE("the picture of two surfaces names the curves, and only nodes that are no joints") {
  const SurfaceIntersection result = intersect(pipe_x, pipe_z);
  const std::string svg = surfaces_svg({result, pipe_x, pipe_z, names}, "A & B");
  CHECK(svg.find("A &amp; B") != std::string::npos);
  CHECK(svg.find("2 ellipses, 2 crossings") != std::string::npos);
  CHECK(svg.find("crossing<") != std::string::npos);
  CHECK(svg.find("joint") == std::string::npos);
  const ImplicitSurface lid = ImplicitSurface::plane({0, 0, 1}, {0, 0, 1});
  const SurfaceIntersection touch = intersect(pipe_x, lid);
  CHECK(surfaces_svg({touch, pipe_x, lid, names}, "").find("line, touching") != std::string::npos);
  // Nothing in common, and nothing that is bounded: no curve, no wire, but a picture.
  const ImplicitSurface above = ImplicitSurface::plane({0, 0, 2}, {0, 0, 1});
  const SurfaceIntersection none = intersect(lid, above);
  const std::string empty = surfaces_svg({none, lid, above, names}, "");
  CHECK(empty.find("nothing in common") != std::string::npos);
  CHECK(empty.find("<path") == std::string::npos);
  CHECK(empty.find("nan") == std::string::npos);
  CHECK(empty.find("inf") == std::string::npos);
}

TEST_CASE("the nodes of two surfaces as a table: exact boxes that hold the points") {
  const SurfaceIntersection result = intersect(pipe_x, pipe_z);
  const std::string text = space_node_csv(result);
  CHECK(text.starts_with("id,kind,arcs,on,x_lower,x_upper,y_lower,y_upper,z_lower,z_upper,x,y,z\n"));
  CHECK(std::ranges::count(text, '\n') == static_cast<std::ptrdiff_t>(result.nodes.size()) + 1);
  std::istringstream lines(text);
  std::string line, cell;
  std::getline(lines, line);
  for (const SpaceNode& node : result.nodes) {
    std::getline(lines, line);
    std::istringstream cells(line);
    for (const std::string& expected : {std::to_string(node.id), std::string(name(node.kind)),
                                        std::to_string(node.degree), std::string()}) {
      std::getline(cells, cell, ',');
      CHECK(cell == expected);
    }
    for (const RationalInterval& side : node.box)
      for (const Rational& end : {side.lower, side.upper}) {
        std::getline(cells, cell, ',');
        CHECK(Rational(cell) == end);
      }
    for (const double coordinate : node.approx) {
      std::getline(cells, cell, ',');
      CHECK(std::stod(cell) == coordinate);
    }
  }
}

}  // namespace
}  // namespace exsect::cli::surfaces_scene_test

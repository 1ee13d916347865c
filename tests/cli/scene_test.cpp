#include "output/drawing/scene.h"

#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <map>
#include <sstream>

#include "output/drawing/scene_obj.h"
#include "output/drawing/scene_ply.h"
#include "output/drawing/scene_vtp.h"
#include "output/text/node_csv.h"
#include "sample_result.h"
#include "support/catch.h"

namespace exsect::cli::scene_test {
namespace {

/// (u, v, u v): its values and derivatives are read off.
BezierPatch saddle(const Rational& height) {
  return BezierPatch::elevated({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, height}}});
}

Scene sample_scene() {
  return intersection_scene(sample_result(), saddle(1), saddle(2), {"a b", "c#d"}, "Title -- with <&>\nbreak",
                            4);
}

template <typename T>
std::vector<T> values(const std::string& text) {
  std::istringstream stream(text);
  std::vector<T> result;
  for (T value; stream >> value;) result.push_back(value);
  CHECK(stream.eof());
  return result;
}

std::size_t curve_vertices(const Scene& scene) {
  std::size_t count = 0;
  for (const SceneCurve& curve : scene.curves) count += curve.vertices.size();
  return count;
}

TEST_CASE("the cells of a sampled patch tile its square and its vertices lie on it") {
  const Scene scene = sample_scene();
  REQUIRE(scene.meshes.size() == 2);
  const SceneMesh& second = scene.meshes[1];
  REQUIRE(second.vertices.size() == 25);
  double area = 0;
  for (const auto& quad : second.faces) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& a = second.vertices[quad[k]].parameters;
      const auto& b = second.vertices[quad[(k + 1) % 4]].parameters;
      area += (a[2] * b[3] - b[2] * a[3]) / 2;
    }
  }
  CHECK(area == 1);
  for (const PolylineVertex& vertex : second.vertices) {
    const auto& [at, point] = vertex;
    CHECK(at[0] == no_parameter);
    CHECK(point == std::array<double, 3>{at[2], at[3], 2 * at[2] * at[3]});
  }
}

TEST_CASE("kinds of nodes and rims of overlaps are told apart") {
  const Scene scene = sample_scene();
  REQUIRE(scene.nodes.size() == 6);
  CHECK(scene.nodes[2].kinds == 5);  // boundary and corner
  CHECK(scene.nodes[5].kinds == 96);
  CHECK(scene.nodes[2].name == "node 2 boundary corner");
  REQUIRE(scene.curves.size() == 5);
  CHECK(scene.curves[2].name == "arc 2 tangential patch-boundary");
  CHECK(scene.curves[4].name == "overlap 0 rim 1 transversal interior");
  CHECK(scene.curves[4].component == -1);
}

TEST_CASE("OBJ indices name the vertices of their own object") {
  const Scene scene = sample_scene();
  std::istringstream lines(obj_text(scene));
  std::size_t vertices = 0, textures = 0, first = 0, faces = 0;
  std::map<std::string, int> objects;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key == "o") {
      words >> word;
      ++objects[word];
      first = vertices;
      CHECK((words >> word).fail());
    }
    if (key == "v") ++vertices;
    if (key == "vt") ++textures;
    if (key == "f") ++faces;
    if (key != "f" && key != "l" && key != "p") continue;
    while (words >> word) {
      CHECK(std::stoul(word) > first);
      CHECK(std::stoul(word) <= vertices);
    }
  }
  CHECK(objects.size() == 13);
  CHECK(objects["patch_c_d"] == 1);
  CHECK(vertices == 50 + curve_vertices(scene) + 6);
  CHECK(textures == 50);
  CHECK(faces == 32);
}

TEST_CASE("PLY has as many lines as its header says, of as many numbers") {
  const Scene scene = sample_scene();
  std::istringstream lines(ply_text(scene));
  std::map<std::string, std::size_t> counts;
  std::map<std::string, std::size_t> properties;
  std::string element, line;
  while (std::getline(lines, line) && line != "end_header") {
    std::istringstream words(line);
    std::string key, name;
    words >> key >> name;
    if (key == "element") words >> counts[element = name];
    if (key == "property") properties[element] += name == "list" ? 5 : 1;  // a count and four corners
  }
  CHECK(counts["vertex"] == 50 + curve_vertices(scene) + 6);
  CHECK(counts["face"] == 32);
  CHECK(counts["edge"] == curve_vertices(scene) - scene.curves.size());
  for (const char* kind : {"vertex", "face", "edge"}) {
    for (std::size_t i = 0; i < counts[kind]; ++i) {
      REQUIRE(std::getline(lines, line));
      CHECK(values<double>(line).size() == properties[kind]);
    }
  }
  CHECK_FALSE(std::getline(lines, line));
}

TEST_CASE("VTK arrays are as long as the numbers of points and cells") {
  const Scene scene = sample_scene();
  std::istringstream stream(vtp_text(scene));
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(stream, tree);
  const auto& piece = tree.get_child("VTKFile.PolyData.Piece");
  const auto points = piece.get<std::size_t>("<xmlattr>.NumberOfPoints");
  const auto cells = piece.get<std::size_t>("<xmlattr>.NumberOfVerts") +
                     piece.get<std::size_t>("<xmlattr>.NumberOfLines") +
                     piece.get<std::size_t>("<xmlattr>.NumberOfPolys");
  CHECK(points == 50 + curve_vertices(scene) + 6);
  CHECK(cells == 6 + 5 + 32);
  CHECK(values<double>(piece.get<std::string>("Points.DataArray")).size() == 3 * points);
  std::map<std::string, std::vector<double>> arrays;
  for (const char* kind : {"PointData", "CellData"}) {
    for (const auto& [tag, array] : piece.get_child(kind)) {
      if (tag != "DataArray") continue;
      const auto name = array.get<std::string>("<xmlattr>.Name");
      arrays[name] = values<double>(array.get_value<std::string>());
      const std::size_t length = std::string(kind) == "PointData" ? points : cells;
      INFO(name);
      if (name == "name")
        CHECK(static_cast<std::size_t>(std::count(arrays[name].begin(), arrays[name].end(), 0)) == length);
      else
        CHECK(arrays[name].size() == length);
    }
  }
  CHECK(arrays["kind"][5] == 96);
  CHECK(arrays["contact"][6 + 2] == 1);
  CHECK(arrays["bound"][6] >= 0.1);
  CHECK(arrays["bound"][6] < 0.1000001);
  CHECK(arrays["patch"].back() == 1);
  CHECK(arrays["bound"].back() == nothing_proved);
  std::size_t seen = 0;
  for (const char* kind : {"Verts", "Lines", "Polys"}) {
    std::map<std::string, std::vector<std::size_t>> lists;
    for (const auto& [tag, array] : piece.get_child(kind)) {
      if (tag == "DataArray")
        lists[array.get<std::string>("<xmlattr>.Name")] = values<std::size_t>(array.get_value<std::string>());
    }
    CHECK(lists["offsets"].back() == lists["connectivity"].size());
    CHECK(*std::max_element(lists["connectivity"].begin(), lists["connectivity"].end()) < points);
    seen += lists["offsets"].size();
  }
  CHECK(seen == cells);
}

TEST_CASE("the table of nodes has a box and a picture of it in every row") {
  const std::string text = node_csv(sample_result().graph, pair_names);
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  CHECK(line ==
        "id,kinds,on,wrt,free,u_lower,u_upper,v_lower,v_upper,r_lower,r_upper,s_lower,s_upper,u,v,r,s,x,y,z");
  std::size_t rows = 0;
  for (; std::getline(lines, line); ++rows) CHECK(std::count(line.begin(), line.end(), ',') == 19);
  CHECK(rows == 6);
  CHECK(text.find("\n2,boundary corner,r=1 s=1,,,") != std::string::npos);
  CHECK(text.find(",1,1,1,1,0.75,0.5,1,1,") != std::string::npos);
}

TEST_CASE("the bound of a drawn parameter line holds between its vertices and is not far above") {
  const BezierPatch x({{{{{0, 0, 0}, {1, 3, 1}, {2, 0, 7}}},
                        {{{0, 0, 1}, {1, 3, 1}, {2, 0, 2}}},
                        {{{0, 0, 2}, {1, 3, 2}, {2, 0, 4}}}}});
  const BezierPatch y = saddle(1);
  const LineQuery query{Parameter::u, Rational(1) / 3};
  const Scene scene = line_scene(intersect_line(x, y, query), x, y, {"x", "y"}, "", 2);
  REQUIRE(scene.curves.size() == 1);
  const SceneCurve& line = scene.curves[0];
  CHECK(line.name == "line u = 1/3");
  double farthest = 0;
  for (std::size_t k = 0; k + 1 < line.vertices.size(); ++k) {
    const Rational t(2 * static_cast<int>(k) + 1, 2 * static_cast<int>(line.vertices.size() - 1));
    const Point p = x(query.value, t);
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double middle = (line.vertices[k].point[c] + line.vertices[k + 1].point[c]) / 2;
      square += (to_double(p[c]) - middle) * (to_double(p[c]) - middle);
    }
    farthest = std::max(farthest, std::sqrt(square));
  }
  CHECK(farthest <= line.error_bound);
  CHECK(line.error_bound <= 2 * farthest);
}

TEST_CASE("the mesh of a surface of revolution keeps its triangles and its bound") {
  const BezierCurve profile({{1, 0}, {2, 1}, {1, 2}});
  const TriangleMesh mesh = revolution_mesh(profile, 3, 8);
  const Scene scene = mesh_scene(mesh, 0.25, "");
  CHECK(scene.meshes[0].faces.size() == mesh.triangles.size());
  const std::string ply = ply_text(scene);
  CHECK(ply.find("\nelement face 48\n") != std::string::npos);
  CHECK(ply.find("\n3 0 1 9 0 0.25\n") != std::string::npos);
  CHECK(vtp_text(scene).find("NumberOfPolys=\"48\"") != std::string::npos);
}

TEST_CASE("a patch beyond the range of doubles is refused") {
  const BezierPatch huge = saddle(Rational(power_of_two(1100)));
  CHECK_THROWS_AS(self_scene(sample_result(), huge, "x", "", 2), std::invalid_argument);
}

}  // namespace
}  // namespace exsect::cli::scene_test

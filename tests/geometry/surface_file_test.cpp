#include <exsect/geometry/surface_file.h>
#include <exsect/geometry/text_file.h>

#include "support/catch.h"

namespace exsect::surface_file_test {
namespace {

std::string file_of(const std::string& entries, const std::string& numbers = "decimal") {
  return R"({"exsect": "patches/1", "numbers": ")" + numbers + R"(", "patches": [)" + entries + "]}";
}

ImplicitSurface surface_of(const std::string& entry) {
  const SurfaceFile file = parse_surfaces(file_of(entry), "f.json");
  REQUIRE(file.surfaces.size() == 1);
  REQUIRE(file.surfaces[0].equation() != nullptr);
  CHECK(file.surfaces[0].patch() == nullptr);
  CHECK(file.surfaces[0].name == "c");
  return *file.surfaces[0].equation();
}

void check_refused(const std::string& entries, const std::string& place, const std::string& reason) {
  INFO(entries);
  try {
    parse_surfaces(file_of(entries), "f.json");
    FAIL_CHECK("taken");
  } catch (const InputError& error) {
    CHECK(error.where() == place);
    CHECK(error.reason().find(reason) != std::string::npos);
    CHECK(std::string(error.what()).starts_with("f.json"));
  }
}

constexpr const char* patch =
    R"({"name": "p", "degree": [1,1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]})";
constexpr const char* sphere = R"({"name": "c", "type": "sphere", "centre": [0,0,0], "radius": 1})";

}  // namespace

TEST_CASE("surfaces in files are those of their makers") {
  CHECK(surface_of(R"({"name": "c", "type": "plane", "point": ["1/2",0,0], "normal": [1,2,3]})").equation() ==
        ImplicitSurface::plane({Rational(1, 2), 0, 0}, {1, 2, 3}).equation());
  CHECK(surface_of(R"({"name": "c", "type": "cylinder", "point": [0,0,0], "axis": [1,1,1], "radius": "0.1"})")
            .equation() == ImplicitSurface::cylinder({0, 0, 0}, {1, 1, 1}, Rational(1, 10)).equation());
  CHECK(
      surface_of(R"({"name": "c", "type": "sphere", "centre": [0,1,0], "radius_squared": "2"})").equation() ==
      ImplicitSurface::sphere({0, 1, 0}, Length::of_squared(2)).equation());
  const std::string cone =
      R"({"name": "c", "type": "cone", "apex": [0,0,3], "axis": [0,0,-1], "slope": "1/2")";
  CHECK(surface_of(cone + "}").bound());
  CHECK(surface_of(cone + R"(, "nappes": 1})").bound());
  CHECK_FALSE(surface_of(cone + R"(, "nappes": 2})").bound());
  CHECK(surface_of(cone + "}").contains({1, 0, 1}));
  CHECK_FALSE(surface_of(cone + "}").contains({1, 0, 5}));
  CHECK(surface_of(R"({"name": "c", "type": "torus", "centre": [0,0,0], "axis": [0,0,2], "major": 3,
                       "minor_squared": 1})")
            .contains({4, 0, 0}));
  const ImplicitSurface quadric = surface_of(
      R"({"name": "c", "type": "implicit", "terms": [["1/2", [2,0,0]], [-1, [0,1,1]], [3, [0,0,0]]]})");
  CHECK(quadric.kind() == SurfaceKind::polynomial);
  CHECK(quadric.equation()({2, 5, 1}) == 0);
  CHECK(surface_of(R"({"type": "sphere", "radius": 1, "centre": [0,0,0], "name": "c"})").contains({0, 0, 1}));
}

TEST_CASE("faces in files are those of their boxes") {
  const ImplicitSurface pipe =
      surface_of(R"({"name": "c", "type": "cylinder", "point": [0,0,0], "axis": [0,0,2],
    "radius": 1, "box": {"sector": {"from": [1,0,5], "to": [0,"1/2",0]}, "height": [0, "1/2"]}})");
  CHECK(pipe.box().bounds.size() == 4);
  CHECK(pipe.contains({Rational(3, 5), Rational(4, 5), 1}));
  CHECK_FALSE(pipe.contains({Rational(3, 5), Rational(4, 5), Rational(101, 100)}));
  CHECK_FALSE(pipe.contains({Rational(3, 5), Rational(-4, 5), 1}));
  const ImplicitSurface cap = surface_of(R"({"name": "c", "type": "sphere", "centre": [0,0,0], "radius": 1,
    "box": {"axis": [0,0,1], "height": ["1/2", 1]}})");
  CHECK(cap.contains({0, 0, 1}));
  CHECK_FALSE(cap.contains({1, 0, 0}));
  const ImplicitSurface inner =
      surface_of(R"({"name": "c", "type": "torus", "centre": [0,0,0], "axis": [0,0,1],
    "major": 3, "minor": 1, "box": {"tube": {"from": [0, 1], "to": [0, -1]}}})");
  CHECK(inner.contains({2, 0, 0}));
  CHECK_FALSE(inner.contains({4, 0, 0}));
  const ImplicitSurface sheet =
      surface_of(R"({"name": "c", "type": "plane", "point": [0,0,0], "normal": [0,0,1],
    "box": {"sides": [[2,0,0],[1,3,0]]}})");
  CHECK(sheet.contains({3, 3, 0}));
  CHECK_FALSE(sheet.contains({0, 3, 0}));
}

TEST_CASE("boxes that are none are refused with their place") {
  const auto refused = [](const std::string& type, const std::string& box, const std::string& place,
                          const std::string& reason) {
    check_refused(R"({"name": "c", )" + type + R"(, "box": )" + box + "}", "$.patches[0]." + place, reason);
  };
  const std::string pipe = R"("type": "cylinder", "point": [0,0,0], "axis": [0,0,1], "radius": 1)";
  const std::string ball = R"("type": "sphere", "centre": [0,0,0], "radius": 1)";
  const std::string ring = R"("type": "torus", "centre": [0,0,0], "axis": [0,0,1], "major": 3, "minor": 1)";
  const std::string flat = R"("type": "plane", "point": [0,0,0], "normal": [0,0,1])";
  refused(pipe, "{}", "box", "bounds nothing");
  refused(pipe, R"({"heights": [0,1]})", "box", "heights");
  refused(pipe, R"({"height": [1,1]})", "box.height", "does not ascend");
  refused(pipe, R"({"height": [2,1]})", "box.height", "does not ascend");
  refused(pipe, R"({"height": [0,1,2]})", "box.height", "2 heights");
  refused(pipe, R"({"sector": {"from": [1,0,0]}})", "box.sector", "to");
  refused(pipe, R"({"sector": {"from": [1,0,0], "to": [2,0,7]}})", "box.sector", "one direction");
  refused(pipe, R"({"sector": {"from": [0,0,3], "to": [2,0,7]}})", "box.sector.from", "parallel to the axis");
  refused(pipe, R"({"sector": {"from": [1,0,0], "to": [0,0,0]}})", "box.sector.to", "zero");
  refused(pipe, R"({"tube": {"from": [1,0], "to": [0,1]}})", "box.tube", "cylinder");
  refused(pipe, R"({"axis": [0,0,1], "height": [0,1]})", "box.axis", "cylinder");
  refused(ball, R"({"height": [0,1]})", "box", "axis");
  refused(ball, R"({"axis": [0,0,0], "height": [0,1]})", "box.axis", "zero");
  refused(ball, R"({"axis": [0,0,1]})", "box", "bounds nothing");
  refused(ring, R"({"tube": {"from": [0,0], "to": [0,1]}})", "box.tube.from", "zero");
  refused(ring, R"({"tube": {"from": [1,1], "to": [2,2]}})", "box.tube", "one direction");
  refused(flat, R"({"height": [0,1]})", "box.height", "plane");
  refused(flat, R"({"sides": [[1,0,0],[2,0,0]]})", "box.sides", "parallel");
  refused(flat, R"({"sides": [[1,0,0],[2,0,1]]})", "box.sides[1]", "orthogonal");
  refused(flat, R"({"sides": [[0,0,0],[2,0,1]]})", "box.sides[0]", "zero");
  refused(R"("type": "implicit", "terms": [[1, [1,0,0]]])", R"({"height": [0,1]})", "box", "implicit");
}

TEST_CASE("surfaces beside patches, in the order of the file, with the numbers of the file") {
  const SurfaceFile file =
      parse_surfaces(file_of(std::string(patch) + ", " +
                                 R"({"name": "c", "type": "sphere", "centre": [0.1,0,0], "radius": 0.5})",
                             "binary64"),
                     "f.json");
  REQUIRE(file.surfaces.size() == 2);
  REQUIRE(file.surfaces[0].patch() != nullptr);
  CHECK((*file.surfaces[0].patch())(1, 1) == Point{1, 1, 1});
  CHECK(file.surfaces[1].equation()->contains({from_double(0.1), 0, from_double(0.5)}));
  CHECK_THROWS_AS(parse_rational_patches(file_of(std::string(patch) + ", " + sphere), "f.json"), InputError);
  try {
    parse_rational_patches(file_of(std::string(patch) + ", " + sphere), "f.json");
  } catch (const InputError& error) {
    CHECK(error.where() == "$.patches[1]");
    CHECK(error.reason() == "\"c\" is given by its equation (sphere); only patches are taken here");
  }
  CHECK(parse_rational_patches(file_of(patch), "f.json").patches.size() == 1);
}

TEST_CASE("what is no surface is refused with its place") {
  const auto with = [](const std::string& members) { return R"({"name": "c", )" + members + "}"; };
  check_refused(with(R"("type": "cube")"), "$.patches[0].type", "must be plane, cylinder");
  check_refused(with(R"("type": 7)"), "$.patches[0].type", "string");
  check_refused(with(R"("type": "plane", "point": [0,0,0])"), "$.patches[0]", "normal");
  check_refused(with(R"("type": "plane", "point": [0,0], "normal": [0,0,1])"), "$.patches[0].point",
                "3 coordinates");
  check_refused(with(R"("type": "plane", "point": [0,0,0], "normal": [0,0,0])"), "$.patches[0].normal",
                "zero");
  check_refused(with(R"("type": "plane", "point": [0,0,"nan"], "normal": [0,0,1])"), "$.patches[0].point[2]",
                "");
  check_refused(with(R"("type": "sphere", "centre": [0,0,0], "radius": 0)"), "$.patches[0].radius",
                "not positive");
  check_refused(with(R"("type": "sphere", "centre": [0,0,0], "radius": "-1")"), "$.patches[0].radius",
                "not positive");
  check_refused(with(R"("type": "sphere", "centre": [0,0,0], "radius_squared": "-1")"),
                "$.patches[0].radius_squared", "not positive");
  check_refused(with(R"("type": "sphere", "centre": [0,0,0], "radius": 1, "radius_squared": 1)"),
                "$.patches[0].radius_squared", "given as well");
  check_refused(with(R"("type": "sphere", "centre": [0,0,0], "radius": 1, "axis": [0,0,1])"), "$.patches[0]",
                "axis");
  check_refused(with(R"("type": "sphere", "centre": [0,0,0], "radius": 1, "box": [])"), "$.patches[0].box",
                "object");
  check_refused(with(R"("type": "cylinder", "point": [0,0,0], "axis": [0,0,0], "radius": 1)"),
                "$.patches[0].axis", "zero");
  check_refused(with(R"("type": "cone", "apex": [0,0,0], "axis": [0,0,1], "slope": 1, "nappes": 3)"),
                "$.patches[0].nappes", "from 1 to 2");
  check_refused(with(R"("type": "torus", "centre": [0,0,0], "axis": [0,0,1], "major": 1, "minor": 2)"),
                "$.patches[0].minor", "spindle");
  check_refused(with(R"("type": "torus", "centre": [0,0,0], "axis": [0,0,1], "major": 1, "minor": 1)"),
                "$.patches[0].minor", "horn");
  check_refused(with(R"("type": "torus", "centre": [0,0,0], "axis": [0,0,1], "major": 1, "minor": 0)"),
                "$.patches[0].minor", "not positive");
  check_refused(with(R"("type": "cylinder", "point": [0,0,0], "axis": [0,0,1], "radius": 0)"),
                "$.patches[0].radius", "not positive");
  check_refused(with(R"("type": "torus", "centre": [0,0,0], "axis": [0,0,1], "major": -1, "minor": 2)"),
                "$.patches[0].major", "not positive");
  check_refused(with(R"("type": "implicit", "terms": [])"), "$.patches[0].terms", "constant");
  check_refused(with(R"("type": "implicit", "terms": [[1, [0,0,0]]])"), "$.patches[0].terms", "constant");
  check_refused(with(R"("type": "implicit", "terms": [[0, [1,0,0]]])"), "$.patches[0].terms", "constant");
  check_refused(with(R"("type": "implicit", "terms": [[1, [3,2,0]]])"), "$.patches[0].terms", "above 4");
  check_refused(with(R"("type": "implicit", "terms": [[1, [5,0,0]]])"), "$.patches[0].terms[0][1][0]",
                "from 0 to 4");
  check_refused(with(R"("type": "implicit", "terms": [[1, [1,0,0]], [2, [1,0,0]]])"),
                "$.patches[0].terms[1][1]", "two terms");
  check_refused(with(R"("type": "implicit", "terms": [[1, [1,0]]])"), "$.patches[0].terms[0][1]",
                "3 exponents");
  check_refused(std::string(sphere) + ", " + sphere, "$.patches[1].name", "two patches");
  check_refused(R"({"name": "", "type": "sphere", "centre": [0,0,0], "radius": 1})", "$.patches[0].name",
                "empty");
  check_refused(R"({"type": "sphere", "centre": [0,0,0], "radius": 1})", "$.patches[0]", "name");
}

}  // namespace exsect::surface_file_test

// exsect intersect of a patch and a surface given by its equation, end to end.
#include "check_refused.h"
#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::intersect_equation_test {
namespace {

using Json = nlohmann::json;

const std::string surfaces = example("surfaces.json");

Json intersect(const std::string& first, const std::string& second) {
  const ProgramRun run =
      run_program({"intersect", surfaces, "--first", first, "--second", second, "--json", "-"});
  INFO(run.err);
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("intersection-1").violation(json) == "");
  json.erase("work");
  return json;
}

}  // namespace

TEST_CASE("intersect: a saddle and a torus, in either order") {
  const Json json = intersect("saddle", "torus");
  CHECK(json["status"] == "complete");
  CHECK(json["first"] == "saddle");
  CHECK(json["second"] == "torus");
  CHECK(json["equation"] == "torus");
  // z = xy/16 is inside the torus over rings around its equators: two closed curves, one of which touches all
  // sides.
  CHECK(json["summary"]["components"] == 2);
  CHECK(json["summary"]["closed"] == 2);
  CHECK(json["summary"]["boundary"] == 4);
  CHECK(json["summary"]["turning"] == Json::parse(R"({"u": 2, "v": 2})"));
  for (const Json& node : json["nodes"]) {
    CHECK_FALSE(node["box"].contains("r"));
    CHECK_FALSE(node["approx"].contains("s"));
  }
  for (const Json& arc : json["arcs"]) {
    CHECK(arc["polyline"][0].size() == 5);
    CHECK(arc["left"].get<int>() == -arc["right"].get<int>());
  }
  CHECK(intersect("torus", "saddle") == json);
}

TEST_CASE("intersect: every kind of surface with a patch") {
  const Json floor = intersect("saddle", "floor");
  CHECK(floor["summary"]["isolated"] == 2);  // its lowest corners, above the plane
  for (const Json& node : floor["nodes"]) CHECK(node["around"] == 1);
  CHECK(intersect("saddle", "oblique")["summary"]["components"] > 0);
  CHECK(intersect("saddle", "cone")["equation"] == "cone");
  CHECK(intersect("ball", "saddle")["summary"]["closed"] == 1);
  CHECK(intersect("saddle", "quartic")["equation"] == "implicit");
}

TEST_CASE("intersect: pictures, tables and scenes of one patch") {
  const ScratchDirectory scratch;
  const ProgramRun run =
      run_program({"intersect", surfaces, "--first", "saddle", "--second", "ball", "--svg",
                   scratch.path("a.svg"), "--csv", scratch.path("a.csv"), "--obj", scratch.path("a.obj"),
                   "--vtp", scratch.path("a.vtp"), "--ply", scratch.path("a.ply")});
  INFO(run.err);
  CHECK(run.status == 0);
  CHECK(run.out.find("saddle with ball: complete, proved: 1 component (1 closed)") != std::string::npos);
  CHECK(run.out.find("in doubles with proved error bounds") != std::string::npos);
  const std::string svg = content(scratch.path("a.svg"));
  CHECK(svg.find("ball by its equation") != std::string::npos);
  CHECK(svg.find("other square") == std::string::npos);
  const std::string csv = content(scratch.path("a.csv"));
  CHECK(csv.starts_with("id,kinds,on,wrt,free,u_lower,u_upper,v_lower,v_upper,u,v,x,y,z\n"));
  for (const char* file : {"a.obj", "a.vtp", "a.ply"}) CHECK(content(scratch.path(file)).size() > 1000);
}

TEST_CASE("intersect: a patch and an equation have a certificate, or none by name") {
  const ScratchDirectory scratch;
  const std::string proof = scratch.path("proof.json");
  for (const char* name : {"oblique", "ball", "floor"}) {  // the floor meets corners of the saddle alone
    INFO(name);
    const ProgramRun run = run_program({"intersect", surfaces, "--first", name, "--second", "saddle",
                                        "--tolerance", "1e-2", "--certificate", proof, "--quiet"});
    INFO(run.err);
    REQUIRE(run.status == 0);
    CHECK(run_program({"check", proof}).out.find("accepted") != std::string::npos);
  }
  const std::string path = scratch.path("none.json");
  const ProgramRun none = run_program(
      {"intersect", surfaces, "--first", "saddle", "--second", "cone", "--certificate", path, "--quiet"});
  INFO(none.err);
  CHECK(none.status == 3);
  CHECK(none.err.find("no certificate: a surface with bounds") != std::string::npos);
}

TEST_CASE("intersect: what is not there yet for equations is refused by name") {
  check_refused({"intersect", surfaces, "--first", "torus", "--second", "ball", "--certificate", "proof"},
                "not supported yet with --certificate");
  check_refused({"line", surfaces, "--first", "saddle", "--second", "ball", "--u", "1/2"},
                "only patches are taken");
  check_refused({"intersect", surfaces}, "holds 7 patches");
}

TEST_CASE("intersect: two surfaces given by their equations") {
  const auto common = [](const std::string& first, const std::string& second, int status) {
    const ProgramRun run = run_program(
        {"intersect", surfaces, "--first", first, "--second", second, "--tolerance", "1e-3", "--json", "-"});
    INFO(run.err);
    CHECK(run.status == status);
    const Json json = Json::parse(run.out);
    CHECK(JsonSchema::named("surfaces-1").violation(json) == "");
    return json;
  };
  const Json circles = common("torus", "floor", 0);  // z = -1 touches along the circle of radius 3
  CHECK(circles["summary"] == "1 circle");
  CHECK(circles["curves"][0]["radius_squared"] == "9");
  CHECK(circles["curves"][0]["multiplicity"] == 2);
  CHECK(circles["curves"][0]["point"] == Json::parse(R"(["0", "0", "-1"])"));
  CHECK(common("cone", "floor", 0)["curves"][0]["radius_squared"] == "4");
  CHECK(common("oblique", "ball", 0)["equations"] == Json::parse(R"(["cylinder", "sphere"])"));
  CHECK(common("torus", "quartic", 0)["summary"] == "2 general curves");
  CHECK(common("floor", "quartic", 0)["summary"] == "1 general curve");
  const ScratchDirectory scratch;
  const auto file = [&](const char* name) { return scratch.path(name); };
  const ProgramRun text = run_program({"intersect", surfaces, "--first", "cone", "--second", "floor", "--svg",
                                       file("a.svg"), "--csv", file("a.csv"), "--obj", file("a.obj"), "--vtp",
                                       file("a.vtp"), "--ply", file("a.ply"), "--grid", "8"});
  CHECK(text.status == 0);
  CHECK(content(file("a.svg")).find("1 circle") != std::string::npos);
  CHECK(content(file("a.csv")).starts_with("id,kind,arcs,on,x_lower"));
  CHECK(content(file("a.obj")).find("o surface_cone\n") != std::string::npos);
  for (const char* name : {"a.vtp", "a.ply"}) CHECK(content(file(name)).size() > 1000);
  CHECK(text.out.find("cone with floor: complete, proved: 1 circle") != std::string::npos);
  CHECK(text.out.find("(0, 0, -1)") != std::string::npos);
}

TEST_CASE("intersect: two tori without rational points") {
  const ScratchDirectory scratch;
  const std::string path = scratch.path("tori.json");
  std::ofstream(path) << R"({"exsect": "patches/1", "patches": [
    {"name": "a", "type": "torus", "centre": [0, 0, 0], "axis": [1, 1, 1], "major": 3, "minor_squared": 2},
    {"name": "b", "type": "torus", "centre": [1, 0, 0], "axis": [1, 1, 1], "major": 3, "minor_squared": 2}]})";
  const ProgramRun run = run_program({"intersect", path, "--first", "a", "--second", "b", "--json", "-"});
  CHECK(run.status == 0);
  const Json complete = Json::parse(run.out);
  CHECK(JsonSchema::named("surfaces-1").violation(complete) == "");
  CHECK(complete["status"] == "complete");
  CHECK(complete["curves"].size() == 2);
}

TEST_CASE("intersect: surfaces beyond the range of doubles are refused with their place") {
  const ScratchDirectory scratch;
  const std::string path = scratch.path("huge.json");
  std::ofstream(path) << R"({"exsect": "patches/1", "patches": [
    {"name": "floor", "type": "plane", "point": ["0", "0", "0"], "normal": ["0", "0", "1"]},
    {"name": "ball", "type": "sphere", "centre": ["0", "0", "0"], "radius": "1e400"}]})";
  check_refused({"intersect", path},
                "$.patches[1].radius: the common points must lie in the range of doubles");
}

TEST_CASE("intersect: two faces of one cylinder share a side") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("faces.json");
  write(file, R"({"exsect": "patches/1", "patches": [
    {"name": "a", "type": "cylinder", "point": [0, 0, 0], "axis": [0, 0, 1], "radius": 1, "box": {"height": [0, 1]}},
    {"name": "b", "type": "cylinder", "point": [0, 0, 5], "axis": [0, 0, 2], "radius": 1, "box": {"height": [-2, -1]}}]})");
  const ProgramRun run = run_program({"intersect", file, "--json", "-"});
  CHECK(run.status == 0);
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("surfaces-1").violation(json) == "");
  CHECK(json["same"] == false);
  CHECK(json["summary"] == "1 circle");
  CHECK(json["curves"][0]["multiplicity"] == 0);
  CHECK(run_program({"intersect", file}).out.find("one surface") != std::string::npos);
}

}  // namespace exsect::intersect_equation_test

#include <cmath>
#include <nlohmann/json.hpp>

#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::revolve_command_test {
namespace {

using Json = nlohmann::json;

const std::string profile = example("profile.json");

Json revolved(std::vector<std::string> options, const std::string& file = profile) {
  std::vector<std::string> arguments = {"revolve", file};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(arguments.end(), {"--json", "-"});
  const ProgramRun run = run_program(arguments);
  INFO(run.err);
  CHECK(run.status == 0);
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("revolution-1").violation(json) == "");
  return json;
}

double proved(const Json& json, const std::string& name) {
  for (const Json& statement : json["proved"])
    if (statement["name"] == name) return statement["approx"];
  return INFINITY;
}

TEST_CASE("revolve: rings, branches and distance of the cubic fit") {
  const Json json = revolved({"--method", "product", "--degree", "3", "--region", "2,0,2"});
  CHECK(json["status"] == "complete");
  REQUIRE(json["rings"].size() == 2);
  CHECK(std::abs(json["rings"][0]["r"]["approx"].get<double>() - 0.63878) < 1e-5);
  CHECK(std::abs(json["rings"][1]["z"]["approx"].get<double>() - 0.98806) < 1e-5);
  const std::vector<std::array<int, 2>> expected = {{1, 0}, {1, 2}, {1, 0}, {0, 1}};
  REQUIRE(json["branches"]["counts"].size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(json["branches"]["counts"][i]["own"] == expected[i][0]);
    CHECK(json["branches"]["counts"][i]["mirrored"] == expected[i][1]);
  }
  CHECK(proved(json, "one-sided") <= 0.0085112);
  CHECK(proved(json, "two-sided") <= 0.00976);
  CHECK(json["equations"][1]["degrees"] == Json({6, 6, 6}));
  // elimination gives the same surface
  const Json other = revolved({"--method", "elimination", "--degree", "3", "--region", "2,0,2"});
  CHECK(other["equations"] == json["equations"]);
}

TEST_CASE("revolve: substitution, splines, and the exact profile") {
  const Json clean = revolved({"--method", "substitution", "--degree", "3", "--region", "2,0,2"});
  CHECK(clean["rings"].empty());
  CHECK(clean["equations"][1]["degrees"] == Json({6, 6, 3}));
  CHECK(proved(clean, "one-sided") <= 0.0051141);
  const Json spline = revolved(
      {"--method", "substitution", "--degree", "2", "--cells", "6", "--w2", "1/1000", "--region", "2,0,2"});
  CHECK(spline["equations"].empty());
  CHECK(spline["cells"].size() > 4);
  CHECK(spline["rings"].is_null());
  const Json exact = revolved({"--method", "product"});
  CHECK(exact["exact"] == true);
  CHECK(exact["proved"][0]["name"] == "exact");
  const Json biquartic =
      revolved({"--method", "product", "--degree", "4x4", "--w2", "1/1000", "--region", "2,0,2"});
  CHECK(biquartic["equations"][1]["degrees"] == Json({8, 8, 8}));
}

TEST_CASE("revolve: against a patch") {
  const Json json = revolved({"--method", "product", "--degree", "3", "--patch-file",
                              example("chapter9-first.json"), "--patch", "x", "--u", "1/2", "--u", "1/4"});
  const Json& patch = json["patch"];
  CHECK(patch["bidegree"] == Json({12, 12}));
  CHECK(patch["components"].size() >= 1);
  REQUIRE(patch["lines"].size() == 2);
  CHECK(patch["lines"][0]["u"] == "1/2");
  for (const Json& arc : patch["arcs"]) CHECK(arc["sheet"] == "own");
}

TEST_CASE("revolve: summary, picture and mesh") {
  const ScratchDirectory scratch;
  const std::string svg = scratch.path("rz.svg"), mesh = scratch.path("surface.obj");
  const std::string ply = scratch.path("surface.ply"), vtp = scratch.path("surface.vtp");
  const ProgramRun run =
      run_program({"revolve", profile, "--method", "product", "--degree", "3", "--region", "2,0,2", "--svg",
                   svg, "--mesh", mesh, "--mesh-size", "4,8", "--ply", ply, "--vtp", vtp});
  CHECK(run.status == 0);
  CHECK(run.out.find("2 singular rings\n") != std::string::npos);
  CHECK(content(svg).find("mirrored branches") != std::string::npos);
  CHECK(content(mesh).find("# every point of the mesh is within ") != std::string::npos);
  CHECK(content(mesh).find("f 1 2 10") != std::string::npos);
  CHECK(content(ply).find("\n3 0 1 9 0 0.1") != std::string::npos);
  CHECK(content(vtp).find("NumberOfPolys=\"64\"") != std::string::npos);
}

TEST_CASE("revolve: bad input is refused with the reason") {
  const ScratchDirectory scratch;
  const std::string oblique = scratch.path("oblique.json");
  write(oblique, R"({"exsect": "curve/1", "degree": 1, "points": [[0, 0], [1, 1]]})");
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& reason) {
    const ProgramRun run = run_program(arguments);
    INFO(run.err);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err.find(reason) != std::string::npos);
  };
  refused({"revolve", oblique, "--method", "substitution", "--degree", "3"}, "not orthogonal to the axis");
  refused({"revolve", profile}, "--method");
  refused({"revolve", profile, "--method", "turning"}, "--method");
  refused({"revolve", profile, "--method", "substitution"}, "needs a degree");
  refused({"revolve", profile, "--method", "product", "--degree", "0"}, "--degree");
  refused({"revolve", profile, "--method", "product", "--degree", "3", "--w1", "0"}, "w1");
  refused({"revolve", profile, "--method", "product", "--degree", "3", "--region", "0,0,1"}, "region");
  refused({"revolve", profile, "--method", "product", "--u", "1/2"}, "--patch-file");
  refused({"revolve", profile, "--method", "product", "--mesh", scratch.path("none/x.obj")}, "--mesh: ");
  refused({"revolve", profile, "--method", "product", "--mesh", profile}, "--mesh: ");
  refused({"revolve", profile, "--method", "product", "--mesh", scratch.path("x.obj"), "--mesh-size", "1,2"},
          "--mesh-size");
  refused({"revolve", example("space-cubic.json"), "--method", "product"}, "planar");
}

}  // namespace
}  // namespace exsect::revolve_command_test

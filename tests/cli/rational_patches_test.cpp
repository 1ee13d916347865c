// Patches of bidegrees up to (3,3), with and without weights, before all commands.
#include <exsect/geometry/rational_patch_file.h>

#include <nlohmann/json.hpp>

#include "check_refused.h"
#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::rational_patches_test {
namespace {

using Json = nlohmann::json;

const std::string teapot = example("teapot.bpt");

/// A quarter of a cylinder with weights 1, 1, 2, and a plane through it of bidegree (1,1).
const std::string weighted = R"({"exsect": "patches/1", "patches": [
  {"name": "quarter", "degree": [2, 1], "points": [[[1,0,0],[1,0,1]], [[1,1,0],[1,1,1]], [[0,1,0],[0,1,1]]],
   "weights": [[1, 1], [1, 1], [2, 2]]},
  {"name": "plane", "degree": [1, 1], "points": [[[0,0,"1/2"],[0,2,"1/2"]], [[2,0,"1/2"],[2,2,"1/2"]]]}]})";

/// Every example of two patches, with both patches in the net of another shape, or with equal weights.
RationalPatchFile reshaped(const RationalPatchFile& file, bool weights) {
  RationalPatchFile result = file;
  for (NamedRationalPatch& named : result.patches) {
    const RationalPatch elevated =
        named.patch.elevated(3, 3 - static_cast<int>(&named - result.patches.data()) % 2);
    std::vector<std::vector<Point>> points;
    std::vector<std::vector<Rational>> fifths;
    for (int i = 0; i <= elevated.degree_u(); ++i) {
      points.emplace_back();
      fifths.emplace_back(static_cast<std::size_t>(elevated.degree_v()) + 1, Rational(7, 5));
      for (int j = 0; j <= elevated.degree_v(); ++j) points.back().push_back(elevated.point(i, j));
    }
    named.patch = weights ? RationalPatch(points, fifths) : RationalPatch(points);
  }
  return result;
}

Json result_of(const std::vector<std::string>& arguments) {
  const ProgramRun run = run_program(arguments);
  INFO(run.err);
  CHECK(run.status == 0);
  Json json = Json::parse(run.out);
  json.erase("work");
  return json;
}

TEST_CASE("a biquadratic patch of another shape has the same results") {
  const ScratchDirectory scratch;
  for (const char* name : {"chapter9-first.json", "touching-curve.json"}) {
    for (const bool weights : {false, true}) {
      const std::string file = scratch.path("elevated.json");
      write_patches(reshaped(read_rational_patches(example(name)), weights), file);
      CHECK(result_of({"intersect", file, "--json", "-"}) ==
            result_of({"intersect", example(name), "--json", "-"}));
      CHECK(result_of({"line", file, "--u", "1/3", "--json", "-"}) ==
            result_of({"line", example(name), "--u", "1/3", "--json", "-"}));
    }
  }
}

TEST_CASE("what patches of higher degree or with weights cannot have is refused with their kind") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("weighted.json");
  write(file, weighted);
  const std::string here =
      ": patch \"quarter\": not supported here: bidegree (2,1) with weights, only polynomial";
  check_refused({"compare", file}, file + here);
  check_refused({"implicitize", file, "--patch", "quarter"}, file + here);
  check_refused({"revolve", example("profile.json"), "--method", "elimination", "--patch-file", file,
                 "--patch", "quarter"},
                file + here);
  check_refused({"intersect", teapot, "--first", "13", "--second", "5", "--exact"},
                teapot + ": not supported yet: exact arithmetic for bidegree (3,3) and bidegree (3,3)");
  CHECK(run_program({"intersect", file, "--exact"}).status == 0);
  for (const char* name : {"plane", "quarter"})
    CHECK(run_program({"self", file, "--patch", name, "--certificate", scratch.path("out")}).status == 0);
}

TEST_CASE("self takes patches of higher degree and with weights, in every form of output") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("loop.json");
  // The loop (0,0), (3,2), (-2,2), (1,0), moved along a line: it crosses itself over t = 1/2 -+ sqrt(3)/4.
  write(file, R"({"exsect": "patches/1", "patches": [
    {"name": "loop", "degree": [3, 1], "points": [[[0, 0, 0], [0, 0, 2]], [[3, 2, 0], [3, 2, 2]],
                                                  [[-2, 2, 0], [-2, 2, 2]], [[1, 0, 0], [1, 0, 2]]]}]})");
  const ProgramRun run =
      run_program({"self", file, "--report", scratch.path("out.html"), "--csv", scratch.path("out.csv"),
                   "--svg", scratch.path("out.svg"), "--vtp", scratch.path("out.vtp")});
  CHECK(run.status == 0);
  CHECK(run.out.find("loop with itself: complete, proved: 1 component (1 open)") != std::string::npos);
  const Json result = Json::parse(run_program({"self", file, "--json", "-"}).out);
  CHECK(JsonSchema::named("self-1").violation(result) == "");
  CHECK(result["components"].size() == 1);
}

TEST_CASE("certificates of patches of higher degree and with weights, and of lines on them") {
  const ScratchDirectory scratch;
  const std::string bent = scratch.path("bent.json");
  write(bent, R"({"exsect": "patches/1", "patches": [
    {"name": "bent", "degree": [2, 1], "points": [[[0,0,0],[0,1,"1/8"]], [["1/2",0,"1/5"],["1/2",1,0]], [[1,0,0],[1,1,"1/7"]]],
     "weights": [[1, 1], ["3/2", "4/3"], [1, 1]]},
    {"name": "cubic", "degree": [3, 1], "points": [[["-1/10","1/3",-1],["-1/10","2/3",1]], [["1/4","1/2",-1],["1/4","1/2",1]],
      [["3/4","2/5",-1],["3/4","3/5",1]], [["11/10","1/2",-1],["11/10","3/7",1]]]}]})");
  const std::string proof = scratch.path("proof.json");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"intersect", bent, "--tolerance", "1e-3"},
        {"intersect", teapot, "--first", "1", "--second", "5", "--tolerance", "1e-2"},
        {"line", bent, "--u", "1/3"},
        {"line", teapot, "--first", "1", "--second", "5", "--u", "1/3"}}) {
    INFO(command[0] << " " << command[1]);
    std::vector<std::string> written = command;
    written.insert(written.end(), {"--certificate", proof, "--quiet"});
    const ProgramRun run = run_program(written);
    INFO(run.err);
    REQUIRE(run.status == 0);
    CHECK(run_program({"check", proof}).out.find("accepted") != std::string::npos);
  }
}

TEST_CASE("line takes patches of higher degree and with weights, in every form of output") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("weighted.json");
  write(file, weighted);
  // The quarter circle of weights 1, 1, 2 is at z = v, the plane (2 r, 2 s, 1/2): one point, where the line u
  // = 1/3 has v = 1/2, x = 4/5 and y = 3/5.
  const Json line = result_of({"line", file, "--u", "1/3", "--json", "-"});
  CHECK(JsonSchema::named("line-1").violation(line) == "");
  REQUIRE(line["points"].size() == 1);
  CHECK(line["points"][0]["box"]["v"] == Json({"1/2", "1/2"}));
  CHECK(line["points"][0]["approx"]["r"].get<double>() == Approx(0.4));
  CHECK(line["points"][0]["multiplicity"] == 1);
  const Json arc = result_of({"line", file, "--v", "1/2", "--json", "-"});  // it lies in the plane
  CHECK(arc["shape"] == "conic");
  CHECK(arc["points"].empty());
  REQUIRE(arc["on_patch"].size() == 1);
  CHECK(arc["on_patch"][0]["to"]["box"] == Json({"1", "1"}));
  for (const char* option : {"--svg", "--report", "--csv", "--obj", "--ply", "--vtp"})
    for (const char* u : {"0", "1/3"}) {
      const std::string out = scratch.path("out");
      CHECK(run_program({"line", teapot, "--first", "13", "--second", "5", "--u", u, option, out}).status ==
            0);
      CHECK(!content(out).empty());
      CHECK(run_program({"line", file, "--u", u, option, out}).status == 0);
    }
  const Json spout =
      result_of({"line", teapot, "--first", "13", "--second", "5", "--u", "1/3", "--json", "-"});
  CHECK(JsonSchema::named("line-1").violation(spout) == "");
  CHECK(spout["pullback"].contains("cubic"));
}

TEST_CASE("verify takes patches of higher degree and with weights") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("weighted.json");
  const std::string candidate = scratch.path("c.json");
  const std::string report = scratch.path("report.html");
  std::string tilted = weighted;  // z = 1/2 + x/4
  tilted.replace(tilted.rfind("[[[0,0"), std::string::npos,
                 R"([[[-1,-1,"1/4"],[-1,2,"1/4"]], [[2,-1,1],[2,2,1]]]}]})");
  write(file, tilted);
  // A quarter of an ellipse: (1 - t^2, 2 t) / (1 + t^2) lifted into the plane.
  const auto agreement = [&](const std::string& second_weight) {
    write(candidate, R"({"exsect": "candidate/1", "patches": ["quarter", "plane"], "curves": [{"points":
      {"degree": 2, "knots": [0,0,0,1,1,1], "points": [[1,0,0.75],[1,1,0.75],[0,1,0.5]], "weights": [1,)" +
                         second_weight + R"(,2]}}]})");
    const ProgramRun run =
        run_program({"verify", candidate, file, "--tolerance", "1e-4", "--json", "-", "--report", report});
    INFO(run.err);
    CHECK(run.err.empty());
    return Json::parse(run.out)["verdict"];
  };
  CHECK(agreement("1") == "agrees");
  CHECK(agreement("1.01") == "disagrees");
  const ProgramRun right =
      run_program({"intersect", teapot, "--first", "1", "--second", "4", "--obj", scratch.path("c.obj")});
  CHECK(right.status == 0);
  CHECK(run_program(
            {"verify", scratch.path("c.obj"), teapot, "--first", "1", "--second", "4", "--tolerance", "1e-3"})
            .status == 0);
  CHECK(run_program(
            {"verify", scratch.path("c.obj"), teapot, "--first", "2", "--second", "3", "--tolerance", "1e-3"})
            .status == 1);
}

TEST_CASE("the teapot is a model with its 32 patches") {
  const ProgramRun run = run_program({"batch", teapot});
  INFO(run.err);
  const Json header = Json::parse(run.out.substr(0, run.out.find('\n')));
  CHECK(header["model"]["patches"] == 32);
  CHECK(header["lines"].get<int>() + header["model"]["apart"].get<int>() == 32 * 31 / 2);
  CHECK(run.out.find("\"by\":\"doubles\"") != std::string::npos);
  CHECK(run.out.find("\"by\":\"exact\"") == std::string::npos);
}

}  // namespace
}  // namespace exsect::rational_patches_test

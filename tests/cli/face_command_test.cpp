// exsect intersect and exsect ray with faces: surfaces given by their equations in a box.
#include <exsect/geometry/text_file.h>

#include "check_refused.h"
#include "geometry/scratch_directory.h"
#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::face_command_test {
namespace {

using Json = nlohmann::json;

const std::string faces = example("faces.json");

}  // namespace

TEST_CASE("intersect: a quarter of a cylinder, with the bounds at the ends of its arc") {
  const ProgramRun run =
      run_program({"intersect", faces, "--first", "roof", "--second", "fillet", "--json", "-"});
  CHECK(run.status == 0);
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("intersection-1").violation(json) == "");
  CHECK(json["summary"]["open"] == 1);
  REQUIRE(json["nodes"].size() == 2);
  CHECK(json["nodes"][0]["bounds"] == Json::parse(R"(["sector=to", "height=to"])"));
  CHECK(json["nodes"][0]["kinds"] == Json::parse(R"(["boundary", "corner"])"));
  CHECK(json["nodes"][1]["bounds"] == Json::parse(R"(["sector=from"])"));
  const ProgramRun text = run_program({"intersect", faces, "--first", "roof", "--second", "fillet"});
  CHECK(text.out.find("boundary, corner  sector=to height=to") != std::string::npos);
  const ScratchDirectory scratch;
  const std::string table = scratch.path("a.csv");
  CHECK(run_program({"intersect", faces, "--first", "roof", "--second", "fillet", "--quiet", "--csv", table})
            .status == 0);
  CHECK(read_text_file(table, 1 << 20).find("\n0,boundary corner,sector=to height=to,") != std::string::npos);
}

TEST_CASE("intersect: two faces, and what the ends of their curve lie on") {
  const ProgramRun run =
      run_program({"intersect", faces, "--first", "floor", "--second", "lid", "--json", "-"});
  CHECK(run.status == 0);
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("surfaces-1").violation(json) == "");
  CHECK(json["summary"] == "1 circle");  // z = 4/3 and x^2 + y^2 = 2/9, inside of the square
  CHECK(json["curves"][0]["radius_squared"] == "2/9");
  CHECK_FALSE(json["nodes"][0].contains("bounds"));
  const std::vector<std::string> pair = {"intersect", faces, "--first", "fillet", "--second", "lid"};
  const ProgramRun text = run_program(pair);
  CHECK(text.status == 0);
  CHECK(text.out.find("first:sector=from first:height=to second:height=from") != std::string::npos);
  const ScratchDirectory scratch;
  const std::string table = scratch.path("a.csv");
  std::vector<std::string> exported = pair;
  exported.insert(exported.end(), {"--quiet", "--csv", table, "--json", scratch.path("a.json")});
  CHECK(run_program(exported).status == 0);
  CHECK(read_text_file(table, 1 << 20).find(",end,1,first:sector=to first:height=to second:height=from,") !=
        std::string::npos);
  const Json ends = Json::parse(read_text_file(scratch.path("a.json"), 1 << 20));
  CHECK(JsonSchema::named("surfaces-1").violation(ends) == "");
  check_refused({"intersect", faces, "--first", "fillet", "--second", "lid", "--certificate", "a.json"},
                "--certificate");
}

TEST_CASE("ray: what is in the box") {
  const ProgramRun ray =
      run_program({"ray", faces, "--origin=-5,-5,0.5", "--direction", "1,1,0", "--json", "-"});
  CHECK(ray.status == 0);
  int on_fillet = 0;
  const Json json = Json::parse(ray.out);
  for (const Json& hit : json["hits"]) on_fillet += hit["surface"] == "fillet" ? 1 : 0;
  CHECK(on_fillet == 1);
}

}  // namespace exsect::face_command_test

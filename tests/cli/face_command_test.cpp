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

TEST_CASE("ray: what is in the box, and intersect: no two equations of which one has a box") {
  const ProgramRun ray =
      run_program({"ray", faces, "--origin=-5,-5,0.5", "--direction", "1,1,0", "--json", "-"});
  CHECK(ray.status == 0);
  int on_fillet = 0;
  const Json json = Json::parse(ray.out);
  for (const Json& hit : json["hits"]) on_fillet += hit["surface"] == "fillet" ? 1 : 0;
  CHECK(on_fillet == 1);
  check_refused({"intersect", faces, "--first", "fillet", "--second", "lid"}, "a box");
}

}  // namespace exsect::face_command_test

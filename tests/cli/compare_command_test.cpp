#include <nlohmann/json.hpp>

#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::compare_command_test {
namespace {

using Json = nlohmann::json;

TEST_CASE("compare: the methods agree on the first example") {
  const ProgramRun run = run_program(
      {"compare", example("chapter9-first.json"), "--lines", "8", "--pieces", "0", "--json", "-"});
  REQUIRE(run.status == 0);
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("comparison-1").violation(json) == "");
  REQUIRE(json["methods"].size() == 3);
  const Json& lines = json["methods"][0];
  const Json& resultant = json["methods"][1];
  for (const Json& method : {lines, resultant}) {
    CHECK(method["found"] == Json{{"number", 2}, {"open", 1}, {"closed", 1}});
    CHECK(method["points"]["certified"] == method["points"]["exact"]);
    CHECK(method["points"]["missed"] == 0);
    CHECK(method["points"]["phantoms"] == method["points"]["phantoms_removed"]);
  }
  CHECK(resultant["detail"] == "curve in (u,r)");
  CHECK(resultant["phantoms"] == Json{{"met", 3}, {"removed", 3}});
  const Json& quartics = json["methods"][2];
  CHECK(quartics["detail"] == "conics, 1 piece");
  CHECK(quartics["points"]["certified"] == 0);
  CHECK(quartics["points"]["missed"] > 0);
}

TEST_CASE("compare: table and picture, the resultant in (v,s)") {
  const ScratchDirectory scratch;
  const std::string svg = scratch.path("compare.svg");
  const ProgramRun run = run_program({"compare", example("chapter9-second.json"), "--lines", "4", "--pieces",
                                      "1", "--fit", "dokken", "--plane", "v,s", "--svg", svg});
  CHECK(run.status == 0);
  CHECK(run.out.find("3 (3/0)") != std::string::npos);
  CHECK(run.out.find("dokken, 4 pieces") != std::string::npos);
  CHECK(content(svg).find("resultant (curve in (v,s)): 3 components") != std::string::npos);
}

TEST_CASE("compare: bad options") {
  const std::string file = example("chapter9-first.json");
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--lines", "0"},
                                                  {"--lines", "1/2"},
                                                  {"--plane", "u,v"},
                                                  {"--pieces", "4"},
                                                  {"--fit", "quadrics"}}) {
    std::vector<std::string> arguments = {"compare", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = run_program(arguments);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err.starts_with("exsect: " + options[0]));
  }
}

}  // namespace
}  // namespace exsect::compare_command_test

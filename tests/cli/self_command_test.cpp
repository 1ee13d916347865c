// exsect self, end to end.

#include "check_refused.h"
#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::self_command_test {
namespace {

using Json = nlohmann::json;

const std::string second = example("chapter9-second.json");

Json self(const std::vector<std::string>& arguments, int status = 0) {
  std::vector<std::string> all = {"self"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--json", "-"});
  const ProgramRun run = run_program(all);
  INFO(run.err);
  CHECK(run.status == status);
  CHECK(run.err.empty());
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("self-1").violation(json) == "");
  CHECK(json["exsect"] == "self/1");
  CHECK(json["status"] == (status == 0 ? "complete" : "incomplete"));
  return json;
}

TEST_CASE("self: the second example's patches") {
  const Json x = self({second, "--patch", "x"});
  CHECK(x["patch"] == "x");
  CHECK(x["summary"] ==
        Json::parse(R"({"components": 1, "closed": 0, "open": 1, "branched": 0, "isolated": 0, "overlaps": 0,
      "turning": {"u1": 0, "v1": 0, "u2": 0, "v2": 0}, "boundary": 1})"));
  const Json y = self({second, "--patch", "y", "--turning", "none"});
  CHECK(y["summary"]["open"] == 3);
  int cusps = 0;
  for (const Json& node : y["nodes"]) {
    if (node["kinds"] != Json({"cusp"})) continue;
    ++cusps;
    CHECK(node["box"]["u1"] == node["box"]["u2"]);
    CHECK(node["box"]["v1"] == node["box"]["v2"]);
  }
  CHECK(cusps == 2);
}

TEST_CASE("self: files, summary and picture") {
  const ScratchDirectory scratch;
  const std::string svg = scratch.path("self.svg");
  const std::string json = scratch.path("self.json");
  const ProgramRun run = run_program({"self", second, "--patch", "y", "--svg", svg, "--json", json});
  CHECK(run.status == 0);
  CHECK(run.out.find("y with itself: complete, proved: 3 components (3 open)") != std::string::npos);
  CHECK(run.out.find("v1=1") != std::string::npos);
  CHECK(content(svg).find("y(u2, v2)") != std::string::npos);
  CHECK(content(svg).find(">cusp</text>") != std::string::npos);
  CHECK(Json::parse(content(json))["patch"] == "y");
  CHECK(run_program({"self", second, "--patch", "y", "--quiet"}).out.empty());
}

TEST_CASE("self: a work cap gives an incomplete answer") {
  const Json json = self({second, "--patch", "y", "--max-seconds", "1e-9"}, 3);
  CHECK(json["incomplete"][0]["why"].get<std::string>().find("work cap") != std::string::npos);
}

TEST_CASE("self: bad usage is refused") {
  check_refused({"self"}, "FILE is required");
  check_refused({"self", second}, "holds 2 patches (\"x\", \"y\"): choose with --patch");
  check_refused({"self", second, "--patch", "z"}, "--patch: no patch is named \"z\"; there are \"x\", \"y\"");
  check_refused({"self", second, "--patch", "x", "--turning", "u"},
                "--turning: \"u\" is not a list of u1, v1, u2, v2, each at most once");
  check_refused({"self", second, "--patch", "x", "--tolerance", "0"}, "--tolerance");
}

}  // namespace
}  // namespace exsect::self_command_test

// exsect ray, end to end.
#include <exsect/geometry/number.h>

#include <cmath>

#include "check_refused.h"
#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::ray_command_test {
namespace {

using Json = nlohmann::json;

const std::string surfaces = example("surfaces.json");

Json ray(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"ray"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--json", "-"});
  const ProgramRun run = run_program(all);
  INFO(run.err);
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("ray-1").violation(json) == "");
  return json;
}

}  // namespace

TEST_CASE("ray: hits on all surfaces of a file in their order along it, equal ones in one place") {
  const Json json = ray({surfaces, "--origin=-5,0,0", "--direction", "1,0,0"});
  CHECK(json["status"] == "complete");
  // By hand: the torus at x = -4, -2, 2, 4; the quartic at -3, 3; the cylinder at ∓sqrt(3/2); the ball at 1 ∓
  // sqrt 2; the cone, of slope 1/2 and apex 3 above, at ∓3/2; the saddle along the axis x.
  std::vector<std::string> order;
  for (const Json& hit : json["hits"]) order.push_back(hit["surface"]);
  CHECK(order == std::vector<std::string>{"torus", "quartic", "torus", "cone", "oblique", "ball", "oblique",
                                          "cone", "torus", "ball", "quartic", "torus"});
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Json& hit = json["hits"][i];
    CHECK(hit["place"] == i + 1);
    CHECK(hit["multiplicity"] == 1);
    CHECK(hit["contact"] == "transversal");
    CHECK(std::abs(hit["point"][0].get<double>() - (hit["t"]["approx"].get<double>() - 5)) < 1e-14);
  }
  CHECK(json["hits"][0]["t"]["box"] == Json::parse(R"(["1", "1"])"));
  const Rational lower = parse_number(json["hits"][4]["t"]["box"][0].get<std::string>());
  const Rational upper = parse_number(json["hits"][4]["t"]["box"][1].get<std::string>());
  CHECK((lower - 5) * (lower - 5) > Rational(3, 2));
  CHECK((upper - 5) * (upper - 5) < Rational(3, 2));
  REQUIRE(json["overlaps"].size() == 1);
  CHECK(json["overlaps"][0]["surface"] == "saddle");
  CHECK(json["overlaps"][0]["from"]["box"][0] == "1");
  CHECK(json["overlaps"][0]["to"]["box"][0] == "9");
}

TEST_CASE("ray: one surface, tangents, parameters of patches, the summary") {
  const Json top = ray({surfaces, "--surface", "torus", "--origin=-5,0,1", "--direction", "2,0,0"});
  REQUIRE(top["hits"].size() == 2);
  for (const Json& hit : top["hits"]) {
    CHECK(hit["multiplicity"] == 2);
    CHECK(hit["contact"] == "tangential");
    CHECK_FALSE(hit.contains("parameters"));
  }
  const Json patch = ray({surfaces, "--surface", "saddle", "--origin", "1,2,-9", "--direction", "0,0,1"});
  REQUIRE(patch["hits"].size() == 1);
  CHECK(patch["hits"][0]["parameters"] == Json::parse(R"({"u": ["5/8", "5/8"], "v": ["3/4", "3/4"]})"));
  CHECK(patch["hits"][0]["t"]["box"][0] == "73/8");
  const ProgramRun summary = run_program({"ray", surfaces, "--origin", "0,0,-5", "--direction", "0,0,1"});
  CHECK(summary.status == 0);
  CHECK(summary.out.find("ray: complete, proved: ") != std::string::npos);
  CHECK(summary.out.find("cone") != std::string::npos);
  CHECK(summary.out.find("singular") != std::string::npos);
  CHECK(run_program({"ray", surfaces, "--origin", "0,0,-5", "--direction", "0,0,1", "--quiet"}).out.empty());
  const ProgramRun inside =
      run_program({"ray", surfaces, "--surface", "floor", "--origin", "0,0,-1", "--direction", "1,0,0"});
  CHECK(inside.out.find("on floor for t from 0 on") != std::string::npos);
}

TEST_CASE("ray: bad usage and bad input are refused") {
  check_refused({"ray", surfaces, "--origin", "0,0,0"}, "--direction");
  check_refused({"ray", surfaces, "--origin", "0,0,0", "--direction", "0,0,0"},
                "--direction: the vector is zero");
  check_refused({"ray", surfaces, "--origin", "0,0", "--direction", "0,0,1"}, "--origin: 0,0 is not x,y,z");
  check_refused({"ray", surfaces, "--origin", "0,0,0,0", "--direction", "0,0,1"}, "more than three");
  check_refused({"ray", surfaces, "--origin", "0,nan,0", "--direction", "0,0,1"}, "--origin");
  check_refused({"ray", surfaces, "--origin", "0,0,0", "--direction", "0,0,1", "--surface", "x"},
                "none is named \"x\"");
  check_refused({"ray", "nowhere.json", "--origin", "0,0,0", "--direction", "0,0,1"}, "nowhere.json");
  check_refused({"batch", surfaces, "--quiet"}, "");
}

}  // namespace exsect::ray_command_test

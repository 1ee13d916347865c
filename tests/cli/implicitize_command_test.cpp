// exsect implicitize, end to end.
#include <exsect/geometry/number.h>

#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::implicitize_command_test {
namespace {

using Json = nlohmann::json;

const std::string profile = example("profile.json");
const std::string circle = example("rational-circle.json");

Json implicitize(std::vector<std::string> arguments, int status = 0) {
  arguments.insert(arguments.begin(), "implicitize");
  arguments.insert(arguments.end(), {"--json", "-"});
  const ProgramRun run = run_program(arguments);
  INFO(run.err);
  CHECK(run.status == status);
  CHECK(run.err.empty());
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("implicit-1").violation(json) == "");
  return json;
}

/// The value of the proved statement of that name, -1 if there is none.
Rational proved(const Json& json, const std::string& name) {
  for (const Json& statement : json["proved"])
    if (statement["name"] == name)
      return statement.contains("value") ? parse_number(statement["value"].get<std::string>()) : Rational(0);
  return -1;
}

std::string refusal(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "implicitize");
  const ProgramRun run = run_program(arguments);
  CHECK(run.status == 2);
  CHECK(run.out.empty());
  return run.err;
}

TEST_CASE("the exact equation of the profile") {
  const Json json = implicitize({profile, "--variables", "r,z"});
  CHECK(json["exact"] == true);
  CHECK(json["kind"] == "planar-curve");
  CHECK(json["variables"] == Json({"r", "z"}));
  REQUIRE(json["equations"].size() == 1);
  CHECK(json["equations"][0]["degree"] == 3);
  CHECK(json["equations"][0]["terms"][0] == Json::parse(R"(["8000", [3, 0]])"));
  CHECK(json["equations"][0]["terms"].size() == 10);
  CHECK(json["parametrisation"] == Json::parse(R"({"power": 1, "exact_degree": 3})"));
  CHECK(proved(json, "one-sided") == 0);
  CHECK(proved(json, "exact") == 0);
  CHECK(json["not_proved"].empty());
  CHECK(implicitize({circle})["equations"][0]["text"] == "x^2+y^2-1");
}

TEST_CASE("approximate equations by every method are certified") {
  for (const char* method : {"least-squares", "bernstein", "legendre", "chebyshev", "lagrange"}) {
    for (const bool exact_arithmetic : {false, true}) {
      std::vector<std::string> arguments = {profile, "--method", method, "--degree", "2"};
      if (exact_arithmetic) arguments.push_back("--exact-arithmetic");
      INFO(method);
      const Json json = implicitize(arguments);
      CHECK(json["method"] == method);
      CHECK(json["exact"] == false);
      CHECK(json["equations"][0]["degree"] == 2);
      CHECK(proved(json, "residual") > 0);
      CHECK(proved(json, "one-sided") > 0);
      CHECK(proved(json, "one-sided") < Rational(1, 9));
      CHECK(proved(json, "two-sided") >= proved(json, "one-sided") / 2);
    }
  }
}

TEST_CASE("the fit of the profile has the distances of the independent computation") {
  const Json json =
      implicitize({profile, "--degree", "3", "--exact-arithmetic", "--variables", "r,z", "--box", "0,2,0,2"});
  CHECK(json["equations"][0]["terms"][0] == Json::parse(R"(["-511887/1000000", [3, 0]])"));
  CHECK(json["digits"] == 6);
  CHECK(json["unique"] == true);
  CHECK(proved(json, "one-sided") <= parse_number("0.0085112"));
  CHECK(proved(json, "two-sided") <= parse_number("0.00976"));
  CHECK(proved(json, "no-singular-point") == 0);
}

TEST_CASE("other spaces") {
  const Json spline = implicitize({profile, "--degree", "2", "--space", "b-spline", "--cells", "6"});
  CHECK(spline["equations"].empty());
  CHECK(spline["cells"].size() > 6);
  CHECK(proved(spline, "one-sided") > 0);
  const Json tensor =
      implicitize({profile, "--degree", "2", "--space", "bernstein", "--method", "bernstein"});
  CHECK(tensor["space"]["dimension"] == 9);
  CHECK(tensor["equations"][0]["degrees"] == Json({2, 2}));
  // The rank shows that degree 3 is exact.
  const Json exact = implicitize({profile, "--degree", "3", "--method", "lagrange"});
  CHECK(exact["exact"] == true);
}

TEST_CASE("what is not proved is incomplete") {
  // A line against the semicubical parabola's cusp: the exact equation has no normal there.
  const ScratchDirectory scratch;
  const std::string file = scratch.path("cusp.json");
  write(file, R"({"exsect": "curve/1", "degree": 3, "points": [[0,0], [0,0], ["1/3",0], [1,1]]})");
  const Json cusp = implicitize({file});
  CHECK(cusp["status"] == "complete");
  REQUIRE(cusp["not_proved"].size() >= 1);
  CHECK(cusp["not_proved"][0]["name"] == "two-sided");
  // A loop against a conic: somewhere on it the gradient is too small.
  write(file, R"({"exsect": "curve/1", "degree": 3, "points": [[0,0], [3,2], [-2,2], [1,0]]})");
  const Json fit = implicitize({file, "--degree", "2"}, 3);
  CHECK(fit["status"] == "incomplete");
  CHECK(proved(fit, "one-sided") == -1);
  CHECK(fit["not_proved"][0]["where"].contains("t"));
}

TEST_CASE("equations of patches") {
  const std::string patches = example("chapter9-first.json");
  const Json exact = implicitize({patches, "--patch", "y"});
  CHECK(exact["kind"] == "patch");
  CHECK(exact["equations"][0]["degree"] == 8);
  CHECK(exact["exact"] == true);
  for (const char* method : {"dokken", "conics"}) {
    const Json fit = implicitize({patches, "--patch", "x", "--method", method});
    CHECK(fit["equations"][0]["degree"] == 4);
    CHECK(proved(fit, "residual") > 0);
    CHECK(fit["singular_value"] > 0);
  }
}

TEST_CASE("surfaces through a curve of space") {
  const std::string cubic = example("space-cubic.json");
  const std::string box = "0,6/5,0,6/5,0,6/5";
  for (const char* method : {"cylinders", "orthogonal", "root-free"}) {
    const Json json = implicitize({cubic, "--method", method, "--box", box});
    CHECK(json["kind"] == "space-curve");
    CHECK(json["method"] == method);
    CHECK(json["exact"] == true);
    CHECK(json["axis"] == "x");
    CHECK(json["regular"] == true);
    CHECK(json["equations"].size() == 2);
    CHECK(proved(json, "cosine") >= proved(json, "cosine-attained"));
    CHECK(proved(json, "tube") == 0);
    for (const Json& branch : json["further_branches"]) CHECK(branch["box"].contains("z"));
  }
  CHECK(proved(implicitize({cubic, "--method", "root-free"}), "cosine") == 0);
  const Json fit = implicitize({cubic, "--degree", "2", "--axis", "z"});
  CHECK(fit["exact"] == false);
  CHECK(fit["axis"] == "z");
  CHECK(proved(fit, "f-one-sided") > 0);
  CHECK(proved(fit, "g-one-sided") > 0);
  const ScratchDirectory scratch;
  const ProgramRun run = run_program({"implicitize", cubic, "--svg", scratch.path("s.svg")});
  CHECK(run.status == 0);
  CHECK(run.out.find("over the (x,y) and the (x,z) plane") != std::string::npos);
  CHECK(content(scratch.path("s.svg")).find(">both projections</text>") != std::string::npos);
  CHECK(refusal({cubic, "--method", "legendre"}).find("not one of cylinders, orthogonal, root-free") !=
        std::string::npos);
  CHECK(refusal({cubic, "--epsilon", "1"}).find("--epsilon: only for") != std::string::npos);
  CHECK(refusal({cubic, "--method", "orthogonal", "--epsilon", "0"}).find("--epsilon") != std::string::npos);
  CHECK(refusal({cubic, "--axis", "w"}).find("--axis") != std::string::npos);
  CHECK(refusal({cubic, "--box", "0,1,0,1"}).find("--box: needs 6 numbers") != std::string::npos);
}

TEST_CASE("pictures and summaries") {
  const ScratchDirectory scratch;
  const ProgramRun run = run_program({"implicitize", profile, "--degree", "2", "--svg", scratch.path("p.svg"),
                                      "--json", scratch.path("p.json"), "--variables", "r,z"});
  CHECK(run.status == 0);
  CHECK(run.out.find("least-squares, 6 functions (monomial, degree 2)") != std::string::npos);
  CHECK(run.out.find("proved      one-sided 6.") != std::string::npos);
  const std::string svg = content(scratch.path("p.svg"));
  CHECK(svg.find(">least-squares of degree 2: one-sided distance at most 6.") != std::string::npos);
  CHECK(svg.find(">zero set</text>") != std::string::npos);
  CHECK(Json::parse(content(scratch.path("p.json")))["exsect"] == "implicit/1");
}

TEST_CASE("a fit of a degree at which there is an exact equation says so") {
  const std::string told =
      "this is a fit; the curve has an exact equation of degree 3, found without --degree";
  CHECK(run_program({"implicitize", profile, "--degree", "3"}).out.find(told) != std::string::npos);
  CHECK(run_program({"implicitize", profile, "--degree", "2"}).out.find("this is a fit") ==
        std::string::npos);
  CHECK(run_program({"implicitize", profile}).out.find("exact equation of degree 3;") != std::string::npos);
}

TEST_CASE("bad input is refused with the reason") {
  CHECK(refusal({profile, "--method", "magic"}).find("--method: \"magic\" is not one of exact, ") !=
        std::string::npos);
  CHECK(refusal({profile, "--method", "legendre"}).find("--degree: needed") != std::string::npos);
  CHECK(refusal({profile, "--degree", "0"}).find("not an integer from 1 to 12") != std::string::npos);
  CHECK(refusal({profile, "--degree", "2", "--w1", "0"}).find("--w1: 0 is not > 0") != std::string::npos);
  CHECK(refusal({profile, "--degree", "2", "--w2", "-1"}).find("--w2") != std::string::npos);
  CHECK(refusal({profile, "--degree", "2", "--space", "hermite"}).find("--space") != std::string::npos);
  CHECK(refusal({profile, "--degree", "2", "--cells", "4"}).find("--cells: only for") != std::string::npos);
  CHECK(refusal({profile, "--samples", "4"}).find("not an option of the method exact") != std::string::npos);
  CHECK(refusal({profile, "--degree", "2", "--box", "0,1,1,0"}).find("--box: every lower end") !=
        std::string::npos);
  CHECK(refusal({profile, "--degree", "2", "--box", "0,1"}).find("--box: needs 4 numbers") !=
        std::string::npos);
  CHECK(refusal({profile, "--variables", "x,x"}).find("--variables") != std::string::npos);
  CHECK(refusal({profile, "--patch", "x"}).find("--patch: only for patch files") != std::string::npos);
  CHECK(refusal({example("chapter9-first.json")}).find("$.patches") != std::string::npos);
  const ScratchDirectory scratch;
  const std::string file = scratch.path("in.json");
  const auto curve = [&](const std::string& members) {
    write(file, R"({"exsect": "curve/1", )" + members + "}");
    return refusal({file});
  };
  CHECK(curve(R"("degree": 0, "points": [[0,0]])").find("$.degree") != std::string::npos);
  CHECK(curve(R"("degree": 1, "points": [[1,1],[1,1]])").find("all points are equal") != std::string::npos);
  CHECK(curve(R"("degree": 1, "points": [[0,0],[1,1]], "weights": [1,0])").find("$.weights[1]") !=
        std::string::npos);
  write(file, R"({"exsect": "line/1"})");
  CHECK(refusal({file}).find(
            "$.exsect: holds a result of exsect line, line/1; needed is curve/1 or patches/1") !=
        std::string::npos);
}

}  // namespace
}  // namespace exsect::implicitize_command_test

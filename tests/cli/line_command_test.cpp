// exsect line, end to end.
#include <exsect/geometry/number.h>

#include <cmath>

#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::line_command_test {
namespace {

using Json = nlohmann::json;

const std::string first = example("chapter9-first.json");

Json line(const std::string& file, const std::string& option, const std::string& value, int status = 0) {
  const ProgramRun run = run_program({"line", file, option, value, "--json", "-"});
  INFO(run.err);
  CHECK(run.status == status);
  CHECK(run.err.empty());
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("line-1").violation(json) == "");
  return json;
}

TEST_CASE("the lines of the first example have the points of the independent computation") {
  const Json reference = Json::parse(content(std::string(EXSECT_CASES) + "/chapter9-first.expected.json"));
  for (const Json& expected : reference["parameter_lines"]) {
    const Json json = line(first, "--u", expected["u0"]);
    INFO(expected["u0"]);
    CHECK(json["fixed"]["u"] == expected["u0"]);
    CHECK(json["shape"] == "conic");
    CHECK(json["pullback"] ==
          Json::parse(R"({"plane": {"bidegree": [2,2]}, "cylinder": {"bidegree": [4,4]}})"));
    CHECK(json["eliminant"]["degree"] == 16);
    CHECK(json["eliminant"]["variable"] == "s");
    CHECK(json["eliminant"]["coefficients"].size() == 17);
    REQUIRE(json["points"].size() == expected["vrs"].size());
    for (std::size_t i = 0; i < expected["vrs"].size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const char* p = std::array{"v", "r", "s"}[k];
        const std::string text = expected["vrs"][i][k].get<std::string>();
        CHECK(std::abs(json["points"][i]["approx"][p].get<double>() - std::stod(text)) < 2e-15);
        // The box is where the reference is, up to the reference's last digit.
        const Rational lower = parse_number(json["points"][i]["box"][p][0].get<std::string>());
        CHECK(abs(lower - parse_number(text)) < parse_number("1e-14"));
      }
      CHECK(json["points"][i]["multiplicity"] == 1);
      CHECK_FALSE(json["points"][i]["box"].contains("u"));
    }
  }
}

TEST_CASE("the plane and the cylinder vanish on the line") {
  // x(1/2, v) of the first example at v = 1/2: the sum of the control points with weights 1 2 1, 2 4 2, 1 2 1
  // over 16.
  const Json json = line(first, "--u", "1/2");
  const Json file = Json::parse(content(first));
  std::array<Rational, 3> p = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int weight = (i == 1 ? 2 : 1) * (j == 1 ? 2 : 1);
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] +=
            Rational(weight) / 16 * parse_number(file["patches"][0]["points"][i][j][c].get<std::string>());
      }
    }
  }
  Rational plane = parse_number(json["plane"]["constant"].get<std::string>());
  for (std::size_t c = 0; c < 3; ++c)
    plane += p[c] * parse_number(json["plane"]["normal"][c].get<std::string>());
  CHECK(plane == 0);
  Rational cylinder = 0;
  for (const Json& term : json["cylinder"]["terms"]) {
    Rational value = parse_number(term[0].get<std::string>());
    for (std::size_t c = 0; c < 3; ++c) {
      for (int k = 0; k < term[1][c].get<int>(); ++k) value *= p[c];
    }
    cylinder += value;
  }
  CHECK(cylinder == 0);
  CHECK(json["cylinder"]["terms"].size() == 10);
}

TEST_CASE("every way to write a number gives the same bytes") {
  const std::string half = run_program({"line", first, "--u", "1/2", "--json", "-"}).out;
  for (const char* text : {"0.5", "0x1p-1", "5e-1", "+2/4"}) {
    CHECK(run_program({"line", first, "--u", text, "--json", "-"}).out == half);
  }
}

TEST_CASE("lines of all four parameters") {
  for (const char* p : {"u", "v", "r", "s"}) {
    const Json json = line(first, std::string("--") + p, "7/10");
    CHECK(json["fixed"] == Json{{p, "7/10"}});
    CHECK(json["status"] == "complete");
    CHECK(json["eliminant"]["variable"] == (std::string("uv").find(p) != std::string::npos ? "s" : "v"));
    for (const Json& point : json["points"]) CHECK(point["approx"][p] == 0.7);
  }
}

TEST_CASE("straight, folded and collapsed lines and lines on the patch") {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("in.json");
  const auto pair = [&](const std::string& x) {
    const std::string y =
        R"({"name": "y", "degree": [1,1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]})";
    write(file, R"({"exsect": "patches/1", "patches": [{"name": "x", )" + x + "}, " + y + "]}");
  };
  pair(R"("degree": [1,1], "points": [[["1/2","1/2",-1],["1/2","1/2",1]],[[1,1,-1],[1,0,1]]])");
  const Json straight = line(file, "--u", "0");
  CHECK(straight["shape"] == "straight");
  CHECK(straight["cylinder"].is_null());
  CHECK(straight.contains("second_plane"));
  REQUIRE(straight["points"].size() == 1);
  CHECK(straight["points"][0]["approx"]["v"] == 0.5);
  pair(
      R"("degree": [1,2], "points": [[["1/2","1/2",-1],["1/2","1/2",1],["1/2","1/2",-1]],[[1,1,-1],[1,0,1],[1,0,2]]])");
  CHECK(line(file, "--u", "0")["shape"] == "folded");
  pair(R"("degree": [1,1], "points": [[["1/2","1/2",0],["1/2","1/2",0]],[[1,1,-1],[1,0,1]]])");
  const Json point = line(file, "--u", "0");
  CHECK(point["shape"] == "point");
  CHECK(point["plane"].is_null());
  pair(R"("degree": [1,1], "points": [[["1/2",0,0],["1/2","2",0]],[[1,1,-1],[1,0,1]]])");
  const Json on = line(file, "--u", "0");
  CHECK(on["points"].empty());
  REQUIRE(on["on_patch"].size() == 1);
  CHECK(on["on_patch"][0]["from"]["box"] == Json({"0", "0"}));
  CHECK(on["on_patch"][0]["to"]["box"] == Json({"1/2", "1/2"}));
  const ProgramRun text = run_program({"line", file, "--u", "0"});
  CHECK(text.out.find("on the other patch for v in [0, 0.5]") != std::string::npos);
}

TEST_CASE("the summary shows points with six proved decimals, or with fifteen") {
  const ProgramRun run = run_program({"line", first, "--u", "1/2"});
  CHECK(run.status == 0);
  CHECK(run.out.find("u = 1/2: complete, proved: 2 points\n") != std::string::npos);
  CHECK(run.out.find("eliminant  degree 16 in s\n") != std::string::npos);
  CHECK(run.out.find("0.122378  0.507744  0.144959") != std::string::npos);
  CHECK(run_program({"line", first, "--u", "1/2", "--verbose"})
            .out.find("0.122377867125713  0.507744326746548  0.144958858226505") != std::string::npos);
  CHECK(run_program({"line", first, "--u", "1/2", "--quiet"}).out.empty());
}

TEST_CASE("pictures of lines are written") {
  const ScratchDirectory scratch;
  CHECK(run_program({"line", first, "--s", "0.3", "--svg", scratch.path("l.svg"), "--quiet"}).status == 0);
  CHECK(content(scratch.path("l.svg")).find("s = 3/10: ") != std::string::npos);
}

}  // namespace
}  // namespace exsect::line_command_test

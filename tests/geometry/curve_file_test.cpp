#include <exsect/geometry/curve_file.h>

#include "curve_specimens.h"
#include "support/catch.h"

namespace exsect::curve_file_test {

namespace {

std::string file_with(const std::string& members) { return R"({"exsect": "curve/1", )" + members + "}"; }

/// "path: reason" of the refusal.
std::string refusal(const std::string& members) {
  try {
    parse_curve(file_with(members), "f.json");
  } catch (const InputError& error) {
    return error.where() + ": " + error.reason();
  }
  FAIL("accepted: " << members);
  return "";
}

}  // namespace

TEST_CASE("the examples of curves are read", "[curve_file]") {
  const std::string examples = EXSECT_EXAMPLES;
  CHECK(read_curve(examples + "/profile.json").curve == profile_cubic());
  CHECK(read_curve(examples + "/rational-circle.json").curve == quarter_circle());
  CHECK(read_curve(examples + "/space-cubic.json").curve == space_cubic());
  CHECK(read_curve(examples + "/profile.json").title == "Profile of a surface of revolution (r,z)");
}

TEST_CASE("numbers of curves mean what patch files say", "[curve_file]") {
  const std::string points = R"("degree": 1, "points": [[0.1, "1/3"], ["0x1p-1", 2]])";
  CHECK(parse_curve(file_with(points), "f").curve ==
        BezierCurve({{Rational(1, 10), Rational(1, 3)}, {Rational(1, 2), 2}}));
  CHECK(parse_curve(file_with(points + R"(, "numbers": "binary64")"), "f").curve.points()[0][0] ==
        from_double(0.1));
}

TEST_CASE("bad curve files are refused with place and reason", "[curve_file]") {
  const std::string points = R"("points": [[0, 0], [1, 1]])";
  CHECK(refusal(R"("degree": 0, "points": [[0, 0]])") ==
        "$.degree: the degree of a curve must be an integer from 1 to 20");
  CHECK(refusal(R"("degree": 1.5, )" + points).find("$.degree: ") == 0);
  CHECK(refusal(R"("degree": 2, )" + points) ==
        "$.points: must be an array of 3 points for this degree, has 2");
  CHECK(refusal(R"("degree": 1, "points": [[0, 0], [1, 1, 1]])") ==
        "$.points[1]: must be an array of 2 coordinates, has 3");
  CHECK(refusal(R"("degree": 1, "points": [[0], [1]])") == "$.points[0]: must have 2 or 3 coordinates");
  CHECK(refusal(R"("degree": 1, "points": [[0, "1/0"], [1, 1]])").find("$.points[0][1]: ") == 0);
  CHECK(refusal(R"("degree": 1, "weights": [1, 0], )" + points) == "$.weights[1]: a weight must be > 0");
  CHECK(refusal(R"("degree": 1, "weights": [1, -1], )" + points) == "$.weights[1]: a weight must be > 0");
  CHECK(refusal(R"("degree": 1, "weights": [1], )" + points).find("$.weights: ") == 0);
  CHECK(refusal(R"("degree": 1, "name": "c", )" + points) == "$: unknown key \"name\"");
  CHECK(refusal(R"("degree": 1)") == "$: key \"points\" is missing");
  CHECK_THROWS_AS(parse_curve(R"({"exsect": "patches/1"})", "f"), InputError);
  CHECK_THROWS_AS(read_curve("/no/such/file"), InputError);
}

TEST_CASE("curve files survive the round trip", "[curve_file]") {
  const auto seed = 53u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const CurveFile file = {round % 2 == 0 ? "" : "A \"curve\"", round % 3 == 0 ? "s" : "",
                            random_curve(random, 1 + round % 5, 2 + round % 2, round % 2 == 0)};
    CHECK(parse_curve(format_curve(file), "f") == file);
  }
  const std::string text = format_curve({"t", "", profile_cubic()});
  for (std::size_t n = 0; n < text.find_last_of('}'); ++n)
    CHECK_THROWS_AS(parse_curve(text.substr(0, n), "f"), InputError);
}

TEST_CASE("the version of a file is found", "[curve_file]") {
  CHECK(file_version(R"({"title": "t", "exsect": "curve/1"})", "f") == "curve/1");
  CHECK(file_version(R"({"exsect": 1})", "f").empty());
  CHECK(file_version("[1]", "f").empty());
  CHECK_THROWS_AS(file_version("{", "f"), InputError);
}

}  // namespace exsect::curve_file_test

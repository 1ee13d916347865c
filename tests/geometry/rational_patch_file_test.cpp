#include <exsect/geometry/bounding_box.h>
#include <exsect/geometry/rational_patch_file.h>

#include "random_shapes.h"
#include "scratch_directory.h"
#include "support/catch.h"

namespace exsect::rational_patch_file_test {
using Catch::Matchers::Contains;

namespace {

using Weights = std::vector<std::vector<Rational>>;

std::string file_with(const std::string& patch) {
  return R"({"exsect": "patches/1", "patches": [)" + patch + "]}";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A quarter of the cylinder x^2 + y^2 = 1 over 0 <= z <= 1.
const std::string quarter =
    R"({"name": "q", "degree": [2, 1], "points": [[[1,0,0],[1,0,1]], [[1,1,0],[1,1,1]],
    [[0,1,0],[0,1,1]]], "weights": [[1, 1], ["1", 1.0], [2, "2/1"]]})";

InputError refusal(const std::string& patch) {
  try {
    parse_rational_patches(file_with(patch), "f.json");
  } catch (const InputError& error) {
    return error;
  }
  FAIL("accepted: " << patch);
  throw std::logic_error("unreachable");
}

RationalPatch random_rational_patch(Random& random, int m, int n, bool weighted) {
  std::vector<std::vector<Point>> points;
  Weights weights;
  for (int i = 0; i <= m; ++i) {
    points.emplace_back();
    weights.emplace_back();
    for (int j = 0; j <= n; ++j) {
      points.back().push_back(random_point(random));
      weights.back().push_back(Rational(1, 9) + abs(random_rational(random)));
    }
  }
  return RationalPatch(points, weighted ? weights : Weights{});
}

}  // namespace

TEST_CASE("weights belong to Cartesian points", "[rational_patch_file]") {
  const RationalPatch patch = parse_rational_patches(file_with(quarter), "f").patches.at(0).patch;
  CHECK((patch.degree_u() == 2 && patch.degree_v() == 1));
  CHECK(patch.homogeneous(2, 1) == HomogeneousPoint{0, 2, 2, 2});
  for (const Rational& u : {Rational(0), Rational(1, 3), Rational(1, 2), Rational(1)}) {
    const Point p = patch(u, Rational(1, 4));
    CHECK(p[0] * p[0] + p[1] * p[1] == 1);
    CHECK(p[2] == Rational(1, 4));
  }
  // (1 - u^2, 2 u) / (1 + u^2)
  CHECK(patch(Rational(1, 2), 0) == Point{Rational(3, 5), Rational(4, 5), 0});
}

TEST_CASE("the weighted example lies on a sphere and on a cylinder", "[rational_patch_file]") {
  const RationalPatchFile file = read_rational_patches(EXSECT_EXAMPLES "/weighted.json");
  REQUIRE(file.patches.size() == 2);
  CHECK(parse_rational_patches(format_patches(file), "f") == file);
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const Rational u(i, 8), v(j, 8);
      const Point p = file.patches[0].patch(u, v), q = file.patches[1].patch(u, v);
      CHECK(dot(p, p) == 1);
      const Point from_axis = {0, q[1] - Rational(1, 8), q[2] - Rational(1, 8)};
      CHECK(dot(from_axis, from_axis) == Rational(25, 64));
      CHECK(q[0] == v);
    }
  }
}

TEST_CASE("every shape is written and read again", "[rational_patch_file]") {
  const ScratchDirectory directory;
  const auto seed = 31u;
  INFO("seed " << seed);
  Random random(seed);
  RationalPatchFile file{"t", "s", {}};
  for (int m = 1; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n)
      for (const bool weighted : {false, true})
        file.patches.push_back(
            {"p" + std::to_string(file.patches.size()), random_rational_patch(random, m, n, weighted)});
  // A weight of zero in the middle, and equal weights that are not 1.
  file.patches.push_back(
      {"zero", RationalPatch({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {2, 1, 3}}},
                             {{1, 2}, {0, 3}, {1, 4}})});
  file.patches.push_back(
      {"equal", RationalPatch({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}}, {{3, 3}, {3, 3}})});
  write_patches(file, directory.path("p.json"));
  CHECK(read_rational_patches(directory.path("p.json")) == file);
  file.patches = {{"infinite", RationalPatch::from_homogeneous({{{0, 0, 0, 1}, {0, 0, 1, 1}},
                                                                {{0, 1, 0, 0}, {0, 1, 0, 0}},
                                                                {{0, 0, 0, 1}, {0, 0, 1, 1}}})}};
  CHECK_THROWS_WITH(format_patches(file), Contains("at infinity"));
}

TEST_CASE("bad degrees and weights are refused with their place", "[rational_patch_file]") {
  const std::string half = R"("weights": [[1, 1], ["1", 1.0], [2, "2/1"]])";
  struct Case {
    std::string patch;
    std::string where;
    const char* reason;
  };
  const std::vector<Case> cases = {
      {replaced(quarter, "[2, 1]", "[0, 1]"), ".degree[0]", "degree 0 is not supported: must be 1, 2 or 3"},
      {replaced(quarter, "[2, 1]", "[2, 4]"), ".degree[1]", "degree 4 is not supported"},
      {replaced(quarter, "[2, 1]", "[25, 1]"), ".degree[0]", "degree 25 is not supported"},
      {replaced(quarter, "[2, 1]", "[-1, 1]"), ".degree[0]", "degree -1 is not supported"},
      {replaced(quarter, "[2, 1]", "[\"2\", 1]"), ".degree[0]", "degree must be 1, 2 or 3"},
      {replaced(quarter, "[2, 1]", "[3, 1]"), ".points", "array of 4 rows for this degree, has 3"},
      {replaced(quarter, half, R"("weights": [[1, 1], [1, 1]])"), ".weights",
       "array of 3 rows for this degree, has 2"},
      {replaced(quarter, half, R"("weights": [[1, 1], [1], [1, 1]])"), ".weights[1]",
       "array of 2 weights for this degree, has 1"},
      {replaced(quarter, half, R"("weights": [1, 1, 1])"), ".weights[0]", "must be an array"},
      {replaced(quarter, half, R"("weights": null)"), ".weights", "must be an array"},
      {replaced(quarter, half, R"("weights": [[1, 1], [1, "nan"], [1, 1]])"), ".weights[1][1]",
       "not a number"},
      {replaced(quarter, half, R"("weights": [[1, 1], [1, [1]], [1, 1]])"), ".weights[1][1]",
       "must be a number"},
      {replaced(quarter, half, R"("weights": [[0, 1], [1, 1], [1, 1]])"), ".weights",
       "the denominator vanishes at (u,v) = (0, 0)"},
      {replaced(quarter, half, R"("weights": [[-1, -1], [-1, -1], [-1, -1]])"), ".weights",
       "the denominator is negative at (u,v) = (0, 0)"},
      {replaced(quarter, half, R"("weights": [[1, 1], [-1, 1], [1, 1]])"), ".weights",
       "the denominator vanishes at (u,v) = (1/2, 0)"},
      {replaced(quarter, half, R"("weights": [[1, 1], [-5, 1], [1, 1]])"), ".weights",
       "the denominator vanishes at (u,v) = (0."},
      {R"({"name": "q", "degree": [1, 1], "points": [[[1,0,0],[1,0,0]], [[1,0,0],[1,0,0]]], "weights": [[1,2],[3,4]]})",
       ".points", "all control points coincide"},
  };
  for (const Case& c : cases) {
    INFO(c.patch);
    const InputError error = refusal(c.patch);
    INFO(error.what());
    CHECK(error.file() == "f.json");
    CHECK(error.where() == "$.patches[0]" + c.where);
    CHECK_THAT(error.reason(), Contains(c.reason));
  }
}

TEST_CASE("methods for biquadratic patches get them in any shape, and no others", "[rational_patch_file]") {
  const auto seed = 32u;
  INFO("seed " << seed);
  Random random(seed);
  const BezierPatch x = random_patch(random);
  const auto text = [](const RationalPatch& patch) {
    return format_patches(RationalPatchFile{"", "", {{"x", patch}}});
  };
  const auto read = [&](const RationalPatch& patch) { return parse_patches(text(patch), "f").patches.at(0); };
  CHECK(read(x) == NamedPatch{"x", {2, 2}, x});
  CHECK(read(RationalPatch(x).elevated(3, 3)) == NamedPatch{"x", {2, 2}, x});
  const RationalPatch bilinear = random_rational_patch(random, 1, 1, false);
  CHECK(read(bilinear) == NamedPatch{"x", {1, 1}, *bilinear.biquadratic()});
  CHECK(read(bilinear.elevated(3, 2)) == NamedPatch{"x", {1, 1}, *bilinear.biquadratic()});
  for (const auto& [patch, reason] :
       {std::pair{random_rational_patch(random, 3, 1, false),
                  "patch \"x\": not supported here: bidegree (3,1), only polynomial"},
        {random_rational_patch(random, 2, 2, true), "bidegree (2,2) with weights"}}) {
    CHECK_THROWS_WITH(parse_patches(text(patch), "f.json"), Contains(reason));
    CHECK_THROWS_WITH(parse_patches(text(patch), "f.json"), Contains("f.json: $.patches[0]: "));
  }
}

TEST_CASE("boxes hold weighted patches", "[bounding_box]") {
  const auto seed = 33u;
  INFO("seed " << seed);
  Random random(seed);
  const auto check = [](const RationalPatch& patch) {
    const BoundingBox box = bounding_box(patch);
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 10; ++j) CHECK(box.contains(patch(Rational(i, 10), Rational(j, 10))));
  };
  for (int round = 0; round < 10; ++round)
    check(random_rational_patch(random, 1 + round % 3, 1 + round % 2, true));
  // Weights 1, -1/2, 1: the hull of the control points does not hold the patch; the point of weight 0 is far
  // away.
  const RationalPatch arch({{{0, 0, 0}, {0, 0, 1}}, {{1, 2, 0}, {1, 2, 1}}, {{2, 0, 0}, {2, 0, 1}}},
                           {{1, 1}, {Rational(-1, 2), Rational(-1, 2)}, {1, 1}});
  check(arch);
  CHECK(bounding_box(arch).lower[1] <= -2);
  const RationalPatch far({{{0, 0, 0}, {0, 0, 1}}, {{1000000, 2, 0}, {1, 2, 1}}, {{2, 0, 0}, {2, 0, 1}}},
                          {{1, 1}, {0, 1}, {1, 1}});
  check(far);
  CHECK(bounding_box(far).upper[0] < 10);
}

}  // namespace exsect::rational_patch_file_test

// Candidates with extreme numbers: what cannot be compared proves nothing, and every comparison ends.
#include <exsect/geometry/candidate_file.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/verify.h>

#include <cmath>
#include <ctime>
#include <limits>

#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::verify_numbers_test {
namespace {

using Vertices = std::vector<std::array<double, 3>>;

/// The plane z = 0 and the wall y = 1/2, which meet in the segment from (0,1/2,0) to (1,1/2,0).
struct Model {
  BezierPatch floor = testing::plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  BezierPatch wall = testing::plane({0, Rational(1, 2), -1}, {1, 0, 0}, {0, 0, 2});
};

Candidate one(const SplineCurve& curve) {
  Candidate candidate;
  candidate.curves.push_back({curve, {}, {}, false, {}});
  return candidate;
}
SplineCurve conic(double height, const std::vector<double>& weights) {
  return {2, {0, 0, 0, 1, 1, 1}, {{0, 0.5, 0}, {0.5, 0.5, height}, {1, 0.5, 0}}, weights};
}
Agreement agreement(const Candidate& candidate, double tolerance = 1e-3) {
  VerifyOptions options;
  options.tolerance = tolerance;
  return verify(candidate, Model().floor, Model().wall, options).verdict.agreement;
}

constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double most = std::numeric_limits<double>::max();

}  // namespace

TEST_CASE("a curve that is 25 above the truth disagrees, whatever its weights are") {
  const std::string cases = EXSECT_CASES "/found/wrong-verify-nan";
  const Candidate candidate = read_candidate(cases + ".candidate.json");
  const auto patches = read_patches(cases + ".json").patches;
  VerifyOptions options;
  options.tolerance = 1e-3;
  CHECK(verify(candidate, patches[0].patch, patches[1].patch, options).verdict.agreement ==
        Agreement::disagrees);
  for (const double w : {least, 0x1p-1022, 1e-200, 1.0, 1e200, most}) {
    INFO(w);
    CHECK(agreement(one(conic(50, {w, w, w}))) == Agreement::disagrees);
    CHECK(agreement(one(conic(0, {w, w, w}))) == Agreement::agrees);
  }
}

TEST_CASE("weights that are far apart prove no agreement where there is none") {
  for (const std::vector<double>& weights :
       {std::vector{least, 1.0, most}, {least, most, least}, {most, least, most}, {1.0, 1e-200, 1.0}}) {
    CHECK(agreement(one(conic(50, weights))) != Agreement::agrees);
    CHECK(agreement(one(conic(0, weights))) == Agreement::agrees);
  }
}

TEST_CASE("candidates far away end, and larger ones are refused") {
  for (const double far : {1e3, 1e10, 1e20, 1e100, 1e150}) {
    INFO(far);
    CHECK(agreement(one(polyline({{0, 0.5, 0}, {1, 0.5, far}}))) != Agreement::agrees);
    CHECK(agreement(one(polyline({{-far, -far, -far}, {far, far, far}}))) != Agreement::agrees);
    CHECK(agreement(one(polyline({{0, 0.5, 0}, {far, 0.5, far}, {-far, 0.5, far}, {1, 0.5, 0}}))) !=
          Agreement::agrees);
  }
  for (const double far : {0x1.1p500, 1e200, 1e308, most}) {
    INFO(far);
    CHECK_THROWS_AS(agreement(one(polyline({{-far, 0.5, 0}, {far, 0.5, 0}}))), std::invalid_argument);
    CHECK_THROWS_AS(agreement(one({1, {0, 0, far, far}, {{0, 0.5, 0}, {1, 0.5, 0}}, {}})),
                    std::invalid_argument);
    Candidate points;
    points.points.push_back({std::array{far, 0.0, 0.0}, {}, {}});
    CHECK_THROWS_AS(agreement(points), std::invalid_argument);
  }
  Candidate outside;
  outside.points.push_back({{}, std::array{0.5, std::nan("")}, {}});
  CHECK_THROWS_AS(agreement(outside), std::invalid_argument);
  CHECK_THROWS_AS(parse_candidate("v 0 0 0\nv 1e200 0 0\nl 1 2\n", "far.obj", CandidateFormat::obj),
                  InputError);
}

TEST_CASE("very large and very small models have the verdict of the model at unit size") {
  const Model unit;
  for (const int e : {-250, 250}) {
    INFO(e);
    const auto scaled = [&](const BezierPatch& x) {
      ControlNet net = x.net();
      for (auto& row : net)
        for (Point& p : row)
          for (std::size_t k = 0; k < 3; ++k) p[k] *= power_of_two(e);
      return BezierPatch(net);
    };
    const auto line = [&](double height) {
      return one(polyline({{0, std::ldexp(0.5, e), 0},
                           {std::ldexp(0.5, e), std::ldexp(0.5, e), std::ldexp(height, e)},
                           {std::ldexp(1, e), std::ldexp(0.5, e), 0}}));
    };
    VerifyOptions options;
    options.tolerance = 1e-3;
    const Verification right = verify(line(1e-4), scaled(unit.floor), scaled(unit.wall), options);
    CHECK(right.verdict.agreement == Agreement::agrees);
    CHECK(right.verdict.curves[0].distance.upper >= std::ldexp(1e-4, e));
    CHECK(right.verdict.curves[0].distance.upper < std::ldexp(4e-4, e));
    CHECK(verify(line(1e-2), scaled(unit.floor), scaled(unit.wall), options).verdict.agreement ==
          Agreement::disagrees);
  }
}

TEST_CASE("a comparison ends in time, and says so") {
  Vertices zigzag;
  for (int i = 0; i <= 20000; ++i) zigzag.push_back({i / 20000.0, 0.5, i % 2 == 0 ? 0 : 1e-2});
  VerifyOptions options;
  options.tolerance = 1e-6;
  options.max_seconds = 1e-9;
  const Verification result = verify(one(polyline(zigzag)), Model().floor, Model().wall, options);
  CHECK(result.verdict.agreement != Agreement::agrees);
  CHECK_FALSE(result.verdict.undecided.empty());
  CHECK(result.verdict.curves.size() == 1);
}

TEST_CASE("the time for a polyline grows with its length, not with its square, also in pieces") {
  const IntersectResult exact = intersect(Model().floor, Model().wall);
  const auto seconds = [&](int n, double height, bool in_pieces) {
    Vertices line;
    for (int i = 0; i <= n; ++i) line.push_back({static_cast<double>(i) / n, 0.5, i % 2 == 0 ? 0 : height});
    Candidate candidate = one(polyline(line));
    if (in_pieces) candidate.curves.clear();
    for (std::size_t i = 1; in_pieces && i < line.size(); ++i)
      candidate.curves.push_back({polyline({line[i - 1], line[i]}), {}, {}, false, {}});
    const std::clock_t start = std::clock();
    verify(candidate, Model().floor, Model().wall, exact, 1e-3);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  for (const bool in_pieces : {false, true}) {
    for (const double height : {0.0, 1e-4, 1e-2}) {
      INFO(height << " " << in_pieces);
      CHECK(seconds(24000, height, in_pieces) <
            20 * seconds(3000, height, in_pieces) + 0.05);  // 64: quadratic
    }
  }
}

}  // namespace exsect::verify_numbers_test

// Certificates of spheres, cylinders and cones: parameters of both patches that turn together, and such that
// turn at sides.
#include <exsect/checker/polynomials.h>
#include <exsect/geometry/number.h>

#include "certificate_changes.h"

namespace exsect::certificate_round_test {
namespace {

using namespace certificates;

/// Of a circle: radius times cosine and sine, and the weight, all times the weight; of a profile the distance
/// from the axis and the height.
using Profile = std::vector<std::array<Rational, 3>>;
using Net = std::vector<std::vector<HomogeneousPoint>>;

Profile quarter(const Rational& r) { return {{r, 0, 1}, {r, r, 1}, {0, 2 * r, 2}}; }

/// A quarter of the surface of revolution around the parallel to the axis k through the centre, from the axis
/// after k to the one before it.
Net quarter_turn(const Profile& profile, const Point& centre, std::size_t k) {
  Net result;
  for (const auto& [cosine, sine, weight] : quarter(1)) {
    result.emplace_back();
    for (const auto& [across, along, w] : profile) {
      HomogeneousPoint& point = result.back().emplace_back();
      point[k] = weight * along;
      point[(k + 1) % 3] = cosine * across;
      point[(k + 2) % 3] = sine * across;
      point[3] = weight * w;
      for (std::size_t d = 0; d < 3; ++d) point[d] += point[3] * centre[d];
    }
  }
  return result;
}

/// The sphere's normal is perpendicular to x, the cylinder's axis, where r = 0.
const Net cylinder = quarter_turn({{Rational(3, 2), 0, 1}, {Rational(3, 2), -2, 1}}, {}, 0);
const Net sphere = quarter_turn(quarter(2), {Rational(-122, 75), Rational(-7, 10), Rational(12, 25)}, 1);
/// Both around axes along x: the height of a common point is a function of v, and one of s.
const Net cone = quarter_turn({{Rational(1, 2), 0, 1}, {1, -1, 1}}, {}, 0);
const Net zone = quarter_turn({{Rational(1, 2), 0, 1},
                               {Rational(1, 2), Rational(1, 4), 1},
                               {Rational(3, 8), Rational(1, 2), Rational(5, 4)}},
                              {Rational(-21, 17), Rational(91, 170), Rational(21, 85)}, 0);

std::string text_of(const Net& x, const Net& y) {
  return certificate(RationalPatch::from_homogeneous(x), RationalPatch::from_homogeneous(y));
}

checker::WeightedNet<Rational> powers(const Net& net) {
  const std::size_t m = net.size() - 1, n = net[0].size() - 1;
  checker::WeightedNet<Rational> result = {checker::Net<Rational>(m, n), checker::Grid<Rational, 1>(m, n)};
  result.points.each([&](std::size_t i, std::size_t j) {
    result.points[i][j] = {net[i][j][0], net[i][j][1], net[i][j][2]};
    result.weights[i][j] = {net[i][j][3]};
  });
  result.to_powers();
  return result;
}

}  // namespace

TEST_CASE("round patches have certificates where two parameters turn together") {
  const std::string text = text_of(cone, zone);
  const Json json = Json::parse(text);
  CHECK(check_certificate(text).summary.turning == std::array<std::size_t, 4>{0, 1, 0, 1});
  const auto turning = [](const Json& node) { return node["wrt"] == Json({"v", "s"}); };
  const auto place = std::find_if(json["nodes"].begin(), json["nodes"].end(), turning);
  REQUIRE(place != json["nodes"].end());
  const auto n = static_cast<std::size_t>(place - json["nodes"].begin());
  const std::string at = "$.nodes[" + std::to_string(n) + "]: ";
  for (const char* other : {"r", "s"})
    reason(text, (at + (other[0] == 'r' ? "the parameters need not turn together" : "")).c_str(),
           [&](Json& j) {
             j["nodes"][n]["wrt"] = other[0] == 'r' ? Json({"v", "r"}) : Json({"s", "v"});
           });
  // No longer are both surfaces those of revolution around axes along x.
  reason(text, "$.", [](Json& j) { j["second"]["points"][1][1][0] = "-1"; });
}

TEST_CASE("round patches have certificates where parameters turn at a side") {
  const std::string text = text_of(cylinder, sphere);
  CHECK(check_certificate(text).summary.turning == std::array<std::size_t, 4>{});
  Generator generator(62);
  INFO("seed 62");
  reject_changes(text, generator, 20);
  CHECK(rejected_forgeries(text, {"tubes", "nodes", "arcs"}, generator, 20) > 5);
}

TEST_CASE("a plane through a torus has a certificate where parameters turn at a side") {
  // A quarter of the tube around a circle of radius 3, and y = 0, a factor of F; r ends where its normal is
  // in a plane x = const.
  const Net torus = quarter_turn({{1, Rational(6, 5), 1}, {1, Rational(-4, 5), 1}, {6, Rational(-8, 5), 2}},
                                 {Rational(-79, 25), Rational(28, 25), 0}, 2);
  Net plane = {{{4, 0, 2, 1}, {4, 0, -2, 1}}, {{-4, 0, 2, 1}, {-4, 0, -2, 1}}};
  Net turned = torus;
  for (auto& row : turned)
    for (auto& point : row)
      for (const std::size_t d : {0, 1})
        point[d] = 2 * (d == 0 ? Rational(-79, 25) : Rational(28, 25)) * point[3] - point[d];
  const Json json = Json::parse(text_of(plane, turned));
  CHECK(json["factors"].size() == 1);
  CHECK(json["summary"]["open"] == 1);
}

TEST_CASE("which parameters turn on a side follows from the patches with their weights divided out") {
  const auto x = powers(cylinder), y = powers(sphere);
  const std::array weights = {checker::polynomial_in(x.weights, 0), checker::polynomial_in(y.weights, 2)};
  const auto turning = [&](std::size_t parameter, int value) {
    std::string result;
    for (std::size_t i = 0; i < 4; ++i)
      if (turns_on_sides(checker::pair_map(x, y), weights, i, {{{parameter}, value}})) result += "uvrs"[i];
    return result;
  };
  CHECK(turning(2, 0) == "us");
  CHECK(turning(2, 1).empty());
  CHECK(turning(0, 1).empty());
  CHECK(turning(1, 0).empty());
  CHECK(turning(3, 1) == "uvs");  // a pole: F does not depend on r there
}

}  // namespace exsect::certificate_round_test

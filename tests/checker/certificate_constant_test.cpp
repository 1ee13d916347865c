// Certificates of curves along which a parameter of either patch is constant, or of one at a single point.
#include <exsect/geometry/number.h>

#include "certificate_changes.h"

namespace exsect::certificate_constant_test {
namespace {

using namespace certificates;

Rational q(long a, long b) { return Rational(a, b); }

/// The quarter (1 - u^2, 2 u) / (1 + u^2) of a circle, turned by the angle with this cosine and sine, in u,
/// around the line with the distance and the height of a profile, linear in v.
RationalPatch turned(const Rational& cosine, const Rational& sine,
                     const std::vector<std::array<Rational, 2>>& profile) {
  std::vector<std::vector<HomogeneousPoint>> net;
  const std::vector<std::array<Rational, 3>> circle = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
  for (const auto& [x, y, w] : circle) {
    net.emplace_back();
    for (const auto& [across, height] : profile)
      net.back().push_back(
          {across * (cosine * x - sine * y), across * (sine * x + cosine * y), height * w, w});
  }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE("circles around a common axis have certificates, whatever the angles between the patches") {
  Generator generator(81);
  INFO("seed 81");
  for (int i = 0; i < 12; ++i) {
    // The slope of the rotation is t, for which (1 - t^2, 2 t) / (1 + t^2) is on the unit circle.
    const Rational t = q(random_pairs::integer(generator, -8, 8), 20);
    const Rational one = 1 + t * t;
    const Rational place = q(random_pairs::integer(generator, 1, 6), 7);
    // A cone and a cylinder of radius 1 where the cone has v = place.
    const RationalPatch cone = turned(1, 0, {{1 + place, 0}, {place, 2}});
    const RationalPatch cylinder =
        turned((1 - t * t) / one, 2 * t / one, {{1, 2 * place - q(3, 5)}, {1, 2 * place + q(9, 10)}});
    INFO(i << ": " << t << ", " << place);
    const std::string text = i % 2 == 0 ? certificate(cone, cylinder) : certificate(cylinder, cone);
    REQUIRE(verdict(text) == "");
    const Json json = Json::parse(text);
    CHECK(json["summary"]["open"] == 1);
    CHECK(json["arcs"].size() == 1);
    REQUIRE(!json["factors"].empty());
    const std::size_t v = i % 2 == 0 ? 1 : 3, s = 4 - v;
    for (const Json& point : json["arcs"][0]["points"]) {
      CHECK(abs(checker::number_of(point[v].get<std::string>()) - place) < power_of_two(-44));
      CHECK(abs(checker::number_of(point[s].get<std::string>()) - q(2, 5)) < power_of_two(-44));
    }
  }
}

TEST_CASE("a circle that is on both patches in one point has a certificate of this point") {
  const RationalPatch cone = turned(1, 0, {{q(10, 7), 0}, {q(3, 7), 2}});
  // From the angle of -90 degrees to where the cone begins, at the height 6/7; and half a plane beyond x = 1.
  const RationalPatch cylinder = turned(0, -1, {{1, q(6, 7) - q(3, 5)}, {1, q(6, 7) + q(9, 10)}});
  const RationalPatch plane(std::vector<std::vector<Point>>{{{1, -1, q(6, 7)}, {1, q(1, 2), q(6, 7)}},
                                                            {{2, -1, q(6, 7)}, {2, q(1, 2), q(6, 7)}}});
  for (const RationalPatch& other : {cylinder, plane}) {
    const std::string text = certificate(cone, other);
    const Json json = Json::parse(text);
    CHECK(check_certificate(text).summary.isolated == 1);
    CHECK(json["arcs"].empty());
    REQUIRE(json["stars"].size() == 1);
    CHECK(json["stars"][0]["at"][1] == "3/7");
    CHECK(json["tubes"].size() == 2);
    Generator generator(82);
    INFO("seed 82");
    reject_changes(text, generator, 20);
    CHECK(rejected_forgeries(text, {"factors", "stars", "tubes"}, generator, 30) > 10);
    // The other patch further on: it meets the circle in an arc.
    reason(text, "$.", [](Json& j) {
      for (Json& row : j["second"]["points"])
        for (Json& point : row)
          point[0] = to_string(checker::number_of(point[0].get<std::string>()) - q(1, 9));
    });
  }
}

TEST_CASE("false factors with constant parameters are rejected") {
  const RationalPatch cone = turned(1, 0, {{q(10, 7), 0}, {q(3, 7), 2}});
  const RationalPatch cylinder = turned(q(4, 5), q(3, 5), {{1, q(6, 7) - q(3, 5)}, {1, q(6, 7) + q(9, 10)}});
  const std::string truth = certificate(cone, cylinder);
  const Json json = Json::parse(truth);
  std::size_t n = 0;
  while (json["factors"][n]["map"][0].size() != 2) ++n;
  const std::string place = "$.factors[" + std::to_string(n) + "]";
  reason(truth, place.c_str(), [&](Json& j) { j["factors"][n]["map"][0][1][0] = "-1/2"; });
  reason(truth, place.c_str(), [&](Json& j) { j["factors"][n]["powers"][2] = 2; });
  reason(truth, place.c_str(),
         [&](Json& j) { std::swap(j["factors"][n]["columns"][0], j["factors"][n]["columns"][1]); });
  Generator generator(83);
  INFO("seed 83");
  reject_changes(truth, generator, 20);
  CHECK(rejected_forgeries(truth, {"factors", "tubes", "arcs"}, generator, 30) > 10);
}

TEST_CASE("patches that touch along a circle around a common axis have certificates") {
  Generator generator(84);
  INFO("seed 84");
  for (int i = 0; i < 6; ++i) {
    const Rational t = q(random_pairs::integer(generator, -8, 8), 20);
    const Rational one = 1 + t * t;
    // A zone with the profile 1 + c (height)^2 for heights from -1 to 1, and the cylinder around it.
    const Rational c = q(random_pairs::integer(generator, 1, 9), 10);
    const RationalPatch zone = turned(1, 0, {{1 + c, -1}, {1 - c, 0}, {1 + c, 1}});
    const RationalPatch cylinder = turned((1 - t * t) / one, 2 * t / one, {{1, q(-3, 5)}, {1, q(9, 10)}});
    INFO(i << ": " << t << ", " << c);
    const std::string text = i % 2 == 0 ? certificate(zone, cylinder) : certificate(cylinder, zone);
    REQUIRE(verdict(text) == "");
    CHECK(check_certificate(text).summary.tangential == 1);
  }
}

}  // namespace exsect::certificate_constant_test

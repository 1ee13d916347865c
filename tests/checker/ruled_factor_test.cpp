// Certificates of patches with parallel lines in them, along which they cross at irrational parameters.
#include "certificate/ruled_factor.h"

#include <exsect/geometry/number.h>

#include "certificate_changes.h"

namespace exsect::ruled_factor_test {
namespace {

using namespace certificates;

Rational q(long a, long b) { return Rational(a, b); }

/// (t, c_0 + c_1 t + c_2 t^2) or, `exchanged`, with both coordinates in the other order, and from there along
/// the third one by `low` to `high`, which depend on t; with the weights 1, w, 1 in t; in other coordinates.
RationalPatch ruled(const std::array<Rational, 3>& c, bool exchanged, const Rational& low,
                    const Rational& high, const Rational& w) {
  const std::array<Rational, 3> heights = {c[0], c[0] + c[1] / 2, c[0] + c[1] + c[2]};
  std::vector<std::vector<Point>> net;
  for (long i = 0; i < 3; ++i) {
    net.emplace_back();
    Rational a = q(i, 2), b = heights[static_cast<std::size_t>(i)];
    if (exchanged) std::swap(a, b);
    for (const Rational& z : {low, high}) {
      const Rational height = z + q(i, 9);
      net.back().push_back({a + height / 3, b - height / 5, height + a / 7});
    }
  }
  return RationalPatch(net, {{1, 1}, {w, w}, {1, 1}});
}

Rational value(const Json& polynomial, const Rational& t) {
  Rational sum = 0;
  for (const Json& term : polynomial) {
    Rational product = checker::number_of(term[0].get<std::string>());
    for (std::size_t i = 1; i < 5; ++i)
      for (int n = 0; n < term[i].get<int>(); ++n) product *= t;
    sum += product;
  }
  return sum;
}

}  // namespace

TEST_CASE("patches with parallel lines have certificates of those in which they cross") {
  Generator generator(505);
  INFO("seed 505");
  int lines = 0;
  for (int i = 0; i < 60 && lines < 8; ++i) {
    const auto number = [&](long n) { return q(random_pairs::integer(generator, -n, n), 8); };
    const Rational w = i % 3 == 0 ? Rational(1) : q(3, 2);
    const RationalPatch x = ruled({q(1, 2) + number(3), number(6), number(8)}, false, 0, 1, w);
    const RationalPatch y = ruled({q(1, 2) + number(3), number(6), number(8)}, true, q(-1, 3), q(4, 5), 1);
    const IntersectResult result = intersect(x, y, coarse());
    if (result.status != Status::complete || result.graph.arcs.empty()) continue;
    INFO(i);
    const Json json = Json::parse(cli::certificate_text(x, y, names, result));
    REQUIRE(verdict(json.dump()) == "");
    CHECK(json["summary"]["tangential"] == 0);
    for (const Json& arc : json["arcs"]) {
      const std::string curve = json["tubes"][arc["pieces"][0][0].get<std::size_t>()]["curve"];
      const Json& map = json["factors"].at(std::stoul(curve.substr(6)))["map"];
      const Rational u = checker::number_of(arc["points"][0][0].get<std::string>());
      for (const Json& point : arc["points"])
        CHECK(abs(checker::number_of(point[0].get<std::string>()) - u) < power_of_two(-40));
      // The first polynomial has a simple zero next to u, which is irrational.
      CHECK(map[0].size() >= 3);
      const Rational near = power_of_two(-36);
      CHECK(value(map[0], u - near) * value(map[0], u + near) < 0);
      ++lines;
    }
  }
  CHECK(lines >= 8);
}

TEST_CASE("false claims about the polynomial of a constant parameter are rejected") {
  // u = r^2 and r = 1/4 + u^2 / 2 cross over two irrational u.
  const RationalPatch x = ruled({q(1, 4), 0, q(1, 2)}, false, 0, 1, 1),
                      y = ruled({0, 0, 1}, true, q(-1, 3), q(4, 5), 1);
  const std::string text = certificate(x, y);
  const Json json = Json::parse(text);
  REQUIRE(json["arcs"].size() == 1);
  const std::string curve = json["tubes"][0]["curve"];
  const std::size_t number = std::stoul(curve.substr(6));
  const std::string place = "$.factors[" + std::to_string(number) + "]: not a sum";
  reason(text, place.c_str(), [&](Json& j) { j["factors"][number]["map"][0][0][0] = "-7/5"; });
  reason(text, place.c_str(), [&](Json& j) { j["factors"][number]["map"][1][0][0] = "-7/5"; });
  // F is not 0 on the first polynomial alone.
  reason(text, place.c_str(),
         [&](Json& j) { std::swap(j["factors"][number]["map"][0], j["factors"][number]["map"][2]); });
  Generator generator(506);
  INFO("seed 506");
  reject_changes(text, generator, 20);
  rejected_forgeries(text, {"factors", "tubes", "nodes", "arcs"}, generator, 80);
}

TEST_CASE("a factor of lines is none where F depends on other parameters in all directions") {
  const RationalPatch x = ruled({q(1, 4), 0, q(1, 2)}, false, 0, 1, 1);
  RationalPatch y({{{0, 0, 0}, {1, 0, q(1, 3)}}, {{0, 1, 0}, {1, 1, 1}}});
  Node node = {};
  for (std::size_t i = 0; i < 4; ++i) node.box[i] = {0, 1};
  CHECK(!cli::ruled_factor(cli::equation_of({x, y}), {0, 2}, node));
}

}  // namespace exsect::ruled_factor_test

// Certificates of pairs with nodes that doubles do not tell apart.
#include <exsect/geometry/number.h>
#include <exsect/geometry/patch_file.h>

#include "certificate_changes.h"
#include "support/graph_patches.h"

namespace exsect::certificate_near_nodes_test {
namespace {

using namespace certificates;
using testing::plane;

Rational q(long a, long b) { return Rational(a, b); }
Rational number(const Json& json) { return checker::number_of(json.get<std::string>()); }

/// The nodes that are in one place but for 2^-40: their number.
std::size_t near_nodes(const Json& json) {
  std::size_t result = 0;
  for (const Json& node : json["nodes"]) {
    for (const Json& other : json["nodes"]) {
      Rational most = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const Rational apart = number(node["at"][i]) - number(other["at"][i]);
        most = std::max<Rational>(most, abs(apart));
      }
      if (most != 0 && most < power_of_two(-40)) ++result;
    }
  }
  return result;
}

/// Across the corner (0,0) of (u, v, c u v): where a u + b v = epsilon. In the middle s turns, unless c = 0.
/// Nothing where the result is incomplete.
std::string across_corner(const Rational& a, const Rational& b, const Rational& c, const Rational& epsilon) {
  std::array<std::array<Point, 3>, 3> points;
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 3; ++j)
      points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {q(i, 2), q(j, 2), c * q(i * j, 4)};
  // (r, s) = (1/3, 1/2) is next to the corner, r goes along the line, s up.
  const Point along = {-b, a, 0};
  const Point up = {0, 0, 1};
  Point origin = {epsilon * a / (a * a + b * b), epsilon * b / (a * a + b * b), 0};
  for (std::size_t d = 0; d < 3; ++d) origin[d] -= along[d] / 3 + up[d] / 2;
  const BezierPatch x(points), y = plane(origin, along, up);
  const IntersectResult result = intersect(x, y, coarse());
  return result.status == Status::complete ? cli::certificate_text(x, y, names, result) : "";
}

}  // namespace

TEST_CASE("arcs between sides and nodes next to each other have certificates") {
  for (const char* name :
       {"arc-between-sides-of-both", "contact-across-a-corner", "corner-arc-twice", "corner-arc-twice-planes",
        "corner-doubles-100mm", "corner-of-second-patch", "tip-through-plane", "two-turnings"}) {
    INFO(name);
    const auto patches = read_patches(std::string(EXSECT_CASES "/found/") + name + ".json").patches;
    for (const bool exchanged : {false, true}) {
      const auto& [x, y] = std::pair{patches[exchanged ? 1 : 0].patch, patches[exchanged ? 0 : 1].patch};
      const std::string text = certificate(x, y);
      CHECK(verdict(text) == "");
      CHECK(near_nodes(Json::parse(text)) == (std::string(name) == "two-turnings" ? 4 : 2));
    }
  }
}

TEST_CASE("an arc across a corner ends where the line meets the sides, at every distance") {
  Generator generator(71);
  INFO("seed 71");
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const Rational a = q(random_pairs::integer(generator, 1, 9), 4);
    const Rational b = q(random_pairs::integer(generator, 1, 9), 5);
    const Rational c = q(random_pairs::integer(generator, -2, 2), 3);
    const long bits = random_pairs::integer(generator, 45, 250);
    const Rational epsilon = power_of_two(-bits) * q(random_pairs::integer(generator, 3, 9), 7);
    INFO(a << " u + " << b << " v = " << epsilon << ", " << c << ", 2^-" << bits);
    const std::string text = across_corner(a, b, c, epsilon);
    if (text.empty()) continue;
    ++found;
    REQUIRE(verdict(text) == "");
    const Json json = Json::parse(text);
    REQUIRE(json["nodes"].size() == (c == 0 ? 2 : 3));
    for (const Json& node : json["nodes"]) {
      const Rational radius = number(node["radius"]);
      CHECK(256 * radius < epsilon);
      const Rational along = node["on"].empty() ? q(1, 2) : node["on"][0] == "u=0" ? 1 : 0;
      CHECK(abs(number(node["at"][0]) - (1 - along) * epsilon / a) <= radius);
      CHECK(abs(number(node["at"][1]) - along * epsilon / b) <= radius);
    }
  }
  CHECK(found >= 15);
}

TEST_CASE("false claims about nodes next to each other are rejected where they stand") {
  const Rational epsilon = power_of_two(-90);
  const std::string truth = across_corner(1, q(3, 2), 0, epsilon);
  // At another place by more than the radius, the arc as well; a box that holds both nodes.
  for (std::size_t n = 0; n < 2; ++n) {
    reason(truth, "$.nodes", [&](Json& j) {
      const std::size_t end = j["arcs"][0]["from"] == n ? 0 : 2;
      for (Json* at : {&j["nodes"][n]["at"][2], &j["arcs"][0]["points"][end][2]})
        *at = to_string(number(*at) + epsilon / 8);
    });
    reason(truth, "$.nodes", [&](Json& j) { j["nodes"][n]["radius"] = to_string(epsilon * 4); });
  }
  // The point between them beyond an end.
  reason(truth, "$.arcs[0]", [&](Json& j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto at = [&](std::size_t p) { return number(j["arcs"][0]["points"][p][i]); };
      j["arcs"][0]["points"][1][i] = to_string(at(2) + (at(2) - at(0)) / 4);
    }
  });
  Generator generator(72);
  INFO("seed 72");
  reject_changes(truth, generator, 20);
  CHECK(rejected_forgeries(truth, {"tubes", "nodes", "arcs"}, generator, 30) > 10);
}

}  // namespace exsect::certificate_near_nodes_test

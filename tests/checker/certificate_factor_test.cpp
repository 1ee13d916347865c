// Certificates with factors: arcs along which the patches touch, or a parameter is constant.
#include <exsect/geometry/number.h>

#include <algorithm>

#include "certificate_changes.h"
#include "support/families.h"

namespace exsect::certificate_factor_test {
namespace {

using namespace certificates;
using families::Plane;

std::string touching_text() {
  static const ExactCase c = families::tangent_curve(Rational(1, 3), Plane::square);
  static const std::string text = certificate(c.x, c.y);
  return text;
}
/// With a factor in charts of a star as well.
std::string crossing_text() {
  static const ExactCase c = families::tangent_and_transversal(Plane::square);
  static const std::string text = certificate(c.x, c.y);
  return text;
}

std::size_t factor_of_tube(const Json& json) {
  const std::string curve = json["tubes"][0]["curve"].get<std::string>();
  REQUIRE(curve.rfind("factor", 0) == 0);
  return std::stoul(curve.substr(6));
}

}  // namespace

TEST_CASE("an arc along which the patches touch has a certificate") {
  for (const ExactCase& c :
       {families::tangent_curve(Rational(1, 3), Plane::square), families::tangent_curve(0, Plane::larger),
        families::tangent_curve(Rational(3, 4), Plane::bilinear),
        families::tangent_curve(Rational(1, 3), Plane::quadratic), families::smooth_neighbour(Rational(1, 2)),
        families::smooth_neighbour(Rational(-1, 3))}) {
    INFO(c.name);
    const checker::Report report = check_certificate(certificate(c.x, c.y));
    CHECK(report.summary.open == 1);
    CHECK(report.summary.tangential == 1);
  }
}

TEST_CASE("a crossing of arcs on one of which the patches touch has a certificate") {
  for (const auto plane : families::regular_planes) {
    const ExactCase c = families::tangent_and_transversal(plane);
    const checker::Report report = check_certificate(certificate(c.x, c.y));
    CHECK(report.summary.branched == 1);
    CHECK(report.summary.tangential == 2);
  }
}

TEST_CASE("arcs on which a parameter is constant and others are curved have certificates") {
  const ExactCase sheets = families::near_sheets(Rational(1, 100), Plane::quadratic);
  CHECK(check_certificate(certificate(sheets.x, sheets.y)).summary.open == 2);
  const ExactCase branches = families::tangent_branches(Plane::quadratic);
  CHECK(check_certificate(certificate(branches.x, branches.y)).summary.branched == 1);
}

TEST_CASE("false claims about a factor are rejected where they stand") {
  const std::string text = touching_text();
  const std::size_t n = factor_of_tube(Json::parse(text));
  const std::string at = "$.factors[" + std::to_string(n) + "]";
  const auto factor = [n](auto change) { return [change, n](Json& j) { change(j["factors"][n]); }; };
  for (const char* key : {"map", "columns"})
    reason(text, (at + ": not a sum of multiples").c_str(), factor([&](Json& f) {
             Json& polynomials = key[0] == 'm' ? f["map"] : f["columns"][2];
             for (Json& polynomial : polynomials)
               if (!polynomial.empty()) polynomial[0][0] = "1/7";
           }));
  for (const int power : {1, 3})
    reason(text, (at + ": not a sum of multiples").c_str(), factor([&](Json& f) { f["powers"][2] = power; }));
  for (const int power : {0, 7})
    reason(text, (at + ": a power").c_str(), factor([&](Json& f) { f["powers"][0] = power; }));
  reason(text, (at + ".map[0][0]: must be a coefficient").c_str(),
         factor([](Json& f) { f["map"][0][0].erase(4); }));
  reason(text, (at + ".map[0][0][1]: an exponent").c_str(), factor([](Json& f) { f["map"][0][0][1] = 13; }));
  reason(text, (at + ".map[3]: must be three").c_str(),
         factor([](Json& f) { f["map"].push_back(f["map"][0]); }));
  reason(text, "$.tubes[0]: names no factor", [](Json& j) { j["tubes"][0]["curve"] = "factor9"; });
  reason(text, "$.tubes[0]: no contraction", [](Json& j) { j["tubes"][0]["curve"] = "pair"; });
  reason(text, "$.tubes[0].curve: must be", [](Json& j) { j["tubes"][0]["curve"] = "line0"; });
  reason(text, "$.arcs[0]: the error bound", [](Json& j) { j["arcs"][0]["error_bound"] = "0"; });
  reason(text, "$.summary", [](Json& j) { j["summary"]["tangential"] = 0; });
}

TEST_CASE("a node at a distance of 2^-30 from a second side is not on it") {
  ExactCase c = families::tangent_curve(Rational(1, 3), Plane::square);
  ControlNet net = c.y.net();
  for (auto& row : net)
    for (Point& point : row) point[1] -= power_of_two(-30);  // s = v + 2^-30
  const std::string text = certificate(c.x, BezierPatch(net));
  const Json nodes = Json::parse(text)["nodes"];
  const auto on_side = [](const Json& node) { return node["on"] == Json::array({"v=0"}); };
  const auto place = std::find_if(nodes.begin(), nodes.end(), on_side);
  REQUIRE(place != nodes.end());
  const auto n = static_cast<std::size_t>(place - nodes.begin());
  reason(text,
         ("$.nodes[" + std::to_string(n) + "]: a side does not follow from that of the tube's axis").c_str(),
         [n](Json& j) {
           j["nodes"][n]["on"].push_back("s=0");
           j["nodes"][n]["at"][3] = "0";
           Json& points = j["arcs"][0]["points"];
           (j["arcs"][0]["from"] == n ? points.front() : points.back())[3] = "0";
           j["nodes"][n]["radius"] = "1/2^25";
         });
}

TEST_CASE("a factor next to whose curve there may be other solutions is rejected") {
  // F = m g^2 = (m g) g, of which the second column vanishes on the curve.
  const std::string text = touching_text();
  const std::size_t n = factor_of_tube(Json::parse(text));
  reason(text, "$.tubes[0]: there may be other solutions", [n](Json& j) {
    Json& factor = j["factors"][n];
    factor["powers"][2] = 1;
    for (Json& polynomial : factor["columns"][2]) {
      if (polynomial.empty()) continue;
      REQUIRE(polynomial.size() == 1);
      const Rational c = checker::number_of(polynomial[0][0].get<std::string>());
      polynomial = factor["map"][2];
      for (Json& term : polynomial)
        term[0] = to_string(Rational(c * checker::number_of(term[0].get<std::string>())));
    }
  });
}

TEST_CASE("a factor proves nothing about another curve") {
  const std::string text = crossing_text();
  reason(text, "$.tubes[", [](Json& j) {
    for (Json& tube : j["tubes"]) {
      const std::string curve = tube["curve"].get<std::string>();
      if (const std::size_t end = curve.find("factor"); curve.rfind("star", 0) == 0 && end != curve.npos)
        tube["curve"] = curve.substr(0, end);
    }
  });
  reason(text, "$.tubes[", [](Json& j) {
    for (Json& tube : j["tubes"]) {
      const std::string curve = tube["curve"].get<std::string>();
      if (const std::size_t end = curve.find("factor"); end != curve.npos)
        tube["curve"] = curve.substr(0, end) + "factor" + (curve.back() == '1' ? "2" : "1");
    }
  });
}

TEST_CASE("no random single change of a certificate with factors is accepted") {
  Generator generator(28);
  INFO("seed 28");
  reject_changes(crossing_text(), generator, 10);
  reject_changes(touching_text(), generator, 30);
}

TEST_CASE("a forged factor is rejected, or says the same as the true one") {
  Generator generator(29);
  INFO("seed 29");
  CHECK(rejected_forgeries(touching_text(), {"factors", "tubes"}, generator, 60) > 30);
}

}  // namespace exsect::certificate_factor_test

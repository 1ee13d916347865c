// Certificates with seams: lines along which the patches touch.
#include <exsect/geometry/number.h>

#include "certificate_changes.h"
#include "support/families.h"

namespace exsect {
namespace {

using namespace certificates;
using families::Plane;

std::string touching_text() {
  static const ExactCase c = families::tangent_curve(Rational(1, 3), Plane::square);
  static const std::string text = certificate(c.x, c.y);
  return text;
}
/// With a seam in a chart of a star as well.
std::string crossing_text() {
  static const ExactCase c = families::tangent_and_transversal(Plane::square);
  static const std::string text = certificate(c.x, c.y);
  return text;
}

}  // namespace

TEST_CASE("an arc along which the patches touch has a certificate") {
  for (const ExactCase& c :
       {families::tangent_curve(Rational(1, 3), Plane::square), families::tangent_curve(0, Plane::larger),
        families::tangent_curve(Rational(3, 4), Plane::larger), families::smooth_neighbour(Rational(1, 2)),
        families::smooth_neighbour(Rational(-1, 3))}) {
    INFO(c.name);
    const checker::Report report = check_certificate(certificate(c.x, c.y));
    CHECK(report.summary.open == 1);
    CHECK(report.summary.tangential == 1);
    CHECK(report.summary.claims[7] == 1);
  }
}

TEST_CASE("a crossing of arcs on one of which the patches touch has a certificate") {
  for (const auto plane : {Plane::square, Plane::larger}) {
    const ExactCase c = families::tangent_and_transversal(plane);
    const checker::Report report = check_certificate(certificate(c.x, c.y));
    CHECK(report.summary.branched == 1);
    CHECK(report.summary.tangential == 2);
    CHECK(report.summary.claims[7] == 4);
  }
}

TEST_CASE("false claims about a seam are rejected where they stand") {
  const std::string text = touching_text();
  const auto seam = [](auto change) { return [change](Json& j) { change(j["seams"][0]); }; };
  const auto first_weights = [](Json& s) {
    for (Json& weight : s["weights"])
      if (weight == 2) weight = 1;
  };
  reason(text, "$.seams[0]: its coordinates", seam([](Json& s) { s["coordinates"][1][1] = "1/7"; }));
  reason(text, "$.seams[0]: its rows are dependent", seam([](Json& s) { s["rows"][0] = s["rows"][1]; }));
  reason(text, "$.seams[0]: an order below 1", seam([](Json& s) { s["orders"][0] = 0; }));
  reason(text, "$.seams[0]: not of this order", seam([](Json& s) { s["orders"][2] = 3; }));
  // With equal weights the derivative alone cannot tell the line from what is next to it.
  reason(text, "$.seams[0].charts[", seam([&](Json& s) {
           first_weights(s);
           s["orders"] = {1, 1, 1};
         }));
  reason(text, "$.seams[0]: neither of a line", seam([](Json& s) { s["weights"] = {1, 1, 1, 1}; }));
  reason(text, "$.seams[0]: not of this order", seam([](Json& s) { s["at"][0] = "1/3"; }));
  reason(text, "$.seams[0].of: must be pair", seam([](Json& s) { s["of"] = "line0"; }));
  reason(text, "$.seams[0]: names no star", seam([](Json& s) { s["of"] = "star0u+"; }));
  reason(text, "$.seams[0].charts[", seam([](Json& s) {
           for (Json& chart : s["charts"])
             if (chart != "") chart = "t0";
         }));
  reason(text, "$.seams[0].charts[", seam([](Json& s) {
           for (Json& chart : s["charts"])
             if (chart == "") chart = "1,0,0";
         }));
  reason(text, "$.seams[0].charts[", seam([](Json& s) {
           for (Json& chart : s["charts"])
             if (chart != "") chart = "1,0,0";
         }));
}

TEST_CASE("false claims about a tube in a seam are rejected where they stand") {
  const std::string text = touching_text();
  const auto tube = [](auto change) { return [change](Json& j) { change(j["tubes"][0]); }; };
  const auto twice = [](Json& number) {
    number = to_string(Rational(2 * checker::number_of(number.get<std::string>())));
  };
  reason(text, "$.tubes[0]: no contraction", tube([](Json& t) { t["curve"] = "line0"; }));
  reason(text, "$.tubes[0].curve: must be", tube([](Json& t) { t["curve"] = "seam0"; }));
  reason(text, "$.tubes[0]: names no seam", tube([](Json& t) { t["curve"] = "line0seam1"; }));
  reason(text, "$.tubes[0]: names no line", tube([](Json& t) { t["curve"] = "line1seam0"; }));
  reason(text, "$.tubes[0]: not in its seam", tube([&](Json& t) { twice(t["width"]); }));
  reason(text, "$.tubes[0]: not in its seam", tube([&](Json& t) { twice(t["reach"]); }));
  reason(text, "$.tubes[0]: its line is not in it", tube([](Json& t) { t["width"] = "1/2^60"; }));
  reason(text, "$.tubes[0]: an inverse", tube([](Json& t) { t["inverse"][0][0] = "1"; }));
  reason(text, "$.lines[0]: not a solution", [](Json& j) { j["lines"][0]["at"][0][0] = "1/3"; });
  reason(text, "$.nodes[0]", [](Json& j) { j["nodes"][0]["on"] = Json::array(); });
  reason(text, "$.arcs[0]: the error bound", [](Json& j) { j["arcs"][0]["error_bound"] = "0"; });
  reason(text, "$.tubes[0]: no arc",
         [](Json& j) { j["arcs"] = j["components"] = j["nodes"] = Json::array(); });
  reason(text, "$.summary", [](Json& j) { j["summary"]["tangential"] = 0; });
  reason(text, "$.cover", [](Json& j) {  // the seam itself is no place for cells
    for (Json& row : j["cover"]) {
      std::string entries = row.get<std::string>();
      if (const std::size_t at = entries.find(" t0"); at != std::string::npos) entries[at + 1] = 'p';
      row = entries;
    }
  });
}

TEST_CASE("a seam of one chart of a star proves nothing about another one") {
  const std::string text = crossing_text();
  Json truth = Json::parse(text);
  std::size_t inner = 0;
  while (truth["seams"][inner]["of"] == "pair") ++inner;
  reason(text, ("$.seams[" + std::to_string(inner) + "]").c_str(), [&](Json& j) {
    Json& seam = j["seams"][inner]["of"];
    seam = seam == "star0u+" ? "star0v+" : "star0u+";
  });
  reason(text, "$.seams[", [&](Json& j) {
    for (Json& seam : j["seams"])
      if (seam["of"] != "pair") seam["of"] = "pair";
  });
}

TEST_CASE("no random single change of a certificate with seams is accepted") {
  Generator generator(28);
  INFO("seed 28");
  reject_changes(crossing_text(), generator, 10);
  reject_changes(touching_text(), generator, 30);
}

TEST_CASE("a forged seam is rejected, or says the same as the true one") {
  Generator generator(29);
  INFO("seed 29");
  CHECK(rejected_forgeries(touching_text(), {"seams", "tubes"}, generator, 60) > 30);
}

}  // namespace exsect

// Certificates with sides that patches share and with stars.
#include <exsect/geometry/patch_file.h>

#include "certificate_changes.h"
#include "support/families.h"

namespace exsect::certificate_star_test {

using namespace certificates;

TEST_CASE("a side that two patches share has a certificate") {
  const ExactCase c = families::shared_side({});
  const std::string text = certificate(c.x, c.y);
  const checker::Report report = check_certificate(text);
  CHECK(report.summary.open == 1);
  CHECK(report.summary.claims[0] >= 1);
  reason(text, "$.tubes[0]: names no factor", [](Json& j) { j["factors"] = Json::array(); });
  // Of F itself no parameter is known to be constant.
  reason(text, "$.tubes[0]", [](Json& j) {
    for (Json& tube : j["tubes"]) tube["curve"] = "pair";
  });
}

TEST_CASE("a point where patches touch has a certificate") {
  const ExactCase c = families::cap(0, families::Plane::square);
  const std::string text = certificate(c.x, c.y);
  const checker::Report report = check_certificate(text);
  CHECK(report.summary.components == 0);
  CHECK(report.summary.claims[1] == 1);
  CHECK(report.summary.isolated == 1);
  reason(text, "$.stars[0]: not of this order", [](Json& j) { j["stars"][0]["orders"] = {1, 1, 3}; });
  reason(text, "$.stars[0]: not in [0,1]^4", [](Json& j) { j["stars"][0]["at"][0] = "-1"; });
  reason(text, "$.stars[1]: its box meets", [](Json& j) { j["stars"].push_back(j["stars"][0]); });
  reason(text, "$.stars[0]: its last row is not normal",
         [](Json& j) { std::swap(j["stars"][0]["rows"][0], j["stars"][0]["rows"][2]); });
}

namespace {

/// Its arcs and the shape of its components, after the exact solution.
void has_certificate(const ExactCase& c, std::size_t branched, std::size_t isolated) {
  INFO(c.name);
  const checker::Report report = check_certificate(certificate(c.x, c.y));
  CHECK(report.summary.branched == branched);
  CHECK(report.summary.isolated == isolated);
}

std::string crossing_text() {
  static const ExactCase c = families::crossing(families::Plane::square);
  static const std::string text = certificate(c.x, c.y);
  return text;
}

}  // namespace

TEST_CASE("a point where branches cross has a certificate") {
  using families::Plane;
  for (const auto plane : {Plane::square, Plane::larger, Plane::bilinear})
    has_certificate(families::crossing(plane), 1, 0);
  has_certificate(families::side_and_arc(), 1, 0);
  has_certificate(families::line_and_arc(), 1, 0);
}

TEST_CASE("false claims about a star are rejected where they stand") {
  const std::string text = crossing_text();
  const auto star = [](auto change) { return [change](Json& j) { change(j["stars"][0]); }; };
  reason(text, "$.arcs[0].points[", star([](Json& s) { s["at"][0] = "1/3"; }));
  reason(text, "$.stars[0]: its coordinates", star([](Json& s) { s["coordinates"][1][1] = "1"; }));
  reason(text, "$.stars[0]: its coordinates", star([](Json& s) { s["axes"][1][2] = "1"; }));
  reason(text, "$.stars[0]: a weight", star([](Json& s) { s["weights"][3] = 0; }));
  reason(text, "$.stars[0]: an order", star([](Json& s) { s["orders"][0] = 0; }));
  reason(text, "$.stars[0]: not of this order", star([](Json& s) { s["orders"][0] = 2; }));
  reason(text, "$.stars[0]: its rows are dependent", star([](Json& s) { s["rows"][0] = s["rows"][1]; }));
  reason(text, "$.stars[0]: its last row", star([](Json& s) { std::swap(s["rows"][0], s["rows"][2]); }));
  reason(text, "$.stars[0].charts[0]: the subdivision", star([](Json& s) { s["charts"][0] = "u"; }));
  reason(text, "$.stars[0].charts[0]: beyond the end", star([](Json& s) {
           s["charts"][0] = s["charts"][0].get<std::string>() + " " + s["charts"][0].get<std::string>();
         }));
  reason(text, "$.stars[0].charts[0]: a cell may", star([](Json& s) { s["charts"][0] = "0,0,0"; }));
  reason(text, "$.stars[0].charts[0]: not an entry", star([](Json& s) { s["charts"][0] = "p0"; }));
  reason(text, "$.stars[0].charts[0]: a tube of another", star([](Json& s) { s["charts"][0] = "t0"; }));
  for (const char letter : {'t', '1'}) {  // a cell with a solution, and one in no tube
    reason(text, "$.stars[0].charts[", star([letter](Json& s) {
             for (Json& chart : s["charts"]) {
               std::string entries = " " + chart.get<std::string>();
               const std::size_t at = entries.find(" t");
               if (at == std::string::npos) continue;
               const std::size_t end = entries.find(' ', at + 1);
               const std::string tube = entries.substr(at, end - at);
               if (letter == 't')
                 entries.replace(at, end - at, " 1,1,1");
               else
                 entries = " u" + tube + entries;
               chart = entries.substr(1);
               return;
             }
             FAIL("no such entry");
           }));
  }
}

TEST_CASE("cusps of the curve and branches tangent to each other have certificates, with weights") {
  using families::Plane;
  for (const auto plane : {Plane::square, Plane::larger, Plane::bilinear}) {
    INFO(static_cast<int>(plane));
    const ExactCase cusp = families::curve_cusp(plane);
    const checker::Report report = check_certificate(certificate(cusp.x, cusp.y));
    CHECK(report.summary.open == 1);
    CHECK(report.summary.claims[4] >= 2);
    const ExactCase tangent = families::tangent_branches(plane);
    CHECK(check_certificate(certificate(tangent.x, tangent.y)).summary.branched == 1);
  }
}

TEST_CASE("false claims about weights are rejected where they stand") {
  const ExactCase c = families::curve_cusp(families::Plane::larger);
  const std::string text = certificate(c.x, c.y);
  CHECK(Json::parse(text)["stars"][0]["weights"] == Json({2, 3, 4, 4}));
  CHECK(Json::parse(text)["stars"][0]["orders"] == Json({4, 4, 6}));
  const auto star = [](auto change) { return [change](Json& j) { change(j["stars"][0]); }; };
  reason(text, "$.stars[0]: not of this order", star([](Json& s) { s["weights"] = {2, 2, 4, 4}; }));
  reason(text, "$.stars[0]: not of this order", star([](Json& s) { s["weights"] = {2, 3, 3, 4}; }));
  reason(text, "$.stars[0]: not of this order", star([](Json& s) { s["orders"] = {4, 4, 7}; }));
  reason(text, "$.stars[0]: a weight", star([](Json& s) { s["weights"] = {2, 3, 4, 7}; }));
  reason(text, "$.tubes[", star([](Json& s) { s["weights"] = {3, 3, 4, 4}; }));
  reason(text, "$.", star([](Json& s) {  // the equations divided by too little vanish with t
           s["orders"] = {4, 4, 5};
         }));
}

TEST_CASE("no random single change of a certificate with weights is accepted") {
  const ExactCase c = families::tangent_branches(families::Plane::larger);
  const std::string text = certificate(c.x, c.y);
  Generator generator(32);
  INFO("seed 32");
  reject_changes(text, generator, 20);
}

TEST_CASE("a star may be seen in the squares of its distances") {
  Json json = Json::parse(crossing_text());
  json["stars"][0]["weights"] = {2, 2, 2, 2};
  json["stars"][0]["orders"] = {2, 2, 4};
  for (Json& arc : json["arcs"]) arc["error_bound"] = "1/8";
  seal_again(json);
  CHECK(verdict(json.dump()) == "");
  json["stars"][0]["weights"] = {2, 2, 2, 1};
  seal_again(json);
  CHECK(verdict(json.dump()) != "");
}

TEST_CASE("false claims about half branches are rejected where they stand") {
  const std::string text = crossing_text();
  const auto tubes = [](Json& j) {
    std::vector<Json*> result;
    for (Json& tube : j["tubes"])
      if (tube["curve"].get<std::string>().substr(0, 4) == "star") result.push_back(&tube);
    return result;
  };
  reason(text, "$.tubes[0]: names no star", [&](Json& j) { (*tubes(j)[0])["curve"] = "star7u+"; });
  reason(text, "$.tubes[0]: ", [&](Json& j) { (*tubes(j)[0])["curve"] = "star0r-"; });
  reason(text, "$.tubes[0].curve: must name u, v, r or s",
         [&](Json& j) { (*tubes(j)[0])["curve"] = "star0"; });
  reason(text, "$.tubes[0]: does not begin", [&](Json& j) {
    Json& tube = *tubes(j)[0];
    tube["centre"][std::string("uvrs").find(tube["axis"].get<std::string>())] = "1/2^40";
  });
  reason(text, "$.tubes[1]: may begin where", [&](Json& j) { *tubes(j)[1] = *tubes(j)[0]; });
  // An arc less: its half branch is inside.
  reason(text, "$.tubes", [](Json& j) { j["arcs"].erase(3); });
  reason(text, "$.arcs[", [&](Json& j) { j["arcs"][0]["pieces"][0][0] = j["arcs"][1]["pieces"][0][0]; });
  reason(text, "$.arcs[0]", [&](Json& j) { j["arcs"][0]["from"] = j["arcs"][0]["to"]; });
  reason(text, "$.tubes", [&](Json& j) { j["arcs"][1] = j["arcs"][0]; });
  reason(text, "$.components[0]", [](Json& j) { j["components"][0]["shape"] = "closed"; });
  reason(text, "$.summary", [](Json& j) { j["summary"]["isolated"] = 1; });
  reason(text, "$.summary", [](Json& j) { j["summary"]["branched"] = 0; });
}

TEST_CASE("no random single change of a certificate with a star is accepted") {
  Generator generator(26);
  INFO("seed 26");
  reject_changes(crossing_text(), generator, 40);
}

TEST_CASE("a forged star is rejected, or says the same as the true one") {
  Generator generator(27);
  INFO("seed 27");
  CHECK(rejected_forgeries(crossing_text(), {"stars"}, generator, 40) > 20);
}

namespace {

/// Why there is no certificate, or nothing.
std::string missing(const BezierPatch& x, const BezierPatch& y) {
  try {
    certificate(x, y);
    return "";
  } catch (const cli::NoCertificate& event) {
    return event.what();
  }
}

}  // namespace

TEST_CASE("an event without a certificate is named") {
  // One plane at different speeds.
  CHECK(
      missing(families::cap(0, families::Plane::square).y, families::cap(0, families::Plane::quadratic).y) ==
      "an overlap of patches whose parameters do not depend on each other linearly");
}

}  // namespace exsect::certificate_star_test

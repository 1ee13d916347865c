// Certificates with planes of solutions: overlaps, and sides along which patches are one surface.
#include <exsect/geometry/number.h>

#include "certificate_changes.h"
#include "support/families.h"

namespace exsect::certificate_overlap_test {
namespace {

using namespace certificates;

std::string overlap_text() {
  static const ExactCase c = families::shifted_copy();
  static const std::string text = certificate(c.x, c.y);
  return text;
}
std::string edge_text() {
  static const ExactCase c = families::smooth_neighbour(0);
  static const std::string text = certificate(c.x, c.y);
  return text;
}

}  // namespace

TEST_CASE("an overlap of patches with parameters that depend on each other linearly has a certificate") {
  for (const ExactCase& c :
       {families::shifted_copy(), families::same_patch(), families::coplanar_squares()}) {
    INFO(c.name);
    const checker::Report report = check_certificate(certificate(c.x, c.y));
    CHECK(report.summary.components == 0);
    CHECK(report.summary.claims[6] == 1);
  }
}

TEST_CASE("a side beyond which one patch continues the other one has a certificate") {
  const checker::Report report = check_certificate(edge_text());
  CHECK(report.summary.open == 1);
  CHECK(report.summary.tangential == 1);
  CHECK(report.summary.claims[6] == 0);
}

TEST_CASE("false claims about an overlap are rejected where they stand") {
  const std::string text = overlap_text();
  const auto edges = [](auto change) { return [change](Json& j) { change(j["overlaps"][0]["edges"]); }; };
  reason(text, "$.overlaps[0]: names no factor", [](Json& j) { j["overlaps"][0]["factor"] = 9; });
  reason(text, "$.overlaps[0].edges[0]: does not end where", edges([](Json& e) { e.erase(1); }));
  reason(text, "$.overlaps[0]: not convex", edges([](Json& e) {  // a corner on an edge
           Json middle = e[0];
           Json& points = e[0]["points"];
           const std::size_t half = points.size() / 2;
           const Json first = points[0];
           const Json last = points.back();
           Json corner = first;
           for (std::size_t i = 0; i < 4; ++i)
             corner[i] = to_string(Rational((checker::number_of(first[i].get<std::string>()) +
                                             checker::number_of(last[i].get<std::string>())) /
                                            2));
           points.erase(points.begin() + static_cast<std::ptrdiff_t>(half), points.end());
           points.push_back(corner);
           middle["points"].erase(middle["points"].begin(),
                                  middle["points"].begin() + static_cast<std::ptrdiff_t>(half));
           middle["points"].insert(middle["points"].begin(), corner);
           e.insert(e.begin() + 1, middle);
         }));
  reason(text, "$.overlaps[0]", edges([](Json& e) {  // a triangle, cut off by no side
           e.erase(2);
           e[1]["points"].back() = e[2]["points"][0];
         }));
  reason(text, "$.overlaps[0].edges[0]: the error bound",
         edges([](Json& e) { e[0]["error_bound"] = "1/2^30"; }));
  reason(text, "$.overlaps[1]: the same", [](Json& j) { j["overlaps"].push_back(j["overlaps"][0]); });
  reason(text, "$.cover[0]: names no overlap", [](Json& j) {
    j["overlaps"] = Json::array();
    j["summary"]["claims"][6] = 0;
  });
  const ExactCase touching = families::tangent_curve(Rational(1, 3), families::Plane::square);
  reason(certificate(touching.x, touching.y), "$.overlaps[0]: its factor is not one of a plane",
         [&](Json& j) { j["overlaps"] = Json::parse(text)["overlaps"]; });
  reason(text, "$.summary", [](Json& j) { j["summary"]["claims"][6] = 0; });
  reason(text, "$.factors[0]: not a sum", [](Json& j) { j["factors"][0]["columns"][0][0][0][0] = "1/7"; });
  reason(text, "$.overlaps[0]: its factor is not one of a plane", [](Json& j) {
    for (Json& polynomial : j["factors"][0]["columns"][2]) polynomial = {{"0", 0, 0, 0, 0}};
  });
}

TEST_CASE("an overlap that is larger or smaller than claimed is rejected") {
  reason(overlap_text(), "$.overlaps[0]", [](Json& j) {
    for (Json& edge : j["overlaps"][0]["edges"])
      for (Json& point : edge["points"])
        for (std::size_t i = 0; i < 4; ++i)
          if (point[i] == "1/3") point[i] = "1/2";
  });
  reason(overlap_text(), "$.cover", [](Json& j) {
    for (Json& row : j["cover"]) {
      std::string entries = " " + row.get<std::string>();
      for (std::size_t at; (at = entries.find(" s0")) != std::string::npos;) entries.replace(at, 3, " 1,0,0");
      row = entries.substr(1);
    }
  });
}

TEST_CASE("a plane of solutions that goes on in the domain is no edge") {
  const ExactCase c = families::same_patch();
  reason(certificate(c.x, c.y), "$.tubes[0]: its surface goes on", [](Json& j) {
    const Json zero = {"0", "0", "0"};
    j["tubes"].push_back({{"centre", {"0", "1/2", "0", "1/2"}},
                          {"axis", "v"},
                          {"slope", {"0", "1", "0", "1"}},
                          {"reach", "1/2"},
                          {"width", "1/8"},
                          {"inverse", {zero, zero, zero}},
                          {"curve", "factor0"}});
  });
  // Where the patches continue each other, the other sign makes it one.
  CHECK(verdict(edge_text()) == "");
}

TEST_CASE("a forged plane of solutions is rejected, or says the same as the true one") {
  Generator generator(32);
  INFO("seed 32");
  CHECK(rejected_forgeries(overlap_text(), {"factors", "overlaps"}, generator, 40) > 30);
  CHECK(rejected_forgeries(edge_text(), {"factors"}, generator, 40) > 30);
}

TEST_CASE("no random single change of a certificate with an overlap is accepted") {
  Generator generator(31);
  INFO("seed 31");
  reject_changes(edge_text(), generator, 10);
  reject_changes(overlap_text(), generator, 30);
}

}  // namespace exsect::certificate_overlap_test

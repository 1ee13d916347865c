// Certificates of neighbours: patches with a common side along which they touch, or nearly so.
#include <exsect/geometry/number.h>
#include <exsect/geometry/patch_file.h>

#include "certificate_changes.h"

namespace exsect::certificate_neighbours_test {
namespace {

using namespace certificates;

Rational q(long a, long b) { return Rational(a, b); }

/// (u, v, u^2 + v^2), and (1 + r (1 + s) / 2, s, 1 + s^2 + r (1 + s) + lift r + bend r^2): where lift is 0
/// they touch along u = 1, r = 0, v = s, in directions that change from place to place.
RationalPatch paraboloid() {
  std::vector<std::vector<Point>> net;
  for (int i = 0; i < 3; ++i) {
    net.emplace_back();
    for (int j = 0; j < 3; ++j) net.back().push_back({q(i, 2), q(j, 2), q(i == 2, 1) + q(j == 2, 1)});
  }
  return RationalPatch(net);
}
RationalPatch neighbour(const Rational& lift, const Rational& bend) {
  std::vector<std::vector<Point>> net;
  for (int i = 0; i < 3; ++i) {
    net.emplace_back();
    for (int j = 0; j < 3; ++j) {
      // r has the control values i/2, s has j/2, r s has i j / 4, and their squares 0, 0, 1.
      const Rational along = q(i, 2) + q(i * j, 4);
      net.back().push_back(
          {1 + along / 2, q(j, 2), 1 + q(j == 2, 1) + along + lift * q(i, 2) + bend * q(i == 2, 1)});
    }
  }
  return RationalPatch(net);
}

/// Enlarged, then moved along x.
RationalPatch moved(const RationalPatch& patch, const Rational& scale, const Rational& shift) {
  std::vector<std::vector<Point>> net;
  for (int i = 0; i < 3; ++i) {
    net.emplace_back();
    for (int j = 0; j < 3; ++j) {
      const Point p = patch.point(i, j);
      net.back().push_back({scale * p[0] + shift, scale * p[1], scale * p[2]});
    }
  }
  return RationalPatch(net);
}

}  // namespace

TEST_CASE(
    "neighbours that touch along their common side have a certificate, as they have if they nearly do") {
  for (const Rational& bend : {q(1, 3), q(-1, 3), q(2, 1)}) {
    for (const Rational& lift : {Rational(0), q(1, 4), power_of_two(-50), Rational(-power_of_two(-50))}) {
      INFO(bend << ", " << lift);
      for (const bool exchanged : {false, true}) {
        const RationalPatch x = paraboloid(), y = neighbour(lift, bend);
        const std::string text = exchanged ? certificate(y, x) : certificate(x, y);
        const checker::Report report = check_certificate(text);
        CHECK(report.summary.open == 1);
        CHECK(report.summary.tangential == (lift == 0 ? 1 : 0));
        CHECK(report.summary.claims[1] == 0);
        // Whether they touch follows from the columns, whatever the summary says.
        reason(text, "$.summary: does not agree",
               [&](Json& j) { j["summary"]["tangential"] = lift == 0 ? 0 : 1; });
      }
    }
  }
}

TEST_CASE("what lies between neighbours is not overlooked") {
  const std::string text = certificate(paraboloid(), neighbour(0, q(1, 3)));
  const Json json = Json::parse(text);
  const auto number = std::stoul(json["tubes"][0]["curve"].get<std::string>().substr(6));
  const std::string factor = "$.factors[" + std::to_string(number) + "]: ";
  // A tube beyond which the normals have turned too far.
  reason(text, "$.tubes[0]: there may be other solutions", [](Json& j) {
    for (const char* size : {"reach", "width"}) j["tubes"][0][size] = "100";
  });
  // The neighbour bent elsewhere, and components of the map exchanged.
  reason(text, "$.factors[0]: not a sum", [](Json& j) { j["second"]["points"][2][1][0] = "1/2"; });
  reason(text, (factor + "not a sum").c_str(),
         [&](Json& j) { std::swap(j["factors"][number]["map"][0], j["factors"][number]["map"][2]); });
  // F = M_a (u - 1 + r) + (M_b - M_a) r + M_c g_c as well, but u - 1 + r is no wall.
  reason(text, "$.tubes[0]: there may be other solutions", [&](Json& j) {
    Json& claim = j["factors"][number];
    std::array<std::size_t, 2> wall = {3, 3};  // u - 1 and r
    for (std::size_t n = 0; n < 3; ++n)
      for (const Json& term : claim["map"][n])
        for (const std::size_t i : {0, 1})
          if (term[1 + 2 * i] == 1) wall[i] = n;
    claim["map"][wall[0]].push_back({"1", 0, 0, 1, 0});
    for (std::size_t d = 0; d < 3; ++d) {
      for (Json term : claim["columns"][wall[0]][d]) {
        const auto c = term[0].get<std::string>();
        term[0] = c[0] == '-' ? c.substr(1) : "-" + c;
        claim["columns"][wall[1]][d].push_back(term);
      }
    }
  });
}

TEST_CASE("a patch that is folded back over its neighbour has no certificate by its walls") {
  // (1 - r (1 + s) / 2, s, 1 + s^2 - r (1 + s) + 2 r^2) is above the paraboloid but for r = 0.
  std::vector<std::vector<Point>> net;
  for (int i = 0; i < 3; ++i) {
    net.emplace_back();
    for (int j = 0; j < 3; ++j) {
      const Rational along = q(i, 2) + q(i * j, 4);
      net.back().push_back({1 - along / 2, q(j, 2), 1 + q(j == 2, 1) - along + q(2 * (i == 2), 1)});
    }
  }
  CHECK_THROWS_AS(certificate(paraboloid(), RationalPatch(net)), cli::NoCertificate);
}

TEST_CASE("neighbours in doubles have certificates, also where they touch at an end, moved and enlarged") {
  Generator generator(77);
  INFO("seed 77");
  for (const char* name : {"smooth-neighbours", "smooth-neighbours-touching-at-an-end"}) {
    INFO(name);
    const auto patches = read_patches(std::string(EXSECT_CASES "/found/") + name + ".json").patches;
    std::string text;
    for (const bool exchanged : {true, false}) {
      for (const auto& [scale, shift] :
           {std::pair{q(1, 1), q(0, 1)}, {q(127, 5), q(0, 1)}, {q(1, 1), q(100000000, 1)}}) {
        const RationalPatch x = moved(patches[0].patch, scale, shift),
                            y = moved(patches[1].patch, scale, shift);
        text = exchanged ? certificate(y, x) : certificate(x, y);
        const checker::Summary count = check_certificate(text).summary;
        CHECK((count.open == 1 && count.components == 1 && count.tangential == 0 && count.claims[1] == 0));
      }
    }
    reject_changes(text, generator, 20);
    rejected_forgeries(text, {"factors", "tubes", "nodes"}, generator, 60);
  }
}

}  // namespace exsect::certificate_neighbours_test

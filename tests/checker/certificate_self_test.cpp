// Certificates of self-intersections.
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/self_intersect.h>

#include "certificate_changes.h"
#include "support/random_nets.h"

namespace exsect::certificate_self_test {
namespace {

using namespace certificates;

/// The Whitney umbrella (s t, s, t^2), s = u - 1/2 + (v - 1/2)/4, t = v - 5/12 + u/8: a cuspidal point where
/// s = t = 0, and a curve s = 0 of pairs t, -t.
BezierPatch umbrella() {
  const std::array<Rational, 3> s = {Rational(-5, 8), 1, Rational(1, 4)};
  const std::array<Rational, 3> t = {Rational(-5, 12), Rational(1, 8), 1};
  const std::array<std::array<std::size_t, 2>, 3> monomials = {{{0, 0}, {1, 0}, {0, 1}}};
  ControlNet c = {};
  for (std::size_t a = 0; a < 3; ++a) {
    c[monomials[a][0]][monomials[a][1]][1] += s[a];
    for (std::size_t b = 0; b < 3; ++b) {
      Point& p = c[monomials[a][0] + monomials[b][0]][monomials[a][1] + monomials[b][1]];
      p[0] += s[a] * t[b];
      p[2] += t[a] * t[b];
    }
  }
  return BezierPatch::from_power_basis(c);
}

std::string self_text(const RationalPatch& x) {
  return cli::self_certificate_text(x, {"x", "x"}, self_intersect(x, coarse()));
}

/// The umbrella of this bidegree, its control points moved by at most 1/50.
random_nets::Net moved_umbrella(Generator& generator, int m, int n) {
  const RationalPatch elevated = RationalPatch(umbrella()).elevated(m, n);
  random_nets::Net net(static_cast<std::size_t>(m) + 1);
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      Point p = elevated.point(i, j);
      for (Rational& c : p) c += Rational(random_pairs::integer(generator, -8, 8), 400);
      net[static_cast<std::size_t>(i)].push_back(p);
    }
  }
  return net;
}

}  // namespace

TEST_CASE("a curve in which a patch meets itself has a certificate from its cuspidal point on") {
  const std::string text = self_text(umbrella());
  const checker::Report report = check_certificate(text);
  CHECK(report.self);
  CHECK(report.summary.open == 1);
  CHECK(report.summary.boundary == 1);
  CHECK(report.summary.claims[3] == 2);
  const auto node = [](Json& j, bool cusp) -> Json& {
    return j["nodes"][0]["on"].empty() == cusp ? j["nodes"][0] : j["nodes"][1];
  };
  reason(text, "$.nodes[1]: ", [&](Json& j) {
    const Json before = node(j, true)["at"];
    node(j, true)["at"][0] = "1/3";
    for (Json& arc : j["arcs"])
      for (Json& point : arc["points"])
        for (std::size_t i = 0; i < 4 && point[1] == before[1] && point[3] == before[3]; ++i)
          point[i] = node(j, true)["at"][i];
  });
  reason(text, "$.nodes[", [&](Json& j) { node(j, true)["on"] = {"u=0"}; });
  reason(text, "$.tubes[", [](Json& j) {
    for (Json& tube : j["tubes"]) tube["curve"] = "pair";
  });
  // Every leaf of the other kinds is needed: none proves what another one does.
  for (const char letter : {'t', 'l', 'i'}) {
    INFO(letter);
    reason(text, "$.cover[", [&](Json& j) {
      for (Json& row : j["cover"]) {
        std::string entries = " " + row.get<std::string>();
        const std::size_t at = entries.find(std::string(" ") + letter);
        if (at == std::string::npos) continue;
        entries.replace(at, entries.find(' ', at + 1) - at, letter == 'i' ? " lower" : " i1,0,0");
        row = entries.substr(1);
        return;
      }
      FAIL("no such entry");
    });
  }
}

TEST_CASE("patches that do not meet themselves have certificates without curves") {
  for (const auto& named : read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches) {
    const checker::Report report = check_certificate(self_text(named.patch));
    CHECK(report.summary.components == 0);
    CHECK(report.exclusions > 0);
  }
}

TEST_CASE("self-intersections of random patches have certificates, none of which can be changed") {
  Generator generator(25);
  INFO("seed 25");
  const std::string text = self_text(umbrella());
  reject_changes(text, generator, 60);
}

TEST_CASE("patches of other kinds that meet themselves have certificates, none of which can be changed") {
  Generator generator(26);
  INFO("seed 26");
  for (const auto& [m, n] : {std::array{3, 3}, {2, 2}, {2, 3}, {3, 2}}) {
    for (const bool weighted : {false, true}) {
      INFO("bidegree (" << m << "," << n << ")" << (weighted ? " with weights" : ""));
      const random_nets::Net net = moved_umbrella(generator, m, n);
      const RationalPatch x = weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
      const std::string text = self_text(x);
      const checker::Report report = check_certificate(text);
      CHECK((report.self && report.summary.open == 1 && report.summary.components == 1));
      CHECK((report.covered > 0 && report.exclusions > 0));
      if (m + n > 4 && weighted) continue;  // what is rejected is checked in rationals too
      reject_changes(text, generator, 12);
    }
  }
}

TEST_CASE("a forged certificate of a patch with weights is rejected where it is false") {
  Generator generator(27);
  INFO("seed 27");
  const std::string text = self_text(random_nets::weighted(generator, moved_umbrella(generator, 2, 2)));
  // Of the patch without its weights, with other ones, or with points of no patch of this bidegree.
  reason(text, "$.tubes[", [](Json& j) { j["first"].erase("weights"); });
  reason(text, "$.", [](Json& j) { j["first"]["weights"][1][1] = "7/3"; });
  reason(text, "$.first: its denominator", [](Json& j) { j["first"]["weights"][2][2] = "-1"; });
  reason(text, "$.first.weights", [](Json& j) { j["first"]["points"].erase(2); });
  // The curve in the chart is no other one, and no curve of the pair.
  const auto charted = [](Json& j) -> Json& {
    for (Json& tube : j["tubes"])
      if (tube["curve"] != "pair") return tube;
    FAIL("no chart");
    return j;
  };
  reason(text, "$.tubes[", [&](Json& j) { charted(j)["curve"] = "pair"; });
  reason(text, "$.tubes[", [&](Json& j) {
    Json& tube = charted(j);
    tube["curve"] = tube["curve"] == "first" ? "second" : "first";
  });
  reason(text, "$.", [&](Json& j) { charted(j)["centre"][2] = "-1/7"; });
  reason(text, "$.", [&](Json& j) { charted(j)["width"] = "1/2^40"; });
  // A curve that is left out.
  reason(text, "$.cover[", [](Json& j) {
    for (const char* list : {"tubes", "nodes", "arcs", "components"}) j[list] = Json::array();
    j["summary"]["claims"] = {0, 0, 0, 0, 0, 0, 0};
    for (const char* count : {"components", "open", "boundary"}) j["summary"][count] = 0;
  });
}

}  // namespace exsect::certificate_self_test

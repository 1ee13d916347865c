// Certificates of patches of every kind: written, accepted, and rejected after a change.
#include <exsect/geometry/number.h>
#include <exsect/geometry/rational_patch_file.h>

#include "certificate/line.h"
#include "certificate_changes.h"
#include "support/random_nets.h"

namespace exsect::certificate_kinds_test {
namespace {

using namespace certificates;
using Degrees = std::array<int, 4>;

/// Not biquadratic both.
const std::vector<Degrees> kinds = {{3, 3, 3, 3}, {3, 3, 2, 2}, {1, 1, 3, 3}, {3, 1, 2, 3},
                                    {1, 3, 3, 2}, {2, 1, 1, 3}, {3, 2, 2, 3}};

/// A certificate that is accepted, of the whole result.
std::string accepted(const RationalPatch& x, const RationalPatch& y) {
  const IntersectResult result = intersect(x, y, coarse());
  REQUIRE(result.status == Status::complete);
  const std::string text = cli::certificate_text(x, y, names, result);
  const checker::Report report = check_certificate(text);
  CHECK(report.summary.components == result.graph.components.size());
  CHECK(report.summary.closed == static_cast<std::size_t>(result.graph.count(ComponentShape::closed)));
  return text;
}

RationalPatch moved(const RationalPatch& patch, const std::function<Point(const Point&)>& map) {
  std::vector<std::vector<Point>> points;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    points.emplace_back();
    for (int j = 0; j <= patch.degree_v(); ++j) points.back().push_back(map(patch.point(i, j)));
  }
  return RationalPatch(points);
}

}  // namespace

TEST_CASE("pairs of every bidegree have certificates that are accepted") {
  Generator generator(32);
  INFO("seed 32");
  for (const Degrees& degrees : kinds) {
    for (int i = 0; i < 4; ++i) {
      INFO(degrees[0] << degrees[1] << degrees[2] << degrees[3] << ", " << i);
      const auto nets =
          i == 3 ? random_nets::loop(generator, degrees) : random_nets::crossing(generator, degrees, i != 0);
      const Json json = Json::parse(accepted(nets.first(), nets.second()));
      // As long as x and y may not be biquadratic, the nets are those given.
      if (degrees[0] == 3 && degrees[1] == 3) CHECK(json["first"]["points"].size() == 4);
    }
  }
}

TEST_CASE("a pair in other coordinates and the other order has a certificate of the same graph") {
  Generator generator(33);
  INFO("seed 33");
  const auto nets = random_nets::crossing(generator, {3, 3, 3, 2}, true);
  const RationalPatch x = nets.first(), y = nets.second();
  const Json summary = Json::parse(accepted(x, y))["summary"];
  const Rational far = 100000000;
  const auto turned = [](const Point& p) {
    return Point{Rational(3, 5) * p[0] - Rational(4, 5) * p[1], Rational(4, 5) * p[0] + Rational(3, 5) * p[1],
                 p[2]};
  };
  const std::vector<std::function<Point(const Point&)>> maps = {
      [](const Point& p) { return Rational(127, 5) * p; },
      [&](const Point& p) {
        return p + Point{far, -far, far};
      },
      turned};
  const auto graph = [](const Json& s) {
    return Json{s["components"], s["closed"], s["open"], s["boundary"], s["isolated"]};
  };
  for (std::size_t i = 0; i < maps.size(); ++i) {
    INFO(i);
    CHECK(graph(Json::parse(accepted(moved(x, maps[i]), moved(y, maps[i])))["summary"]) == graph(summary));
  }
  CHECK(graph(Json::parse(accepted(y, x))["summary"]) == graph(summary));
  CHECK(graph(Json::parse(accepted(x.transposed(), y.restricted_to(1, 0, 0, 1)))["summary"]) ==
        graph(summary));
}

TEST_CASE(
    "a biquadratic patch with the net of a higher bidegree has the certificate of the biquadratic one") {
  Generator generator(34);
  INFO("seed 34");
  const auto pair = random_pairs::doubles(generator);
  const RationalPatch x(pair.x), y(pair.y);
  CHECK(certificate(x.elevated(3, 3), y.elevated(2, 3)) == certificate(pair.x, pair.y));
}

TEST_CASE("patches with a common side, and those that touch, have certificates or a named reason") {
  const auto teapot = read_rational_patches(EXSECT_EXAMPLES "/teapot.bpt").patches;
  const auto numbered = [&](const char* name) {
    return std::find_if(teapot.begin(), teapot.end(), [&](const auto& p) { return p.name == name; })->patch;
  };
  const Json side = Json::parse(accepted(numbered("1"), numbered("5")));
  CHECK(side["summary"]["open"] == 1);
  CHECK(side["factors"].size() == 1);
  CHECK_THROWS_AS(accepted(numbered("1"), numbered("2")), cli::NoCertificate);  // they touch along a side
}

TEST_CASE("no random single change of a certificate of bicubic patches is accepted") {
  Generator generator(35);
  INFO("seed 35");
  const auto nets = random_nets::crossing(generator, {3, 3, 1, 2}, false);
  const std::string truth = accepted(nets.first(), nets.second());
  reject_changes(truth, generator, 20);
  CHECK(rejected_forgeries(truth, {"tubes", "nodes", "arcs"}, generator, 20) > 5);
}

TEST_CASE("false claims about bicubic patches are rejected where they stand") {
  Generator generator(36);
  INFO("seed 36");
  const auto nets = random_nets::crossing(generator, {3, 3, 3, 1}, false);
  const std::string truth = accepted(nets.first(), nets.second());
  reason(truth, "$.tubes", [](Json& j) { j["first"]["points"][1][2][2] = "7"; });
  reason(truth, "$.tubes", [](Json& j) { std::swap(j["second"]["points"][0], j["second"]["points"][1]); });
  reason(truth, "$.", [](Json& j) { j["tubes"].erase(1); });
  reason(truth, "$.cover", [](Json& j) { j["cover"].erase(j["cover"].size() - 1); });
  // Of no shape, and of degree 4.
  reason(truth, "$.first.points", [](Json& j) { j["first"]["points"][1].erase(3); });
  reason(truth, "$.first.points", [](Json& j) { j["first"]["points"].push_back(j["first"]["points"][0]); });
  reason(truth, "$.second.points[2]", [](Json& j) { j["second"]["points"][2].push_back({"0", "0", "0"}); });
  reason(truth, "$.second.points", [](Json& j) {
    for (Json& row : j["second"]["points"]) row.erase(1);
  });
  reason(truth, "$.second.points",
         [](Json& j) { j["second"]["points"] = Json::array({j["second"]["points"][0]}); });
}

TEST_CASE("pairs of every bidegree with weights have certificates that are accepted") {
  Generator generator(39);
  INFO("seed 39");
  const std::vector<Degrees> weighted = {
      {1, 1, 1, 1}, {2, 2, 2, 2}, {2, 1, 1, 3}, {3, 2, 1, 2}, {3, 3, 3, 3}};
  for (const Degrees& degrees : weighted) {
    for (int i = 0; i < (degrees[0] + degrees[2] == 6 ? 1 : 4); ++i) {
      INFO(degrees[0] << degrees[1] << degrees[2] << degrees[3] << ", " << i);
      const auto nets =
          i == 2 ? random_nets::loop(generator, degrees) : random_nets::crossing(generator, degrees, i != 0);
      const RationalPatch x = random_nets::weighted(generator, nets.x);
      const RationalPatch y = i == 1 ? nets.second() : random_nets::weighted(generator, nets.y);
      const Json json = Json::parse(accepted(x, y));
      CHECK(json["first"].contains("weights"));
      CHECK(json["second"].contains("weights") == (i != 1));
    }
  }
}

namespace {

/// P -> P / (1 + c . P), a patch with weights 1 + c . P_ij.
RationalPatch image(const BezierPatch& patch, const Point& c) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const auto& row : patch.net()) {
    net.emplace_back();
    for (const Point& p : row) net.back().push_back({p[0], p[1], p[2], 1 + dot(c, p)});
  }
  return RationalPatch::from_homogeneous(net);
}
/// What does not depend on the coordinates in space.
Json in_parameters(const std::string& text) {
  const Json summary = Json::parse(text)["summary"];
  return {summary["components"], summary["closed"], summary["open"], summary["boundary"], summary["turning"]};
}

}  // namespace

TEST_CASE("images of a pair under projective maps have certificates of the same graph") {
  Generator generator(40);
  INFO("seed 40");
  for (int i = 0; i < 4; ++i) {
    const auto pair = i == 3 ? random_pairs::loop(generator) : random_pairs::doubles(generator);
    const Json graph = in_parameters(accepted(pair.x, pair.y));
    for (const Point& c :
         {Point{Rational(1, 40), Rational(-1, 50), Rational(1, 30)}, Point{Rational(1, 20), 0, 0}}) {
      INFO(i << ", " << c[0]);
      const RationalPatch x = image(pair.x, c), y = image(pair.y, c);
      CHECK(in_parameters(accepted(x, y)) == graph);
      const Json turning = in_parameters(accepted(y, x))[4];
      CHECK(turning == Json({graph[4][2], graph[4][3], graph[4][0], graph[4][1]}));
    }
  }
}

TEST_CASE("single weights may be negative") {
  const auto q = [](long a, long b) { return Rational(a, b); };
  const RationalPatch x(
      {{{0, 0, 0}, {0, 1, q(1, 8)}}, {{q(1, 2), 0, q(1, 5)}, {q(1, 2), 1, 0}}, {{1, 0, 0}, {1, 1, q(1, 7)}}},
      {{1, 1}, {q(-1, 4), q(-1, 4)}, {1, 1}});
  const RationalPatch y({{{q(-1, 10), q(1, 3), -1}, {q(-1, 10), q(2, 3), 1}},
                         {{q(11, 10), q(1, 2), -1}, {q(11, 10), q(3, 7), 1}}});
  const Json json = Json::parse(accepted(x, y));
  CHECK(json["first"]["weights"][1] == Json({"-1/4", "-1/4"}));
  CHECK(json["summary"]["turning"] == Json({0, 2, 2, 1}));
}

TEST_CASE("false claims about patches with weights are rejected where they stand") {
  Generator generator(42);
  INFO("seed 42");
  const auto nets = random_nets::crossing(generator, {2, 1, 1, 2}, false);
  const std::string truth =
      accepted(random_nets::weighted(generator, nets.x), random_nets::weighted(generator, nets.y));
  reject_changes(truth, generator, 40);
  CHECK(rejected_forgeries(truth, {"tubes", "nodes", "arcs"}, generator, 40) > 10);
  reason(truth, "$.", [](Json& j) { j["first"]["weights"][1][0] = "9/7"; });
  reason(truth, "$.", [](Json& j) { std::swap(j["first"]["weights"][0], j["first"]["weights"][1]); });
  reason(truth, "$.", [](Json& j) { j["second"]["points"][1][1][0] = "3"; });
  reason(truth, "$.", [](Json& j) { j["second"].erase("weights"); });
  reason(truth, "$.", [](Json& j) { j["tubes"].erase(0); });
  // Denominators that are 0 or negative somewhere.
  reason(truth, "$.first: its denominator", [](Json& j) { j["first"]["weights"][0][0] = "0"; });
  reason(truth, "$.second: its denominator", [](Json& j) { j["second"]["weights"][1][2] = "-1/8"; });
  reason(truth, "$.second: its denominator", [](Json& j) {
    j["second"]["weights"] = {{"1", "-1", "1"}, {"1", "-1", "1"}};
  });
  reason(truth, "$.first: its denominator", [](Json& j) {
    for (Json& row : j["first"]["weights"]) row = {"-1", "-1"};
  });
  // Of another shape, or no numbers.
  reason(truth, "$.first.weights", [](Json& j) { j["first"]["weights"].push_back({"1", "1"}); });
  reason(truth, "$.first.weights", [](Json& j) { j["first"]["weights"].erase(0); });
  reason(truth, "$.first.weights[1]", [](Json& j) { j["first"]["weights"][1].push_back("1"); });
  reason(truth, "$.first.weights[0]", [](Json& j) { j["first"]["weights"][0] = "1"; });
  reason(truth, "$.first.weights[0][0]", [](Json& j) { j["first"]["weights"][0][0] = 1; });
  reason(truth, "$.first", [](Json& j) { j["first"]["more"] = j["first"]["weights"]; });
}

TEST_CASE("lines on patches of every kind have certificates, none of which can be changed") {
  Generator generator(45);
  INFO("seed 45");
  for (const Degrees& degrees : {Degrees{3, 3, 3, 3}, {2, 2, 3, 1}, {1, 3, 2, 1}}) {
    for (int i = 0; i < 4; ++i) {
      INFO(degrees[0] << degrees[1] << degrees[2] << degrees[3] << ", " << i);
      const auto nets = random_nets::crossing(generator, degrees, i % 2 == 0);
      const RationalPatch x = i < 2 ? random_nets::weighted(generator, nets.x) : nets.first();
      const RationalPatch y = i == 1 ? random_nets::weighted(generator, nets.y) : nets.second();
      const LineQuery query = {all_parameters[below(generator, 4)],
                               Rational(random_pairs::integer(generator, 0, 97), 97)};
      const LineIntersection line = intersect_line(x, y, query);
      const std::string text = cli::certificate_text(x, y, names, line);
      CHECK(check_certificate(text).summary.claims[3] == line.solution.points.size());
      reject_changes(text, generator, 5);
    }
  }
}

}  // namespace exsect::certificate_kinds_test

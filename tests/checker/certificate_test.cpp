// Certificates of pairs in general position: written, accepted, and rejected after any change.
#include <exsect/geometry/number.h>
#include <exsect/geometry/patch_file.h>

#include <cmath>

#include "certificate/claims.h"
#include "certificate_changes.h"
#include "support/families.h"
#include "support/graph_patches.h"

namespace exsect::certificate_test {
namespace {

using namespace certificates;

using testing::plane;

/// Two planes that cross in one open arc.
std::string planes() {
  const auto q = [](long a, long b) { return Rational(a, b); };
  return certificate(plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                     plane({0, 0, q(-3, 5)}, {1, q(1, 4), 1}, {q(1, 3), 1, q(1, 2)}));
}

/// A closed curve with turning points and relations between the parameters.
std::string circle() {
  const ExactCase c = families::cap(Rational(1, 50), families::Plane::square);
  return certificate(c.x, c.y);
}

}  // namespace

TEST_CASE("the first example has a certificate under 5 MB that is accepted") {
  const auto patches = read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches;
  const std::string text = certificate(patches[0].patch, patches[1].patch);
  CHECK(text.size() < 5000000);
  const checker::Report report = check_certificate(text);
  CHECK(report.summary.closed == 1);
  CHECK(report.summary.open == 1);
  CHECK(report.summary.boundary == 2);
  CHECK(report.summary.turning == std::array<std::size_t, 4>{2, 3, 3, 2});
}

namespace {

/// With each arc from its other end.
std::string turned_round(const std::string& text) {
  Json json = Json::parse(text);
  for (Json& arc : json["arcs"]) {
    std::swap(arc["from"], arc["to"]);
    const std::size_t last = arc["points"].size() - 1;
    std::reverse(arc["points"].begin(), arc["points"].end());
    std::size_t first = 0;
    for (Json& piece : arc["pieces"]) {
      const std::size_t end = piece[1];
      piece[1] = last - first;
      first = end;
    }
    std::reverse(arc["pieces"].begin(), arc["pieces"].end());
  }
  seal_again(json);
  return json.dump();
}

}  // namespace

TEST_CASE("an arc may begin at either of its ends") {
  // A parameter turns in tubes with a single step next to its turning point, at the end of which it is slow.
  for (const char* name : {EXSECT_EXAMPLES "/chapter9-first.json", EXSECT_EXAMPLES "/chapter9-second.json",
                           EXSECT_CASES "/nearly-crossing.json", EXSECT_CASES "/tangent-curve.json"}) {
    INFO(name);
    const auto patches = read_patches(name).patches;
    CHECK(verdict(turned_round(certificate(patches[0].patch, patches[1].patch))) == "");
  }
}

TEST_CASE("doubles are written as the rationals that they are, and read again") {
  const auto same = [](double a) {
    INFO(a);
    const std::string text = cli::exact_number(a);
    CHECK(checker::number_of(text) == from_double(a));
    const Integer power = denominator(from_double(a));
    CHECK((text.find("/2^") != std::string::npos) == (power >= 256));
    CHECK(text == (power < 256 ? to_string(from_double(a))
                               : numerator(from_double(a)).str() + "/2^" + std::to_string(msb(power))));
  };
  for (const double a : {0.0, -0.0, 1.0, 0.5, 3.0 / 128, 1.0 / 256, 0.1, 1e15 + 0.5, 0x1p52, 0x1p53, 0x1.8p62,
                         1e300, 0x1p-1022, 0x1.8p-1023, 0x1p-1074, 0x1.fffffffffffffp1023, 0x1p-52})
    for (const double b : {a, -a}) same(b);
  Generator generator(7);
  INFO("seed 7");
  for (int i = 0; i < 300; ++i) {
    const auto p = static_cast<double>(random_pairs::integer(generator, -(1L << 53), 1L << 53));
    same(std::ldexp(p, -static_cast<int>(below(generator, 120))));
  }
}

TEST_CASE("claims have the text that the JSON library writes") {
  for (const char* text : {R"({})", R"([])", R"({"a":[],"b":{"c":[1,-2,[true,null]]},"d":1.5})",
                           R"(["a\"b\\c\n/~ "])", R"(["\u00fcber \u2264 \u0001"])"}) {
    const Json json = Json::parse(text);
    CHECK(cli::compact_text(json) == json.dump());
  }
  const Json json = Json::parse(circle());
  CHECK(cli::compact_text(json) == json.dump());
  CHECK(cli::compact_text({{"a", cli::verbatim("[1, \"\n\"]")}, {"b", 2}}) == "{\"a\":[1, \"\n\"],\"b\":2}");
}

namespace {

/// Most changes in small certificates; `special`: some with each other kind of claim.
void mutations_are_rejected(int many, const std::vector<ExactCase>& special) {
  std::vector<std::string> certificates = {planes(), circle()};
  for (const ExactCase& c : special) certificates.push_back(certificate(c.x, c.y));
  Generator generator(20);
  INFO("seed 20");
  for (int i = 0; i < many; ++i) {
    const std::size_t which = i % (special.empty() ? 10 : 2) == 0 ? below(generator, certificates.size()) : 0;
    Json json = Json::parse(certificates[which]);
    const std::string change = mutate(json, generator, true);
    INFO(i << ": " << change);
    REQUIRE(verdict(json.dump()) != "");
  }
}

}  // namespace

TEST_CASE("no random single change of a certificate is accepted") { mutations_are_rejected(200, {}); }
TEST_CASE("no random single change of a certificate of any kind is accepted, many", "[.slow]") {
  using families::Plane;
  mutations_are_rejected(2000, {families::crossing(Plane::larger), families::tangent_curve(0, Plane::larger),
                                families::tangent_and_transversal(Plane::larger), families::shifted_copy(),
                                families::smooth_neighbour(0), families::tangent_branches(Plane::larger),
                                families::curve_cusp(Plane::larger), families::crossing(Plane::quadratic)});
}

TEST_CASE("a forged certificate is rejected, or says the same as the true one") {
  const std::string text = planes();
  const Json truth = Json::parse(text);
  Generator generator(21);
  INFO("seed 21");
  int rejected = 0;
  for (int i = 0; i < 150; ++i) {
    Json json = truth;
    const std::string change = mutate(json, generator, false);
    seal_again(json);
    INFO(i << ": " << change);
    if (verdict(json.dump()) != "") {
      ++rejected;
      continue;
    }
    // What the checker accepts is proved for the patches in the file: if they are the same, so is the graph.
    if (json["first"]["points"] == truth["first"]["points"] &&
        json["second"]["points"] == truth["second"]["points"])
      REQUIRE(json["summary"] == truth["summary"]);
  }
  CHECK(rejected > 50);
}

TEST_CASE("claims that are false are rejected where they stand") {
  const std::string truth = circle();
  const auto reason = [&](const char* where, auto change) {
    Json json = Json::parse(truth);
    change(json);
    seal_again(json);
    const std::string said = verdict(json.dump());
    INFO(where << " expected, got " << said);
    CHECK(said.rfind(where, 0) == 0);
  };
  reason("$.tubes[0]", [](Json& j) { j["tubes"][0]["inverse"][0] = {"0", "0", "0"}; });
  reason("$.tubes[0]", [](Json& j) { j["tubes"][0]["reach"] = "1/2"; });
  reason("$.tubes[0]: a chart of two", [](Json& j) { j["tubes"][0]["curve"] = "first"; });
  reason("$.tubes[0]: names no factor", [](Json& j) { j["tubes"][0]["curve"] = "factor9"; });
  reason("$.arcs[0].points[0]: must be where", [](Json& j) { j["nodes"][0]["at"][0] = "1/3"; });
  reason("$.nodes[0]", [](Json& j) { j["nodes"][0]["radius"] = "0"; });
  reason("$.arcs[0]", [](Json& j) { j["nodes"].erase(0); });
  reason("$.arcs[0]", [](Json& j) { j["arcs"][0]["error_bound"] = "0"; });
  reason("$.arcs[0]", [](Json& j) {
    j["arcs"][0]["points"].erase(1);
    j["arcs"][0]["points"].erase(1);
  });
  reason("$.cover", [](Json& j) {
    j["cover"].erase(j["cover"].size() - 1);
    j["summary"]["claims"][5] = cells(j);
  });
  reason("$.summary", [](Json& j) { j["cover"].push_back("u #"); });
  reason("$.summary", [](Json& j) { j["summary"]["closed"] = 2; });
  reason("$.components[0]", [](Json& j) { j["components"][0]["shape"] = "open"; });
  // Without an arc its tubes are good for nothing.
  reason("$.tubes", [](Json& j) {
    j["arcs"].erase(j["arcs"].size() - 1);
    j["components"][0]["arcs"].erase(j["components"][0]["arcs"].size() - 1);
  });
}

TEST_CASE("a number is written in one way of each of three") {
  CHECK(checker::number_of("-3/7") == Rational(-3, 7));
  CHECK(checker::number_of("12") == 12);
  CHECK(checker::number_of("-3/2^4") == Rational(-3, 16));
  CHECK(checker::number_of("6293554681484751/2^100") == Rational(6293554681484751) * power_of_two(-100));
  for (const char* text :
       {"6/4",  "0.5",  "+1", "-0",     "2/2^3", "1/2^0", "1/2^-3", "1/2^03", "1/2^3 ", "1/3/2^2", "1/2^2001",
        "1/2^", "/2^3", "",   "01/2^3", "0/2^3", "0/2",   "3/1",    "1/0",    "1/-2",   "--1",     "007"}) {
    INFO(text);
    CHECK_THROWS_AS(checker::number_of(text), std::invalid_argument);
  }
}

TEST_CASE("what is no certificate is unreadable") {
  const std::string text = planes();
  for (const std::string& wrong :
       {std::string(), std::string("{"), std::string("[]"), text.substr(0, text.size() / 2),
        std::string("{\"exsect\": \"patches/1\"}"), text + "}"})
    CHECK_THROWS_AS(check_certificate(wrong), Unreadable);
}

TEST_CASE("a certificate has its keys once, in their order, and a command that is known") {
  const std::string text = planes();
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    return changed.replace(changed.find(from), from.size(), to);
  };
  const std::string command = "\"command\": \"intersect\"";
  CHECK(verdict(with(command, command)) == "");
  for (const std::string& wrong : {std::string("\"command\": \"meet\""), command + ", " + command,
                                   "\"more\": 1, " + command, std::string("\"command\": 1")})
    CHECK_THROWS_AS(check_certificate(with(command, wrong)), Rejected);
}

namespace {

/// Each has a certificate that is accepted, in doubles alone and in exact arithmetic as far as these do not
/// do.
void random_pairs_are_accepted(int many, const IntersectOptions& options) {
  Generator generator(22);
  INFO("seed 22");
  for (int i = 0; i < many; ++i) {
    INFO(i);
    const auto pair = i % 3 == 0   ? random_pairs::small_rationals(generator)
                      : i % 3 == 1 ? random_pairs::doubles(generator)
                                   : random_pairs::loop(generator);
    const IntersectResult result = intersect(pair.x, pair.y, options);
    REQUIRE(result.status == Status::complete);
    const checker::Report report = check_certificate(cli::certificate_text(pair.x, pair.y, names, result));
    REQUIRE(report.summary.components == result.graph.components.size());
  }
}

}  // namespace

TEST_CASE("generic random pairs have certificates that are accepted") {
  random_pairs_are_accepted(20, coarse());
}
TEST_CASE("generic random pairs have certificates that are accepted, many", "[.slow]") {
  random_pairs_are_accepted(500, {});
}

TEST_CASE("a curve that begins in a common corner has a certificate") {
  const auto x = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto y = plane({0, 0, 0}, {1, Rational(1, 4), 1}, {Rational(1, 3), 1, -1});
  const IntersectResult result = intersect(x, y, coarse());
  CHECK(result.graph.nodes[0].on.size() == 4);
  CHECK(verdict(certificate(x, y)) == "");
}

}  // namespace exsect::certificate_test

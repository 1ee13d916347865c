// Certificates: written, accepted, and rejected after any change.
#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/line_patch.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "certificate_text.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"

namespace exsect {
namespace {

using testing::plane;

using Json = nlohmann::ordered_json;
using checker::check_certificate;
using checker::Rejected;
using checker::Unreadable;

const cli::PatchNames names = {"x", "y"};

/// With few vertices: the tests need small certificates.
IntersectOptions coarse() {
  IntersectOptions options;
  options.tolerance = 1e-2;
  return options;
}

std::string certificate(const BezierPatch& x, const BezierPatch& y) {
  return cli::certificate_text(x, y, names, intersect(x, y, coarse()));
}

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

/// Where and why, or nothing if the certificate is accepted.
std::string verdict(const std::string& text) {
  try {
    check_certificate(text);
    return "";
  } catch (const Rejected& rejected) {
    CHECK(!rejected.place().empty());
    return rejected.place() + ": " + rejected.what();
  } catch (const Unreadable& unreadable) {
    return std::string("unreadable: ") + unreadable.what();
  }
}

using Generator = random_pairs::Generator;

std::size_t below(Generator& generator, std::size_t n) {
  return static_cast<std::size_t>(random_pairs::integer(generator, 0, static_cast<long>(n) - 1));
}

/// Another digit, or the other sign, in a number.
std::string other_number(std::string text, Generator& generator) {
  if (below(generator, 5) == 0) return text[0] == '-' ? text.substr(1) : "-" + text;
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
  char& digit = text[digits[below(generator, digits.size())]];
  digit = static_cast<char>('0' + (digit - '0' + 1 + static_cast<int>(below(generator, 9))) % 10);
  return text;
}

/// Every leaf below `json` but seals.
void collect(Json& json, std::vector<Json*>& leaves, bool seals) {
  if (!json.is_structured()) return leaves.push_back(&json);
  for (auto& [key, value] : json.items())
    if (seals || key != "seal") collect(value, leaves, seals);
}

/// Changes one leaf: a digit or sign of a number, a count, a letter.
void change_leaf(Json& leaf, Generator& generator) {
  if (leaf.is_boolean()) {
    leaf = !leaf.get<bool>();
  } else if (leaf.is_number()) {
    leaf = leaf.get<std::size_t>() + 1 + below(generator, 3);
  } else {
    std::string text = leaf.get<std::string>();
    if (text.find_first_of("0123456789") != std::string::npos) {
      leaf = other_number(text, generator);
    } else {
      text[below(generator, text.size())] = "uvrsz"[below(generator, 5)];
      leaf = text == leaf ? text + "u" : text;
    }
  }
}

/// One random change of the document. `seals`: the seals may change as well.
std::string mutate(Json& json, Generator& generator, bool seals) {
  std::vector<std::string> lists;
  std::vector<std::string> sealed;
  for (const auto& [key, value] : json.items()) {
    if (value.is_array()) lists.push_back(key);
    if (value.is_structured()) sealed.push_back(key);
  }
  Json& list = json[lists[below(generator, lists.size())]];
  const std::size_t kind = below(generator, 8);
  if (kind == 0) {
    if (!json.contains("second")) {
      json["command"] = "intersect";
      return "another command";
    }
    std::swap(json["first"], json["second"]);
    return "patches swapped";
  }
  if (kind <= 3 && !list.empty()) {
    const std::size_t i = below(generator, list.size());
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(i);
    if (kind == 1) list.erase(at);
    if (kind == 2) list.insert(at, Json(list[i]));
    if (kind == 3 && list.size() > 1 && list[i] != list[(i + 1) % list.size()])
      std::swap(list[i], list[(i + 1) % list.size()]);
    else if (kind == 3)
      list.erase(at);
    return "a claim dropped, repeated or moved";
  }
  std::vector<Json*> leaves;
  while (leaves.empty()) {
    Json& part = json[sealed[below(generator, sealed.size())]];
    if (part.is_array() && !part.empty())
      collect(part[below(generator, part.size())], leaves, seals);
    else
      collect(part, leaves, seals);
  }
  Json& leaf = *leaves[below(generator, leaves.size())];
  const std::string before = leaf.dump();
  change_leaf(leaf, generator);
  return before + " changed to " + leaf.dump();
}

/// The number of entries in all rows of the cover.
std::size_t cells(const Json& json) {
  std::size_t count = 0;
  for (const Json& row : json["cover"]) {
    const std::string text = row.get<std::string>();
    count += static_cast<std::size_t>(std::count(text.begin(), text.end(), ' '));
  }
  return count;
}

/// Seals that fit, as a forger would make them.
void seal_again(Json& json) {
  const auto seal_claim = [](Json& claim, const std::string& place) {
    claim.erase("seal");
    claim["seal"] = checker::seal(place + claim.dump());
  };
  for (auto& [key, value] : json.items()) {
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
      const std::string place = "$." + key + "[" + std::to_string(i) + "]";
      if (value[i].is_object()) {
        seal_claim(value[i], place);
      } else {
        std::string text = value[i].get<std::string>();
        text = text.substr(0, text.find(" #"));
        value[i] = text + " #" + checker::seal(place + text);
      }
    }
    if (value.is_object()) seal_claim(value, "$." + key);
  }
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

void mutations_are_rejected(int many) {
  const std::array<std::string, 2> certificates = {planes(), circle()};
  Generator generator(20);
  INFO("seed 20");
  for (int i = 0; i < many; ++i) {
    Json json = Json::parse(certificates[i % 10 == 0 ? 1 : 0]);
    const std::string change = mutate(json, generator, true);
    INFO(i << ": " << change);
    REQUIRE(verdict(json.dump()) != "");
  }
}

}  // namespace

TEST_CASE("no random single change of a certificate is accepted") { mutations_are_rejected(200); }
TEST_CASE("no random single change of a certificate is accepted, many", "[.slow]") {
  mutations_are_rejected(2000);
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
  reason("$.tubes[0]: names no line", [](Json& j) { j["tubes"][0]["curve"] = "line0"; });
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
    j["summary"]["claims"][6] = cells(j);
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
  for (const char* text : {"6/4", "0.5", "+1", "-0", "2/2^3", "1/2^0", "1/2^-3", "1/2^03", "1/2^3 ",
                           "1/3/2^2", "1/2^2001", "1/2^", "/2^3", "", "01/2^3", "0/2^3"}) {
    INFO(text);
    CHECK_THROWS_AS(checker::number_of(text), std::invalid_argument);
  }
}

TEST_CASE("what is no certificate is unreadable") {
  for (const char* text :
       {"", "{", "[]", "{\"exsect\": \"patches/1\"}", "{\"exsect\": \"certificate/1\", \"exsect\": 1}"})
    CHECK_THROWS_AS(check_certificate(text), Unreadable);
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

namespace {

std::string line_text(const BezierPatch& x, const BezierPatch& y, Parameter fixed, const Rational& value) {
  return cli::certificate_text(x, y, names, intersect_line(x, y, {fixed, value}));
}

}  // namespace

TEST_CASE("the points of a line have a certificate") {
  const auto patches = read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches;
  for (const Parameter p : all_parameters) {
    for (const Rational& value : {Rational(1, 2), Rational(1, 3), Rational(0), Rational(19, 20)}) {
      INFO(name(p) << " = " << value);
      const BezierPatch& x = patches[0].patch;
      const BezierPatch& y = patches[1].patch;
      const auto solution = intersect_line(x, y, {p, value}).solution;
      const checker::Report report = check_certificate(line_text(x, y, p, value));
      CHECK(report.fixed->value == value);
      CHECK(report.summary.claims[4] == solution.points.size());
    }
  }
}

TEST_CASE("lines of random pairs have certificates, none of which can be changed") {
  Generator generator(24);
  INFO("seed 24");
  for (int i = 0; i < 20; ++i) {
    const auto pair = random_pairs::scattered(generator);
    const Rational value(random_pairs::integer(generator, 0, 97), 97);
    const std::string text = line_text(pair.x, pair.y, all_parameters[below(generator, 4)], value);
    INFO(i);
    REQUIRE(verdict(text) == "");
    for (int k = 0; k < 10; ++k) {
      Json json = Json::parse(text);
      const std::string change = mutate(json, generator, true);
      INFO(change);
      REQUIRE(verdict(json.dump()) != "");
    }
  }
}

TEST_CASE("false claims about a line are rejected where they stand") {
  const auto patches = read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches;
  const std::string truth = line_text(patches[0].patch, patches[1].patch, Parameter::u, Rational(1, 2));
  const auto reason = [&](const char* where, auto change) {
    Json json = Json::parse(truth);
    REQUIRE(json["points"].size() == 2);
    change(json);
    json["summary"]["claims"] = {0, 0, 0, json["tubes"].size(), json["points"].size(), 0, cells(json)};
    seal_again(json);
    const std::string said = verdict(json.dump());
    INFO(where << " expected, got " << said);
    CHECK(said.rfind(where, 0) == 0);
  };
  reason("$.tubes[1]: no point", [](Json& j) { j["points"].erase(1); });
  reason("$.points[1]: its box meets", [](Json& j) { j["points"][1] = j["points"][0]; });
  reason("$.points[0]: must be on the line", [](Json& j) { j["fixed"]["value"] = "1/3"; });
  reason("$.points[0]", [](Json& j) { j["points"][0]["radius"] = "0"; });
  reason("$.cover", [](Json& j) { j["cover"].erase(j["cover"].size() - 1); });
  reason("$.tubes[0]", [](Json& j) { j["tubes"][0]["axis"] = "v"; });
}

namespace {

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

std::string self_text(const BezierPatch& x) {
  return cli::self_certificate_text(x, {"x", "x"}, self_intersect(x, coarse()));
}

/// The same change is named where it stands.
void reason(const std::string& truth, const char* where, const std::function<void(Json&)>& change) {
  Json json = Json::parse(truth);
  change(json);
  json["summary"]["claims"][6] = cells(json);
  seal_again(json);
  const std::string said = verdict(json.dump());
  INFO(where << " expected, got " << said);
  CHECK(said.rfind(where, 0) == 0);
}

}  // namespace

TEST_CASE("a curve in which a patch meets itself has a certificate from its cuspidal point on") {
  const std::string text = self_text(umbrella());
  const checker::Report report = check_certificate(text);
  CHECK(report.self);
  CHECK(report.summary.open == 1);
  CHECK(report.summary.boundary == 1);
  CHECK(report.summary.claims[4] == 2);
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
  for (int k = 0; k < 60; ++k) {
    Json json = Json::parse(text);
    const std::string change = mutate(json, generator, true);
    INFO(change);
    REQUIRE(verdict(json.dump()) != "");
  }
}

TEST_CASE("a side that two patches share has a certificate") {
  const ExactCase c = families::shared_side({});
  const std::string text = certificate(c.x, c.y);
  const checker::Report report = check_certificate(text);
  CHECK(report.summary.open == 1);
  CHECK(report.summary.claims[1] == 1);
  reason(text, "$.lines[0]: not a solution", [](Json& j) {
    for (Json& row : j["lines"][0]["at"])
      if (row[1] == "0") row[0] = "1/2";
  });
  reason(text, "$.tubes[0]: names no line", [](Json& j) { j["lines"].erase(0); });
  reason(text, "$.tubes[0]: a parameter may turn", [](Json& j) {
    for (Json& tube : j["tubes"]) tube["curve"] = "pair";
  });
}

TEST_CASE("a point where patches touch has a certificate") {
  const ExactCase c = families::cap(0, families::Plane::square);
  const std::string text = certificate(c.x, c.y);
  const checker::Report report = check_certificate(text);
  CHECK(report.summary.components == 0);
  CHECK(report.summary.claims[2] == 1);
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

TEST_CASE("false claims about half branches are rejected where they stand") {
  const std::string text = crossing_text();
  const auto tubes = [](Json& j) {
    std::vector<Json*> result;
    for (Json& tube : j["tubes"])
      if (tube["curve"].get<std::string>().substr(0, 4) == "star") result.push_back(&tube);
    return result;
  };
  reason(text, "$.tubes[4]: names no star", [&](Json& j) { (*tubes(j)[0])["curve"] = "star7u+"; });
  reason(text, "$.tubes[4]: ", [&](Json& j) { (*tubes(j)[0])["curve"] = "star0r-"; });
  reason(text, "$.tubes[4].curve: must be a chart", [&](Json& j) { (*tubes(j)[0])["curve"] = "star0"; });
  reason(text, "$.tubes[4]: does not begin", [&](Json& j) {
    Json& tube = *tubes(j)[0];
    tube["centre"][std::string("uvrs").find(tube["axis"].get<std::string>())] = "1/2^40";
  });
  reason(text, "$.tubes[5]: may begin where", [&](Json& j) { *tubes(j)[1] = *tubes(j)[0]; });
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
  for (int k = 0; k < 40; ++k) {
    Json json = Json::parse(crossing_text());
    const std::string change = mutate(json, generator, true);
    INFO(change);
    REQUIRE(verdict(json.dump()) != "");
  }
}

TEST_CASE("a forged star is rejected, or says the same as the true one") {
  const Json truth = Json::parse(crossing_text());
  Generator generator(27);
  INFO("seed 27");
  int rejected = 0;
  for (int i = 0; i < 40; ++i) {
    Json json = truth;
    std::vector<Json*> leaves;
    collect(json["stars"], leaves, false);
    Json& leaf = *leaves[below(generator, leaves.size())];
    const std::string before = leaf.dump();
    change_leaf(leaf, generator);
    INFO(i << ": " << before << " changed to " << leaf.dump());
    seal_again(json);
    if (verdict(json.dump()) != "")
      ++rejected;
    else
      REQUIRE(json["summary"] == truth["summary"]);
  }
  CHECK(rejected > 20);
}

TEST_CASE("an event without a certificate is named") {
  const auto refusal = [](const ExactCase& c) -> std::string {
    try {
      certificate(c.x, c.y);
      return "";
    } catch (const cli::NoCertificate& reason) {
      return reason.what();
    }
  };
  const auto plane = families::Plane::square;
  CHECK(refusal(families::curve_cusp(plane)) == "a special point with degenerate quadratic terms");
  CHECK(refusal(families::shifted_copy()) == "an overlap");
  CHECK(refusal(families::tangent_curve(Rational(1, 3), plane)) == "an arc along which the patches touch");
}

}  // namespace exsect

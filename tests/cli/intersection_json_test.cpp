#include "output/text/intersection_json.h"

#include <exsect/geometry/number.h>

#include <limits>
#include <random>

#include "json_schema.h"
#include "sample_result.h"
#include "support/catch.h"

namespace exsect::cli::intersection_json_test {
namespace {

const PatchNames names = {"first \"quoted\"", "zweite"};

TEST_CASE("the JSON of a result has the documented form") {
  const std::string text = json_text(intersection_json(sample_result(), names));
  const nlohmann::json json = nlohmann::json::parse(text);
  CHECK(JsonSchema::named("intersection-1").violation(json) == "");
  CHECK(json["status"] == "incomplete");
  CHECK(json["first"] == "first \"quoted\"");
  CHECK(json["nodes"][0]["box"]["u"] == nlohmann::json({"0", "0"}));
  CHECK(json["nodes"][0]["box"]["v"] ==
        nlohmann::json({"274877906943/1099511627776", "274877906945/1099511627776"}));
  CHECK(json["nodes"][2]["kinds"] == nlohmann::json({"boundary", "corner"}));
  CHECK(json["nodes"][2]["on"] == nlohmann::json({"r=1", "s=1"}));
  CHECK(json["nodes"][3]["wrt"] == nlohmann::json({"u", "s"}));
  CHECK(json["nodes"][5]["kinds"] == nlohmann::json({"cusp", "end-of-overlap"}));
  CHECK(json["arcs"][0]["polyline"][1] == nlohmann::json({0.25, 0.625, 0.25, 0.7, 0.25, 0.625, 0.25 / 3}));
  CHECK(json["arcs"][2]["on"] == "patch-boundary");
  CHECK(json["arcs"][2]["contact"] == "tangential");
  CHECK(json["nodes"][3]["free"] == nlohmann::json::array());
  CHECK(json["nodes"][4]["free"] == nlohmann::json({"r"}));
  CHECK(json["nodes"][4]["box"]["r"] == nlohmann::json({"0", "1/2"}));
  CHECK(json["arcs"][2]["free"] == nlohmann::json({"s"}));
  CHECK(json["isolated_points"] == nlohmann::json({4}));
  CHECK(json["overlaps"][0]["chains"][0].size() == 2);
  CHECK(json["incomplete"][0]["where"]["u"] == nlohmann::json({"0", "1/8"}));
  CHECK(json["summary"] == nlohmann::json::parse(R"({"components": 2, "closed": 1, "open": 1, "branched": 0,
      "isolated": 1, "overlaps": 1, "turning": {"u": 1, "v": 1, "r": 0, "s": 1}, "boundary": 2})"));
  CHECK(json["work"] == nlohmann::json::parse(R"({"milliseconds": 12.5, "steps": {"tubes": 42}})"));
}

TEST_CASE("keys come in the documented order and equal results give equal text") {
  const std::string text = json_text(intersection_json(sample_result(), names));
  std::size_t last = 0;
  for (const char* key : {"exsect", "status", "first", "second", "nodes", "arcs", "components",
                          "isolated_points", "overlaps", "summary", "incomplete", "work"}) {
    const std::size_t at = text.find("\n \"" + std::string(key) + "\": ");
    CHECK(at != std::string::npos);
    CHECK(at >= last);
    last = at;
  }
  CHECK(text == json_text(intersection_json(sample_result(), names)));
}

TEST_CASE("an empty complete result is complete") {
  const nlohmann::json json = nlohmann::json::parse(
      json_text(intersection_json(IntersectResult{Status::complete, {}, {}, {}}, {"x", "y"})));
  CHECK(JsonSchema::named("intersection-1").violation(json) == "");
  CHECK(json["status"] == "complete");
  CHECK(json["nodes"].empty());
}

TEST_CASE("the schema refuses what is not the documented form") {
  const JsonSchema schema = JsonSchema::named("intersection-1");
  const nlohmann::json good = nlohmann::json::parse(json_text(intersection_json(sample_result(), names)));
  const auto refused = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json bad = good;
    bad[nlohmann::json::json_pointer(pointer)] = value;
    return !schema.violation(bad).empty();
  };
  CHECK(refused("/status", "unknown"));
  CHECK(refused("/extra", 1));
  CHECK(refused("/nodes/0/box/u/0", 0));
  CHECK(refused("/nodes/0/box/u/0", "1/0"));
  CHECK(refused("/nodes/0/kinds/0", "end_of_overlap"));
  CHECK(refused("/nodes/0/on", "u=0"));
  CHECK(refused("/nodes/0/free/0", "t"));
  CHECK(refused("/arcs/0/error_bound", "0"));
  CHECK(refused("/arcs/0/polyline/0", nlohmann::json({0, 0, 0, 0})));
  CHECK(refused("/summary/turning/u", -1));
}

TEST_CASE("an error bound is not rounded down by its decimal") {
  CHECK(decimal_not_below(0) == 0);
  // The double 0.1 is above 1/10, the double 0.3 below 3/10.
  CHECK(decimal_not_below(0.1) == std::nextafter(0.1, 1.0));
  CHECK(decimal_not_below(0.3) == 0.3);
  std::mt19937_64 random(20260713);
  std::uniform_real_distribution<double> exponent(-320, 300);
  for (int i = 0; i < 2000; ++i) {
    const double bound = std::pow(10.0, exponent(random));
    INFO("bound " << bound);
    const double shown = decimal_not_below(bound);
    CHECK(parse_number(Json(shown).dump()) >= from_double(bound));
    CHECK(shown <= std::nextafter(bound, std::numeric_limits<double>::infinity()));
  }
}

TEST_CASE("doubles are read back unchanged") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const double x = uniform(random);
    CHECK(nlohmann::json::parse(json_text(Json(x))).get<double>() == x);
  }
}

TEST_CASE("the text breaks lines only where they grow too long") {
  CHECK(json_text(Json::array({1, 2, 3})) == "[1,2,3]\n");
  CHECK(json_text(Json::object()) == "{}\n");
  const std::string word(120, 'w');
  CHECK(json_text(Json::array({word, word})) == "[\n \"" + word + "\",\n \"" + word + "\"\n]\n");
  CHECK(json_text(Json{{"a", {word, word}}, {"b", 1}}) ==
        "{\n \"a\": [\n  \"" + word + "\",\n  \"" + word + "\"\n ],\n \"b\": 1\n}\n");
}

}  // namespace
}  // namespace exsect::cli::intersection_json_test

// Certificates of lines.
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/line_patch.h>

#include "certificate/line.h"
#include "certificate_changes.h"

namespace exsect::certificate_line_test {
namespace {

using namespace certificates;

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
      CHECK(report.summary.claims[3] == solution.points.size());
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
    reject_changes(text, generator, 10);
  }
}

TEST_CASE("false claims about a line are rejected where they stand") {
  const auto patches = read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches;
  const std::string truth = line_text(patches[0].patch, patches[1].patch, Parameter::u, Rational(1, 2));
  const auto reason = [&](const char* where, auto change) {
    Json json = Json::parse(truth);
    REQUIRE(json["points"].size() == 2);
    change(json);
    json["summary"]["claims"] = {0, 0, json["tubes"].size(), json["points"].size(), 0, cells(json), 0};
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

}  // namespace exsect::certificate_line_test

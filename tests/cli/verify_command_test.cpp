#include <map>
#include <nlohmann/json.hpp>

#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::verify_command_test {
namespace {

using Json = nlohmann::json;

std::string candidate(const std::string& name) { return example("candidates/" + name + ".candidate.json"); }
std::string model(const std::string& name) { return example("candidates/" + name + ".json"); }

struct Judged {
  int status;
  Json verdict;
};

Judged judged(const std::string& name, const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments = {"verify", candidate(name), model(name), "--json",
                                        "-",      "--tolerance",   "1e-4"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_program(arguments);
  INFO(run.err);
  REQUIRE(run.status != 2);
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("verdict-1").violation(json) == "");
  return {run.status, json};
}

std::map<std::string, int> kinds(const Json& verdict) {
  std::map<std::string, int> result;
  for (const Json& difference : verdict.at("differences")) ++result[difference.at("kind")];
  return result;
}

}  // namespace

TEST_CASE("verify: candidates of other programs that are right") {
  for (const std::string name : {"sisl-right", "occt-right", "occt-section-right"}) {
    INFO(name);
    const Judged result = judged(name);
    CHECK(result.status == 0);
    CHECK(result.verdict.at("verdict") == "agrees");
    CHECK(result.verdict.at("differences").empty());
    for (const Json& curve : result.verdict.at("curves")) CHECK(curve.at("distance")[1] < 1e-4);
  }
}

TEST_CASE("verify: candidates of other programs that are wrong, with these reasons and no others") {
  struct Expected {
    std::string name;
    std::map<std::string, int> kinds;
  };
  const std::vector<Expected> all = {
      {"occt-curve-of-contact-lost", {{"lost-curve", 1}}},
      {"occt-loop-lost", {{"lost-curve", 1}}},
      {"occt-one-of-two-lost", {{"lost-curve", 1}}},
      {"occt-random-curve-lost", {{"lost-curve", 1}}},
      {"occt-section-bridge", {{"wrong-connection", 3}, {"spurious-curve", 3}}},
      {"occt-section-curves-as-points", {{"lost-curve", 2}, {"curve-as-points", 1}, {"false-point", 2}}},
      {"occt-section-false-points", {{"false-point", 2}}},
      {"occt-section-two-joined", {{"wrong-connection", 3}, {"spurious-curve", 3}, {"repeated", 2}}},
      {"occt-small-loop-lost", {{"lost-curve", 1}}},
      {"occt-touch-point-lost", {{"lost-point", 1}}},
      {"sisl-loop-as-points", {{"lost-curve", 1}, {"curve-as-points", 1}, {"point-on-curve", 2}}},
      {"sisl-loop-as-points-2", {{"lost-curve", 1}, {"curve-as-points", 1}, {"point-on-curve", 1}}},
      {"sisl-loop-as-points-3", {{"lost-curve", 1}, {"curve-as-points", 1}, {"point-on-curve", 1}}},
      {"sisl-loop-repeated", {{"repeated", 20}}},
      {"sisl-lost-curve", {{"lost-curve", 1}, {"curve-as-points", 1}, {"point-on-curve", 2}}},
      {"sisl-nearly-crossing-lost", {{"lost-curve", 2}, {"curve-as-points", 2}, {"point-on-curve", 4}}},
      {"sisl-parameter-curve-off", {{"spurious-curve", 1}}}};
  for (const Expected& expected : all) {
    INFO(expected.name);
    const Judged result = judged(expected.name);
    CHECK(result.status == 1);
    CHECK(result.verdict.at("verdict") == "disagrees");
    CHECK(kinds(result.verdict) == expected.kinds);
  }
}

TEST_CASE("verify: never agreement where the exact answer is incomplete") {
  const Judged result = judged("sisl-right", {"--max-seconds", "1e-9"});
  CHECK(result.status == 3);
  CHECK(result.verdict.at("status") == "incomplete");
  CHECK(result.verdict.at("exact") == "incomplete");
  CHECK_FALSE(result.verdict.at("undecided").empty());
}

TEST_CASE("verify: what exsect exports agrees with itself, in every format") {
  const ScratchDirectory scratch;
  const std::string obj = scratch.path("curves.obj");
  const std::string file = example("chapter9-first.json");
  REQUIRE(run_program({"intersect", file, "--tolerance", "1e-5", "--obj", obj, "--quiet"}).status == 0);
  const ProgramRun agrees = run_program({"verify", obj, file, "--tolerance", "1e-4"});
  CHECK(agrees.status == 0);
  CHECK(agrees.out.find("agrees\n  tolerance") != std::string::npos);
  // the same polylines as a table, in the parameters of the first patch
  const Json result = Json::parse(run_program({"intersect", file, "--tolerance", "1e-5", "--json", "-"}).out);
  std::string table = "curve,u,v\n";
  std::string splines;
  for (const Json& arc : result.at("arcs")) {
    const Json& line = arc.at("polyline");
    std::string knots = "0";
    std::string points;
    for (std::size_t i = 0; i < line.size(); ++i) {
      table += arc.at("id").dump() + "," + line[i][0].dump() + "," + line[i][1].dump() + "\n";
      knots += " " + std::to_string(i);
      for (std::size_t k = 4; k < 7; ++k) points += line[i][k].dump() + (k < 6 ? " " : "\n");
    }
    splines += "100 1 0 0\n3 0\n" + std::to_string(line.size()) + " 2\n" + knots + " " +
               std::to_string(line.size() - 1) + "\n" + points;
  }
  write(scratch.path("curves.csv"), table);
  write(scratch.path("curves.g2"), splines);
  for (const std::string name : {"curves.csv", "curves.g2"}) {
    const ProgramRun run = run_program({"verify", scratch.path(name), file, "--tolerance", "1e-4"});
    INFO(name << run.out << run.err);
    CHECK(run.status == 0);
  }
}

TEST_CASE("verify: the summary tells both tolerances and one line of a difference in three representations") {
  const std::string bridge = example("candidates/occt-section-bridge");
  const ProgramRun run =
      run_program({"verify", bridge + ".candidate.json", bridge + ".json", "--tolerance", "1e-4"});
  CHECK(
      run.out.find("disagrees: 2 differences\n"
                   "  tolerance 1e-4 of the size of the model: 2.24e-04 in the unit of its control points\n"
                   "  largest distance of the curves given, proved: 0.000548 to 5.76e-04\n"
                   "  spurious-curve: curve 2 is no intersection, vertices 14 to 50 in space, (u,v), (r,s), "
                   "from near (") != std::string::npos);
  CHECK(run.out.find(
            "  wrong-connection: curve 2 joins component 0 to component 1, vertices 12 to 52 in space, "
            "(u,v), (r,s), from near (") != std::string::npos);
  const std::string right = example("candidates/sisl-right");
  CHECK(
      run_program({"verify", right + ".candidate.json", right + ".json", "--tolerance", "1e-4"})
          .out.find("agrees\n"
                    "  tolerance 1e-4 of the size of the model: 2.14e-04 in the unit of its control points\n"
                    "  largest distance, proved: at most 4.47e-05\n") != std::string::npos);
}

TEST_CASE("verify: a difference has a place") {
  for (const auto& [name, words] :
       {std::pair{"occt-loop-lost", "lost-curve: component 0 (closed) is missing, through near ("},
        std::pair{"occt-touch-point-lost", "lost-point: isolated point 0 is not claimed, near ("},
        std::pair{"occt-section-false-points", "false-point: point 1 is no intersection, near ("},
        std::pair{"sisl-loop-repeated", "repeated: curves 0 and 2 both run along arc 0, in 3 places\n"}}) {
    const std::string pair = example(std::string("candidates/") + name);
    const ProgramRun run =
        run_program({"verify", pair + ".candidate.json", pair + ".json", "--tolerance", "1e-4"});
    INFO(run.out);
    CHECK(run.out.find(words) != std::string::npos);
  }
}

TEST_CASE("verify: picture and page mark the differences") {
  const ScratchDirectory scratch;
  const std::string svg = scratch.path("picture.svg");
  const std::string page = scratch.path("page.html");
  const auto drawn = [&](const std::string& name) {
    run_program(
        {"verify", candidate(name), model(name), "--tolerance", "1e-4", "--svg", svg, "--report", page});
    return content(svg);
  };
  const std::string right = drawn("sisl-right");
  CHECK(right.find(">candidate<") != std::string::npos);
  CHECK(right.find("not covered") == std::string::npos);
  const std::string wrong = drawn("sisl-lost-curve");
  CHECK(wrong.find("not covered by the candidate") != std::string::npos);
  const std::string text = content(page);
  const std::size_t data = text.find("id=\"data\"");
  REQUIRE(data != std::string::npos);
  const std::size_t from = text.find('>', data) + 1;
  const Json json = Json::parse(text.substr(from, text.find("</script>", from) - from));
  CHECK(json.at("result").at("verdict") == "disagrees");
  CHECK(JsonSchema::named("verdict-1").violation(json.at("result")) == "");
  CHECK(JsonSchema::named("intersection-1").violation(json.at("graph")) == "");
  CHECK_FALSE(json.at("gaps").empty());
  CHECK(json.at("candidate").at("points").size() == 2);
}

TEST_CASE("verify: bad input") {
  const ScratchDirectory scratch;
  const std::string file = model("sisl-right");
  const auto refused = [&](const std::string& name, const std::string& text, const std::string& word) {
    write(scratch.path(name), text);
    const ProgramRun run = run_program({"verify", scratch.path(name), file});
    INFO(name << ": " << run.err);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err.find(word) != std::string::npos);
  };
  refused("a.json", R"({"exsect": "candidate/1", "patches": ["x", "q"], "curves": []})",
          "no patch is named \"q\"");
  refused("a.json", R"({"exsect": "candidate/1", "patches": ["x", "y"], "curves": [)", "a.json");
  refused("a.csv", "x,y,z\n0,0,nan\n", "line 2");
  refused("a.obj", "l 1 2\n", "does not exist");
  refused("a.g2", "100 1 0 0\n3 0\n4", "ends where");
  refused("a.stp", "", ".json, .csv, .obj or .g2");
  CHECK(run_program({"verify", "/no/such/file.json", file}).status == 2);
  CHECK(run_program({"verify", candidate("sisl-right"), "/no/such/file.json"}).status == 2);
  CHECK(run_program({"verify", candidate("sisl-right")}).status == 2);
  CHECK(run_program({"verify", candidate("sisl-right"), file, "--tolerance", "0"}).status == 2);
  CHECK(run_program({"verify", candidate("sisl-right"), file, "--json", candidate("sisl-right")}).status ==
        2);
}

TEST_CASE("verify: a surface given by its equation, in either order") {
  const ScratchDirectory scratch;
  const std::string file = example("surfaces.json"), path = scratch.path("claims.json");
  const Json found = Json::parse(
      run_program({"intersect", file, "--first", "saddle", "--second", "torus", "--json", "-"}).out);
  Json claims = {{"exsect", "candidate/1"}, {"patches", {"torus", "saddle"}}, {"curves", Json::array()}};
  for (const Json& arc : found.at("arcs")) {
    Json space = Json::array(), square = Json::array();
    for (const Json& v : arc.at("polyline")) {
      space.push_back({v[2], v[3], v[4]});
      square.push_back({v[0], v[1]});
    }
    claims["curves"].push_back({{"points", space}, {"second", square}});
  }
  write(path, claims.dump());
  const ProgramRun run = run_program(
      {"verify", path, file, "--tolerance", "1e-4", "--json", "-", "--svg", scratch.path("verdict.svg")});
  INFO(run.err);
  CHECK(run.status == 0);
  const Json verdict = Json::parse(run.out);
  CHECK(JsonSchema::named("verdict-1").violation(verdict) == "");
  CHECK(verdict.at("verdict") == "agrees");
  CHECK(verdict.at("first") == "saddle");
  CHECK(verdict.at("second") == "torus");
  CHECK(run_program({"verify", path, file, "--tolerance", "1e-4"}).out.find("agrees") != std::string::npos);
  // As parameters of the torus, which has none.
  CHECK(run_program({"verify", path, file, "--first", "saddle", "--second", "torus"})
            .err.find("\"torus\" is given by its equation: it has no parameters") != std::string::npos);
  const std::string page = scratch.path("page.html");
  CHECK(run_program({"verify", path, file, "--tolerance", "1e-4", "--report", page}).status == 0);
  CHECK(content(page).find("Agrees, proved.") != std::string::npos);
  claims["curves"] = Json::array({claims["curves"][0]});
  write(path, claims.dump());
  const std::string lost = scratch.path("lost.svg");
  CHECK(run_program({"verify", path, file, "--tolerance", "1e-4", "--svg", lost, "--report", page}).status ==
        1);
  CHECK(content(lost).find("not covered by the candidate") != std::string::npos);
}

TEST_CASE("verify: two surfaces given by their equations") {
  const ScratchDirectory scratch;
  const std::string file = example("surfaces.json"), path = scratch.path("claims.json");
  const Json found = Json::parse(
      run_program({"intersect", file, "--first", "torus", "--second", "oblique", "--json", "-"}).out);
  Json claims = {{"exsect", "candidate/1"}, {"patches", {"torus", "oblique"}}, {"curves", Json::array()}};
  for (const Json& arc : found.at("arcs")) claims["curves"].push_back({{"points", arc.at("polyline")}});
  write(path, claims.dump());
  const auto verify = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"verify", path, file, "--tolerance", "1e-4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  };
  const ProgramRun run = verify({});
  INFO(run.err);
  CHECK(run.status == 0);
  CHECK(run.out.find("agrees\n  tolerance 1e-4 of the size of what is common: ") != std::string::npos);
  claims["curves"].erase(0);
  write(path, claims.dump());
  const ProgramRun wrong = verify({"--json", "-"});
  CHECK(wrong.status == 1);
  const Json verdict = Json::parse(wrong.out);
  CHECK(JsonSchema::named("verdict-1").violation(verdict) == "");
  const Json& gap = verdict.at("differences")[0];
  CHECK(gap.at("kind") == "gap");
  CHECK(gap.at("gap").size() == 1);
  CHECK(gap.at("gap").at("vertices")[0] == 0);
  CHECK(verify({}).out.find("gap: a part of arc 0 is not covered, vertices 0 to ") != std::string::npos);
  const auto refused = [&](const std::vector<std::string>& more, const std::string& word) {
    const ProgramRun failed = verify(more);
    CHECK(failed.status == 2);
    INFO(failed.err);
    CHECK(failed.err.find(word) != std::string::npos);
  };
  const std::string svg = scratch.path("picture.svg"), page = scratch.path("page.html");
  CHECK(verify({"--svg", svg, "--report", page}).status == 1);
  for (const char* words : {"not covered by the candidate", ">candidate<", ">curve<"})
    CHECK(content(svg).find(words) != std::string::npos);
  CHECK(content(page).find("Disagrees, proved.") != std::string::npos);
  claims["curves"][0]["first"] = claims["curves"][0]["points"];
  for (Json& p : claims["curves"][0]["first"]) p = {0.5, 0.5};
  write(path, claims.dump());
  refused({}, "\"torus\" and \"oblique\" are given by their equations: the candidate has parameters");
  write(path, R"({"exsect": "candidate/1", "patches": ["floor", "wall"], "curves": [], "points": []})");
  const std::string planes = scratch.path("planes.json");
  write(planes, R"({"exsect": "patches/1", "patches": [
    {"name": "floor", "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1]},
    {"name": "wall", "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}]})");
  const ProgramRun unbounded = run_program({"verify", path, planes});
  CHECK(unbounded.status == 2);
  CHECK(unbounded.err.find("a common curve goes on to infinity") != std::string::npos);
}

}  // namespace exsect::verify_command_test

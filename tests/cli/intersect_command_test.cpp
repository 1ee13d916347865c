// exsect intersect, end to end.
#include <exsect/geometry/number.h>

#include <cmath>
#include <sstream>

#include "json_schema.h"
#include "run_program.h"
#include "support/catch.h"

namespace exsect::intersect_command_test {
namespace {

using Json = nlohmann::json;

const std::string first = example("chapter9-first.json");

Json intersection(const std::vector<std::string>& arguments, int status = 0) {
  std::vector<std::string> all = {"intersect"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--json", "-"});
  const ProgramRun run = run_program(all);
  INFO(run.err);
  CHECK(run.status == status);
  CHECK(run.err.empty());
  const Json json = Json::parse(run.out);
  CHECK(JsonSchema::named("intersection-1").violation(json) == "");
  CHECK(json["status"] == (status == 0 ? "complete" : "incomplete"));
  return json;
}

double coordinate(const Json& node, const char* parameter) { return node["approx"][parameter].get<double>(); }

/// Nodes that turn with respect to p, or lie on a side, have the values of the independent computation.
void check_against_reference(const Json& json, const Json& reference) {
  for (const Json& segment : reference["segments"]) {
    std::vector<Json> points;
    for (const Json& point : segment["turning"]) points.push_back(point);
    for (const Json& point : segment["boundary"]) points.push_back(point);
    for (const Json& point : points) {
      INFO(point.dump());
      int found = 0;
      for (const Json& node : json["nodes"]) {
        const Json& labels = point.contains("wrt") ? node["wrt"] : node["on"];
        if (labels != Json::array({point.contains("wrt") ? point["wrt"] : point["on"]})) continue;
        double distance = 0;
        for (int i = 0; i < 4; ++i) {
          const double expected = std::stod(point["uvrs"][static_cast<std::size_t>(i)].get<std::string>());
          distance = std::max(
              distance, std::abs(expected - coordinate(node, std::array{"u", "v", "r",
                                                                        "s"}[static_cast<std::size_t>(i)])));
        }
        if (distance < 5e-14) ++found;
      }
      CHECK(found == 1);
    }
  }
}

TEST_CASE("the first example is complete and agrees with the independent computation") {
  const Json json = intersection({first});
  CHECK(json["first"] == "x");
  CHECK(json["summary"] ==
        Json::parse(R"({"components": 2, "closed": 1, "open": 1, "branched": 0, "isolated": 0,
      "overlaps": 0, "turning": {"u": 2, "v": 3, "r": 3, "s": 2}, "boundary": 2})"));
  CHECK(json["nodes"].size() == 12);
  check_against_reference(json,
                          Json::parse(content(std::string(EXSECT_CASES) + "/chapter9-first.expected.json")));
}

TEST_CASE("the graph that is written is consistent") {
  const Json json = intersection({first});
  for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
    const Json& node = json["nodes"][i];
    CHECK(node["id"] == i);
    for (const char* p : {"u", "v", "r", "s"}) {
      const Rational lower = parse_number(node["box"][p][0].get<std::string>());
      const Rational upper = parse_number(node["box"][p][1].get<std::string>());
      CHECK(lower <= upper);
      CHECK(std::abs(coordinate(node, p) - to_double(lower)) < 1e-9);
    }
  }
  for (const Json& arc : json["arcs"]) {
    for (const char* end : {"from", "to"}) {
      const Json& node = json["nodes"][arc[end].get<std::size_t>()];
      const Json& vertex = std::string(end) == "from" ? arc["polyline"].front() : arc["polyline"].back();
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(std::abs(vertex[i].get<double>() - coordinate(node, std::array{"u", "v", "r", "s"}[i])) < 1e-6);
      }
    }
    CHECK(arc["error_bound"].get<double>() <= 1e-6);
  }
}

TEST_CASE("the second example has three open components") {
  const Json json = intersection({example("chapter9-second.json"), "--tolerance", "1/1000"});
  CHECK(json["summary"]["components"] == 3);
  CHECK(json["summary"]["open"] == 3);
}

TEST_CASE("exchanged patches give the same graph") {
  const Json json = intersection({first, "--first", "y"});
  CHECK(json["first"] == "y");
  CHECK(json["second"] == "x");
  CHECK(json["summary"]["turning"] == Json::parse(R"({"u": 3, "v": 2, "r": 2, "s": 3})"));
  CHECK(intersection({first, "--second", "x"})["first"] == "y");
}

TEST_CASE("turning points are nodes only where asked for") {
  // A closed curve without any other node keeps turning points: every component has nodes.
  const Json none = intersection({first, "--turning", "none"});
  for (const Json& node : none["nodes"]) CHECK((node["kinds"] == Json({"boundary"})) == !node["on"].empty());
  for (const Json& component : none["components"])
    CHECK((component["shape"] == "closed" || component["arcs"].size() == 1));
  const Json some = intersection({first, "--turning", "s,u"});
  CHECK(some["summary"]["turning"] == Json::parse(R"({"u": 2, "v": 0, "r": 0, "s": 2})"));
}

TEST_CASE("files and standard output hold the same result") {
  const ScratchDirectory scratch;
  const ProgramRun run =
      run_program({"intersect", first, "--json", scratch.path("a.json"), "--svg", scratch.path("a.svg")});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK(run.out.find("x with y: complete, proved: 2 components (1 open, 1 closed)\n") != std::string::npos);
  CHECK(run.out.find("First example: one closed loop and one open arc") != std::string::npos);
  CHECK(scratch.number_of_files() == 2);
  Json written = Json::parse(content(scratch.path("a.json")));
  Json printed = intersection({first});
  written.erase("work");
  printed.erase("work");
  CHECK(written == printed);
  const std::string svg = content(scratch.path("a.svg"));
  CHECK(svg.find("component 1, closed") != std::string::npos);
  CHECK(svg.size() < 200000);
}

TEST_CASE("every digit of a node in the summary is proved by its box") {
  for (const std::string name : {"chapter9-first.json", "chapter9-second.json", "touching-curve.json"}) {
    for (const std::string more : {"--verbose", "--turning=u,v,r,s"}) {
      const Json json = intersection({example(name)});
      const ProgramRun run = run_program({"intersect", example(name), more});
      std::istringstream lines(run.out);
      std::string line;
      while (std::getline(lines, line) && line.find("turns in") == std::string::npos) {
      }
      for (const Json& node : json["nodes"]) {
        REQUIRE(std::getline(lines, line));
        std::istringstream words(line);
        const std::vector<std::string> cells{std::istream_iterator<std::string>(words), {}};
        REQUIRE(cells.size() >= 11);
        for (std::size_t k = 0; k < 4; ++k) {
          const std::string shown = cells[cells.size() - 7 + k];
          const std::size_t point = shown.find('.');
          const auto decimals = point == std::string::npos ? 0 : shown.size() - point - 1;
          const Rational half = parse_number("0.5e-" + std::to_string(decimals));
          INFO(name << " node " << node["id"] << " "
                    << "uvrs"[k] << " = " << shown);
          for (const Json& end : node["box"][std::string(1, "uvrs"[k])])
            CHECK(abs(Rational(parse_number(end.get<std::string>()) - parse_number(shown))) <= half);
        }
      }
    }
  }
}

TEST_CASE("the summary says which arithmetic decided, and counts only where it is asked for") {
  const std::string plain = run_program({"intersect", first}).out;
  CHECK(plain.find(" ms, in doubles with proved error bounds\n") != std::string::npos);
  CHECK(plain.find("in the unit of the control points\n") != std::string::npos);
  CHECK(plain.find("tubes") == std::string::npos);
  CHECK(run_program({"intersect", first, "--verbose"}).out.find("tubes") != std::string::npos);
  CHECK(run_program({"intersect", first, "--exact"}).out.find(" ms, in exact arithmetic\n") !=
        std::string::npos);
}

TEST_CASE("quiet prints nothing") {
  const ProgramRun run = run_program({"intersect", first, "--quiet"});
  CHECK(run.status == 0);
  CHECK(run.out.empty());
  CHECK(run.err.empty());
}

TEST_CASE("an existing file is replaced whole and a link is followed") {
  const ScratchDirectory scratch;
  write(scratch.path("old.json"), std::string(1000000, 'x'));
  std::filesystem::create_symlink(scratch.path("old.json"), scratch.path("link.json"));
  CHECK(run_program({"line", first, "--u", "0", "--json", scratch.path("link.json")}).status == 0);
  CHECK(std::filesystem::is_symlink(scratch.path("link.json")));
  CHECK(Json::parse(content(scratch.path("old.json")))["exsect"] == "line/1");
  CHECK(scratch.number_of_files() == 2);
}

TEST_CASE("what is not decided is incomplete with place and reason, exit status 3") {
  const ScratchDirectory scratch;
  // In the corner u = v = 0, r = 1, s = 0 all derivatives of y are on one line.
  const std::string file = scratch.path("corner.json");
  write(file, R"({"exsect": "patches/1", "patches": [
    {"name": "x", "degree": [2,3], "points": [[[-1,-1,0],[-1,1,1],[1,0,0],[-1,-1,1]],
      [[-1,1,1],[-1,-1,0],[0,0,1],[0,0,1]], [[-1,-1,1],[0,-1,1],[1,0,0],[-1,-1,0]]]},
    {"name": "y", "degree": [1,3], "points": [[[-1,1,1],[-1,-1,0],[-1,-1,0],[1,0,0]],
      [[-1,-1,0],[-1,-1,0],[-1,-1,0],[-1,-1,1]]]}]})");
  const Json json = intersection({file, "--max-seconds", "5"}, 3);
  CHECK_FALSE(json["incomplete"].empty());
  const ProgramRun run =
      run_program({"intersect", file, "--max-seconds", "5", "--svg", scratch.path("a.svg")});
  CHECK(run.status == 3);
  CHECK(run.out.find("x with y: incomplete") != std::string::npos);
  CHECK(run.out.find("Not decided:\n  u in [") != std::string::npos);
  CHECK(content(scratch.path("a.svg")).find("not decided") != std::string::npos);
}

TEST_CASE("a cap on the time ends as incomplete") {
  const Json json = intersection({first, "--max-seconds", "1e-9"}, 3);
  REQUIRE_FALSE(json["incomplete"].empty());
  CHECK(json["incomplete"][0]["reason"] == "time");
}

}  // namespace
}  // namespace exsect::intersect_command_test

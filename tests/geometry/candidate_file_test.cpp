#include <exsect/geometry/candidate_file.h>

#include "support/catch.h"

namespace exsect::candidate_file_test {
namespace {

Candidate parsed(const std::string& text, CandidateFormat format) {
  return parse_candidate(text, "file", format);
}

/// The refusal's words.
std::string refusal(const std::string& text, CandidateFormat format) {
  try {
    parse_candidate(text, "file", format);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string head = R"({"exsect": "candidate/1", "patches": ["x", "y"], "curves": )";

}  // namespace

TEST_CASE("candidate file: JSON with polylines, splines and points") {
  const Candidate candidate = parsed(head + R"([
    {"points": [[0, 0.1, 0], [1, 0, 0]], "first": [[0, 0], [1, 1]], "closed": true, "contact": "tangential"},
    {"second": {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[0, 0], [1, 0], [1, 1]], "weights": [1, 2, 1]}}],
    "points": [{"first": [0.5, 0.5]}], "source": "by hand"})",
                                     CandidateFormat::json);
  CHECK(candidate.patches == std::array<std::string, 2>{"x", "y"});
  CHECK(candidate.source == "by hand");
  REQUIRE(candidate.curves.size() == 2);
  CHECK(candidate.curves[0].space->points[0] == std::array<double, 3>{0, 0.1, 0});
  CHECK(candidate.curves[0].space->from() == 0);
  CHECK(candidate.curves[0].space->to() == 1);
  CHECK(candidate.curves[0].first->points.size() == 2);
  CHECK_FALSE(candidate.curves[0].second);
  CHECK(candidate.curves[0].closed);
  CHECK(candidate.curves[0].tangential == true);
  CHECK(candidate.curves[1].second->weights == std::vector<double>{1, 2, 1});
  CHECK_FALSE(candidate.curves[1].tangential);
  CHECK((*candidate.points.at(0).first)[1] == 0.5);
}

TEST_CASE("candidate: of the pair in the other order") {
  const Candidate given = parsed(head + R"([
    {"points": [[0, 0, 0], [1, 0, 0]], "first": [[0, 0], [1, 1]]}, {"second": [[0, 0.25], [1, 1]]}],
    "points": [{"first": [0.5, 0.25]}, {"point": [1, 2, 3]}]})",
                                 CandidateFormat::json);
  const Candidate other = exchanged(given);
  CHECK(other.patches == given.patches);
  CHECK(other.curves[0].space == given.curves[0].space);
  CHECK_FALSE(other.curves[0].first);
  CHECK(other.curves[0].second == given.curves[0].first);
  CHECK(other.curves[1].first == given.curves[1].second);
  CHECK_FALSE(other.points[0].first);
  CHECK(other.points[0].second == given.points[0].first);
  CHECK(other.points[1].point == given.points[1].point);
  CHECK(exchanged(other).curves[0].first == given.curves[0].first);
}

TEST_CASE("candidate file: JSON that is refused, with the place") {
  const auto refused = [](const std::string& curves) {
    return refusal(head + curves + "}", CandidateFormat::json);
  };
  CHECK(contains(refused("[{}]"), "$.curves[0]: one of"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0]]}])"), "at least 2 vertices"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0], [1, 1]]}])"), "$.curves[0].points[1]"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0], [1, 1, NaN]]}])"), "file"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0], [1, 1, "nan"]]}])"), "is not a number"));
  CHECK(contains(refused(R"([{"first": [[0, 0], [1, 2.5]]}])"), "[-1,2]"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0], [1, 1, 1]], "first": [[0, 0], [1, 1], [0, 0]]}])"),
                 "same length"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0], [1, 1, 1]], "closed": 1}])"), "true or false"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0], [1, 1, 1]], "contact": "close"}])"), "tangential"));
  CHECK(contains(refused(R"([{"points": [[0, 0, 0], [1, 1, 1]], "colour": 1}])"), "unknown key"));
  const auto spline = [&](const std::string& rest) {
    return refused(R"([{"points": {"degree": 2, )" + rest + "}}]");
  };
  const std::string three = R"("points": [[0, 0, 0], [1, 1, 1], [2, 0, 0]])";
  CHECK(contains(spline(R"("knots": [0, 0, 0, 1, 1], )" + three), "6 knots"));
  CHECK(contains(spline(R"("knots": [0, 0, 0, 1, 0, 1], )" + three), "ascend"));
  CHECK(contains(spline(R"("knots": [0, 0, 0, 0, 0, 0], )" + three), "empty"));
  CHECK(contains(spline(R"("knots": [0, 0, 0, 1, 1, 1], "weights": [1, 0, 1], )" + three), "> 0"));
  CHECK(contains(spline(R"("knots": [0, 0, 0, 1, 1, 1], "weights": [1, 1], )" + three), "as many weights"));
  CHECK(contains(refusal(head + "[", CandidateFormat::json), "file"));
  CHECK(contains(
      refusal(R"({"exsect": "candidate/2", "patches": ["x", "y"], "curves": []})", CandidateFormat::json),
      "version"));
  CHECK(
      contains(refusal(R"({"exsect": "candidate/1", "patches": ["x"], "curves": []})", CandidateFormat::json),
               "2 names"));
}

TEST_CASE("candidate file: CSV") {
  const Candidate candidate =
      parsed("curve,u,v,x,y,z\r\n1, 0,0 ,0,0,0\n1,1,1,1,1,1\n2,0,1,0,1,0\n\n3,0,0,0,0,0\n3,1,0,1,0,0\n",
             CandidateFormat::csv);
  REQUIRE(candidate.curves.size() == 2);
  CHECK(candidate.curves[0].first->points[1] == std::array<double, 3>{1, 1, 0});
  CHECK(candidate.curves[1].space->points[1] == std::array<double, 3>{1, 0, 0});
  REQUIRE(candidate.points.size() == 1);
  CHECK(candidate.points[0].first == std::array<double, 2>{0, 1});
  const auto refused = [](const std::string& text) { return refusal(text, CandidateFormat::csv); };
  CHECK(contains(refused(""), "names of the columns"));
  CHECK(contains(refused("x,y\n"), "together"));
  CHECK(contains(refused("u,r\n"), "together"));
  CHECK(contains(refused("curve\n"), "no coordinates"));
  CHECK(contains(refused("x,y,z,w\n"), "unknown column"));
  CHECK(contains(refused("x,y,z,x\n"), "twice"));
  CHECK(contains(refused("x,y,z\n0,0\n"), "line 2: has 2 cells"));
  CHECK(contains(refused("x,y,z\n0,0,inf\n"), "line 2"));
  CHECK(contains(refused("u,v\n0,3\n"), "[-1,2]"));
  CHECK(parsed("x,y,z\n", CandidateFormat::csv).curves.empty());
}

TEST_CASE("candidate file: OBJ") {
  const Candidate candidate =
      parsed("# made by hand\no line\nv 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 -1\nv 5 5 5\np 4 1\nf 1 2 3\n",
             CandidateFormat::obj);
  REQUIRE(candidate.curves.size() == 1);
  CHECK(candidate.curves[0].space->points.size() == 3);
  CHECK(candidate.curves[0].space->points[2] == std::array<double, 3>{1, 1, 0});
  REQUIRE(candidate.points.size() == 1);  // vertex 1 is an end of the line
  CHECK(candidate.points[0].point == std::array<double, 3>{5, 5, 5});
  const auto refused = [](const std::string& text) { return refusal(text, CandidateFormat::obj); };
  CHECK(contains(refused(""), "no vertex"));
  CHECK(contains(refused("v 0 0\n"), "line 1"));
  CHECK(contains(refused("v 0 0 nan\n"), "line 1"));
  CHECK(contains(refused("v 0 0 0\nl 1\n"), "at least 2"));
  CHECK(contains(refused("v 0 0 0\nl 1 2\n"), "vertex 2 does not exist"));
  CHECK(contains(refused("v 0 0 0\nl 1 0\n"), "vertex 0 does not exist"));
  CHECK(contains(refused("v 0 0 0\nl 1 x\n"), "whole number"));
  CHECK(contains(refused("curve 1\n"), "unknown element"));
}

TEST_CASE("candidate file: g2") {
  const Candidate candidate = parsed(
      "100 1 0 0\n3 1\n3 3\n0 0 0 1 1 1\n1 0 0 1\n2 2 0 2\n0 1 0 1\n"
      "100 1 0 0 4 0 2 2 0 0 1 1 0 0 0.5 0.5 1 1 0.5 1\n400 1 0 4 255 0 0 255\n1\n1 2 3\n",
      CandidateFormat::g2);
  REQUIRE(candidate.curves.size() == 2);
  CHECK(candidate.curves[0].space->degree == 2);
  CHECK(candidate.curves[0].space->points[1] == std::array<double, 3>{1, 1, 0});  // divided by its weight
  CHECK(candidate.curves[0].space->weights == std::vector<double>{1, 2, 1});
  CHECK(candidate.curves[1].second->points[1] == std::array<double, 3>{0.5, 1, 0});
  CHECK(candidate.points.at(0).point == std::array<double, 3>{1, 2, 3});
  const auto refused = [](const std::string& text) { return refusal(text, CandidateFormat::g2); };
  CHECK(contains(refused(""), "nothing"));
  CHECK(contains(refused("200 1 0 0\n"), "class type 200"));
  CHECK(contains(refused("100 1 0 0\n3 0\n2 2\n0 0 1 1\n0 0 0\n1 1"), "ends where a coordinate"));
  CHECK(contains(refused("100 1 0 0\n3 0\n1 2\n"), "order"));
  CHECK(contains(refused("100 1 0 0\n5 0\n"), "dimension"));
  CHECK(contains(refused("100 1 0 0\n3 0\n2 2\n0 1 0 1\n0 0 0\n1 1 1"), "ascend"));
  CHECK(contains(refused("100 1 0 0\n3 0\n2 2\n0 0 1 1\n0 0 0\n1 1 nan"), "line 6"));
  CHECK(contains(refused("100 1 0 0\n3 1\n2 2\n0 0 1 1\n0 0 0 0\n1 1 1 1"), "weight"));
}

TEST_CASE("candidate file: the name tells the format") {
  CHECK(candidate_format("a.b/c.JSON") == CandidateFormat::json);
  CHECK(candidate_format("c.g2") == CandidateFormat::g2);
  CHECK_THROWS_AS(candidate_format("curves.step"), InputError);
  CHECK_THROWS_AS(candidate_format("curves"), InputError);
  CHECK_THROWS_AS(read_candidate("/no/such/file.csv"), InputError);
}

}  // namespace exsect::candidate_file_test

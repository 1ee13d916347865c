// Candidates made from the proved result and then changed on purpose.
#include "candidates.h"
#include "support/catch.h"

namespace exsect::verify_changed_test {

using namespace candidates;

TEST_CASE("verify: what was changed on purpose is found") {
  const Subject pair = example("chapter9-first.json");
  const IntersectResult exact = fine(pair);
  const Candidate right = candidate_of(exact.graph);
  const double tolerance = 1e-4 * extent(pair);
  const std::size_t loop =
      right.curves[0].space->points.front() == right.curves[0].space->points.back() ? 0 : 1;
  const std::size_t open = 1 - loop;

  SECTION("a curve left out") {
    for (const std::size_t left_out : {loop, open}) {
      Candidate wrong = right;
      wrong.curves.erase(wrong.curves.begin() + static_cast<std::ptrdiff_t>(left_out));
      const Verdict verdict = verdict_of(wrong, pair);
      INFO(text(verdict));
      CHECK(verdict.agreement == Agreement::disagrees);
      REQUIRE(verdict.differences.size() == 1);
      CHECK(verdict.differences[0].kind == DifferenceKind::lost_curve);
      CHECK(verdict.differences[0].components == std::vector<int>{static_cast<int>(left_out)});
    }
  }
  SECTION("shifted by half a tolerance and by two") {
    for (const std::array<double, 3>& direction :
         {std::array<double, 3>{1, 0, 0}, std::array<double, 3>{0, 1, 0},
          std::array<double, 3>{0.6, 0, 0.8}}) {
      const auto by = [&](double factor) {
        return std::array<double, 3>{factor * tolerance * direction[0], factor * tolerance * direction[1],
                                     factor * tolerance * direction[2]};
      };
      CHECK(text(verdict_of(shifted(right, by(0.5)), pair)) == "agrees");
      const Verdict off = verdict_of(shifted(right, by(2)), pair);
      CHECK(off.agreement == Agreement::disagrees);
      CHECK(has(off, DifferenceKind::spurious_curve));
      for (const CurveFinding& curve : off.curves) {
        CHECK(curve.distance.upper <= 2.3 * tolerance);
        CHECK(curve.distance.lower >= tolerance);
      }
    }
  }
  SECTION("two curves joined") {
    Candidate wrong = right;
    Vertices& points = wrong.curves[open].space->points;
    points.insert(points.end(), right.curves[loop].space->points.begin(),
                  right.curves[loop].space->points.end());
    renumber(*wrong.curves[open].space);
    wrong.curves.erase(wrong.curves.begin() + static_cast<std::ptrdiff_t>(loop));
    const Verdict verdict = verdict_of(wrong, pair);
    INFO(text(verdict));
    CHECK(verdict.agreement == Agreement::disagrees);
    CHECK(has(verdict, DifferenceKind::wrong_connection));
    CHECK(has(verdict, DifferenceKind::spurious_curve));
    CHECK_FALSE(has(verdict, DifferenceKind::lost_curve));
  }
  SECTION("a curve split: at one vertex it is the same curve, with a piece left out it is not") {
    const Vertices& all = right.curves[open].space->points;
    const auto middle = static_cast<std::ptrdiff_t>(all.size() / 2);
    for (const std::ptrdiff_t left_out : {0, 6}) {
      Candidate wrong = right;
      wrong.curves[open].space = polyline({all.begin(), all.begin() + middle + 1});
      wrong.curves.push_back(wrong.curves[open]);
      wrong.curves.back().space = polyline({all.begin() + middle + left_out, all.end()});
      const Verdict verdict = verdict_of(wrong, pair);
      INFO(text(verdict));
      CHECK(verdict.agreement == (left_out == 0 ? Agreement::agrees : Agreement::disagrees));
      CHECK(has(verdict, DifferenceKind::split) == (left_out != 0));
      CHECK(has(verdict, DifferenceKind::gap) == (left_out != 0));
      if (left_out == 0) continue;
      const auto gap =
          std::find_if(verdict.differences.begin(), verdict.differences.end(), [](const Difference& d) {
            return d.gap.has_value();
          })->gap.value();
      // the ends of what was left out, in the parameter that the gap names
      const auto line = lines_of(exact.graph)[open];
      const std::size_t k = index(*gap.parameter);
      double from = line[static_cast<std::size_t>(middle)].parameters[k];
      double to = line[static_cast<std::size_t>(middle + left_out)].parameters[k];
      double gap_from = to_double(gap.from);
      double gap_to = to_double(gap.to);
      if (from > to) std::swap(from, to);
      if (gap_from > gap_to) std::swap(gap_from, gap_to);
      CHECK(from <= gap_from);
      CHECK(gap_to <= to);
      CHECK(gap_to - gap_from > 0.9 * (to - from));
    }
  }
  SECTION("a closed curve left open") {
    Candidate wrong = right;
    wrong.curves[loop].space->points.resize(wrong.curves[loop].space->points.size() - 5);
    renumber(*wrong.curves[loop].space);
    const Verdict verdict = verdict_of(wrong, pair);
    INFO(text(verdict));
    CHECK(has(verdict, DifferenceKind::split));
  }
  SECTION("points instead of a closed curve") {
    Candidate wrong = right;
    wrong.points.push_back({wrong.curves[loop].space->points[5], {}, {}});
    wrong.curves.erase(wrong.curves.begin() + static_cast<std::ptrdiff_t>(loop));
    const Verdict verdict = verdict_of(wrong, pair);
    INFO(text(verdict));
    CHECK(has(verdict, DifferenceKind::lost_curve));
    CHECK(has(verdict, DifferenceKind::curve_as_points));
    CHECK(has(verdict, DifferenceKind::point_on_curve));
  }
  SECTION("a curve and a point too many") {
    Candidate wrong = right;
    const auto& p = right.curves[open].space->points.front();
    wrong.curves.push_back(
        {polyline({{p[0] + 0.1, p[1], p[2]}, {p[0] + 0.2, p[1], p[2] + 0.1}}), {}, {}, false, {}});
    wrong.points.push_back({std::array<double, 3>{p[0] + 3 * tolerance, p[1] + 3 * tolerance, p[2]}, {}, {}});
    const Verdict verdict = verdict_of(wrong, pair);
    INFO(text(verdict));
    REQUIRE(has(verdict, DifferenceKind::spurious_curve));
    CHECK(has(verdict, DifferenceKind::false_point));
    CHECK(verdict.curves[2].spurious.size() == 1);
    CHECK(verdict.curves[2].spurious[0].from == 0);
    CHECK(verdict.curves[2].spurious[0].to == 1);
    CHECK(verdict.components[0].coverage == Coverage::covered);
  }
  SECTION("a curve twice") {
    Candidate wrong = right;
    wrong.curves.push_back(right.curves[open]);
    const Verdict verdict = verdict_of(wrong, pair);
    INFO(text(verdict));
    CHECK(verdict.agreement == Agreement::disagrees);
    CHECK(has(verdict, DifferenceKind::repeated));
  }
  SECTION("a wrong contact") {
    Candidate wrong = right;
    for (CandidateCurve& curve : wrong.curves) curve.tangential = false;
    CHECK(text(verdict_of(wrong, pair)) == "agrees");
    wrong.curves[loop].tangential = true;
    CHECK(has(verdict_of(wrong, pair), DifferenceKind::wrong_contact));
  }
  SECTION("a polyline that is too coarse") {
    Candidate wrong = right;
    Vertices& points = wrong.curves[loop].space->points;
    Vertices few;
    for (std::size_t i = 0; i < points.size(); i += 8) few.push_back(points[i]);
    few.push_back(points.front());
    wrong.curves[loop].space = polyline(few);
    const Verdict verdict = verdict_of(wrong, pair);
    CHECK(verdict.agreement == Agreement::disagrees);
    CHECK_FALSE(has(verdict, DifferenceKind::wrong_connection));
    CHECK(text(verdict_of(wrong, pair, 1e-2)) == "agrees");
  }
}

}  // namespace exsect::verify_changed_test

// Candidates made from the proved result, as it is in every representation, and of random pairs.
#include <algorithm>
#include <cmath>

#include "candidates.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/random_pairs.h"

namespace exsect::verify_test {

using namespace candidates;

TEST_CASE("verify: the proved result agrees in every representation, direction and start") {
  const Subject pair = example("chapter9-first.json");
  const IntersectResult exact = fine(pair);
  for (const std::string in : {"u", "xur"}) {
    INFO(in);
    const Verdict verdict = verdict_of(candidate_of(exact.graph, in), pair);
    CHECK(text(verdict) == "agrees");
    CHECK(verdict.curves.size() == 2);
    for (const CurveFinding& curve : verdict.curves) {
      CHECK(curve.distance.upper <= verdict.tolerance);
      CHECK(curve.distance.lower <= curve.distance.upper);
    }
    for (const ArcFinding& arc : verdict.arcs) CHECK(arc.coverage == Coverage::covered);
  }
  Candidate turned = candidate_of(exact.graph);
  for (CandidateCurve& curve : turned.curves) {
    Vertices& points = curve.space->points;
    std::reverse(points.begin(), points.end());
    if (points.front() != points.back()) continue;
    points.pop_back();
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 3),
                points.end());
    curve.closed = true;
    renumber(*curve.space);
  }
  CHECK(text(verdict_of(turned, pair)) == "agrees");
}

TEST_CASE("verify: its ids are those of the intersection with the tolerance that it names") {
  const PatchFile file = read_patches(std::string(EXSECT_CASES) + "/found/ids-with-tolerance.json");
  const BezierPatch& x = file.patches.at(0).patch;
  const BezierPatch& y = file.patches.at(1).patch;
  const Candidate candidate = candidate_of(intersect(x, y).graph);
  VerifyOptions options;
  options.tolerance = 1e-4;
  const Verification found = verify(candidate, x, y, options);
  CHECK(found.verdict.agreement == Agreement::agrees);
  IntersectOptions same;
  same.tolerance = found.exact_tolerance;
  const IntersectionGraph& a = found.exact.graph;
  const IntersectionGraph b = intersect(x, y, same).graph;
  REQUIRE(a.nodes.size() == b.nodes.size());
  REQUIRE(a.arcs.size() == b.arcs.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) CHECK(a.nodes[i].approx == b.nodes[i].approx);
  for (std::size_t i = 0; i < a.arcs.size(); ++i) {
    CHECK(a.arcs[i].from == b.arcs[i].from);
    CHECK(a.arcs[i].to == b.arcs[i].to);
    CHECK(a.arcs[i].component == b.arcs[i].component);
    CHECK(a.arcs[i].polyline.size() == b.arcs[i].polyline.size());
  }
}

TEST_CASE("verify: an incomplete exact answer is never agreement") {
  const Subject pair = example("chapter9-first.json");
  Candidate candidate = candidate_of(fine(pair).graph);
  VerifyOptions options;
  options.max_seconds = 1e-9;
  const Verification incomplete = verify(candidate, pair.x, pair.y, options);
  CHECK(incomplete.exact.status == Status::incomplete);
  CHECK(incomplete.verdict.agreement == Agreement::undecided);
  // a point that is on neither patch is wrong whatever the missing part is
  candidate.points.push_back({std::array<double, 3>{0.5, 0.5, 100}, {}, {}});
  const Verdict off = verify(candidate, pair.x, pair.y, incomplete.exact, 1e-6);
  CHECK(off.agreement == Agreement::disagrees);
  CHECK(has(off, DifferenceKind::false_point));
  CHECK_THROWS_AS(verdict_of(candidate, pair, 0), std::invalid_argument);
}

TEST_CASE("verify: a rational B-spline that is the curve itself") {
  // a² + b² = 1/10 in both squares and in space: a circle of four arcs
  const ExactCase cap = families::cap(Rational(1, 10), families::Plane::square);
  const double radius = std::sqrt(0.1);
  SplineCurve circle{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {}, {}};
  const std::array<std::array<double, 2>, 9> corners = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    circle.points.push_back({0.5 + radius * corners[i][0], 0.5 + radius * corners[i][1], 0});
    circle.weights.push_back(i % 2 == 0 ? 1 : std::sqrt(0.5));
  }
  REQUIRE(violation(circle).empty());
  Candidate candidate;
  candidate.curves.push_back({circle, circle, circle, false, {}});
  const Verdict verdict = verdict_of(candidate, {cap.x, cap.y}, 1e-5);
  CHECK(text(verdict) == "agrees");
  circle.weights[3] *= 1.01;
  candidate.curves[0].second = circle;
  const Verdict off = verdict_of(candidate, {cap.x, cap.y}, 1e-4);
  CHECK(off.agreement == Agreement::disagrees);
  for (const Difference& d : off.differences)
    if (d.part) {
      CHECK(d.part->representation == Representation::second);
      CHECK(d.part->from >= 1);
      CHECK(d.part->to <= 2);
    }
}

TEST_CASE("verify: families in special position agree with themselves") {
  for (const ExactCase& c : families::specimens()) {
    INFO(c.name);
    const Subject pair = {c.x, c.y};
    const IntersectResult exact = fine(pair);
    const double tolerance = 1e-4 * extent(pair);
    const Verdict verdict = verdict_of(candidate_of(exact.graph, "xur"), pair);
    if (exact.status == Status::complete)
      CHECK(text(verdict) == "agrees");
    else
      CHECK(verdict.agreement == Agreement::undecided);
    const bool empty =
        exact.graph.arcs.empty() && exact.graph.isolated_points.empty() && exact.graph.overlaps.empty();
    if (!empty && exact.status == Status::complete)
      CHECK(verify({}, pair.x, pair.y, exact, tolerance).agreement == Agreement::disagrees);
  }
}

TEST_CASE("verify: arcs over one segment of space are told apart by parameters") {
  const ExactCase c = families::double_cover();
  const Subject pair = {c.x, c.y};
  const IntersectResult exact = fine(pair);
  const double tolerance = 1e-4 * extent(pair);
  const auto judged = [&](const Candidate& candidate) {
    return verify(candidate, pair.x, pair.y, exact, tolerance);
  };
  const Candidate right = candidate_of(exact.graph, "xur");
  REQUIRE(right.curves.size() == 2);
  CHECK(text(judged(right)) == "agrees");
  Candidate one = right;
  one.curves.pop_back();
  CHECK(judged(one).agreement == Agreement::disagrees);
  Candidate twice = right;
  twice.curves[1] = twice.curves[0];
  CHECK(judged(twice).agreement != Agreement::agrees);
}

TEST_CASE("verify: curves shorter than the tolerance are where their parameters say") {
  const Subject pair = example("chapter9-first.json");
  const IntersectResult exact = fine(pair);
  Candidate candidate;
  for (const Arc& arc : exact.graph.arcs) candidate.curves.push_back(curve_of(arc.polyline, "xur"));
  for (const double tolerance : {1e-2, 5e-2, 1e-1})
    CHECK(text(verdict_of(candidate, pair, tolerance)) == "agrees");
}

TEST_CASE(
    "verify: a segment of space that is covered twice is right if it occurs twice, whatever its parts") {
  const ExactCase c = families::double_cover();
  const Subject pair = {c.x, c.y};
  const IntersectResult exact = fine(pair);
  const auto verdict = [&](const std::vector<Vertices>& lines) {
    Candidate candidate;
    for (const Vertices& line : lines) candidate.curves.push_back({polyline(line), {}, {}, false, {}});
    return verify(candidate, pair.x, pair.y, exact, 1e-4 * extent(pair));
  };
  const Vertices up = {{0.25, 0, 0}, {0.25, 1, 0}};
  const Vertices down = {{0.25, 1, 0}, {0.25, 0.75, 0}, {0.25, 0, 0}};
  const Vertices lower = {{0.25, 0, 0}, {0.25, 0.5, 0}};
  const Vertices upper = {{0.25, 0.5, 0}, {0.25, 1, 0}};
  CHECK(text(verdict({up, up})) == "agrees");
  CHECK(text(verdict({up, down})) == "agrees");
  CHECK(text(verdict({lower, down, upper})) == "agrees");
  CHECK(text(verdict({upper, lower, upper, lower})) == "agrees");
  for (const Verdict& wrong : {verdict({up}), verdict({up, up, up}), verdict({up, lower})})
    CHECK(wrong.agreement != Agreement::agrees);
  CHECK(has(verdict({up}), DifferenceKind::lost_curve));
}

TEST_CASE("verify: bounds of distances hold for random pairs and random errors") {
  const auto seed = GENERATE(11u, 12u, 13u);
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  const random_pairs::Pair random = random_pairs::small_rationals(generator);
  const Subject pair = {random.x, random.y};
  const IntersectResult exact = fine(pair);
  REQUIRE(exact.status == Status::complete);
  Candidate candidate = candidate_of(exact.graph);
  const double size = extent(pair);
  std::uniform_real_distribution<double> error(-1e-4 * size, 1e-4 * size);
  for (CandidateCurve& curve : candidate.curves)
    for (auto& p : curve.space->points)
      for (double& c : p) c += error(generator);
  const Verdict verdict = verdict_of(candidate, pair, 1e-3);
  CHECK(text(verdict) == "agrees");
  // brute force: samples of the candidate against all vertices of the exact polylines and points between them
  for (std::size_t c = 0; c < candidate.curves.size(); ++c) {
    const Vertices& points = candidate.curves[c].space->points;
    double largest = 0;
    for (std::size_t i = 0; i + 1 < points.size(); i += std::max<std::size_t>(1, points.size() / 150)) {
      for (const double t : {0.0, 0.25, 0.5}) {
        double nearest = 1e9;
        for (const Arc& arc : exact.graph.arcs) {
          for (std::size_t j = 0; j + 1 < arc.polyline.size(); ++j) {
            const auto& a = arc.polyline[j].point;
            const auto& b = arc.polyline[j + 1].point;
            double along = 0;
            double square = 0;
            for (std::size_t k = 0; k < 3; ++k) {
              const double p = points[i][k] + t * (points[i + 1][k] - points[i][k]);
              along += (p - a[k]) * (b[k] - a[k]);
              square += (b[k] - a[k]) * (b[k] - a[k]);
            }
            const double s = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
            double distance = 0;
            for (std::size_t k = 0; k < 3; ++k) {
              const double p = points[i][k] + t * (points[i + 1][k] - points[i][k]);
              distance += std::pow(p - a[k] - s * (b[k] - a[k]), 2);
            }
            nearest = std::min(nearest, std::sqrt(distance));
          }
        }
        largest = std::max(largest, nearest);
      }
    }
    CHECK(largest <= verdict.curves[c].distance.upper + 1e-5 * size);
    CHECK(verdict.curves[c].distance.lower > 0.5 * largest);
    CHECK(verdict.curves[c].distance.upper < 3e-4 * size);
  }
}

}  // namespace exsect::verify_test

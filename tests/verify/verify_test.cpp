// Candidates made from the proved result and then changed on purpose.
#include <exsect/geometry/bounding_box.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/verify/verify.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/families.h"
#include "support/random_pairs.h"

namespace exsect::verify_test {
namespace {

using Vertices = std::vector<std::array<double, 3>>;

struct Subject {
  BezierPatch x;
  BezierPatch y;
};

Subject example(const std::string& name) {
  const auto patches = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name).patches;
  return {patches[0].patch, patches[1].patch};
}

double extent(const Subject& pair) {
  const BoundingBox box = united(bounding_box(pair.x), bounding_box(pair.y));
  return to_double(largest_extent(box));
}

IntersectResult fine(const Subject& pair) {
  IntersectOptions options;
  options.tolerance = 1e-5;
  return intersect(pair.x, pair.y, options);
}

/// Curves in space, in (u,v) and in (r,s), from polylines with all seven coordinates.
CandidateCurve curve_of(const std::vector<PolylineVertex>& line, const std::string& in) {
  Vertices space;
  Vertices first;
  Vertices second;
  for (const PolylineVertex& v : line) {
    space.push_back(v.point);
    first.push_back({v.parameters[0], v.parameters[1], 0});
    second.push_back({v.parameters[2], v.parameters[3], 0});
  }
  CandidateCurve curve;
  if (in.find('x') != std::string::npos) curve.space = polyline(space);
  if (in.find('u') != std::string::npos) curve.first = polyline(first);
  if (in.find('r') != std::string::npos) curve.second = polyline(second);
  return curve;
}

/// Simple components as one polyline each, arcs of branched ones and of rims as they are.
std::vector<std::vector<PolylineVertex>> lines_of(const IntersectionGraph& graph) {
  std::vector<std::vector<PolylineVertex>> lines;
  const auto arc = [&](int id) -> const Arc& { return graph.arcs[static_cast<std::size_t>(id)]; };
  for (const Component& component : graph.components) {
    std::vector<PolylineVertex> line;
    int at = arc(component.arcs[0]).from;
    if (component.arcs.size() > 1) {
      const Arc& second = arc(component.arcs[1]);
      if (at == second.from || at == second.to) at = arc(component.arcs[0]).to;
    }
    for (const int id : component.arcs) {
      std::vector<PolylineVertex> next = arc(id).polyline;
      if (component.shape == ComponentShape::branched) {
        lines.push_back(next);
        continue;
      }
      const bool forward = arc(id).from == at;
      if (!forward) std::reverse(next.begin(), next.end());
      at = forward ? arc(id).to : arc(id).from;
      line.insert(line.end(), next.begin() + (line.empty() ? 0 : 1), next.end());
    }
    if (!line.empty()) lines.push_back(line);
  }
  for (const Overlap& overlap : graph.overlaps)
    for (const auto& chain : overlap.chains)
      for (const Arc& rim : chain) lines.push_back(rim.polyline);
  return lines;
}

Candidate candidate_of(const IntersectionGraph& graph, const std::string& in = "x") {
  Candidate candidate;
  for (const auto& line : lines_of(graph)) candidate.curves.push_back(curve_of(line, in));
  for (const int id : graph.isolated_points)
    candidate.points.push_back({graph.nodes[static_cast<std::size_t>(id)].point, {}, {}});
  return candidate;
}

bool has(const Verdict& verdict, DifferenceKind kind) {
  return std::any_of(verdict.differences.begin(), verdict.differences.end(),
                     [&](const Difference& d) { return d.kind == kind; });
}

std::string text(const Verdict& verdict) {
  std::string result = name(verdict.agreement);
  for (const Difference& d : verdict.differences) result += std::string("; ") + name(d.kind) + ": " + d.text;
  for (const std::string& open : verdict.undecided) result += "; ? " + open;
  return result;
}

Verdict verdict_of(const Candidate& candidate, const Subject& pair, double tolerance = 1e-4) {
  VerifyOptions options;
  options.tolerance = tolerance;
  return verify(candidate, pair.x, pair.y, options).verdict;
}

Candidate shifted(Candidate candidate, const std::array<double, 3>& by) {
  for (CandidateCurve& curve : candidate.curves)
    for (auto& p : curve.space->points)
      for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
  return candidate;
}

/// A knot for each vertex again.
void renumber(SplineCurve& curve) { curve = polyline(curve.points); }

}  // namespace

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

// Candidates for a patch and a surface given by its equation, made from the proved result and changed.
#include <exsect/geometry/surface_file.h>
#include <exsect/solver/intersect_surface.h>
#include <exsect/verify/verify_equation.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/catch.h"

namespace exsect::verify_equation_test {
namespace {

struct Subject {
  ImplicitSurface surface;
  RationalPatch x;
};

Subject example(const std::string& name) {
  const SurfaceFile file = read_surfaces(std::string(EXSECT_EXAMPLES) + "/surfaces.json");
  const auto entry = std::ranges::find(file.surfaces, name, &NamedSurface::name);
  return {*entry->equation(), *file.surfaces.front().patch()};
}

/// z = x^2 over [-1,1]^2 above the plane z = 0, which it touches along a line.
Subject trough() {
  std::vector<std::vector<Point>> net(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      net[static_cast<std::size_t>(i)].push_back({i - 1, 2 * j - 1, i == 1 ? -1 : 1});
  return {ImplicitSurface::plane({0, 0, 0}, {0, 0, 1}), RationalPatch(net)};
}

IntersectionGraph graph_of(const Subject& pair) {
  IntersectOptions options;
  options.tolerance = 1e-5;
  return intersect(pair.surface, pair.x, options).graph;
}

/// Every arc as one curve, in space or in (u,v) or both.
Candidate candidate_of(const IntersectionGraph& graph, bool in_space, bool in_square) {
  Candidate candidate;
  for (const Arc& arc : graph.arcs) {
    std::vector<std::array<double, 3>> space, square;
    for (const PolylineVertex& v : arc.polyline) {
      space.push_back(v.point);
      square.push_back({v.parameters[0], v.parameters[1], 0});
    }
    candidate.curves.push_back({});
    if (in_space) candidate.curves.back().space = polyline(space);
    if (in_square) candidate.curves.back().first = polyline(square);
  }
  for (const int id : graph.isolated_points)
    candidate.points.push_back({graph.nodes[static_cast<std::size_t>(id)].point, {}, {}});
  return candidate;
}

Verdict verdict_of(const Candidate& candidate, const Subject& pair) {
  VerifyOptions options;
  options.tolerance = 1e-3;
  const Verification found = verify(candidate, pair.surface, pair.x, options);
  for (const Difference& d : found.verdict.differences) UNSCOPED_INFO(name(d.kind) << ": " << d.text);
  for (const std::string& open : found.verdict.undecided) UNSCOPED_INFO(open);
  CHECK(found.exact_turning == std::vector<Parameter>{Parameter::u, Parameter::v});
  return found.verdict;
}

bool has(const Verdict& verdict, DifferenceKind kind) {
  return std::ranges::any_of(verdict.differences, [&](const Difference& d) { return d.kind == kind; });
}

}  // namespace

TEST_CASE("verify with an equation: what is right agrees, in space and in the square") {
  for (const std::string name : {"floor", "oblique", "cone", "ball", "torus"}) {
    INFO(name);
    const Subject pair = example(name);
    const IntersectionGraph graph = graph_of(pair);
    REQUIRE(!graph.nodes.empty());
    for (const auto& [space, square] :
         {std::pair(true, false), std::pair(false, true), std::pair(true, true)})
      CHECK(verdict_of(candidate_of(graph, space, square), pair).agreement == Agreement::agrees);
  }
}

TEST_CASE("verify with an equation: a lost, a moved and an invented curve, and a false point") {
  const Subject pair = example("torus");
  const Candidate right = candidate_of(graph_of(pair), true, true);
  Candidate lost = right;
  lost.curves.clear();
  const Verdict missing = verdict_of(lost, pair);
  CHECK(missing.agreement == Agreement::disagrees);
  CHECK(has(missing, DifferenceKind::lost_curve));
  for (const ArcFinding& arc : missing.arcs)
    for (const ArcGap& gap : arc.gaps) CHECK(index(gap.parameter) < 2);

  Candidate moved = right;
  moved.curves[0].first.reset();
  for (auto& p : moved.curves[0].space->points) p[2] += 0.1;
  const Verdict off = verdict_of(moved, pair);
  CHECK(off.agreement == Agreement::disagrees);
  CHECK(has(off, DifferenceKind::spurious_curve));

  Candidate false_point = right;
  false_point.points.push_back({std::array<double, 3>{0, 0, 0}, {}, {}});  // on the patch, off the torus
  CHECK(has(verdict_of(false_point, pair), DifferenceKind::false_point));
}

TEST_CASE("verify with an equation: contact along a curve") {
  const Subject pair = trough();
  Candidate candidate = candidate_of(graph_of(pair), true, false);
  REQUIRE(candidate.curves.size() == 1);
  candidate.curves[0].tangential = true;
  CHECK(verdict_of(candidate, pair).agreement == Agreement::agrees);
  candidate.curves[0].tangential = false;
  CHECK(has(verdict_of(candidate, pair), DifferenceKind::wrong_contact));
}

TEST_CASE("verify with an equation: what is refused") {
  const Subject pair = example("ball");
  Candidate candidate = candidate_of(graph_of(pair), true, true);
  candidate.curves[0].second = candidate.curves[0].first;
  CHECK_THROWS_AS(verify(candidate, pair.surface, pair.x), std::invalid_argument);
  candidate.curves[0].second.reset();
  CHECK_NOTHROW(verify(candidate, pair.surface, pair.x));
  candidate.points.push_back({{}, {}, std::array<double, 2>{0, 0}});
  CHECK_THROWS_AS(verify(candidate, pair.surface, pair.x), std::invalid_argument);
  candidate.points.clear();
  for (const double tolerance : {0.0, -1.0, std::nan("")}) {
    VerifyOptions options;
    options.tolerance = tolerance;
    CHECK_THROWS_AS(verify(candidate, pair.surface, pair.x, options), std::invalid_argument);
  }
}

}  // namespace exsect::verify_equation_test

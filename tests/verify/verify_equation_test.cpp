// Candidates for a surface given by its equation and a patch, or another such surface, made from the proved
// result and changed.
#include <exsect/geometry/surface_box.h>
#include <exsect/geometry/surface_file.h>
#include <exsect/solver/intersect_equations.h>
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

/// With the next assertion that fails.
void report(const Verdict& verdict) {
  for (const Difference& d : verdict.differences) UNSCOPED_INFO(name(d.kind) << ": " << d.text);
  for (const std::string& open : verdict.undecided) UNSCOPED_INFO(open);
}

Verdict verdict_of(const Candidate& candidate, const Subject& pair) {
  VerifyOptions options;
  options.tolerance = 1e-3;
  const Verification found = verify(candidate, pair.surface, pair.x, options);
  report(found.verdict);
  CHECK(found.exact_turning == std::vector<Parameter>{Parameter::u, Parameter::v});
  return found.verdict;
}

bool has(const Verdict& verdict, DifferenceKind kind) {
  return std::ranges::any_of(verdict.differences, [&](const Difference& d) { return d.kind == kind; });
}

/// Two surfaces given by their equations.
struct Two {
  ImplicitSurface first;
  ImplicitSurface second;
};

/// Every arc as one curve, the touch points as points.
Candidate candidate_of(const Two& pair, double tolerance = 1e-5) {
  IntersectOptions options;
  options.tolerance = tolerance;
  const SurfaceIntersection found = intersect(pair.first, pair.second, options);
  Candidate candidate;
  for (const SpaceArc& arc : found.arcs)
    candidate.curves.push_back({polyline(arc.polyline), {}, {}, false, {}});
  for (const SpaceNode& node : found.nodes)
    if (node.kind == SpaceNodeKind::touch) candidate.points.push_back({node.approx, {}, {}});
  return candidate;
}

Verdict verdict_of(const Candidate& candidate, const Two& pair) {
  VerifyOptions options;
  options.tolerance = 1e-3;
  const EquationsVerification found = verify(candidate, pair.first, pair.second, options);
  report(found.verdict);
  CHECK(found.exact_turning.empty());
  IntersectOptions again;
  again.tolerance = found.exact_tolerance;
  CHECK(intersect(pair.first, pair.second, again).arcs.size() == found.exact.graph.arcs.size());
  CHECK(found.surfaces.arcs.size() == found.exact.graph.arcs.size());
  return found.verdict;
}

Two moved(const Two& pair, const Point& origin, const Rational& scale) {
  return {pair.first.seen_from(origin, scale), pair.second.seen_from(origin, scale)};
}

ImplicitSurface tilted_tube() {
  return ImplicitSurface::cylinder({0, 0, 0}, {1, 2, 3}, Length::of_squared(2));
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
    for (const ArcGap& gap : arc.gaps) CHECK(index(*gap.parameter) < 2);

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

TEST_CASE("verify of two equations: what is right agrees, of every kind, in either order, at every size") {
  const ImplicitSurface ball = ImplicitSurface::sphere({Rational(1, 3), 0, 0}, 2);
  const ImplicitSurface ring = ImplicitSurface::torus({0, 0, 0}, {0, 0, 1}, 3, 1);
  const ImplicitSurface cone = ImplicitSurface::cone({0, 0, 3}, {1, 0, -1}, Rational(1, 2), 2);
  const std::vector<Two> pairs = {
      {tilted_tube(), ball}, {ball, tilted_tube()},
      {ball, cone},          {ring, tilted_tube()},
      {cone, ring},          {boxed(tilted_tube(), {.height = HeightRange{-1, Rational(1, 3)}}), ball}};
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    INFO(k);
    const Candidate candidate = candidate_of(pairs[k]);
    REQUIRE(!candidate.curves.empty());
    CHECK(verdict_of(candidate, pairs[k]).agreement == Agreement::agrees);
  }
  for (const Two& pair :
       {moved(pairs[0], {-100000000, 0, 3}, 1), moved(pairs[0], {0, 0, 0}, Rational(5, 127)),
        moved(pairs[0], {0, 0, 0}, power_of_two(250)), moved(pairs[0], {0, 0, 0}, power_of_two(-250))})
    CHECK(verdict_of(candidate_of(pair), pair).agreement == Agreement::agrees);
}

TEST_CASE("verify of two equations: a lost, a moved and an invented curve, a false and a lost point") {
  const Two pair = {tilted_tube(), ImplicitSurface::sphere({1, 0, 0}, 2)};
  const Candidate right = candidate_of(pair);
  Candidate lost = right;
  lost.curves.clear();
  const Verdict missing = verdict_of(lost, pair);
  CHECK(missing.agreement == Agreement::disagrees);
  CHECK(has(missing, DifferenceKind::lost_curve));
  for (const ArcFinding& arc : missing.arcs)
    for (const ArcGap& gap : arc.gaps) CHECK_FALSE(gap.parameter.has_value());

  Candidate moved = right;
  for (auto& p : moved.curves[0].space->points) p[2] += 0.1;
  const Verdict off = verdict_of(moved, pair);
  CHECK(has(off, DifferenceKind::spurious_curve));
  CHECK(has(off, DifferenceKind::gap));

  Candidate more = right;
  more.points.push_back({std::array<double, 3>{0, 0, 0}, {}, {}});
  CHECK(has(verdict_of(more, pair), DifferenceKind::false_point));
  more.points.back() = {right.curves[0].space->points[5], {}, {}};
  CHECK(has(verdict_of(more, pair), DifferenceKind::point_on_curve));

  const Two touching = {ImplicitSurface::cylinder({0, 0, 0}, {0, 0, 1}, 1),
                        ImplicitSurface::sphere({2, 0, Rational(1, 3)}, 1)};
  Candidate point = candidate_of(touching);
  REQUIRE(point.points.size() == 1);
  CHECK(verdict_of(point, touching).agreement == Agreement::agrees);
  (*point.points[0].point)[0] += 0.002;
  const Verdict apart = verdict_of(point, touching);
  CHECK(has(apart, DifferenceKind::false_point));
  CHECK(has(apart, DifferenceKind::lost_point));
}

TEST_CASE("verify of two equations: contact along a curve, and a small loop on a large surface") {
  const Two pair = {ImplicitSurface::cylinder({0, 0, 0}, {0, 0, 1}, 1),
                    ImplicitSurface::sphere({0, 0, 0}, 1)};
  Candidate candidate = candidate_of(pair);
  for (CandidateCurve& curve : candidate.curves) curve.tangential = true;
  CHECK(verdict_of(candidate, pair).agreement == Agreement::agrees);
  candidate.curves[0].tangential = false;
  CHECK(has(verdict_of(candidate, pair), DifferenceKind::wrong_contact));
  // The cut of a plane 2^-20 below the top of a sphere of radius 1000: polylines follow the loop's own size.
  const Two cap = {ImplicitSurface::sphere({0, 0, 0}, 1000),
                   ImplicitSurface::plane({0, 0, 1000 - power_of_two(-20)}, {0, 0, 1})};
  CHECK(verdict_of(candidate_of(cap, 1e-8), cap).agreement == Agreement::agrees);
}

TEST_CASE("verify of two equations: what is off a surface is false where the exact answer is incomplete") {
  const auto quartic = [](const Rational& c) {
    return ImplicitSurface::polynomial(
        SpacePolynomial({{{4, 0, 0}, 1}, {{0, 4, 0}, 1}, {{0, 0, 4}, 1}, {{1, 1, 1}, c}, {{0, 0, 0}, -1}}));
  };
  const Two pair = {quartic(1), quartic(2)};
  if (intersect(pair.first, pair.second).status == Status::complete) return;
  Candidate candidate;
  candidate.points.push_back({std::array<double, 3>{1, 0, 0}, {}, {}});
  CHECK(verify(candidate, pair.first, pair.second).verdict.agreement == Agreement::undecided);
  candidate.points.push_back({std::array<double, 3>{1, 1, 0}, {}, {}});
  CHECK(has(verify(candidate, pair.first, pair.second).verdict, DifferenceKind::false_point));
}

TEST_CASE("verify of two equations: what is refused") {
  const ImplicitSurface ball = ImplicitSurface::sphere({1, 0, 0}, 2);
  Candidate candidate = candidate_of(Two{tilted_tube(), ball});
  for (const auto square : {&CandidateCurve::first, &CandidateCurve::second}) {
    candidate.curves[0].*square = candidate.curves[0].space;
    CHECK_THROWS_AS(verify(candidate, tilted_tube(), ball), NotComparable);
    (candidate.curves[0].*square).reset();
  }
  candidate.points.push_back({{}, std::array<double, 2>{0, 0}, {}});
  CHECK_THROWS_AS(verify(candidate, tilted_tube(), ball), NotComparable);
  candidate.points.clear();
  CHECK_THROWS_AS(verify(candidate, ball, ball), NotComparable);
  const ImplicitSurface floor = ImplicitSurface::plane({0, 0, 0}, {0, 0, 1});
  CHECK_THROWS_AS(verify(candidate, floor, ImplicitSurface::cylinder({0, 0, 0}, {1, 0, 0}, 1)),
                  NotComparable);
  CHECK_NOTHROW(verify(candidate, boxed(floor, {.sides = std::array<Point, 2>{{{5, 0, 0}, {0, 5, 0}}}}),
                       ImplicitSurface::cylinder({0, 0, 0}, {1, 0, 0}, 1)));
  VerifyOptions options;
  for (const double tolerance : {0.0, -1.0, std::nan("")}) {
    options.tolerance = tolerance;
    CHECK_THROWS_AS(verify(candidate, tilted_tube(), ball, options), std::invalid_argument);
  }
}

}  // namespace exsect::verify_equation_test

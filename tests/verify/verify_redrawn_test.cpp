// Verdicts that need polylines finer than those of the first round.
#include <exsect/geometry/bounding_box.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/verify/verify.h>

#include "support/catch.h"

namespace exsect::verify_redrawn_test {

namespace {

/// The arcs of the result, moved by a vector.
Candidate moved_arcs(const IntersectionGraph& graph, const std::array<double, 3>& by) {
  Candidate candidate;
  for (const Arc& arc : graph.arcs) {
    std::vector<std::array<double, 3>> points;
    for (const PolylineVertex& vertex : arc.polyline) {
      points.push_back(vertex.point);
      for (std::size_t k = 0; k < 3; ++k) points.back()[k] += by[k];
    }
    candidate.curves.emplace_back().space = polyline(points);
  }
  return candidate;
}

/// Arcs of one pair moved by nearly the tolerance: in the round that decides, the exact result is a drawing
/// of the first one, and the verdict that of a result solved with that tolerance.
void check(const BezierPatch& x, const BezierPatch& y, const std::array<double, 3>& direction) {
  VerifyOptions options;
  options.tolerance = 1e-5;
  const double extent = to_double(largest_extent(united(bounding_box(x), bounding_box(y))));
  IntersectOptions fine;
  fine.tolerance = 1e-8;
  const IntersectionGraph graph = intersect(x, y, fine).graph;
  bool is_redrawn = false;
  for (const double part : {0.99, 1.01}) {
    INFO(part << " of the tolerance");
    std::array<double, 3> by = direction;
    for (double& c : by) c *= part * options.tolerance * extent;
    const Candidate candidate = moved_arcs(graph, by);
    const Verification found = verify(candidate, x, y, options);
    CHECK((found.verdict.agreement == Agreement::agrees) == (part < 1));
    CHECK(found.verdict.agreement != Agreement::undecided);
    IntersectOptions named;
    named.tolerance = found.exact_tolerance;
    const IntersectResult solved = intersect(x, y, named);
    CHECK(solved.graph.arcs.size() == found.exact.graph.arcs.size());
    CHECK(verify(candidate, x, y, solved, options.tolerance * extent).agreement == found.verdict.agreement);
    if (found.exact_tolerance < options.tolerance / 32) {
      is_redrawn = true;
      CHECK(found.exact.work.steps.count("drawing ms") == 1);
    }
  }
  CHECK(is_redrawn);
}

}  // namespace

TEST_CASE("verify redrawn: a parabola of a pair in doubles, moved across its plane") {
  const BezierPatch plane = BezierPatch::elevated({{{-1, -1, 0}, {-1, 2, 0}}, {{2, -1, 0}, {2, 2, 0}}});
  ControlNet cylinder{};
  cylinder[0][0] = {0, 0, -1};
  cylinder[0][1] = {0, 0, 2};
  cylinder[1][0] = {1, 0, 0};
  cylinder[2][0] = {0, 1, 0};
  check(plane, BezierPatch::from_power_basis(cylinder), {0, 0, 1});
}

TEST_CASE("verify redrawn: a curve along which patches touch, exactly") {
  const auto patches = read_patches(std::string(EXSECT_EXAMPLES) + "/touching-curve.json").patches;
  check(patches[0].patch, patches[1].patch, {0, 0, 1});
}

}  // namespace exsect::verify_redrawn_test

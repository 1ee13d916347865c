// One policy for the tolerance: the topology never depends on it, and its cost grows smoothly.
#include <exsect/geometry/bounding_box.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/self_intersect.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <string>

#include "answer/model_scale.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::tolerance_test {

namespace {

using Solve = std::function<IntersectResult(const IntersectOptions&)>;

struct Subject {
  std::string name;
  double extent;
  Solve solve;
};

Subject pair(const std::string& folder, const std::string& name) {
  const PatchFile file = read_patches(folder + "/" + name + ".json");
  const BezierPatch x = file.patches.at(0).patch;
  const BezierPatch y = file.patches.at(1).patch;
  return {name, model_scale(x, y).extent, [=](const IntersectOptions& o) { return intersect(x, y, o); }};
}

Subject self(const std::string& name, std::size_t i) {
  const BezierPatch x = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name + ".json").patches.at(i).patch;
  return {name + " with itself", model_scale(x, x).extent,
          [=](const IntersectOptions& o) { return self_intersect(x, o); }};
}

/// Generic, an overlap, self-intersection, contact along a curve, a touch point's family, a shared side, a
/// cusp.
std::vector<Subject> subjects() {
  const std::string cases = EXSECT_CASES;
  return {pair(EXSECT_EXAMPLES, "chapter9-first"),
          pair(cases, "overlap"),
          self("chapter9-second", 1),
          pair(cases, "tangent-curve"),
          pair(cases, "crossing"),
          pair(cases, "shared-side"),
          pair(cases, "cusp-of-the-curve"),
          pair(cases, "two-near-sheets")};
}

struct Counts {
  std::array<std::size_t, 5> of;

  explicit Counts(const IntersectionGraph& graph)
      : of{graph.nodes.size(), graph.arcs.size(), graph.components.size(), graph.overlaps.size(),
           graph.isolated_points.size()} {}
  friend bool operator==(const Counts&, const Counts&) = default;
};

template <class Visit>
void for_each_arc(const IntersectionGraph& graph, const Visit& visit) {
  for (const Arc& arc : graph.arcs) visit(arc);
  for (const Overlap& overlap : graph.overlaps)
    for (const auto& chain : overlap.chains)
      for (const Arc& arc : chain) visit(arc);
}

double extent_of(const random_nets::Nets& nets) {
  double extent = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    Rational lower = nets.x[0][0][c];
    Rational upper = lower;
    for (const random_nets::Net* net : {&nets.x, &nets.y})
      for (const auto& row : *net)
        for (const Point& p : row) {
          lower = std::min(lower, p[c]);
          upper = std::max(upper, p[c]);
        }
    extent = std::max(extent, to_double(upper - lower));
  }
  return extent;
}

/// Pairs behind which there is no exact arithmetic: bicubic ones, and weighted ones of both degrees.
std::vector<Subject> subjects_in_doubles() {
  std::vector<Subject> result;
  for (const int kind : {0, 1, 2}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      random_nets::Generator generator(seed);
      const int n = kind == 1 ? 2 : 3;
      const auto nets = random_nets::crossing(generator, {n, n, n, n}, true);
      const RationalPatch x = kind == 0 ? nets.first() : random_nets::weighted(generator, nets.x);
      const RationalPatch y = kind == 0 ? nets.second() : random_nets::weighted(generator, nets.y);
      result.push_back({std::to_string(kind) + " seed " + std::to_string(seed), extent_of(nets),
                        [=](const IntersectOptions& o) { return intersect(x, y, o); }});
    }
  }
  return result;
}

}  // namespace

TEST_CASE("tolerances from 1e-3 to 1e-16 in doubles alone: one topology, honest bounds") {
  for (const Subject& subject : subjects_in_doubles()) {
    CAPTURE(subject.name);
    IntersectOptions options;
    options.tolerance = 1e-2;
    const Counts counts(subject.solve(options).graph);
    for (const double tolerance : {1e-3, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-12, 1e-16}) {
      CAPTURE(tolerance);
      options.tolerance = tolerance;
      const IntersectResult result = subject.solve(options);
      CHECK(result.status == Status::complete);
      CHECK(Counts(result.graph) == counts);
      double worst = 0;
      for_each_arc(result.graph, [&](const Arc& arc) { worst = std::max(worst, arc.error_bound); });
      CHECK(result.coarse.has_value() == (worst > tolerance * subject.extent * (1 + 1e-9)));
      if (result.coarse) {
        CHECK(worst <= result.coarse->bound);
        CHECK(worst < 1e-6 * subject.extent);
      }
    }
  }
}

TEST_CASE("tolerances from 1e-3 to 1e-16: one topology, honest bounds, cost like the square root") {
  for (const Subject& subject : subjects()) {
    CAPTURE(subject.name);
    IntersectOptions options;
    options.tolerance = 1e-2;
    const Counts counts(subject.solve(options).graph);
    std::size_t before = 0;
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12, 1e-16}) {
      CAPTURE(tolerance);
      options.tolerance = tolerance;
      const std::clock_t begin = std::clock();
      const IntersectResult result = subject.solve(options);
      CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 20);
      CHECK(result.status == Status::complete);
      CHECK(Counts(result.graph) == counts);
      std::size_t vertices = 0;
      double worst = 0;
      for_each_arc(result.graph, [&](const Arc& arc) {
        vertices += arc.polyline.size();
        worst = std::max(worst, arc.error_bound);
      });
      const double asked = tolerance * subject.extent * (1 + 1e-9);
      if (result.coarse) {
        CHECK(worst <= result.coarse->bound * (1 + 1e-9));
        CHECK(worst > tolerance * subject.extent * (1 - 1e-9));
        CHECK(worst < 0x1p-29 * subject.extent);
      } else {
        CHECK(worst <= asked);
      }
      if (before > 0) CHECK(vertices <= 100 * before);
      before = vertices;
    }
  }
}

}  // namespace exsect::tolerance_test

// The solution in doubles against the exact one: the same graph, or none.
#include "filter/filter.h"

#include <exsect/solver/intersect.h>

#include <cmath>
#include <functional>

#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"
#include "trace/pair_system.h"
#include "trace/tube.h"

namespace exsect::filter_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;
using Family = Pair (*)(Generator&);

IntersectOptions exact_mode() {
  IntersectOptions options;
  options.exact = true;
  return options;
}

/// True if doubles decide the pair; then the graph is sound and that of the exact solution.
bool agrees(const Pair& pair, const IntersectOptions& options = {}) {
  const auto filtered = intersect_filtered(pair.x, pair.y, options);
  if (!filtered) return false;
  CHECK(filtered->status == Status::complete);
  CHECK(unsound(pair.x, pair.y, *filtered) == "");
  const IntersectResult other = intersect_exactly(pair.x, pair.y, options);
  CHECK(other.status == Status::complete);
  CHECK(difference(filtered->graph, other.graph, {}) == "");
  return true;
}

void check_family(Family family, std::uint64_t first_seed, std::uint64_t count, std::uint64_t least_decided) {
  std::uint64_t decided = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    decided += agrees(family(generator)) ? 1 : 0;
  }
  CHECK(decided >= least_decided);
}

/// Points of the true curve between the vertices, by Newton's method in balls, are within the bound of the
/// chord.
void check_chords(const Pair& pair, const IntersectionGraph& graph) {
  const PairSystem<DoubleBall> system(pair.x, pair.y, Point{0, 0, 0}, 0);
  for (const Arc& arc : graph.arcs) {
    for (std::size_t i = 1; i < arc.polyline.size(); i += 1 + arc.polyline.size() / 40) {
      const PolylineVertex& a = arc.polyline[i - 1];
      const PolylineVertex& b = arc.polyline[i];
      std::size_t axis = 0;
      for (std::size_t j = 1; j < 4; ++j) {
        if (std::fabs(b.parameters[j] - a.parameters[j]) >
            std::fabs(b.parameters[axis] - a.parameters[axis])) {
          axis = j;
        }
      }
      for (const double t : {0.25, 0.5, 0.75}) {
        BallPoint<DoubleBall> start;
        for (std::size_t j = 0; j < 4; ++j) {
          start[j] = DoubleBall(a.parameters[j] + t * (b.parameters[j] - a.parameters[j]));
        }
        const auto w = newton_corrected(system, start, axis, 4).value();
        const auto x = system.taylor_x(w)[0];
        double along = 0;
        double length2 = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          along += (x[c].approximation() - a.point[c]) * (b.point[c] - a.point[c]);
          length2 += (b.point[c] - a.point[c]) * (b.point[c] - a.point[c]);
        }
        const double s = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
        double distance2 = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const double d = x[c].approximation() - a.point[c] - s * (b.point[c] - a.point[c]);
          distance2 += d * d;
        }
        CHECK(std::sqrt(distance2) <= arc.error_bound);
      }
    }
  }
}

}  // namespace

TEST_CASE("filter: agrees with the exact solution on small rationals") {
  check_family(random_pairs::small_rationals, 1000, 25, 23);
}

TEST_CASE("filter: agrees with the exact solution on doubles") {
  check_family(random_pairs::doubles, 1000, 25, 24);
}

TEST_CASE("filter: agrees with the exact solution on scattered control points") {
  check_family(random_pairs::scattered, 1000, 25, 23);
}

TEST_CASE("filter: agrees with the exact solution on small loops") {
  check_family(random_pairs::loop, 1000, 25, 21);
}

TEST_CASE("filter: agrees with the exact solution on a thousand pairs", "[.slow]") {
  check_family(random_pairs::small_rationals, 2000, 250, 240);
  check_family(random_pairs::doubles, 2000, 250, 245);
  check_family(random_pairs::scattered, 2000, 250, 240);
  check_family(random_pairs::loop, 2000, 250, 225);
}

TEST_CASE("filter: other turning points and tolerances") {
  Generator generator(7);
  const Pair pair = random_pairs::scattered(generator);
  const Pair closed = random_pairs::loop(generator);
  IntersectOptions options;
  options.turning = {};
  CHECK(agrees(pair, options));
  CHECK(agrees(closed, options));
  options.turning = {Parameter::v, Parameter::s};
  options.tolerance = 1e-9;
  CHECK(agrees(pair, options));
  CHECK(agrees(closed, options));
  options.tolerance = 1e-4;
  CHECK(agrees(pair, options));
  options.tolerance = 1e-15;  // then as fine as doubles allow, or not at all
  if (const auto result = intersect_filtered(pair.x, pair.y, options)) {
    REQUIRE(result->coarse);
    CHECK(result->coarse->bound < 1e-10);
  }
}

TEST_CASE("filter: true points between the vertices are within the bound of the chords") {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
      INFO("seed " << seed << ", tolerance " << tolerance);
      Generator generator(seed);
      const Pair pair = random_pairs::scattered(generator);
      IntersectOptions options;
      options.tolerance = tolerance;
      const auto result = intersect_filtered(pair.x, pair.y, options);
      if (result) check_chords(pair, result->graph);
    }
  }
}

TEST_CASE("filter: the special families are decided rightly or not at all") {
  for (const ExactCase& c : families::specimens()) {
    INFO(c.name);
    IntersectOptions options;
    options.turning = c.turning;
    const auto result = intersect_filtered(c.x, c.y, options);
    if (result) CHECK(difference(*result, c) == "");
  }
}

TEST_CASE("filter: near misses, small loops and near crossings are decided") {
  for (const int k : {4, 8, 12, 16}) {
    INFO("2^-" << k);
    const Rational e = 3 * power_of_two(-k - 2);
    const auto decided = [](const ExactCase& c) {
      IntersectOptions options;
      options.turning = c.turning;
      const auto result = intersect_filtered(c.x, c.y, options);
      return result && difference(*result, c) == "";
    };
    CHECK(decided(families::cap(e, families::Plane::bilinear)));
    CHECK(decided(families::cap(-e, families::Plane::bilinear)));
    CHECK(decided(families::near_crossing(e, families::Plane::larger)));
    CHECK(decided(families::parted_sheets(e, families::Plane::quadratic)));
  }
}

TEST_CASE("filter: the result says which way it was found") {
  Generator generator(3);
  const Pair pair = random_pairs::doubles(generator);
  CHECK(intersect(pair.x, pair.y).work.steps.count("filtered") == 1);
  CHECK(intersect(pair.x, pair.y, exact_mode()).work.steps.count("filtered") == 0);
}

TEST_CASE("filter: curves of contact, cusps and lifted sides are left to the exact solution") {
  for (const ExactCase& c : {families::tangent_curve(Rational(1, 3), families::Plane::bilinear),
                             families::curve_cusp(families::Plane::bilinear), families::side_and_arc(),
                             families::pinch_point_passed(false)}) {
    INFO(c.name);
    CHECK_FALSE(intersect_filtered(c.x, c.y, {}));
  }
}

}  // namespace exsect::filter_test

#include "support/graph_checks.h"

#include <exsect/solver/intersect.h>
#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/catch.h"
#include "support/families.h"
#include "support/oracle.h"
#include "support/random_pairs.h"

namespace exsect::graph_checks_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;

/// A result with a loop and both ends of an arc in it: two caps would do, this has an open arc as well.
Pair loop_and_arc() {
  Generator generator(4);
  return random_pairs::small_rationals(generator);
}

std::vector<std::function<void(IntersectResult&)>> unsound_changes() {
  return {[](IntersectResult& r) {
            r.graph.nodes[0].box[2] = {Rational(2, 1000), Rational(3, 1000)};
          },
          [](IntersectResult& r) { r.graph.nodes[1].box[0].lower = Rational(-1, 1000000); },
          [](IntersectResult& r) {
            r.graph.nodes[0].on = {{Parameter::u, 1}, {Parameter::u, 0}};
          },
          [](IntersectResult& r) { r.graph.arcs[0].polyline[1].parameters[3] /= 2; },
          [](IntersectResult& r) { r.graph.arcs[0].polyline[1].point[0] += 0.01; },
          [](IntersectResult& r) { r.graph.arcs[0].polyline.clear(); },
          [](IntersectResult& r) { r.graph.components[0].shape = ComponentShape::branched; },
          [](IntersectResult& r) { r.graph.components.pop_back(); },
          [](IntersectResult& r) { r.graph.isolated_points = {r.graph.arcs[0].from}; },
          [](IntersectResult& r) { r.status = Status::incomplete; }};
}

}  // namespace

TEST_CASE("oracle: points on arbitrary lines are the exact ones") {
  int conclusive = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Generator generator(seed);
    const Pair pair = random_pairs::scattered(generator);
    for (const Parameter p : all_parameters) {
      const Rational value(random_pairs::integer(generator, 1, 62), 64);
      INFO("seed " << seed << ", " << name(p) << " = " << value);
      const auto expected = line_points(pair.x, pair.y, {p, value}).points;
      const auto found = oracle::line_points(pair.x, pair.y, index(p), to_double(value));
      if (!found.conclusive()) continue;
      ++conclusive;
      REQUIRE(found.points.size() == expected.size());
      for (const CertifiedPoint& point : expected) {
        CHECK(std::count_if(found.points.begin(), found.points.end(), [&](const oracle::Vector4& z) {
                for (std::size_t i = 0; i < 4; ++i) {
                  if (std::fabs(z[i] - to_double(point.box()[i].midpoint())) > 1e-9) return false;
                }
                return true;
              }) == 1);
      }
    }
  }
  CHECK(conclusive >= 76);
}

TEST_CASE("graph checks: a right result passes, a wrong one does not") {
  const Pair pair = loop_and_arc();
  const IntersectResult result = intersect(pair.x, pair.y);
  REQUIRE(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() >= 2);
  CHECK(unsound(pair.x, pair.y, result) == "");
  const Comparison right = compare_with_oracle(pair.x, pair.y, result.graph);
  CHECK(right.difference == "");
  CHECK(right.lines >= 10);
  std::size_t k = 0;
  for (const auto& change : unsound_changes()) {
    INFO("change " << k++);
    IntersectResult wrong = result;
    change(wrong);
    CHECK(unsound(pair.x, pair.y, wrong) != "");
  }
}

TEST_CASE("graph checks: what is missing or too much is seen") {
  const Pair pair = loop_and_arc();
  const IntersectResult result = intersect(pair.x, pair.y);
  const auto longest =
      std::max_element(result.graph.arcs.begin(), result.graph.arcs.end(),
                       [](const Arc& a, const Arc& b) { return a.polyline.size() < b.polyline.size(); });
  IntersectionGraph less = result.graph;
  less.arcs.erase(less.arcs.begin() + (longest - result.graph.arcs.begin()));
  CHECK(compare_with_oracle(pair.x, pair.y, less).difference != "");
  IntersectionGraph more = result.graph;
  more.arcs.push_back(*longest);
  CHECK(compare_with_oracle(pair.x, pair.y, more).difference != "");
  const ExactCase touch = families::cap(0, families::Plane::square);
  CHECK(compare_with_oracle(touch.x, touch.y, {}).difference != "");
  const ExactCase nothing = families::cap(Rational(-1, 100), families::Plane::square);
  CHECK(compare_with_oracle(nothing.x, nothing.y, {}).difference == "");
}

TEST_CASE("graph checks: lines across singular situations are conclusive") {
  using families::Plane;
  for (const ExactCase& c : {families::crossing(Plane::square), families::curve_cusp(Plane::bilinear)}) {
    INFO(c.name);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto line = oracle::line_points(c.x, c.y, i, 0.63);
      CHECK(line.doubt == "");
      CHECK(line.points.size() == 2);
    }
  }
}

}  // namespace exsect::graph_checks_test

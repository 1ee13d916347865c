// Results in other parameters.
#include "answer/parameter_names.h"

#include <exsect/solver/intersect.h>

#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::parameter_names_test {
namespace {

/// (u,v,r,s) as far as p is concerned: s' = s / (k (1 - s) + s).
Rational moved(const Rational& t, const Rational& k) { return t / (k * (1 - t) + t); }

}  // namespace

TEST_CASE("parameter names: a Moebius map of one parameter, and the map back") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    const random_pairs::Pair pair = random_pairs::doubles(generator);
    IntersectResult given = intersect(pair.x, pair.y);
    given.incomplete.push_back({{{{0, 1}, {0, 1}, {0, 1}, {Rational(1, 4), 1}}}, "", Reason::time});
    IntersectResult result = given;
    const Rational k(5, 3);
    change_parameter(result, Parameter::s, k);
    REQUIRE(result.graph.nodes.size() == given.graph.nodes.size());
    for (std::size_t i = 0; i < given.graph.nodes.size(); ++i) {
      const Node& before = given.graph.nodes[i];
      const Node& after = result.graph.nodes[i];
      CHECK(after.box[3].lower == moved(before.box[3].lower, k));
      CHECK(after.box[3].upper == moved(before.box[3].upper, k));
      CHECK(after.box[2].lower == before.box[2].lower);
      CHECK(std::abs(after.approx[3] - to_double(moved(from_double(before.approx[3]), k))) < 1e-15);
      CHECK(after.on == before.on);
    }
    CHECK(result.incomplete.back().where[3].lower == Rational(1, 6));
    CHECK(result.incomplete.back().where[3].upper == 1);
    for (std::size_t i = 0; i < given.graph.arcs.size(); ++i) {
      const std::vector<PolylineVertex>& before = given.graph.arcs[i].polyline;
      const std::vector<PolylineVertex>& after = result.graph.arcs[i].polyline;
      for (std::size_t j = 0; j < before.size(); ++j) {
        CHECK(after[j].point == before[j].point);
        CHECK(after[j].parameters[1] == before[j].parameters[1]);
        CHECK(std::abs(after[j].parameters[3] - to_double(moved(from_double(before[j].parameters[3]), k))) <
              1e-15);
      }
    }
    change_parameter(result, Parameter::s, Rational(1 / k));
    CHECK(difference(given.graph, result.graph, {}, 1e-14) == "");
  }
}

TEST_CASE("parameter names: rims of overlaps are in other parameters too") {
  random_pairs::Generator generator(2);
  const BezierPatch x = random_pairs::small_rationals(generator).x;
  IntersectResult result = intersect(x, x);
  REQUIRE(result.graph.overlaps.size() == 1);
  change_parameter(result, Parameter::u, 3);
  for (const Arc& arc : result.graph.overlaps[0].chains[0])
    for (const PolylineVertex& vertex : arc.polyline) {
      const auto& [u, v, r, s] = vertex.parameters;
      CHECK(std::abs(u - r / (3 * (1 - r) + r)) < 1e-15);
      CHECK(v == s);
    }
}

TEST_CASE("parameter names: pieces over a box in the parameters of the whole") {
  random_pairs::Generator generator(3);
  const random_pairs::Pair pair = random_pairs::doubles(generator);
  const IntersectResult given = intersect(pair.x, pair.y);
  REQUIRE_FALSE(given.graph.arcs.empty());
  IntersectResult placed = given;
  const ParameterBox over = {
      {{Rational(1, 3), Rational(1, 2)}, {0, 1}, {Rational(1, 8), Rational(3, 8)}, {Rational(2, 5), 1}}};
  place_parameters(placed, over);
  for (std::size_t i = 0; i < given.graph.nodes.size(); ++i) {
    const Node &before = given.graph.nodes[i], &after = placed.graph.nodes[i];
    CHECK(after.on.empty());
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(after.box[j].lower == over[j].lower + over[j].width() * before.box[j].lower);
      CHECK(after.box[j].upper == over[j].lower + over[j].width() * before.box[j].upper);
      const Rational at = over[j].lower + over[j].width() * from_double(before.approx[j]);
      CHECK(std::abs(after.approx[j] - to_double(at)) < 1e-15);
    }
  }
  const PolylineVertex &before = given.graph.arcs[0].polyline[1], &after = placed.graph.arcs[0].polyline[1];
  CHECK(after.point == before.point);
  CHECK(std::abs(after.parameters[2] - (0.125 + 0.25 * before.parameters[2])) < 1e-15);
}

}  // namespace exsect::parameter_names_test

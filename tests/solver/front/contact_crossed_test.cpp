// Patches that touch along a curve which another curve of the pair crosses: by closed formulas.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/special/revolved.h"
#include "support/catch.h"
#include "support/polynomial_patch.h"
#include "support/random_nets.h"

namespace exsect::contact_crossed_test {
namespace {

using Surface = std::array<BivariatePolynomial, 3>;

const BivariatePolynomial kU = BivariatePolynomial::r(), kV = BivariatePolynomial::s();
const Rational kHalf(1, 2);

BivariatePolynomial number(const Rational& c) { return BivariatePolynomial::constant(c); }
BivariatePolynomial times(const Rational& c, const BivariatePolynomial& f) { return number(c) * f; }

struct Carrier {
  const char* name;
  bool has_inverse;
  Surface at;
};

std::vector<Carrier> carriers() {
  const Rational a(1, 8), b(1, 16), c(1, 24);
  const BivariatePolynomial &u = kU, &v = kV;
  return {{"plane", true, {u, v, number(0)}},
          {"cylinder along v", true, {u, v, u * u}},
          {"cylinder along u", true, {u, v, v * v - v}},
          {"saddle", true, {u, v, u * v}},
          {"biquadratic",
           false,
           {u + times(a, u * u) + times(b, v * v), v + times(a, u * v), u * u - v * v + u * v * v}},
          {"bicubic", false, {u + times(c, u * u * u), v + times(c, v * v * v), u * u * v + v * v}}};
}

/// A distance from a carrier: 0 along a line v = const where it does not change sign, or is a cube, and on
/// what crosses that line.
struct Distance {
  const char* name;
  BivariatePolynomial q;
  double v;                                // of the line
  int tangential, transversal, crossings;  // arcs and nodes, without turning points
};

std::vector<Distance> distances() {
  const BivariatePolynomial line = kV - number(kHalf), up = kU - number(kHalf), twice = line * line;
  const BivariatePolynomial two = (kU - number(Rational(1, 4))) * (kU - number(Rational(3, 4)));
  return {{"a line", twice * up, 0.5, 2, 2, 1},
          {"a slanted line", twice * (up + times(Rational(1, 3), line)), 0.5, 2, 2, 1},
          {"two lines", twice * two, 0.5, 3, 4, 2},
          {"a curve that crosses twice", twice * (line + times(4, two)), 0.5, 3, 3, 2},
          {"in an irrational point", twice * (kU * kU - kV), 0.5, 2, 2, 1},
          {"a curve that touches it", twice * (line - times(4, up * up)), 0.5, 2, 2, 1},
          {"a curve with an inflection there", twice * (line - times(8, up * up * up)), 0.5, 2, 2, 1},
          {"contact of second order", twice * line * up, 0.5, 2, 2, 1},
          {"along a side", kV * kV * up, 0, 2, 1, 1},
          {"in a corner", kV * kV * kU, 0, 1, 1, 0}};
}

RationalPatch beside(const Carrier& carrier, const Distance& distance) {
  Surface off = carrier.at;
  off[2] += distance.q;
  return testing::patch_of(off);
}

/// Over u and v from -1 to 2.
RationalPatch widened(const Carrier& carrier) {
  const BivariatePolynomial p = times(3, kU) - number(1), q = times(3, kV) - number(1);
  Surface wide;
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i <= carrier.at[k].degree_r(); ++i)
      for (int j = 0; j <= carrier.at[k].degree_s(); ++j) {
        BivariatePolynomial term = number(carrier.at[k].coefficient(i).coefficient(j));
        for (int n = 0; n < i; ++n) term = term * p;
        for (int n = 0; n < j; ++n) term = term * q;
        wide[k] += term;
      }
  return testing::patch_of(wide);
}

/// Both parameters of y as functions of those of x.
struct Place {
  std::array<double, 2> from = {-1, -1}, size = {3, 3};
};

/// The graph is that of the zeros of the distance; `place` is where they are on y.
void check_zeros(const IntersectionGraph& graph, const Distance& distance, const Place& place = {}) {
  std::array<int, 2> arcs = {0, 0};
  for (const Arc& arc : graph.arcs) {
    const bool is_tangential = arc.contact == Contact::tangential;
    ++arcs[is_tangential ? 0 : 1];
    double off = 0;
    for (const PolylineVertex& vertex : arc.polyline) {
      const auto& [u, v, r, s] = vertex.parameters;
      off = std::max({off, std::fabs(place.from[0] + place.size[0] * r - u),
                      std::fabs(place.from[1] + place.size[1] * s - v),
                      std::fabs(to_double(distance.q(from_double(u), from_double(v)))),
                      is_tangential ? std::fabs(v - distance.v) : 0});
    }
    CHECK(off < 1e-5);
  }
  CHECK(arcs == std::array<int, 2>{distance.tangential, distance.transversal});
  CHECK(graph.components.size() == 1);
  CHECK(graph.isolated_points.empty());
  const auto is = [](const Node& node, NodeKind kind) { return std::ranges::count(node.kinds, kind) > 0; };
  CHECK(std::ranges::count_if(graph.nodes, [&](const Node& node) {
          return is(node, NodeKind::crossing) && !is(node, NodeKind::corner);
        }) == distance.crossings);
}

IntersectOptions without_turnings() {
  IntersectOptions options;
  options.turning = {};
  options.max_seconds = 60;
  return options;
}

}  // namespace

TEST_CASE("contact crossed: complete with an inverse, without one nothing wrong") {
  for (const Carrier& carrier : carriers())
    for (const Distance& distance : distances()) {
      INFO(carrier.name << ", " << distance.name);
      const IntersectResult result =
          intersect(beside(carrier, distance), widened(carrier), without_turnings());
      if (carrier.has_inverse) REQUIRE(result.status == Status::complete);
      if (result.status == Status::complete)
        check_zeros(result.graph, distance);
      else
        CHECK_FALSE(result.incomplete.empty());
    }
}

TEST_CASE("contact crossed: turned, in inches, far away, and by a projective map") {
  random_nets::Generator generator(2024);
  for (const std::size_t k : {1, 3})
    for (const Distance& distance : distances()) {
      const Carrier carrier = carriers()[k];
      const RationalPatch x = beside(carrier, distance), y = widened(carrier);
      const Rational c(381, 25), s(508, 25), far(100000000);  // 25.4 times 3/5 and 4/5
      for (const random_nets::ProjectiveMap& map :
           {random_nets::ProjectiveMap{{{c, -s, 0, far}, {s, c, 0, -far}, {0, 0, 25, 0}, {0, 0, 0, 1}}},
            random_nets::projective_map(generator)}) {
        INFO(carrier.name << ", " << distance.name);
        const IntersectResult result =
            intersect(random_nets::image(x, map), random_nets::image(y, map), without_turnings());
        REQUIRE(result.status == Status::complete);
        check_zeros(result.graph, distance);
      }
    }
}

TEST_CASE("contact crossed: along a circle of a cylinder") {
  const auto cylinder = [](const Rational& from, const Rational& to, const Rational& below,
                           const Rational& above) {
    return revolved::patch({{1, below, 1}, {1, above, 1}}, revolved::arc(from, to));
  };
  const RationalPatch inner = cylinder(0, 1, 0, 1);
  for (const Distance& distance : distances()) {
    if (distance.q.degree_r() > 1) continue;
    INFO(distance.name);
    // (1 + q) times the radius.
    std::array<BivariatePolynomial, 4> at;
    for (std::size_t k = 0; k < 4; ++k) at[k] = inner.component(static_cast<int>(k)).exchanged();
    for (const std::size_t k : {0, 1}) at[k] = at[k] * (number(1) + distance.q);
    std::vector<std::vector<HomogeneousPoint>> net(4, std::vector<HomogeneousPoint>(4));
    for (std::size_t k = 0; k < 4; ++k) {
      const auto values = tensor_bernstein(at[k], 3, 3);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) net[i][j][k] = values[i][j];
    }
    const RationalPatch y = cylinder(-kHalf, Rational(3, 2), -1, 2);
    const IntersectResult result = intersect(RationalPatch::from_homogeneous(net), y, without_turnings());
    REQUIRE(result.status == Status::complete);
    IntersectionGraph graph = result.graph;  // with the angle of y as r
    for (Arc& arc : graph.arcs)
      for (PolylineVertex& vertex : arc.polyline) std::swap(vertex.parameters[2], vertex.parameters[3]);
    check_zeros(graph, distance, {{-0.5, -1}, {2, 3}});
  }
}

}  // namespace exsect::contact_crossed_test

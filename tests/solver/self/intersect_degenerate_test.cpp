// Self-intersections of patches in special position: folded lines, cuspidal points on sides, folds, collapsed
// sides.
#include <exsect/solver/intersect.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

#include "self/degenerate.h"
#include "shape/special_cusps.h"
#include "support/catch.h"

namespace exsect::intersect_degenerate_test {

namespace {

const Rational half(1, 2);

struct Term {
  int i;
  int j;
  Point p;
};

BezierPatch patch(const std::vector<Term>& terms) {
  ControlNet c{};
  for (const Term& term : terms) {
    Point& entry = c[static_cast<std::size_t>(term.i)][static_cast<std::size_t>(term.j)];
    entry = entry + term.p;
  }
  return BezierPatch::from_power_basis(c);
}

/// (a, b^2, a b) with a = u - u0, b = v - v0: the Whitney umbrella, x(u0, v0 + t) = x(u0, v0 - t).
BezierPatch umbrella(const Rational& u0, const Rational& v0) {
  return patch({{1, 0, {1, 0, -v0}}, {0, 1, {0, -2 * v0, -u0}}, {0, 2, {0, 1, 0}}, {1, 1, {0, 0, 1}}});
}

/// In fewer seconds of processor time than given: other programs may keep this one waiting.
IntersectResult self_intersect_within(double seconds, const BezierPatch& x) {
  const std::clock_t start = std::clock();
  IntersectResult result = self_intersect(x);
  CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < seconds);
  return result;
}

void check_incomplete(const BezierPatch& x, const std::string& reason) {
  const auto result = self_intersect_within(20, x);
  REQUIRE(result.status == Status::incomplete);
  CAPTURE(result.incomplete.front().why);
  CHECK(result.incomplete.front().why.find(reason) != std::string::npos);
}

void check_nothing(const BezierPatch& x) {
  const auto result = self_intersect(x);
  CHECK(result.status == Status::complete);
  CHECK(result.graph.nodes.empty());
}

/// One arc from the pair `end` on the boundary to the cuspidal point.
void check_fold(const BezierPatch& x, const std::array<double, 4>& end, const std::array<double, 2>& cusp,
                ArcPlace place) {
  const auto result = self_intersect(x);
  REQUIRE(result.status == Status::complete);
  const IntersectionGraph& graph = result.graph;
  REQUIRE(graph.components.size() == 1);
  REQUIRE(graph.arcs.size() == 1);
  REQUIRE(graph.nodes.size() == 2);
  CHECK(graph.arcs[0].place == place);
  for (const Node& node : graph.nodes) {
    if (node.kinds.front() == NodeKind::cusp) {
      for (std::size_t j = 0; j < 4; ++j) CHECK(std::fabs(node.approx[j] - cusp[j % 2]) < 1e-13);
    } else {
      const std::size_t shift =
          std::fabs(node.approx[0] - end[0]) + std::fabs(node.approx[1] - end[1]) < 1e-9 ? 0 : 2;
      for (std::size_t j = 0; j < 4; ++j) CHECK(std::fabs(node.approx[(j + shift) % 4] - end[j]) < 1e-13);
    }
  }
  for (const PolylineVertex& v : graph.arcs[0].polyline) {
    CHECK(std::fabs(v.parameters[0] - cusp[0]) < 1e-13);
    CHECK(std::fabs(v.parameters[2] - cusp[0]) < 1e-13);
    CHECK(std::fabs(v.parameters[1] + v.parameters[3] - 2 * cusp[1]) < 1e-12);
  }
}

}  // namespace

TEST_CASE("folded lines and cuspidal points on sides are exact") {
  const auto umbrellas = folded_lines(umbrella(Rational(1, 3), half).exchanged());
  REQUIRE(umbrellas.size() == 1);
  CHECK(umbrellas[0].turn.s() == RealAlgebraic(Rational(1, 3)));
  CHECK(sign_at(BivariatePolynomial::r() - BivariatePolynomial::constant(half), umbrellas[0].turn) == 0);
  CHECK(!umbrellas[0].side[0]);
  CHECK(!umbrellas[0].side[1]);
  CHECK(folded_lines(umbrella(Rational(1, 3), half)).empty());
  const auto corner = folded_lines(umbrella(0, 1).exchanged());
  REQUIRE(corner.size() == 1);
  CHECK(corner[0].side[0] == 1);
  CHECK(corner[0].side[1] == 0);
  CHECK(folded_lines(umbrella(2, half).exchanged()).empty());
  const auto cusps = side_cusps(umbrella(0, Rational(1, 4)));
  REQUIRE(cusps.size() == 1);
  CHECK(cusps[0].side == 0);
  CHECK(cusps[0].at == RealAlgebraic(Rational(1, 4)));
  CHECK(side_cusps(umbrella(half, half)).empty());
}

TEST_CASE("self_intersect: Whitney umbrellas") {
  check_fold(umbrella(half, half), {0.5, 1, 0.5, 0}, {0.5, 0.5}, ArcPlace::interior);
  check_fold(umbrella(Rational(1, 3), Rational(1, 4)), {1.0 / 3, 0.5, 1.0 / 3, 0}, {1.0 / 3, 0.25},
             ArcPlace::interior);
  check_fold(umbrella(Rational(1, 3), Rational(3, 4)), {1.0 / 3, 0.5, 1.0 / 3, 1}, {1.0 / 3, 0.75},
             ArcPlace::interior);
  check_fold(umbrella(0, half), {0, 1, 0, 0}, {0, 0.5}, ArcPlace::patch_boundary);
  check_fold(umbrella(1, Rational(1, 4)), {1, 0.5, 1, 0}, {1, 0.25}, ArcPlace::patch_boundary);
  // The turn is on the line's end or outside, the line is run through once.
  check_nothing(umbrella(half, 0));
  check_nothing(umbrella(half, 1));
  check_nothing(umbrella(0, 0));
  check_nothing(umbrella(Rational(-1, 1000), half));
  check_nothing(umbrella(half, Rational(1001, 1000)));
}

TEST_CASE("self_intersect: umbrellas nearly along a parameter line, nearly on a side") {
  // (a + e b, b^2, a b), a = u - u0, b = v - 1/2: the pairs a = -+e b, b = +-t.
  const auto slanted = [](const Rational& u0, const Rational& e) {
    return patch({{1, 0, {1, 0, -half}}, {0, 1, {e, -1, -u0}}, {0, 2, {0, 1, 0}}, {1, 1, {0, 0, 1}}});
  };
  const auto check_one_curve = [](const BezierPatch& x, const Rational& u_end, const Rational& v_end) {
    const auto result = self_intersect(x);
    REQUIRE(result.status == Status::complete);
    REQUIRE(result.graph.components.size() == 1);
    CHECK(result.graph.count(ComponentShape::open) == 1);
    REQUIRE(result.graph.boundary_points() == 1);
    for (const Node& node : result.graph.nodes) {
      if (node.kinds.front() != NodeKind::boundary) continue;
      const std::size_t first = node.box[1].lower > half ? 0 : 2;
      CHECK(node.box[first].lower <= u_end);
      CHECK(node.box[first].upper >= u_end);
      CHECK(node.box[first + 1].lower <= v_end);
      CHECK(node.box[first + 1].upper >= v_end);
    }
  };
  Rational e = 1;
  for (const int digits : {3, 6}) {
    INFO("e = 10^-" << digits);
    e = 1;
    for (int i = 0; i < digits; ++i) e /= 10;
    check_one_curve(slanted(half, e), half - e / 2, 1);
    check_one_curve(slanted(half, -e), half + e / 2, 1);
    const Rational third(1, 3);
    check_one_curve(slanted(e, third), 0, half + 3 * e);
    check_nothing(slanted(-e, third));
  }
  check_nothing(slanted(0, Rational(1, 3)));
}

TEST_CASE("self_intersect: two cuspidal points near each other") {
  const std::array<std::array<int, 3>, 9> points = {{{-2, 2, -1},
                                                     {-1, 2, 1},
                                                     {0, -1, -2},
                                                     {2, -1, 1},
                                                     {-1, 2, -1},
                                                     {2, -2, 2},
                                                     {-2, -2, -2},
                                                     {2, 0, 2},
                                                     {1, 2, 0}}};
  ControlNet net;
  for (std::size_t i = 0; i < 9; ++i) net[i / 3][i % 3] = {points[i][0], points[i][1], points[i][2]};
  const auto result = self_intersect_within(5, BezierPatch(net));
  REQUIRE(result.status == Status::complete);
  CHECK(result.graph.components.size() == 2);
  CHECK(result.graph.boundary_points() == 1);
  CHECK(std::count_if(result.graph.nodes.begin(), result.graph.nodes.end(),
                      [](const Node& n) { return n.kinds.front() == NodeKind::cusp; }) == 3);
  for (const Parameter p : all_parameters) CHECK(result.graph.turning_points(p) >= 1);
}

TEST_CASE("self_intersect: an umbrella sheared against the parameters") {
  // a = u - 1/3, b = v - 1/2; u is replaced by u + v b: the fold is no parameter line, the cusp is the same.
  const Rational third(1, 3);
  const BezierPatch x = patch({{1, 0, {1, 0, -half}},
                               {0, 1, {0, -1, -third}},
                               {0, 2, {0, 1, half}},
                               {1, 1, {0, half, 1}},
                               {2, 0, {0, 0, Rational(1, 5)}},
                               {0, 0, {0, 0, 0}}});
  const auto result = self_intersect(x);
  CHECK(result.status == Status::complete);
  for (const Node& node : result.graph.nodes)
    CHECK((node.kinds.front() == NodeKind::cusp || !node.on.empty() || !node.wrt.empty()));
}

TEST_CASE("self_intersect: patches that do not meet themselves") {
  check_nothing(patch({{1, 0, {1, 0, 0}}, {0, 1, {0, 1, 0}}}));                     // plane
  check_nothing(patch({{1, 0, {1, 0, 0}}, {0, 1, {0, 1, 0}}, {1, 1, {0, 0, 1}}}));  // bilinear
  check_nothing(patch({{1, 0, {1, 0, 0}}, {0, 1, {0, 1, 0}}, {2, 2, {0, 0, 1}}}));  // graph
  check_nothing(
      patch({{1, 0, {1, 0, 0}}, {0, 1, {0, 1, 0}}, {2, 0, {0, Rational(1, 4), 0}}}));  // plane, curved
}

TEST_CASE("self_intersect: a side that is one point is one node") {
  // u (1, v, v^2), and with the tip on the side v = 1.
  const BezierPatch cone = patch({{1, 0, {1, 0, 0}}, {1, 1, {0, 1, 0}}, {1, 2, {0, 0, 1}}});
  for (const bool exchanged : {false, true}) {
    const auto result = self_intersect(exchanged ? cone.exchanged().reversed_second() : cone);
    CHECK(result.status == Status::complete);
    CHECK(result.graph.arcs.empty());
    REQUIRE(result.graph.nodes.size() == 1);
    const Node& tip = result.graph.nodes.front();
    CHECK(result.graph.isolated_points == std::vector<int>{0});
    using enum Parameter;
    CHECK(tip.on == (exchanged ? std::vector<Side>{{v, 1}, {s, 1}} : std::vector<Side>{{u, 0}, {r, 0}}));
    CHECK(tip.free == (exchanged ? std::vector<Parameter>{u, r} : std::vector<Parameter>{v, s}));
    for (const Parameter p : tip.free) {
      CHECK(tip.box[index(p)].lower == 0);
      CHECK(tip.box[index(p)].upper == 1);
    }
  }
  // Both ends of the line v = 0 are the tip.
  check_incomplete(patch({{1, 0, {1, 0, 0}}, {2, 0, {-1, 0, 0}}, {1, 1, {0, 1, 0}}, {1, 2, {0, 0, 1}}}),
                   "so are other points");
  // A sector covered twice.
  const auto sector = self_intersect(
      patch({{1, 0, {1, 0, half / 2}}, {1, 1, {0, 0, -1}}, {1, 2, {0, 0, 1}}, {2, 0, {0, 1, 0}}}));
  CHECK(sector.status == Status::complete);
  CHECK(sector.graph.isolated_points.size() == 1);
  CHECK(sector.graph.overlaps.size() == 1);
}

namespace {

/// ((u - fold)^2, v, v^2).
BezierPatch folded(const Rational& fold) {
  return patch({{0, 0, {fold * fold, 0, 0}},
                {1, 0, {-2 * fold, 0, 0}},
                {2, 0, {1, 0, 0}},
                {0, 1, {0, 1, 0}},
                {0, 2, {0, 0, 1}}});
}

}  // namespace

TEST_CASE("self_intersect: a fold is an overlap of the patch with itself") {
  for (const Rational& fold : {half, Rational(1, 3), Rational(3, 4), power_of_two(-40)}) {
    CAPTURE(fold);
    const Rational reach = std::min<Rational>(fold, 1 - fold);
    for (const bool exchanged : {false, true}) {
      const BezierPatch x = exchanged ? folded(fold).exchanged() : folded(fold);
      const auto result = self_intersect(x);
      CHECK(result.status == Status::complete);
      CHECK(result.graph.arcs.empty());
      REQUIRE(result.graph.overlaps.size() == 1);
      REQUIRE(result.graph.overlaps[0].chains.size() == 1);
      const std::vector<Arc>& chain = result.graph.overlaps[0].chains[0];
      REQUIRE(chain.size() == 4);
      const std::size_t across = exchanged ? 1 : 0;
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(chain[i].to == chain[(i + 1) % 4].from);
        const Node& node = result.graph.nodes[static_cast<std::size_t>(chain[i].from)];
        const Rational d = i == 1 || i == 2 ? reach : Rational(0);
        CHECK(node.box[across].lower == fold + d);
        CHECK(node.box[across].upper == fold + d);
        CHECK(node.box[across + 2].lower == fold - d);
        for (const PolylineVertex& v : chain[i].polyline) {
          CHECK(std::fabs(v.parameters[across] + v.parameters[across + 2] - 2 * to_double(fold)) < 1e-15);
          CHECK(v.parameters[1 - across] == v.parameters[3 - across]);
        }
      }
      CHECK(intersect(x, x).status == Status::complete);
      CHECK(intersect(x, x).graph.overlaps.size() == 3);
    }
  }
  // The fold is on a side or outside.
  check_nothing(folded(0));
  check_nothing(folded(1));
  check_nothing(folded(-power_of_two(-40)));
}

TEST_CASE("self_intersect: planar bilinear patches") {
  const auto bilinear = [](const std::array<Point, 4>& p) {
    return BezierPatch::elevated({{p[0], p[1]}, {p[2], p[3]}});
  };
  // Convex, with a reflex corner, and crossed: the preimages of a point are two or none.
  check_nothing(bilinear({{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 3, 0}}}));
  int folded_patches = 0;
  for (const Point& last : {Point{Rational(1, 3), Rational(1, 4), 0}, Point{-2, Rational(1, 2), 0},
                            Point{half, half / 2, 0}, Point{Rational(1, 5), Rational(-3), 0}}) {
    const BezierPatch x = bilinear({{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, last}});
    const auto result = self_intersect(x);
    CHECK(result.status == Status::complete);
    REQUIRE(result.graph.overlaps.size() == 1);
    ++folded_patches;
    const std::vector<Arc>& chain = result.graph.overlaps[0].chains[0];
    CHECK(chain.size() >= 3);
    int folds = 0;
    Rational twice_the_area = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Node& node = result.graph.nodes[static_cast<std::size_t>(chain[i].from)];
      const Node& next = result.graph.nodes[static_cast<std::size_t>(chain[i].to)];
      CHECK(chain[i].to == chain[(i + 1) % chain.size()].from);
      CHECK(x(node.box[0].lower, node.box[1].lower) == x(node.box[2].lower, node.box[3].lower));
      folds += chain[i].place == ArcPlace::interior ? 1 : 0;
      twice_the_area += node.box[0].lower * next.box[1].lower - node.box[1].lower * next.box[0].lower;
    }
    CHECK(folds == 1);
    // Brute force: the part of the square with t > 0 whose partners are in it.
    const PlanarFold fold = *planar_fold(x);
    constexpr int kCells = 40;
    int inside = 0;
    for (int i = 0; i < kCells; ++i)
      for (int j = 0; j < kCells; ++j) {
        const Rational u(2 * i + 1, 2 * kCells);
        const Rational v(2 * j + 1, 2 * kCells);
        const Rational t = fold.t[0] + fold.t[1] * u + fold.t[2] * v;
        const Rational r = u + t * fold.direction[0];
        const Rational s = v + t * fold.direction[1];
        CHECK(x(u, v) == x(r, s));
        inside += t > 0 && r >= 0 && r <= 1 && s >= 0 && s <= 1 ? 1 : 0;
      }
    CHECK(std::fabs(std::fabs(to_double(twice_the_area)) / 2 - inside / (1.0 * kCells * kCells)) < 0.03);
  }
  CHECK(folded_patches == 4);
  // A bow tie: the line u = 1/3 is one point.
  for (const bool exchanged : {false, true}) {
    const BezierPatch bow = bilinear({{{0, 1, 0}, {0, -1, 0}, {3, -2, 0}, {3, 2, 0}}});
    const auto result = self_intersect(exchanged ? bow.exchanged() : bow);
    CHECK(result.status == Status::complete);
    REQUIRE(result.graph.isolated_points.size() == 1);
    const Node& node = result.graph.nodes[0];
    CHECK(node.box[exchanged ? 1 : 0].lower == Rational(1, 3));
    CHECK(node.free == (exchanged ? std::vector<Parameter>{Parameter::u, Parameter::r}
                                  : std::vector<Parameter>{Parameter::v, Parameter::s}));
  }
}

TEST_CASE("self_intersect: patches that are a curve or a point") {
  const auto parabola = self_intersect(patch({{1, 0, {1, 0, 0}}, {2, 0, {0, 1, 0}}}));
  CHECK(parabola.status == Status::complete);
  REQUIRE(parabola.graph.arcs.size() == 1);
  CHECK(parabola.graph.arcs[0].free == std::vector<Parameter>{Parameter::v, Parameter::s});
  const auto point = self_intersect(patch({{0, 0, {1, 2, 3}}}));
  CHECK(point.status == Status::complete);
  REQUIRE(point.graph.isolated_points.size() == 1);
  CHECK(point.graph.nodes[0].free.size() == 4);
}

TEST_CASE("self_intersect: folds that meet themselves are incomplete with a reason") {
  // The fold of an umbrella.
  check_incomplete(patch({{2, 0, {1, 0, 0}},
                          {1, 0, {-1, 0, 0}},
                          {0, 1, {0, -1, 0}},
                          {0, 2, {0, 1, 0}},
                          {2, 1, {0, 0, 1}},
                          {1, 1, {0, 0, -1}}}),
                   "covers its image more than once: (u, v) and (1 - u, v) are one point");
  // (u + v^2, 2 u^2 - u + v, 0), and the same where it is one to one.
  const auto planar = [](const Rational& bend) {
    return patch({{1, 0, {1, -half * bend, 0}}, {0, 1, {0, 1, 0}}, {0, 2, {1, 0, 0}}, {2, 0, {0, bend, 0}}});
  };
  check_incomplete(planar(2), "lies in a plane and folds over");
  check_nothing(planar(Rational(1, 4)));
}

}  // namespace exsect::intersect_degenerate_test

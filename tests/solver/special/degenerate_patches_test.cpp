// Patches that are a point or a curve: exact expected answers, and the laws of exchange.
#include "special/degenerate_patches.h"

#include <exsect/solver/intersect.h>

#include <algorithm>
#include <vector>

#include "shape/patch_shape.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"
#include "support/renaming_checks.h"

namespace exsect::degenerate_patches_test {
namespace {

using random_pairs::Pair;

BezierPatch point_patch(const Point& p) { return power({{{0, 0}, p}}); }
/// (r, s, r s).
BezierPatch saddle() { return power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}, {{1, 1}, {0, 0, 1}}}); }

bool contains(const RationalInterval& i, const Rational& q) { return i.lower <= q && q <= i.upper; }

/// The only node, complete, with the given exact parameters; a free one is given as -1.
void check_one_node(const Pair& pair, const std::array<Rational, 4>& at) {
  const IntersectResult result = intersect(pair.x, pair.y);
  CHECK(result.status == Status::complete);
  REQUIRE(result.graph.nodes.size() == 1);
  const Node& node = result.graph.nodes[0];
  CHECK(result.graph.isolated_points == std::vector<int>{0});
  for (const Parameter p : all_parameters) {
    const RationalInterval& box = node.box[index(p)];
    const bool free = std::count(node.free.begin(), node.free.end(), p) > 0;
    CHECK(free == (at[index(p)] == -1));
    if (free) {
      CHECK((box.lower == 0 && box.upper == 1));
    } else {
      CHECK(contains(box, at[index(p)]));
      CHECK(box.width() <= power_of_two(-45));
    }
  }
  check_renamings(pair, result.graph);
}

TEST_CASE("the dimension of a patch") {
  CHECK(shape(point_patch({1, 2, 3})) == PatchShape::point);
  CHECK(shape(power({{{1, 0}, {1, 0, 0}}, {{2, 0}, {0, 1, 0}}})) == PatchShape::curve_of_first);
  CHECK(shape(power({{{0, 2}, {1, 0, 0}}})) == PatchShape::curve_of_second);
  CHECK(shape(power({{{1, 1}, {1, 0, 0}}, {{2, 2}, {0, 1, 0}}})) == PatchShape::curve);
  CHECK(shape(power({{{1, 0}, {1, 2, 3}}, {{0, 2}, {2, 4, 6}}})) == PatchShape::curve);
  CHECK(shape(saddle()) == PatchShape::surface);
}

TEST_CASE("a point on and off a surface") {
  const Rational third(1, 3);
  const Rational quarter(1, 4);
  check_one_node({point_patch({third, quarter, third * quarter}), saddle()}, {-1, -1, third, quarter});
  check_one_node({point_patch({0, quarter, 0}), saddle()}, {-1, -1, 0, quarter});
  const auto off = intersect(point_patch({third, quarter, third}), saddle());
  CHECK(off.status == Status::complete);
  CHECK(off.graph.nodes.empty());
  const auto outside = intersect(point_patch({2, quarter, Rational(1, 2)}), saddle());
  CHECK(outside.status == Status::complete);
  CHECK(outside.graph.nodes.empty());
}

TEST_CASE("a point where a surface has several parameters") {
  // ((2r - 1)^2, s, 0) is run through twice.
  const BezierPatch folded =
      power({{{0, 0}, {1, 0, 0}}, {{1, 0}, {-4, 0, 0}}, {{2, 0}, {4, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  const Pair pair = {point_patch({Rational(1, 4), Rational(1, 2), 0}), folded};
  const IntersectResult result = intersect(pair.x, pair.y);
  CHECK(result.status == Status::complete);
  REQUIRE(result.graph.nodes.size() == 2);
  CHECK(contains(result.graph.nodes[0].box[2], Rational(1, 4)));
  CHECK(contains(result.graph.nodes[1].box[2], Rational(3, 4)));
  check_renamings(pair, result.graph);
}

TEST_CASE("a point on a collapsed parameter line") {
  // r (1, s, r): the side r = 0 is the origin.
  const BezierPatch collapsed = power({{{1, 0}, {1, 0, 0}}, {{1, 1}, {0, 1, 0}}, {{2, 0}, {0, 0, 1}}});
  check_one_node({point_patch({0, 0, 0}), collapsed}, {-1, -1, 0, -1});
  // (2 s^2 - 1) (r, 1, 0) + (0, 0, 2 s^2 - 1): the line s = sqrt(1/2).
  const BezierPatch inner =
      power({{{0, 0}, {0, -1, -1}}, {{0, 2}, {0, 2, 2}}, {{1, 0}, {-1, 0, 0}}, {{1, 2}, {2, 0, 0}}});
  const IntersectResult result = intersect(point_patch({0, 0, 0}), inner);
  CHECK(result.status == Status::complete);
  REQUIRE(result.graph.nodes.size() == 1);
  CHECK(result.graph.nodes[0].free == std::vector{Parameter::u, Parameter::v, Parameter::r});
  CHECK(result.graph.nodes[0].approx[3] == Approx(std::sqrt(0.5)).epsilon(1e-14));
}

TEST_CASE("a point on a collapsed curve that is no parameter line is incomplete") {
  // (r - s) (1, r, s)
  const BezierPatch collapsed = power({{{1, 0}, {1, 0, 0}},
                                       {{0, 1}, {-1, 0, 0}},
                                       {{2, 0}, {0, 1, 0}},
                                       {{1, 1}, {0, -1, 1}},
                                       {{0, 2}, {0, 0, -1}}});
  const IntersectResult result = intersect(point_patch({0, 0, 0}), collapsed);
  CHECK(result.status == Status::incomplete);
  CHECK(intersect(point_patch({1, 0, 0}), collapsed).status == Status::complete);
}

TEST_CASE("points and curves") {
  check_one_node({point_patch({1, 2, 3}), point_patch({1, 2, 3})}, {-1, -1, -1, -1});
  CHECK(intersect(point_patch({1, 2, 3}), point_patch({1, 2, 4})).graph.nodes.empty());
  const BezierPatch parabola = power({{{1, 0}, {1, 0, 0}}, {{2, 0}, {0, 1, 0}}});
  check_one_node({point_patch({Rational(1, 3), Rational(1, 9), 0}), parabola}, {-1, -1, Rational(1, 3), -1});
  check_one_node({point_patch({1, 1, 0}), parabola}, {-1, -1, 1, -1});
  CHECK(intersect(point_patch({2, 4, 0}), parabola).graph.nodes.empty());
}

TEST_CASE("a curve through a surface") {
  const BezierPatch line = power({{{0, 0}, {Rational(1, 3), Rational(1, 4), 0}}, {{1, 0}, {0, 0, 1}}});
  check_one_node({line, saddle()}, {Rational(1, 12), -1, Rational(1, 3), Rational(1, 4)});
  for (const std::vector<Parameter>& asked : {std::vector<Parameter>{}, {Parameter::u}, {Parameter::v}}) {
    IntersectOptions options;
    options.turning = asked;
    const IntersectResult result = intersect(line, saddle(), options);
    CHECK(result.graph.arcs.empty());
    CHECK(result.graph.nodes.size() == 1);
  }
}

/// The only component, complete: one open arc with the given parameters of its ends (ascending in u).
void check_one_arc(const Pair& pair, const std::vector<Parameter>& free, std::array<double, 4> from,
                   std::array<double, 4> to) {
  const IntersectResult result = intersect(pair.x, pair.y);
  for (const Incomplete& region : result.incomplete) UNSCOPED_INFO(region.why);
  CHECK(result.status == Status::complete);
  REQUIRE(result.graph.arcs.size() == 1);
  const Arc& arc = result.graph.arcs[0];
  CHECK(arc.free == free);
  CHECK(result.graph.nodes.size() == 2);
  CHECK(result.graph.isolated_points.empty());
  REQUIRE(result.graph.components.size() == 1);
  CHECK(result.graph.components[0].shape == ComponentShape::open);
  for (std::size_t i = 0; i < 4; ++i) {
    INFO("parameter " << i);
    CHECK(arc.polyline.front().parameters[i] == Approx(from[i]).margin(1e-12));
    CHECK(arc.polyline.back().parameters[i] == Approx(to[i]).margin(1e-12));
  }
  CHECK(arc.error_bound < 1e-5);
  check_renamings(pair, result.graph);
}

TEST_CASE("a curve on a surface in part") {
  // On (r, s, r s): r = 2 u - 1/2, s = 1/4, so u in [1/4, 3/4].
  const Rational half(1, 2);
  const BezierPatch line =
      power({{{0, 0}, {-half, half * half, -half * half * half}}, {{1, 0}, {2, 0, half}}});
  check_one_arc({line, saddle()}, {Parameter::v}, {0.25, 0.5, 0, 0.25}, {0.75, 0.5, 1, 0.25});
  // r = s = u, a parabola.
  const BezierPatch diagonal = power({{{1, 0}, {1, 1, 0}}, {{2, 0}, {0, 0, 1}}});
  check_one_arc({diagonal, saddle()}, {Parameter::v}, {0, 0.5, 0, 0}, {1, 0.5, 1, 1});
  // Along the side s = 0, from the middle on.
  const BezierPatch along = power({{{0, 0}, {half, 0, 0}}, {{1, 0}, {1, 0, 0}}});
  check_one_arc({along, saddle()}, {Parameter::v}, {0, 0.5, 0.5, 0}, {0.5, 0.5, 1, 0});
}

TEST_CASE("a curve on a surface ends at an irrational parameter") {
  // On (r, s, r s): r = u, s = 2 u - u^2... does not fit; take r = 1/2, s = 2 u^2: u up to sqrt(1/2).
  const BezierPatch line = power({{{0, 0}, {Rational(1, 2), 0, 0}}, {{2, 0}, {0, 2, 1}}});
  check_one_arc({line, saddle()}, {Parameter::v}, {0, 0.5, 0.5, 0}, {std::sqrt(0.5), 0.5, 0.5, 1});
}

TEST_CASE("two curves with an arc in common, or a point") {
  const BezierPatch parabola = power({{{1, 0}, {1, 0, 0}}, {{2, 0}, {0, 1, 0}}});
  // The same parabola over [1/3, 4/3].
  const BezierPatch shifted = parabola.restricted_to(Rational(1, 3), Rational(4, 3), 0, 1);
  check_one_arc({parabola, shifted}, {Parameter::v, Parameter::s}, {1.0 / 3, 0.5, 0, 0.5},
                {1, 0.5, 2.0 / 3, 0.5});
  const BezierPatch line = power({{{0, 0}, {1, 0, 0}}, {{1, 0}, {-1, 1, 0}}});  // x + y = 1
  const IntersectResult crossing = intersect(parabola, line);
  CHECK(crossing.status == Status::complete);
  REQUIRE(crossing.graph.isolated_points.size() == 1);
  CHECK(crossing.graph.nodes[0].approx[0] == Approx((std::sqrt(5) - 1) / 2).epsilon(1e-14));
  check_renamings({parabola, line}, crossing.graph);
  const BezierPatch skew = power({{{0, 0}, {0, 0, 1}}, {{1, 0}, {1, 2, 3}}});
  const IntersectResult nothing = intersect(parabola, skew);
  CHECK(nothing.status == Status::complete);
  CHECK(nothing.graph.nodes.empty());
}

}  // namespace
}  // namespace exsect::degenerate_patches_test

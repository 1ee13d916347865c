// A patch and the same patch with one control point moved: common sides, along some of which they touch, and
// arcs that leave these in irrational points.
#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/intersect.h>

#include <algorithm>
#include <vector>

#include "eliminant/critical_values.h"
#include "support/catch.h"
#include "support/graph_checks.h"

namespace exsect::moved_control_point_test {
namespace {

/// The polynomial (x_u × x_v)·d along the side v = 1 (or u = 0), by interpolation; its degree is at most 4.
Polynomial normal_along(const BezierPatch& x, Parameter fixed, const Rational& value, const Point& d) {
  Polynomial sum(0);
  for (int i = 0; i <= 4; ++i) {
    const Rational t(i);
    const Rational u = fixed == Parameter::u ? value : t;
    const Rational v = fixed == Parameter::u ? t : value;
    Polynomial basis(dot(d, cross(x.derivative_first(u, v), x.derivative_second(u, v))));
    for (int k = 0; k <= 4; ++k) {
      if (k != i) basis = basis * Polynomial({Rational(-k) / (i - k), Rational(1) / (i - k)});
    }
    sum = sum + basis;
  }
  return sum;
}

/// y - x = B(u,v) d with a double zero of B on the side: there the patches touch. Near it y(u,v) = x(u + a,
/// v + b) requires d to be tangent to x, so arcs leave the side where (x_u × x_v)·d vanishes.
void check_side(const BezierPatch& x, const Point& d, const IntersectionGraph& graph, const Side& side) {
  const Parameter along = side.parameter == Parameter::u ? Parameter::v : Parameter::u;
  std::vector<RealAlgebraic> roots;
  for (RealAlgebraic& root : real_roots(normal_along(x, side.parameter, side.value, d), 0, 1))
    if (root.compare(0) != 0 && root.compare(1) != 0) roots.push_back(std::move(root));
  std::vector<const Node*> nodes;
  for (const Node& node : graph.nodes) {
    const auto is_on = [&](const Side& other) {
      return std::find(node.on.begin(), node.on.end(), other) != node.on.end();
    };
    const std::ptrdiff_t degree = std::count_if(graph.arcs.begin(), graph.arcs.end(),
                                                [&](const Arc& arc) { return arc.from == node.id; }) +
                                  std::count_if(graph.arcs.begin(), graph.arcs.end(),
                                                [&](const Arc& arc) { return arc.to == node.id; });
    if (is_on(side) && node.on.size() == 2 && degree == 3) nodes.push_back(&node);
  }
  REQUIRE(nodes.size() == roots.size());
  for (const RealAlgebraic& root : roots) {
    CHECK(std::count_if(nodes.begin(), nodes.end(), [&](const Node* node) {
            const RationalInterval& at = node->box[index(along)];
            return root.compare(at.lower) >= 0 && root.compare(at.upper) <= 0;
          }) == 1);
  }
  CHECK(std::any_of(graph.arcs.begin(), graph.arcs.end(),
                    [](const Arc& arc) { return arc.contact == Contact::tangential; }));
}

ControlNet net(const std::array<std::array<int, 3>, 9>& points) {
  ControlNet result;
  for (std::size_t i = 0; i < 9; ++i) result[i / 3][i % 3] = {points[i][0], points[i][1], points[i][2]};
  return result;
}

IntersectResult check_complete(const BezierPatch& x, const BezierPatch& y) {
  IntersectResult result = intersect(x, y);
  CHECK(result.status == Status::complete);
  CHECK(unsound(x, y, result) == "");
  return result;
}

}  // namespace

TEST_CASE("a control point of a side is moved: arcs leave the side where the patches touch") {
  const ControlNet x = net({{{0, -1, -1},
                             {2, -1, 1},
                             {0, 0, 1},
                             {-2, 2, 0},
                             {-1, -2, -2},
                             {0, 2, 0},
                             {-2, 2, 2},
                             {0, -2, 2},
                             {-1, 0, -1}}});
  const Point d = {3, -2, 1};
  ControlNet y = x;
  y[1][0] = y[1][0] + d;
  const IntersectResult result = check_complete(BezierPatch(x), BezierPatch(y));
  check_side(BezierPatch(x), d, result.graph, {Parameter::v, 1});
  // Where an arc leaves the side, the simple points of the fibre have multiplicity two and the others none.
  const auto turning = turning_values(BezierPatch(x), BezierPatch(y), Parameter::u);
  REQUIRE(turning);
  CHECK(turning->touching);
  for (const RealAlgebraic& root : real_roots(normal_along(BezierPatch(x), Parameter::v, 1, d), 0, 1)) {
    if (root.compare(0) != 0 && root.compare(1) != 0)
      CHECK(std::count_if(turning->values.begin(), turning->values.end(), [&](const TurningValue& value) {
              return value.value == root && value.multiplicity == 2;
            }) == 1);
  }
}

TEST_CASE("a corner is moved: arcs leave both sides where the patches touch") {
  const ControlNet x = net({{{2, -1, 2},
                             {1, 2, -2},
                             {-1, 2, -1},
                             {2, 0, 1},
                             {0, -2, -2},
                             {2, 1, 0},
                             {1, 2, -2},
                             {2, 0, -2},
                             {-2, 0, -1}}});
  const Point d = {-1, -1, 2};
  ControlNet y = x;
  y[2][0] = y[2][0] + d;
  const IntersectResult result = check_complete(BezierPatch(x), BezierPatch(y));
  check_side(BezierPatch(x), d, result.graph, {Parameter::u, 0});
  check_side(BezierPatch(x), d, result.graph, {Parameter::v, 1});
}

}  // namespace exsect::moved_control_point_test

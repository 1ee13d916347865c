// Lines of patches with weights and of degree 3, as shown by `exsect line`.
#include "line/rational_line_intersection.h"

#include <exsect/solver/line_intersection.h>

#include <array>

#include "answer/parameter_box.h"
#include "line_shapes.h"
#include "point_checks.h"
#include "support/catch.h"

namespace exsect::rational_line_intersection_test {
namespace {

using Net = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Rational>>;

/// The plane z = height over [-3,3]^2.
RationalPatch floor_at(const Rational& height) {
  return RationalPatch(Net{{{-3, -3, height}, {-3, 3, height}}, {{3, -3, height}, {3, 3, height}}});
}

/// The line u = 0 is the curve; the patch goes off along x.
RationalPatch along_x(const std::vector<Point>& curve, const std::vector<Rational>& weights = {}) {
  Net net = {curve, curve};
  for (Point& p : net[1]) p[0] += 1;
  return RationalPatch(net, weights.empty() ? Weights{} : Weights{weights, weights});
}

LineIntersection solve(const RationalPatch& x, const RationalPatch& y) {
  LineIntersection line = intersect_line(x, y, {Parameter::u, 0});
  CHECK(!line.solution.incomplete);
  return line;
}

void check_same(const LinePoints& a, const LinePoints& b) {
  CHECK((!a.incomplete && !b.incomplete));
  REQUIRE(a.points.size() == b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const CertifiedPoint p = a.points[i].refined_to(power_of_two(-100)),
                         q = b.points[i].refined_to(power_of_two(-100));
    for (std::size_t k = 0; k < 4; ++k)
      CHECK((p.box()[k].lower <= q.box()[k].upper && q.box()[k].lower <= p.box()[k].upper));
    CHECK(p.sides() == q.sides());
    CHECK(p.multiplicity() == q.multiplicity());
    CHECK(p.branch() == q.branch());
  }
  REQUIRE(a.on_patch.size() == b.on_patch.size());
  for (std::size_t i = 0; i < a.on_patch.size(); ++i)
    CHECK((a.on_patch[i].from == b.on_patch[i].from && a.on_patch[i].to == b.on_patch[i].to));
}

/// The map (x, y, z) -> (x + z, y, z) / (1 + x/8 + z/16), which leaves the parameters alone.
RationalPatch projected(const RationalPatch& x) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= x.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= x.degree_v(); ++j) {
      const HomogeneousPoint& p = x.homogeneous(i, j);
      net.back().push_back({p[0] + p[2], p[1], p[2], p[3] + p[0] / 8 + p[2] / 16});
    }
  }
  return RationalPatch::from_homogeneous(net);
}

TEST_CASE("lines of polynomial biquadratic patches: the same by plane and cylinder and by moving planes") {
  const unsigned seed = 2024;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::size_t found = 0;
  for (int i = 0; i < 24; ++i) {
    const auto [x, y] = random_pair(random, i % 2 == 0 ? 4 : 1000);
    for (const Parameter p : all_parameters) {
      const LineQuery query = {p, Rational(i % 5, 4)};
      const LineIntersection by_forms = intersect_line(x, y, query);
      const LineIntersection by_planes = rational_line_intersection(x, y, query);
      CHECK(by_planes.shape == by_forms.shape);
      CHECK(by_planes.eliminant_variable == by_forms.eliminant_variable);
      if (by_forms.shape == LineShape::conic && by_forms.pullback.plane.degree_r() == 2) {
        CHECK(by_planes.eliminant == by_forms.eliminant);
        CHECK(cross(by_planes.plane.normal, by_forms.plane.normal) == Point{0, 0, 0});
        const bool same_way = dot(by_planes.plane.normal, by_forms.plane.normal) > 0;
        if (!same_way) continue;  // the branches change their names
        check_same(by_planes.solution, by_forms.solution);
        found += by_forms.solution.points.size();
      }
    }
  }
  CHECK(found > 20);
}

/// The same sets, in whatever order.
void check_same_sets(const LinePoints& a, const LinePoints& b) {
  REQUIRE(a.points.size() == b.points.size());
  for (const CertifiedPoint& p : a.points)
    CHECK(std::ranges::count_if(b.points, [&](const CertifiedPoint& q) {
            return meet(p.box(), q.box()) && p.sides() == q.sides() &&
                   (p.multiplicity() == 1) == (q.multiplicity() == 1);
          }) == 1);
  REQUIRE(a.on_patch.size() == b.on_patch.size());
  for (std::size_t i = 0; i < a.on_patch.size(); ++i) {
    CHECK(a.on_patch[i].from == b.on_patch[i].from);
    CHECK(a.on_patch[i].to == b.on_patch[i].to);
  }
}

TEST_CASE("lines full of coincidences: the same points and parts by both ways, and with weights") {
  const int range = GENERATE(1, 2);
  const int height = GENERATE(0, 1);
  std::size_t points = 0, parts = 0;
  for (unsigned seed = 1050; seed < 1080; ++seed) {
    INFO("range " << range << ", height " << height << ", seed " << seed);
    std::mt19937 random(seed);
    const auto [x, y] = grid_pair(random, range, height);
    const LineQuery query = {all_parameters[seed % 4], Rational(static_cast<int>(seed % 3), 2)};
    const LinePoints by_forms = intersect_line(x, y, query).solution;
    CHECK(!by_forms.incomplete);
    const LinePoints by_planes = rational_line_intersection(x, y, query).solution;
    if (by_planes.incomplete) continue;
    for (const CertifiedPoint& p : by_planes.points) check_point(x, y, p);
    check_same_sets(by_planes, by_forms);
    check_same_sets(rational_line_intersection(projected(x), projected(y), query).solution, by_forms);
    points += by_forms.points.size();
    parts += by_forms.on_patch.size();
  }
  CHECK(points + parts > 10);
}

TEST_CASE("a quarter circle with weights: plane, cylinder, eliminant and feasible interval") {
  // (0, (1 - t^2)/(1 + t^2), 2 t/(1 + t^2)), of weights 1, 1, 2.
  const RationalPatch quarter = along_x({{0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, {1, 1, 2});
  const LineIntersection line = solve(quarter, floor_at(Rational(3, 5)));
  CHECK(line.shape == LineShape::conic);
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)}) {
    const Point p = quarter(0, t);
    CHECK(line.plane(p) == 0);
    CHECK(line.forms->e0(p) * line.forms->e2(p) == line.forms->e1(p) * line.forms->e1(p));
    CHECK(line.forms->e1(p) == t * line.forms->e0(p));
  }
  REQUIRE(line.solution.points.size() == 1);
  // 2 t / (1 + t^2) = 3/5 at t = 1/3, where y = 4/5: (y + 3)/6 = 19/30.
  CHECK(contains(line.solution.points[0].box(), {0, Rational(1, 3), Rational(1, 2), Rational(19, 30)}));
  CHECK(line.solution.points[0].multiplicity() == 1);
  CHECK(sign_at(line.eliminant, RealAlgebraic(Rational(19, 30))) == 0);
  CHECK(line.eliminant.degree() == 2);  // y = 4/5 and y = -4/5
  REQUIRE(line.feasible.size() == 1);
  // t = z/(1 + y) is the slope seen from (-1,0): at z = 3/5 it is between 0 and 1 from y = -2/5 on.
  REQUIRE(line.feasible[0].intervals.size() == 1);
  CHECK(line.feasible[0].intervals[0].from == RealAlgebraic(Rational(13, 30)));
  CHECK(line.feasible[0].intervals[0].to == RealAlgebraic(1));
}

TEST_CASE("lines with weights that touch: the multiplicity, and the sides") {
  // The arc of weights 1, 2, 1 over z = 0, 3, 0 has its top 6 * 2 t (1-t) / (1 + 2 t (1-t)) = 2 at t = 1/2.
  const RationalPatch arc = along_x({{0, -1, 0}, {0, 0, 3}, {0, 1, 0}}, {1, 2, 1});
  const LineIntersection touch = solve(arc, floor_at(2));
  REQUIRE(touch.solution.points.size() == 1);
  CHECK(contains(touch.solution.points[0].box(), {0, Rational(1, 2), Rational(1, 2), Rational(1, 2)}));
  CHECK(touch.solution.points[0].multiplicity() == 2);
  CHECK(touch.solution.points[0].sides() == std::vector<Side>{{Parameter::u, 0}});
  CHECK(solve(arc, floor_at(2 + power_of_two(-200))).solution.points.empty());
  const LineIntersection near = solve(arc, floor_at(2 - power_of_two(-200)));
  REQUIRE(near.solution.points.size() == 2);
  for (const CertifiedPoint& p : near.solution.points) CHECK(p.multiplicity() == 1);
  const LineIntersection ends = solve(arc, floor_at(0));
  REQUIRE(ends.solution.points.size() == 2);
  CHECK(ends.solution.points[0].sides() == std::vector<Side>{{Parameter::u, 0}, {Parameter::v, 0}});
  CHECK(ends.solution.points[1].sides() == std::vector<Side>{{Parameter::u, 0}, {Parameter::v, 1}});
}

TEST_CASE("cubic lines: shapes, equations, and points where they touch") {
  // y = 2 t - 1, z = y^3 - y/4 in a plane: flat at y^2 = 1/12.
  const auto height = [](const std::array<Rational, 4>& z) {
    return std::vector<Point>{
        {0, -1, z[0]}, {0, Rational(-1, 3), z[1]}, {0, Rational(1, 3), z[2]}, {0, 1, z[3]}};
  };
  const Rational q(1, 4);
  const RationalPatch cubic = along_x(height({q - 1, 1 + q / 3, -1 - q / 3, 1 - q}));
  const LineIntersection through = solve(cubic, floor_at(0));
  CHECK(through.shape == LineShape::plane_cubic);
  CHECK(through.cubic.size() == 1);
  CHECK(through.eliminant.is_zero());
  REQUIRE(through.solution.points.size() == 3);  // y = -1/2, 0, 1/2
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational v(static_cast<int>(i) + 1, 4);
    CHECK(
        contains(through.solution.points[i].box(), {0, v, Rational(1, 2), Rational(1, 2) + (2 * v - 1) / 6}));
    CHECK(through.solution.points[i].multiplicity() == 1);
  }
  // z = y^3 - 3 y^2/4 = 1/2 ... at its lowest point y = 1/2 the height is -1/16.
  const RationalPatch flat =
      along_x(height({Rational(-7, 4), Rational(5, 4), Rational(-3, 4), Rational(1, 4)}));
  const LineIntersection touch = solve(flat, floor_at(Rational(-1, 16)));
  std::size_t touching = 0;
  for (const CertifiedPoint& p : touch.solution.points) {
    const bool at_bottom = contains(p.box(), {0, Rational(3, 4), Rational(1, 2), Rational(7, 12)});
    CHECK(p.multiplicity() == (at_bottom ? 0 : 1));
    touching += at_bottom ? 1 : 0;
  }
  CHECK(touching == 1);
  const RationalPatch twisted = along_x({{0, 0, -1}, {1, 0, 1}, {0, 1, -1}, {0, 0, 2}}, {1, 2, 1, 1});
  const LineIntersection space = solve(twisted, floor_at(0));
  CHECK(space.shape == LineShape::twisted_cubic);
  CHECK(space.cubic.size() == 3);
  CHECK(space.plane.normal == Point{0, 0, 0});
  for (const CertifiedPoint& p : space.solution.points) CHECK(p.multiplicity() == 1);
  CHECK(!space.solution.points.empty());
}

TEST_CASE("a cubic with a node: a patch that touches one of its branches") {
  // y = s^2 - 1/4, z = s^3 - s/4, s = 2 t - 1 ... the node y = z = 0 at s = +-1/2, tangents (1, +-1/2).
  const Rational q(1, 4);
  const RationalPatch nodal = along_x({{0, 1 - q, q - 1},
                                       {0, Rational(-1, 3) - q, 1 + q / 3},
                                       {0, Rational(-1, 3) - q, -1 - q / 3},
                                       {0, 1 - q, 1 - q}});
  // The plane z = y/2 over x, y in [-3,3].
  const RationalPatch slope(Net{{{-3, -3, Rational(-3, 2)}, {-3, 3, Rational(3, 2)}},
                                {{3, -3, Rational(-3, 2)}, {3, 3, Rational(3, 2)}}});
  const LineIntersection line = solve(nodal, slope);
  std::size_t at_node = 0;
  for (const CertifiedPoint& p : line.solution.points) {
    if (!contains(p.box(), {0, p.box()[1].midpoint(), Rational(1, 2), Rational(1, 2)})) continue;
    const bool at_three_quarters = contains(p.box(), {0, Rational(3, 4), Rational(1, 2), Rational(1, 2)});
    CHECK(p.multiplicity() == (at_three_quarters ? 0 : 1));
    ++at_node;
  }
  CHECK(at_node == 2);
  for (const CertifiedPoint& p : solve(nodal, floor_at(0)).solution.points) CHECK(p.multiplicity() == 1);
}

TEST_CASE("lines of both patches: a projective map and elevation change no point, exchange renames") {
  const unsigned seed = 77;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(-3, 3), weight(1, 3), degree(1, 3);
  const auto patch = [&](int tilt) {
    const int m = degree(random), n = degree(random);
    Net net;
    Weights weights;
    for (int i = 0; i <= m; ++i) {
      net.emplace_back();
      weights.emplace_back();
      for (int j = 0; j <= n; ++j) {
        const Rational a = Rational(6 * i, m) - 3, b = Rational(6 * j, n) - 3, c = coordinate(random);
        net.back().push_back(tilt == 0 ? Point{a, b, c} : Point{c, a, b});
        weights.back().emplace_back(weight(random));
      }
    }
    return RationalPatch(net, weights);
  };
  std::size_t found = 0;
  for (int i = 0; i < 12; ++i) {
    const RationalPatch x = patch(0), y = patch(1);
    for (const Parameter p : all_parameters) {
      const LineQuery query = {p, Rational(1 + i % 3, 4)};
      const LinePoints plain = intersect_line(x, y, query).solution;
      found += plain.points.size();
      const LinePoints moved = intersect_line(projected(x), projected(y), query).solution;
      REQUIRE(moved.points.size() == plain.points.size());
      for (std::size_t k = 0; k < plain.points.size(); ++k) {
        const ParameterBox a = plain.points[k].refined_to(power_of_two(-90)).box();
        const ParameterBox b = moved.points[k].refined_to(power_of_two(-90)).box();
        for (std::size_t j = 0; j < 4; ++j) CHECK((a[j].lower <= b[j].upper && b[j].lower <= a[j].upper));
        CHECK(moved.points[k].multiplicity() == plain.points[k].multiplicity());
        CHECK(moved.points[k].sides() == plain.points[k].sides());
        const ParameterBox& w = plain.points[k].box();
        const Point on_x = x(w[0].midpoint(), w[1].midpoint()), on_y = y(w[2].midpoint(), w[3].midpoint());
        for (std::size_t j = 0; j < 3; ++j) CHECK(abs(on_x[j] - on_y[j]) < power_of_two(-40));
      }
      check_same(intersect_line(x.elevated(3, 3), y.elevated(3, 3), query).solution, plain);
      const Parameter renamed = all_parameters[(index(p) + 2) % 4];
      CHECK(intersect_line(y, x, {renamed, query.value}).solution.points.size() == plain.points.size());
    }
  }
  CHECK(found > 20);
  CHECK_THROWS_AS(intersect_line(patch(0), patch(1), {Parameter::s, Rational(101, 100)}),
                  std::invalid_argument);
}

}  // namespace
}  // namespace exsect::rational_line_intersection_test

#include <exsect/algebra/algebraic_value.h>
#include <exsect/solver/rational_line_points.h>

#include <algorithm>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::rational_line_points_test {
namespace {

using Net = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Rational>>;
const LineQuery at_start = {Parameter::u, 0};

RationalPatch square() { return RationalPatch(Net{{{-1, -1, 0}, {-1, 1, 0}}, {{1, -1, 0}, {1, 1, 0}}}); }

/// The line u = 0 is the curve; the patch goes off along z.
RationalPatch with_line(const std::vector<Point>& curve, const std::vector<Rational>& weights = {}) {
  Net net = {curve, curve};
  for (Point& p : net[1]) p[2] += 1;
  return RationalPatch(net, weights.empty() ? Weights{} : Weights{weights, weights});
}

std::vector<RealAlgebraic> parameters(const RationalLinePoints& line) {
  CHECK_FALSE(line.incomplete);
  std::vector<RealAlgebraic> result;
  for (const RationalLinePoint& p : line.points) result.push_back(p.t.number().value());
  std::ranges::sort(result);
  return result;
}

void check_rational(const RationalLinePoints& line, const std::vector<Rational>& expected) {
  std::vector<RealAlgebraic> numbers(expected.begin(), expected.end());
  CHECK(parameters(line) == numbers);
}

void check_part(const RationalLinePoints& line, const Rational& from, const Rational& to) {
  CHECK_FALSE(line.incomplete);
  REQUIRE(line.on_patch.size() == 1);
  CHECK(line.on_patch[0].from == RealAlgebraic(from));
  CHECK(line.on_patch[0].to == RealAlgebraic(to));
}

TEST_CASE("lines of patches of all kinds: straight ones, once and folded, and one point") {
  const Rational half(1, 2), third(1, 3);
  check_rational(rational_line_points(with_line({{0, 0, -1}, {0, 0, 1}}), square(), at_start), {half});
  check_rational(rational_line_points(with_line({{0, 0, -1}, {0, 0, 1}}, {1, 2}), square(), at_start),
                 {third});
  // z = 1 - 4 t (1 - t) - 1/4: twice through the square.
  check_rational(rational_line_points(
                     with_line({{0, 0, Rational(3, 4)}, {0, 0, Rational(-5, 4)}, {0, 0, Rational(3, 4)}}),
                     square(), at_start),
                 {Rational(1, 4), Rational(3, 4)});
  check_part(rational_line_points(with_line({{-2, 0, 0}, {2, 0, 0}}), square(), at_start), Rational(1, 4),
             Rational(3, 4));
  check_part(rational_line_points(with_line({{0, 0, 0}, {2, 0, 0}, {0, 0, 0}}), square(), at_start), 0, 1);
  const RationalPatch fan(Net{{{0, 0, 0}, {0, 0, 0}}, {{1, 0, 1}, {0, 1, 1}}});
  check_part(rational_line_points(fan, square(), at_start), 0, 1);
  CHECK_THROWS_AS(rational_line_points(fan, square(), {Parameter::u, 2}), std::invalid_argument);
}

TEST_CASE("lines of patches of all kinds: cubics of space and of a plane, with a node and a cusp") {
  // (t, t^2, t^3) in the parameters from -1 to 1: through the square at 0 alone.
  const Rational third(1, 3);
  const RationalPatch twisted = with_line({{-1, 1, -1}, {-third, -third, 1}, {third, -third, -1}, {1, 1, 1}});
  check_rational(rational_line_points(twisted, square(), at_start), {Rational(1, 2)});
  // The node of (t^2 - 1, t^3 - t), t from -2 to 2, is met twice by a square across its plane.
  const RationalPatch nodal =
      with_line({{3, -6, 0}, {-7 * third, 26 * third, 0}, {-7 * third, -26 * third, 0}, {3, 6, 0}});
  const RationalPatch across(Net{{{0, -1, -1}, {0, -1, 1}}, {{0, 1, -1}, {0, 1, 1}}});
  check_rational(rational_line_points(nodal, across, at_start), {Rational(1, 4), Rational(3, 4)});
  // The cusp of (t^2, t^3), t from -1 to 1.
  const RationalPatch cuspidal = with_line({{1, -1, 0}, {-third, 1, 0}, {-third, -1, 0}, {1, 1, 0}});
  check_rational(rational_line_points(cuspidal, across, at_start), {Rational(1, 2)});
  check_part(rational_line_points(cuspidal, square(), at_start), 0, 1);
}

TEST_CASE("lines of patches of all kinds: the circle of a cylinder in two patches with weights") {
  // x = 1 - y on the quarter circle: both ends; x = y: the middle.
  const RationalPatch quarter = with_line({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, 1, 2});
  const RationalPatch chord(Net{{{1, 0, -1}, {1, 0, 1}}, {{0, 1, -1}, {0, 1, 1}}});
  check_rational(rational_line_points(quarter, chord, at_start), {0, 1});
  check_part(rational_line_points(quarter, quarter, at_start), 0, 1);
  const RationalPatch bisector(Net{{{0, 0, -1}, {0, 0, 1}}, {{1, 1, -1}, {1, 1, 1}}});
  const RationalLinePoints middle = rational_line_points(quarter, bisector, at_start);
  REQUIRE(middle.points.size() == 1);
  // 1 - t^2 = 2 t
  CHECK(sign_at(Polynomial{-1, 2, 1}, middle.points[0].t.number().value()) == 0);
  CHECK(middle.points[0].t.compare(0) > 0);
}

TEST_CASE("lines of patches of all kinds: elevation, exchange and reversal keep the answer") {
  const Net net = {{{-1, -1, -1}, {0, -1, 2}, {1, -1, -1}}, {{-1, 1, 1}, {0, 1, -2}, {1, 1, 2}}};
  const RationalPatch y(net, {{1, 2, 1}, {1, 1, 3}});
  const RationalPatch x = with_line({{-1, 0, 1}, {0, 1, -1}, {1, -1, 1}}, {1, 3, 1});
  const RationalLinePoints plain = rational_line_points(x, y, at_start);
  REQUIRE(!plain.points.empty());
  CHECK(parameters(rational_line_points(x.elevated(2, 3), y.elevated(2, 3), at_start)) == parameters(plain));
  CHECK(parameters(rational_line_points(x.transposed(), y.transposed(), {Parameter::v, 0})) ==
        parameters(plain));
  CHECK(parameters(rational_line_points(y, x, {Parameter::r, 0})) == parameters(plain));
  // The two halves of the line have the points of the whole.
  const auto part = [&](const Rational& from, const Rational& to) {
    return parameters(rational_line_points(x.restricted_to(0, 1, from, to), y, at_start)).size();
  };
  CHECK(part(0, Rational(1, 2)) + part(Rational(1, 2), 1) == plain.points.size());
}

/// The coordinates of the line minus those of the patch, without the denominators, at a point found.
void check_on_both(const RationalPatch& x, const RationalPatch& y, const RationalLinePoint& p) {
  const Rational width = power_of_two(-60);
  const RationalInterval t = p.t.enclosure(width);
  const TriangularPoint q = p.parameters.refined_to(width);
  const Point on_line = x(0, (t.lower + t.upper) / 2);
  const Point on_patch = y((q.r_interval().lower + q.r_interval().upper) / 2,
                           (q.s().interval().lower + q.s().interval().upper) / 2);
  for (std::size_t k = 0; k < 3; ++k) CHECK(abs(on_line[k] - on_patch[k]) < power_of_two(-40));
}

TEST_CASE("lines of patches of all kinds: a space cubic with weights on a bicubic graph") {
  // z = f(x,y) over the square [0,1]^2: the points are the roots of one polynomial in t, another route.
  Net net(4, std::vector<Point>(4));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {Rational(i, 3), Rational(j, 3),
                                                                       Rational((7 * i + 5 * j * j) % 6 - 2)};
  const RationalPatch graph(net);
  const Rational tenth(1, 10);
  const std::vector<Point> points = {
      {tenth, 2 * tenth, -2}, {3 * tenth, 9 * tenth, 5}, {6 * tenth, tenth, -4}, {9 * tenth, 8 * tenth, 3}};
  for (const std::vector<Rational>& weights :
       {std::vector<Rational>{1, 1, 1, 1}, std::vector<Rational>{1, 2, 1, 3}}) {
    const RationalPatch x = with_line(points, weights);
    const RationalLinePoints line = rational_line_points(x, graph, at_start);
    std::array<Polynomial, 4> c;
    for (int k = 0; k < 4; ++k) c[static_cast<std::size_t>(k)] = x.component(k).at_r(0);
    const BivariatePolynomial f = graph.component(2);
    Polynomial of_t = -(c[2] * c[3] * c[3] * c[3] * c[3] * c[3]);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        Polynomial term(f.coefficient(i, j));
        for (int k = 0; k < 6; ++k) term = term * (k < i ? c[0] : k < i + j ? c[1] : c[3]);
        of_t = of_t + term;
      }
    const std::vector<RealAlgebraic> expected = real_roots(of_t, 0, 1);
    CHECK(!expected.empty());
    CHECK(parameters(line) == expected);
    for (const RationalLinePoint& p : line.points) check_on_both(x, graph, p);
  }
}

RationalPatch random_weighted(Random& random, int m, int n) {
  std::uniform_int_distribution<int> coordinate(-3, 3), weight(1, 3);
  Net net;
  Weights weights;
  for (int i = 0; i <= m; ++i) {
    net.emplace_back();
    weights.emplace_back();
    for (int j = 0; j <= n; ++j) {
      const int z = coordinate(random);
      net.back().push_back({Rational(6 * i, m) - 3, Rational(6 * j, n) - 3, z});
      weights.back().emplace_back(weight(random));
    }
  }
  return RationalPatch(net, weights);
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

TEST_CASE("lines of patches of all kinds: a projective map and the order of elimination change no point") {
  const unsigned seed = 24;
  INFO("seed " << seed);
  Random random(seed);
  std::size_t found = 0;
  for (int d = 1; d <= 3; ++d)
    for (int m = 1; m <= 2; ++m)
      for (int n = 1; n <= 2; ++n) {
        const RationalPatch y = random_weighted(random, m, n);
        std::vector<Point> curve;
        std::vector<Rational> weights;
        for (int j = 0; j <= d; ++j) {
          const Point p = random_point(random);
          curve.push_back({p[0] / 10, p[1] / 10, j % 2 == 0 ? -4 : 4});
          weights.emplace_back(1 + j % 2);
        }
        const RationalPatch x = with_line(curve, weights);
        const std::vector<RealAlgebraic> plain = parameters(rational_line_points(x, y, at_start));
        found += plain.size();
        CHECK(parameters(rational_line_points(projected(x), projected(y), at_start)) == plain);
        CHECK(parameters(rational_line_points(x, y.transposed(), at_start)) == plain);
        CHECK(parameters(rational_line_points(x, y.restricted_to(1, 0, 0, 1), at_start)) == plain);
      }
  CHECK(found > 10);
}

}  // namespace
}  // namespace exsect::rational_line_points_test

#include <exsect/geometry/surface_pull_back.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <cmath>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::intersect_surface_test {
namespace {

const Point origin = {0, 0, 0}, up = {0, 0, 1};
const std::vector<int> near = {3, 6, 10, 20};
Rational tenth_to(int k) {
  Rational value = 1;
  for (int i = 0; i < k; ++i) value /= 10;
  return value;
}

/// The half u -> (1 - t^2, 2 t) / (1 + t^2), t = 2 u - 1, of the circle about (x,y), extruded from z to z'.
RationalPatch half_cylinder(const Rational& x, const Rational& y, const Rational& z, const Rational& to) {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (const Rational& height : {z, to}) {
    net[0].push_back({2 * x, 2 * y - 2, 2 * height, 2});
    net[1].push_back({2, 0, 0, 0});
    net[2].push_back({2 * x, 2 * y + 2, 2 * height, 2});
  }
  return RationalPatch::from_homogeneous(net);
}

/// About (-2,0), of radius 2, from z = -5 to z = 5.
RationalPatch half_cylinder_of_radius_2() {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (const int height : {-5, 5}) {
    net[0].push_back({-4, -4, 2 * height, 2});
    net[1].push_back({4, 0, 0, 0});
    net[2].push_back({-4, 4, 2 * height, 2});
  }
  return RationalPatch::from_homogeneous(net);
}

RationalPatch bilinear(const Point& a, const Point& b, const Point& c, const Point& d) {
  return RationalPatch({{a, b}, {c, d}});
}

using Vector = std::array<double, 3>;

double distance(const Vector& p, const Vector& a, const Vector& b) {
  double along = 0, length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    length += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  double squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double d = p[k] - a[k] - t * (b[k] - a[k]);
    squared += d * d;
  }
  return std::sqrt(squared);
}

/// The distance of p from the polylines less the bound of the nearest one, and from the points without arcs.
double excess(const IntersectionGraph& graph, const Vector& p) {
  double least = 1e300;
  for (const Arc& arc : graph.arcs)
    for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i)
      least =
          std::min(least, distance(p, arc.polyline[i].point, arc.polyline[i + 1].point) - arc.error_bound);
  for (const int id : graph.isolated_points) {
    const Vector& q = graph.nodes[static_cast<std::size_t>(id)].point;
    least = std::min(least, distance(p, q, q));
  }
  return least;
}

Vector in_doubles(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

/// Points of the intersection over lines u = const and v = const, by real roots of one polynomial each.
std::vector<Vector> true_points(const ImplicitSurface& surface, const RationalPatch& x, int lines) {
  const BivariatePolynomial f = pull_back(surface.equation(), x);
  std::vector<Vector> points;
  const auto add = [&](const Polynomial& g, const Rational& fixed, bool is_u) {
    if (g.degree() < 1) return;
    for (const RealAlgebraic& root : real_roots(g, 0, 1)) {
      const Rational t = root.refined_to(power_of_two(-70)).interval().midpoint();
      const Point p = is_u ? x(fixed, t) : x(t, fixed);
      if (!surface.bound() || (*surface.bound())(p) >= 0) points.push_back(in_doubles(p));
    }
  };
  for (int i = 0; i <= lines; ++i) {
    const Rational at = i == 0 || i == lines ? Rational(i / lines) : Rational(7 * i + 1, 7 * lines + 3);
    add(f.at_r(at), at, true);
    add(f.at_s(at), at, false);
  }
  return points;
}

/// Complete, every true point is within the bounds, the bounds keep the tolerance, and every vertex lies on
/// the patch and, to first order, on the surface.
IntersectResult checked(const ImplicitSurface& surface, const RationalPatch& x, double tolerance = 1e-6,
                        bool has_arcs = true) {
  IntersectOptions options;
  options.tolerance = tolerance;
  const IntersectResult result = intersect(surface, x, options);
  for (const Incomplete& reason : result.incomplete) UNSCOPED_INFO(reason.why);
  REQUIRE(result.status == Status::complete);
  CHECK_FALSE(result.coarse);
  CHECK(result.graph.arcs.empty() != has_arcs);
  double size = 0;
  for (const Arc& arc : result.graph.arcs)
    for (const PolylineVertex& vertex : arc.polyline)
      for (const double c : vertex.point) size = std::max(size, std::fabs(c));
  for (const Vector& p : true_points(surface, x, 12)) CHECK(excess(result.graph, p) <= 1e-14 * size);
  for (const Arc& arc : result.graph.arcs)
    for (std::size_t i = 0; i < arc.polyline.size(); i += 1 + arc.polyline.size() / 16) {
      const PolylineVertex& vertex = arc.polyline[i];
      const Rational u = from_double(vertex.parameters[0]), v = from_double(vertex.parameters[1]);
      const Vector on_patch = in_doubles(x(u, v));
      CHECK(distance(vertex.point, on_patch, on_patch) <= arc.error_bound);
      const Point p = {from_double(vertex.point[0]), from_double(vertex.point[1]),
                       from_double(vertex.point[2])};
      double gradient = 0;
      for (std::size_t k = 0; k < 3; ++k)
        gradient += std::pow(to_double(surface.equation().derivative(k)(p)), 2);
      if (gradient > 0 && surface.kind() != SurfaceKind::polynomial)
        CHECK(std::fabs(to_double(surface.equation()(p))) <=
              1.5 * arc.error_bound * std::sqrt(gradient) + 50 * arc.error_bound * arc.error_bound);
    }
  return result;
}

/// Nodes, arcs, components, isolated points.
using Shape = std::array<std::size_t, 4>;
Shape shape(const IntersectResult& result) {
  const IntersectionGraph& g = result.graph;
  return {g.nodes.size(), g.arcs.size(), g.components.size(), g.isolated_points.size()};
}
std::size_t with(const IntersectResult& result, NodeKind kind) {
  return static_cast<std::size_t>(
      std::count_if(result.graph.nodes.begin(), result.graph.nodes.end(), [&](const Node& node) {
        return std::find(node.kinds.begin(), node.kinds.end(), kind) != node.kinds.end();
      }));
}

TEST_CASE("Viviani's curve by its equation is drawn through its node") {
  const RationalPatch x = half_cylinder(1, 0, -2, 2);
  const IntersectResult viviani = checked(ImplicitSurface::sphere(origin, 2), x);
  CHECK(shape(viviani) == Shape{5, 4, 1, 0});
  CHECK(with(viviani, NodeKind::crossing) == 1);
  for (const int k : near) {
    CHECK(shape(checked(ImplicitSurface::sphere(origin, Length::of_squared(4 + tenth_to(k))), x))[2] == 2);
    CHECK(shape(checked(ImplicitSurface::sphere(origin, Length::of_squared(4 - tenth_to(k))), x))[2] == 2);
  }
}

TEST_CASE("contact along circles is drawn and named") {
  const RationalPatch x = half_cylinder(0, 0, -1, 1);
  const IntersectResult bore = checked(ImplicitSurface::sphere(origin, 1), x);
  REQUIRE(shape(bore) == Shape{2, 1, 1, 0});
  CHECK(bore.graph.arcs[0].contact == Contact::tangential);
  const RationalPatch top = bilinear({-9, -9, 3}, {-9, 9, 3}, {9, -9, 3}, {9, 9, 3});
  const IntersectResult circle = checked(ImplicitSurface::torus(origin, up, 5, 3), top);
  REQUIRE(circle.graph.components.size() == 1);
  CHECK(circle.graph.components[0].shape == ComponentShape::closed);
  CHECK(circle.graph.arcs[0].contact == Contact::tangential);
  for (const int k : near) {
    CHECK(shape(checked(ImplicitSurface::sphere(origin, 1 + tenth_to(k)), x)) == Shape{4, 2, 2, 0});
    CHECK(shape(checked(ImplicitSurface::sphere(origin, 1 - tenth_to(k)), x, 1e-6, false)) == Shape{});
    CHECK(shape(checked(ImplicitSurface::torus(origin, up, 5, 3 + tenth_to(k)), top))[2] == 2);
  }
}

TEST_CASE("equal cylinders, Villarceau's circles, touch points and apexes are drawn") {
  const RationalPatch x = half_cylinder(0, 0, -2, 2);
  CHECK(checked(ImplicitSurface::cylinder(origin, {1, 0, 0}, 1), x).graph.components.size() == 1);
  CHECK(with(checked(ImplicitSurface::cylinder(origin, {0, 1, 0}, 1), x), NodeKind::crossing) == 1);
  const auto in_plane = [](const Rational& a, const Rational& b) {
    return Point{Rational(4, 5) * a, b, Rational(3, 5) * a};
  };
  const RationalPatch plane =
      bilinear(in_plane(-10, -10), in_plane(-10, 10), in_plane(10, -10), in_plane(10, 10));
  const IntersectResult circles = checked(ImplicitSurface::torus(origin, up, 5, 3), plane);
  CHECK(with(circles, NodeKind::crossing) == 2);
  CHECK(circles.graph.components.size() == 1);
  for (const int k : near)
    CHECK(checked(ImplicitSurface::torus(origin, up, 5, 3 + tenth_to(k)), plane).graph.components.size() ==
          2);
  const RationalPatch level = bilinear({-1, -1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, 1});
  const IntersectResult touch = checked(ImplicitSurface::sphere(origin, 1), level, 1e-6, false);
  CHECK(shape(touch) == Shape{1, 0, 0, 1});
  CHECK(with(touch, NodeKind::touch) == 1);
  const RationalPatch through = bilinear({0, -1, -1}, {0, -1, 1}, {0, 1, -1}, {0, 1, 1});
  CHECK(with(checked(ImplicitSurface::cone(origin, up, 1, 2), through), NodeKind::crossing) == 1);
  CHECK(checked(ImplicitSurface::cone(origin, up, 1), through).graph.arcs.size() == 2);
  const RationalPatch tangent = bilinear({-1, -1, -1}, {1, -1, 1}, {-1, 1, -1}, {1, 1, 1});
  const IntersectResult ruling = checked(ImplicitSurface::cone(origin, up, 1), tangent);
  REQUIRE(shape(ruling) == Shape{2, 1, 1, 0});
  CHECK(ruling.graph.arcs[0].contact == Contact::tangential);
}

/// Open, closed, branched components, isolated points, boundary points, turning points in u and in v.
using Counts = std::array<int, 7>;
Counts counts(const IntersectionGraph& g) {
  return {g.count(ComponentShape::open),
          g.count(ComponentShape::closed),
          g.count(ComponentShape::branched),
          static_cast<int>(g.isolated_points.size()),
          g.boundary_points(),
          g.turning_points(Parameter::u),
          g.turning_points(Parameter::v)};
}

void check_drawn_alike(const IntersectionGraph& a, const IntersectionGraph& b) {
  for (const Arc& arc : a.arcs)
    for (std::size_t i = 0; i < arc.polyline.size(); i += 1 + arc.polyline.size() / 8)
      CHECK(excess(b, arc.polyline[i].point) <= arc.error_bound);
}

/// 53-bit numbers around a net of the square [-1,1]^2.
RationalPatch wavy(Random& random, int m, int n) {
  std::uniform_real_distribution<double> between(-1, 1);
  std::vector<std::vector<Point>> net(static_cast<std::size_t>(m) + 1);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      net[static_cast<std::size_t>(i)].push_back({from_double(-1 + 2.0 * i / m + 0.2 * between(random)),
                                                  from_double(-1 + 2.0 * j / n + 0.2 * between(random)),
                                                  from_double(0.6 * between(random))});
  return RationalPatch(net);
}

TEST_CASE("the parameters of the patch may be exchanged") {
  const std::uint64_t seed = 26031;
  INFO("seed " << seed);
  Random random(seed);
  int turning = 0;
  for (int round = 0; round < 8; ++round) {
    INFO("round " << round);
    const RationalPatch x = wavy(random, 1 + round % 3, 2);
    const ImplicitSurface surface =
        round < 3   ? ImplicitSurface::sphere({0, 0, Rational(1, 9)}, Rational(3, 4))
        : round < 6 ? ImplicitSurface::cone({0, 0, -1}, {Rational(1, 7), 0, 1}, Rational(2, 3))
                    : ImplicitSurface::torus(origin, {1, 2, 3}, Rational(3, 5), Rational(1, 5));
    const IntersectResult result = checked(surface, x);
    const IntersectResult exchanged = checked(surface, x.transposed());
    Counts expected = counts(result.graph);
    turning += expected[6];
    std::swap(expected[5], expected[6]);
    CHECK(counts(exchanged.graph) == expected);
    check_drawn_alike(result.graph, exchanged.graph);
    check_drawn_alike(exchanged.graph, result.graph);
  }
  CHECK(turning > 8);
}

TEST_CASE("planes and cylinders as patches give the same curves") {
  const std::uint64_t seed = 26032;
  INFO("seed " << seed);
  Random random(seed);
  IntersectOptions options;
  options.turning = {Parameter::u, Parameter::v};
  const auto agree = [&](const ImplicitSurface& surface, const RationalPatch& x, const RationalPatch& y) {
    const IntersectResult one = checked(surface, x), two = intersect(x, y, options);
    REQUIRE(two.status == Status::complete);
    CHECK(counts(one.graph) == counts(two.graph));
    check_drawn_alike(one.graph, two.graph);
    check_drawn_alike(two.graph, one.graph);
  };
  for (int round = 0; round < 6; ++round) {
    INFO("round " << round);
    const RationalPatch x = wavy(random, 2, 2);
    const Rational z(round, 40);
    agree(ImplicitSurface::plane({0, 0, z}, {Rational(1, 5), 0, 1}), x,
          bilinear({-5, -5, z + 1}, {-5, 5, z + 1}, {5, -5, z - 1}, {5, 5, z - 1}));
    agree(ImplicitSurface::cylinder({-2, 0, 0}, up, 2), x, half_cylinder_of_radius_2());
  }
}

/// A biquadratic patch with the given rational expansion about (u0,v0): p + a du + b dv + c0 du² + c1 du dv +
/// c2 dv².
RationalPatch expanded(const Rational& u0, const Rational& v0, const Point& p, const Point& a, const Point& b,
                       const std::array<Point, 3>& c) {
  std::vector<std::vector<Point>> net(3, std::vector<Point>(3));
  // The blossom: the control point ij has arguments of i ones and 2 - i zeros, and so in v.
  const auto pair = [](int ones, const Rational& about) {
    const Rational s = (ones > 1 ? 1 : 0) - about, t = (ones > 0 ? 1 : 0) - about;
    return std::array<Rational, 2>{(s + t) / 2, s * t};
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto [du, du2] = pair(i, u0);
      const auto [dv, dv2] = pair(j, v0);
      net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          p + du * a + dv * b + du2 * c[0] + du * dv * c[1] + dv2 * c[2];
    }
  return RationalPatch(net);
}

TEST_CASE("patches that touch a round surface, and nearly do") {
  const std::uint64_t seed = 26033;
  INFO("seed " << seed);
  Random random(seed);
  std::uniform_real_distribution<double> between(-2, 2);
  const auto any = [&] { return from_double(between(random)); };
  const Point p = {1, 2, 2};
  const auto tangent = [&] { return any() * Point{2, -1, 0} + any() * Point{0, 1, -1}; };
  for (int round = 0; round < 32; ++round) {
    INFO("round " << round);
    const Rational u0(1 + round % 7, 8), v0(1 + round % 5, 6);
    const Point a = tangent(), b = tangent();
    const RationalPatch x =
        expanded(u0, v0, p, a, b,
                 {Point{any(), any(), any()}, Point{any(), any(), any()}, Point{any(), any(), any()}});
    REQUIRE(x(u0, v0) == p);
    const auto at_contact = [&](const Rational& off) {
      const ImplicitSurface surface =
          round % 4 == 0   ? ImplicitSurface::sphere(origin, 3 + off)
          : round % 4 == 1 ? ImplicitSurface::plane({1 + off, 2, 2}, {1, 2, 2})
          : round % 4 == 2 ? ImplicitSurface::cylinder(origin, {2, -1, 0}, 3 + off)
                           : ImplicitSurface::torus({Rational(1, 6), Rational(1, 3), Rational(1, 3)},
                                                    {2, 1, -2}, Rational(3, 2), 1 + off);
      const IntersectResult result = intersect(surface, x);
      CHECK(result.status == Status::complete);
      CHECK_FALSE(result.coarse);
      return std::count_if(result.graph.nodes.begin(), result.graph.nodes.end(), [&](const Node& node) {
        const auto has = [&](NodeKind kind) {
          return std::find(node.kinds.begin(), node.kinds.end(), kind) != node.kinds.end();
        };
        const auto in = [&](std::size_t k, const Rational& t) {
          return node.box[k].lower <= t && t <= node.box[k].upper;
        };
        return in(0, u0) && in(1, v0) && (has(NodeKind::touch) || has(NodeKind::crossing));
      });
    };
    CHECK(at_contact(0) == 1);
    const Rational off = tenth_to(near[static_cast<std::size_t>(round) % near.size()]);
    CHECK(at_contact(off) == 0);
    CHECK(at_contact(-off) == 0);
  }
}

TEST_CASE("a patch on the surface is an overlap with its sides") {
  const RationalPatch x = half_cylinder(0, 0, -1, 1);
  const IntersectResult result = intersect(ImplicitSurface::cylinder(origin, up, 1), x);
  CHECK(result.status == Status::complete);
  REQUIRE(result.graph.overlaps.size() == 1);
  CHECK(result.graph.overlaps[0].chains.at(0).size() == 4);
  CHECK_FALSE(result.coarse);
}

TEST_CASE("finer tolerances, other sizes and places are kept to") {
  const ImplicitSurface sphere = ImplicitSurface::sphere({Rational(1, 3), 0, 0}, Rational(11, 10));
  const RationalPatch x = half_cylinder(0, 0, -2, 2);
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) checked(sphere, x, tolerance);
  std::vector<std::vector<Point>> net(3);
  const Point far = {from_double(1e8 + 0.1), from_double(-1e8 / 3), from_double(0.7)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      net[static_cast<std::size_t>(i)].push_back(far + Point{from_double(0.51 * i), from_double(0.49 * j),
                                                             from_double(0.1 * ((i * 5 + j * 7) % 4))});
  const IntersectResult result =
      intersect(ImplicitSurface::sphere(far + Point{Rational(1, 2), Rational(1, 2), 0}, Rational(1, 3)),
                RationalPatch(net));
  CHECK(result.status == Status::complete);
  CHECK(result.graph.arcs.size() > 0);
}

TEST_CASE("the work cap and bad options are obeyed") {
  IntersectOptions options;
  options.max_seconds = 1e-9;
  const IntersectResult result =
      intersect(ImplicitSurface::sphere(origin, 2), half_cylinder(1, 0, -2, 2), options);
  CHECK(result.status == Status::incomplete);
  REQUIRE(result.incomplete.size() == 1);
  CHECK(result.incomplete[0].why == "the work cap was reached");
  options.tolerance = 0;
  CHECK_THROWS_AS(intersect(ImplicitSurface::sphere(origin, 2), half_cylinder(1, 0, -2, 2), options),
                  std::invalid_argument);
}

/// The sign of the equation at a point of the patch a little beside the middle of the arc.
int sign_beside(const ImplicitSurface& surface, const RationalPatch& x, const Arc& arc, int side) {
  const std::size_t middle = arc.polyline.size() / 2;
  const auto& a = arc.polyline[middle - 1].parameters;
  const auto& b = arc.polyline[middle].parameters;
  const double du = b[0] - a[0], dv = b[1] - a[1], length = std::hypot(du, dv), step = side * 1e-4 / length;
  const Rational u = from_double(0.5 * (a[0] + b[0]) - step * dv),
                 v = from_double(0.5 * (a[1] + b[1]) + step * du);
  return sign(surface.equation()(x(u, v)));
}

TEST_CASE("on which side of the surface the patch lies beside arcs and around points") {
  const std::uint64_t seed = 26120;
  INFO("seed " << seed);
  Random random(seed);
  const std::vector<ImplicitSurface> surfaces = {
      ImplicitSurface::plane({0, 0, Rational(1, 50)}, {Rational(1, 3), -1, 2}),
      ImplicitSurface::sphere(origin, Rational(1, 2)),
      ImplicitSurface::cylinder(origin, {1, 1, 1}, Rational(1, 3)),
      ImplicitSurface::cone({0, 0, -2}, up, Rational(1, 4)),
      ImplicitSurface::torus(origin, {0, 1, 3}, Rational(1, 2), Rational(1, 5))};
  int arcs = 0;
  for (int round = 0; round < 4; ++round)
    for (const ImplicitSurface& surface : surfaces) {
      const RationalPatch x = wavy(random, 2, 2);
      const IntersectResult result = intersect(surface, x, {});
      REQUIRE(result.status == Status::complete);
      for (const Arc& arc : result.graph.arcs) {
        REQUIRE(arc.beside);
        CHECK(arc.beside->left == sign_beside(surface, x, arc, 1));
        CHECK(arc.beside->right == sign_beside(surface, x, arc, -1));
        CHECK(arc.beside->left == -arc.beside->right);
        ++arcs;
      }
    }
  CHECK(arcs > 40);
  // Contact from outside: a bore around a ball of its radius, a plane on a ball and one in which it would
  // end.
  const IntersectResult bore = intersect(ImplicitSurface::sphere(origin, 1), half_cylinder(0, 0, -1, 1), {});
  REQUIRE(bore.graph.arcs.size() == 1);
  CHECK(bore.graph.arcs[0].beside == SideSigns{1, 1});
  const RationalPatch level = bilinear({-1, -1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, 1});
  const IntersectResult touch = intersect(ImplicitSurface::sphere(origin, 1), level, {});
  REQUIRE(touch.graph.isolated_points.size() == 1);
  CHECK(touch.graph.nodes[0].around == 1);
  const RationalPatch bowl({{{-1, -1, 1}, {-1, 0, -1}, {-1, 1, 1}},
                            {{0, -1, -1}, {0, 0, -3}, {0, 1, -1}},
                            {{1, -1, 1}, {1, 0, -1}, {1, 1, 1}}});
  const ImplicitSurface below =
      ImplicitSurface::plane({0, 0, bowl(Rational(1, 2), Rational(1, 2))[2]}, {0, 0, -1});
  const IntersectResult rests = intersect(below, bowl, {});
  REQUIRE(rests.graph.isolated_points.size() == 1);
  CHECK(rests.graph.nodes[0].around == -1);
  // Only the other nappe goes on from the apex: no sign is that of all points around it.
  const RationalPatch under = bilinear({0, -1, -1}, {0, -1, 0}, {0, 1, -1}, {0, 1, 0});
  const IntersectResult apex = intersect(ImplicitSurface::cone(origin, up, Rational(1, 2)), under, {});
  REQUIRE(apex.graph.isolated_points.size() == 1);
  CHECK_FALSE(apex.graph.nodes[0].around);
  // A crossing of third order: the inflection z = u^3 of a sheet in the plane z = 0; and lines u = const.
  const RationalPatch inflected(
      {{{0, 0, -1}, {0, 1, -1}}, {{1, 0, 1}, {1, 1, 1}}, {{2, 0, -1}, {2, 1, -1}}, {{3, 0, 1}, {3, 1, 1}}});
  const IntersectResult line = intersect(ImplicitSurface::plane(origin, up), inflected, {});
  REQUIRE(line.graph.arcs.size() == 1);
  CHECK(line.graph.arcs[0].contact == Contact::tangential);
  CHECK(line.graph.arcs[0].beside == SideSigns{-1, 1});
}

/// The point of the model before it was scaled and shifted.
Point moved_point(const Rational& scale, const Point& shift, const Vector& at) {
  const Point given = {from_double(at[0]), from_double(at[1]), from_double(at[2])};
  return Rational(1 / scale) * (given - shift);
}

TEST_CASE("surfaces and patches of any size and place: the same graph") {
  const auto scaled = [](const Rational& scale, const Point& shift) {
    const auto at = [&](int a, int b, int c) { return scale * Point{a, b, c} + shift; };
    const RationalPatch saddle({{at(-4, -4, 1), at(-4, 4, -1)}, {at(4, -4, -1), at(4, 4, 1)}});
    return std::pair(intersect(ImplicitSurface::torus(shift, up, 3 * scale, scale), saddle, {}),
                     intersect(ImplicitSurface::cone(shift, {0, 1, 1}, 1), saddle, {}));
  };
  const auto [torus, cone] = scaled(1, origin);
  REQUIRE(torus.status == Status::complete);
  REQUIRE(cone.status == Status::complete);
  const std::vector<std::pair<Rational, Point>> places = {
      {power_of_two(-1030), origin},
      {power_of_two(1000), origin},
      {from_double(25.4), {from_double(1e8 + 0.1), from_double(-1e8), 7}},
      {power_of_two(-30), {from_double(1e8), 1, 2}}};
  for (const auto& [scale, shift] : places) {
    INFO(to_double(scale) << " at " << to_double(shift[0]));
    const auto [moved_torus, moved_cone] = scaled(scale, shift);
    for (const auto& [given, moved] : {std::pair(&torus, &moved_torus), std::pair(&cone, &moved_cone)}) {
      CHECK(moved->status == Status::complete);
      CHECK(shape(*moved) == shape(*given));
      for (std::size_t i = 0; i < given->graph.arcs.size(); ++i) {
        CHECK(moved->graph.arcs[i].beside == given->graph.arcs[i].beside);
        for (const PolylineVertex& vertex : moved->graph.arcs[i].polyline) {
          const Point p = moved_point(scale, shift, vertex.point);
          CHECK(excess(given->graph, in_doubles(p)) <=
                1e-5 + 1e-7 / to_double(scale) * (shift[0] == 0 ? 0 : 1));
        }
      }
    }
  }
}

}  // namespace
}  // namespace exsect::intersect_surface_test

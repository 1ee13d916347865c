// Surfaces by their equations in boxes: parts of curves that are known otherwise.
#include <exsect/geometry/surface_box.h>
#include <exsect/solver/intersect_equations.h>
#include <exsect/solver/intersect_surface.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "algebra/random_numbers.h"
#include "support/catch.h"

namespace exsect::boxed_equations_test {
namespace {

using S = ImplicitSurface;
const Point origin = {0, 0, 0}, right = {1, 0, 0}, left = {-1, 0, 0}, back = {0, 1, 0}, front = {0, -1, 0},
            up = {0, 0, 1};

IntersectOptions within(double tolerance) {
  IntersectOptions options;
  options.tolerance = tolerance;
  return options;
}

S sector(const S& whole, const Point& from, const Point& to, const std::optional<Point>& axis = {}) {
  SurfaceBox box;
  box.axis = axis;
  box.sector = AxisSector{from, to};
  return boxed(whole, box);
}
S heights(const S& whole, const Rational& from, const Rational& to, const std::optional<Point>& axis = {}) {
  SurfaceBox box;
  box.axis = axis;
  box.height = HeightRange{from, to};
  return boxed(whole, box);
}
S tube(const S& whole, std::array<Rational, 2> from, std::array<Rational, 2> to) {
  SurfaceBox box;
  box.tube = TubeSector{from, to};
  return boxed(whole, box);
}
S quarter(const S& whole, const Rational& from, const Rational& to) {
  SurfaceBox box;
  box.sector = AxisSector{right, back};
  box.height = HeightRange{from, to};
  return boxed(whole, box);
}
S tile(const Point& at, const Point& normal, const Point& first, const Point& second) {
  SurfaceBox box;
  box.sides = {first, second};
  return boxed(S::plane(at, normal), box);
}

std::string listed(const std::array<std::vector<std::string>, 2>& bounds) {
  std::string text;
  for (const std::size_t of : {0, 1})
    for (const std::string& name : bounds[of]) text += " " + std::to_string(of + 1) + ":" + name;
  return text;
}

/// Curves by kind and shape, then the nodes that are no joints with what they lie on.
std::string census(const SurfaceIntersection& result) {
  if (result.status != Status::complete) return "incomplete: " + result.incomplete.at(0).why;
  if (result.is_same) return "same";
  std::map<std::string, int> counts;
  for (const SpaceCurve& curve : result.curves)
    ++counts[std::string("1 ") + name(curve.kind) + (curve.is_closed ? " o" : "") +
             (curve.multiplicity > 1 ? " *" + std::to_string(curve.multiplicity) : "")];
  for (const SpaceNode& node : result.nodes)
    if (node.kind != SpaceNodeKind::joint)
      ++counts[std::string("2 ") + name(node.kind) + listed(node.bounds)];
  std::string text;
  for (const auto& [what, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + what.substr(1);
  return text.empty() ? "nothing" : text;
}

std::string census(const S& first, const S& second) {
  const SurfaceIntersection result = intersect(first, second, within(1e-3));
  SurfaceIntersection exchanged = intersect(second, first, within(1e-3));
  for (SpaceNode& node : exchanged.nodes) std::swap(node.bounds[0], node.bounds[1]);
  CHECK(census(result) == census(exchanged));
  return census(result);
}

Rational tenth_to(int k) { return k == 0 ? Rational(1) : tenth_to(k - 1) / 10; }
const std::vector<int> near = {3, 6, 10, 20};

double length(const SurfaceIntersection& result) {
  REQUIRE(result.status == Status::complete);
  double sum = 0;
  for (const SpaceArc& arc : result.arcs)
    for (std::size_t k = 0; k + 1 < arc.polyline.size(); ++k) {
      const auto &a = arc.polyline[k], &b = arc.polyline[k + 1];
      sum += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }
  return sum;
}

/// Every 16th vertex is outside of the box by no more than doubles are off.
void check_inside(const S& boxed, const SurfaceIntersection& result) {
  for (const SpaceArc& arc : result.arcs)
    for (std::size_t k = 0; k < arc.polyline.size(); k += 16) {
      const auto& p = arc.polyline[k];
      const Point at = {from_double(p[0]), from_double(p[1]), from_double(p[2])};
      for (const std::vector<std::size_t>& clause : boxed.box().clauses)
        CHECK(std::ranges::any_of(
            clause, [&](std::size_t i) { return to_double(boxed.box().bounds[i].form(at)) > -1e-9; }));
    }
}

/// The parts are a whole.
void check_glued(const std::vector<S>& first, const std::vector<S>& second, double whole) {
  double sum = 0;
  for (const S& a : first)
    for (const S& b : second) {
      const SurfaceIntersection part = intersect(a, b, within(1e-4));
      check_inside(a, part);
      check_inside(b, part);
      sum += length(part);
    }
  CHECK(std::fabs(sum - whole) < 1e-3 * (1 + whole));
}

const Point skew = {3, 1, 2};
std::vector<S> halves(const S& whole) {
  if (whole.kind() == SurfaceKind::polynomial) return {whole};
  if (whole.kind() == SurfaceKind::plane) {
    const Point a = cross(whole.data()->axis, Point{1, 2, -1}), b = cross(whole.data()->axis, a);
    std::vector<S> tiles;
    for (const int s : {-30, 30})
      for (const int t : {-30, 30})
        tiles.push_back(tile(whole.data()->point, whole.data()->axis, Rational(s) * a, Rational(t) * b));
    return tiles;
  }
  const std::optional<Point> axis = whole.kind() == SurfaceKind::sphere ? std::optional(skew) : std::nullopt;
  const Point d = {1, 2, 5};
  return {sector(whole, d, Rational(-1) * d, axis), sector(whole, Rational(-1) * d, d, axis)};
}

TEST_CASE("boxes: circles on quarters of a cylinder") {
  const S pipe = S::cylinder(origin, up, 1);
  const std::string ends = ", 1 end 1:sector=from, 1 end 1:sector=to";
  CHECK(census(quarter(pipe, 0, 2), S::plane(up, up)) == "1 circle" + ends);
  CHECK(census(sector(pipe, back, right), S::plane(up, up)) == "1 circle" + ends);
  CHECK(census(heights(pipe, 0, 2), S::plane(up, up)) == "1 circle o");
  for (const int k : near) {
    CHECK(census(heights(pipe, 0, 1 - tenth_to(k)), S::plane(up, up)) == "nothing");
    CHECK(census(heights(pipe, 0, 1 + tenth_to(k)), S::plane(up, up)) == "1 circle o");
  }
  const SurfaceIntersection drawn = intersect(quarter(pipe, 0, 2), S::plane(up, up), within(1e-7));
  CHECK(std::fabs(length(drawn) - std::acos(0)) < 1e-5);
  for (const SpaceNode& node : drawn.nodes) {
    if (node.kind != SpaceNodeKind::end) continue;
    const Point at =
        node.bounds[0] == std::vector<std::string>{"sector=from"} ? Point{1, 0, 1} : Point{0, 1, 1};
    for (std::size_t k = 0; k < 3; ++k) CHECK((node.box[k].lower <= at[k] && at[k] <= node.box[k].upper));
  }
}

TEST_CASE("boxes: curves along a bound, and points on it alone") {
  const S pipe = S::cylinder(origin, up, 1);
  CHECK(census(heights(pipe, 0, 1), S::plane(up, up)) == "1 circle o");
  const SurfaceIntersection rim = intersect(heights(pipe, 0, 1), S::plane(up, up));
  for (const SpaceNode& node : rim.nodes) CHECK(listed(node.bounds) == " 1:height=to");
  CHECK(census(quarter(pipe, 0, 1), S::plane(up, up)) ==
        "1 circle, 1 end 1:sector=from 1:height=to, 1 end 1:sector=to 1:height=to");
  // Half of the plane's section with the sides' plane lies on the other half plane of the sector.
  CHECK(census(quarter(pipe, 0, 1), S::plane(origin, back)) ==
        "1 line, 1 end 1:sector=from 1:height=from, 1 end 1:sector=from 1:height=to");
  CHECK(census(sector(pipe, left, right), S::plane(origin, back)) ==
        "2 line, 2 cut 1:sector=from, 2 cut 1:sector=to");
  const S ball = S::sphere(origin, 1);
  for (const int k : near) {
    CHECK(census(ball, tile({0, 1 - tenth_to(k), 0}, right, back, up)).starts_with("1 circle"));
    CHECK(census(ball, tile({0, 1 + tenth_to(k), 0}, right, back, up)) == "nothing");
  }
  CHECK(census(ball, tile({0, 1, -1}, right, back, {0, 0, 2})) == "1 touch 2:first=0");
  CHECK(census(ball, tile({0, 1, 0}, right, back, up)) == "1 touch 2:first=0 2:second=0");
  CHECK(census(ball, tile({0, 0, 0}, right, back, up)) ==
        "1 circle, 1 end 2:first=0 2:second=1, 1 end 2:first=1 2:second=0");
}

TEST_CASE("boxes: two planes") {
  const S wall = tile({0, 0, -1}, right, {0, 4, 0}, {0, 0, 2});
  CHECK(census(S::plane(origin, up), wall) == "1 line, 1 end 2:first=0, 1 end 2:first=1");
  CHECK(census(tile({-1, 1, 0}, up, {2, 0, 0}, {0, 9, 0}), wall) ==
        "1 line, 1 end 1:second=0, 1 end 2:first=1");
  CHECK(census(tile({-1, 4, 0}, up, {2, 0, 0}, {0, 9, 0}), wall) == "1 touch 1:second=0 2:first=1");
  CHECK(census(tile({-1, 5, 0}, up, {2, 0, 0}, {0, 9, 0}), wall) == "nothing");
  CHECK(census(S::plane({0, 0, 1}, up), wall) ==
        "1 line, 1 end 2:first=0 2:second=1, 1 end 2:first=1 2:second=1");
  CHECK(census(S::plane({0, 0, 1 + tenth_to(20)}, up), wall) == "nothing");
  CHECK(census(S::plane({1, 0, 0}, right), wall) == "nothing");
  CHECK(census(wall, wall) == "same");
  CHECK(census(S::plane(origin, right), wall) == "same");
}

TEST_CASE("boxes: crossings on bounds, and an apex") {
  const S one = S::cylinder(origin, up, 1), other = S::cylinder(origin, right, 1);
  CHECK(census(one, other) == "2 ellipse o, 2 crossing");
  // The crossings are (0,1,0) and (0,-1,0).
  CHECK(census(sector(one, front, back), other) ==
        "2 ellipse, 1 singular 1:sector=from, 1 singular 1:sector=to");
  CHECK(census(sector(one, right, back), other) == "2 ellipse, 2 end 1:sector=from, 1 singular 1:sector=to");
  CHECK(census(heights(one, 0, 1), other) == "2 ellipse, 2 singular 1:height=from");
  const S cone = S::cone(origin, up, 1), both = S::cone(origin, up, 1, 2);
  CHECK(census(heights(both, -1, 2), S::plane(origin, right)) ==
        "2 line, 1 crossing, 2 end 1:height=from, 2 end 1:height=to");
  CHECK(census(quarter(cone, 0, 3), S::plane(origin, {1, -1, 0})) ==
        "1 line, 1 end 1:height=to, 1 end 1:sector=from 1:sector=to 1:height=from");
  CHECK(census(heights(cone, 0, 3), S::plane(origin, up)) == "1 touch 1:height=from");
  CHECK(census(heights(cone, 1, 3), S::plane(origin, up)) == "nothing");
  CHECK(census(heights(cone, 0, 3), heights(S::cone(origin, {0, 0, -1}, 1), 0, 1)) ==
        "1 touch 1:height=from 2:height=from");
  CHECK(census(heights(cone, 1, 3), S::cone(origin, {0, 0, -1}, 1)) == "nothing");
  CHECK(census(heights(cone, 1, 3), cone) == "same");
}

TEST_CASE("boxes: bounds far beyond the nodes of the whole curve") {
  const S pipe = S::cylinder(origin, up, 1);
  CHECK(census(pipe, S::plane(origin, right)) == "2 line, 4 cut");
  CHECK(census(heights(pipe, 1000, 100000), S::plane(origin, right)) ==
        "2 line, 2 end 1:height=from, 2 end 1:height=to");
  CHECK(census(sector(pipe, front, right), S::plane(origin, {2, 1, 0})) == "1 line, 2 cut");
  const S cone = S::cone(origin, up, 1);
  CHECK(census(heights(cone, 5, 50), S::plane({0, 0, 1}, {1, 0, 1})) ==
        "1 parabola, 2 end 1:height=from, 2 end 1:height=to");
  CHECK(census(cone, tile({0, -100, 1}, {1, 0, 1}, {0, 200, 0}, {-50, 0, 50})) ==
        "1 parabola, 2 end 2:second=0, 2 end 2:second=1");
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2);
  const S saddle = S::polynomial(x * y - z);
  CHECK(census(tile({0, 0, 1}, up, {100, 0, 0}, {0, 20, 0}), saddle) ==
        "1 hyperbola, 1 end 1:first=1, 1 end 1:second=1");
}

TEST_CASE("boxes: tori with tori and polynomials") {
  const S ring = S::torus(origin, up, 5, 2), other = S::torus({3, 0, 1}, {2, 2, 1}, 4, 1);
  const S coaxial = S::torus({0, 0, 2}, up, 5, 2);
  CHECK(census(ring, coaxial) == "2 circle o");
  // Of the circles of radius 5 +- sqrt(3) at height 1 the outer one, and half of it.
  CHECK(census(tube(ring, {0, -1}, {0, 1}), coaxial) == "1 circle o");
  CHECK(census(sector(tube(ring, {0, -1}, {0, 1}).part_in({}), right, left), coaxial) ==
        "2 circle, 2 end 1:sector=from, 2 end 1:sector=to");
  CHECK(census(ring, sector(coaxial, back, front)) == "2 circle, 2 end 2:sector=from, 2 end 2:sector=to");
  const double whole = length(intersect(ring, other, within(1e-4)));
  check_glued({sector(ring, right, left), sector(ring, left, right)}, {other}, whole);
  check_glued({tube(ring, {1, 2}, {-1, -2}), tube(ring, {-1, -2}, {1, 2})}, {other}, whole);
  check_glued({ring}, {sector(other, back, front), sector(other, front, back)}, whole);
  // Sides of sectors in the common sides of the charts, if these were not turned.
  const S small = S::torus(origin, up, 4, 1), big = S::torus({3, 0, 1}, {2, 2, 1}, 5, 2);
  check_glued({sector(small, back, front), sector(small, front, back)}, {big},
              length(intersect(small, big, within(1e-4))));
}

/// What census tells of nodes.
std::string nodes(const S& first, const S& second) {
  SurfaceIntersection result = intersect(first, second, within(1e-3));
  result.curves.clear();
  return census(result);
}

TEST_CASE("boxes: a torus without charts, with surfaces by name and by equation") {
  const S ring = S::torus(origin, up, 5, Length::of_squared(5));
  // The first plane touches it in (4,0,2), on bounds of boxes below, the second one in (6,0,2) alone.
  const std::vector<S> others = {S::plane(origin, {-1, 0, 2}), S::plane({6, 0, 2}, {1, 0, 2}),
                                 S::plane({6 - tenth_to(6), 0, 2}, {1, 0, 2}), S::sphere({4, 1, 0}, 3),
                                 S::cylinder({4, 1, 0}, {1, 1, 1}, 1)};
  const std::vector<S> faces = {sector(ring, right, left), sector(ring, left, back), heights(ring, 0, 2),
                                heights(ring, 2, 3), tube(ring, {1, 2}, {-1, -2})};
  for (const S& other : others)
    for (const S& face : faces) {
      const S unnamed = S::polynomial(other.equation());
      CHECK(nodes(face, unnamed) == nodes(face, other));
      const double known = length(intersect(face, other, within(1e-4)));
      CHECK(std::fabs(length(intersect(face, unnamed, within(1e-4))) - known) < 1e-3 * (1 + known));
    }
}

TEST_CASE("boxes: two tori without charts") {
  const S ring = S::torus(origin, up, 5, Length::of_squared(3));
  const S other = S::torus({3, 0, 1}, {2, 2, 1}, 4, Length::of_squared(2));
  const double whole = length(intersect(ring, other, within(1e-4)));
  check_glued({sector(ring, right, left), sector(ring, left, right)}, {other}, whole);
  const std::string part = census(heights(ring, 0, 1), other);
  CHECK(part.find("1:height=from") != std::string::npos);
  CHECK(part.find("1:height=to") != std::string::npos);
}

TEST_CASE("boxes: curves along a bound of a torus without charts, against one with charts") {
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2), one = SpacePolynomial::constant(1);
  const auto ring = [](const Rational& square) {
    return S::torus(origin, up, 5, Length::of_squared(square));
  };
  const S low = S::polynomial(y * (z - one)), touching = S::polynomial(y * y * (z + x));
  for (const S& other : {low, touching})
    for (const auto& cut : {+[](const S& whole) { return sector(whole, right, back); },
                            +[](const S& whole) { return sector(whole, left, right); },
                            +[](const S& whole) { return heights(whole, 0, 1); },
                            +[](const S& whole) { return heights(whole, 1, 3); }})
      CHECK(nodes(cut(ring(3)), other) == nodes(cut(ring(4)), other));
  CHECK(census(sector(ring(3), left, right), touching) == "2 circle o *2, 1 general o");
  CHECK(census(heights(ring(4), -1, 1), S::plane(up, up)) == "2 circle o");
}

TEST_CASE("boxes: parts of both surfaces have all of the curve together") {
  const S ring = S::torus(origin, up, 5, 2);
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                        z = SpacePolynomial::variable(2);
  const std::vector<std::array<S, 2>> pairs = {
      {S::cylinder({1, 0, 0}, up, 1), S::sphere(origin, 2)},
      {S::cylinder(origin, up, 2), S::cylinder({0, 1, 0}, {1, 2, 0}, 1)},
      {S::cylinder(origin, up, 1), S::plane({0, 0, 1}, {1, 1, 1})},
      {S::sphere(origin, 2), S::plane({0, 0, 1}, {1, 1, 1})},
      {S::sphere(origin, 2), S::sphere({1, 2, 1}, 2)},
      {S::cone({0, 0, -3}, up, 1), S::sphere({0, 3, 1}, 2)},
      {S::cone({0, 0, -3}, up, Rational(1, 2)), S::plane(origin, {1, 0, 2})},
      {ring, S::plane({0, 0, 1}, {1, 0, 3})},
      {ring, S::sphere({4, 1, 0}, 3)},
      {ring, S::cylinder({4, 1, 0}, {1, 1, 1}, 1)},
      {ring, S::cone({4, 1, 5}, {1, 0, -2}, Rational(1, 3))},
      {S::cone({0, 0, -3}, up, 1), S::cylinder({0, 1, 0}, {5, 0, 1}, 2)},
      {S::cone({0, 0, -3}, up, Rational(1, 2)), S::cone({5, 1, 0}, {-3, 0, 1}, Rational(1, 3))},
      {ring, S::torus({3, 0, 1}, {2, 2, 1}, 4, 1)},
      {S::torus({3, 0, 1}, {2, 2, 1}, 4, 1), S::polynomial(x * x * x + y * z - Rational(3) * x)},
      {S::sphere({1, 0, 0}, 2), S::polynomial(x * x * x + y * z - x)},
  };
  for (const auto& [first, second] : pairs) {
    const double whole = length(intersect(first, second, within(1e-4)));
    CHECK(whole > 1);
    check_glued(halves(first), halves(second), whole);
  }
}

/// A quarter of a cylinder as a patch with weights.
RationalPatch quarter_patch(const Rational& radius, const Rational& from, const Rational& to) {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (const Rational& z : {from, to}) {
    net[0].push_back({radius, 0, z, 1});
    net[1].push_back({radius, radius, z, 1});
    net[2].push_back({0, 2 * radius, 2 * z, 2});
  }
  return RationalPatch::from_homogeneous(net);
}

/// The numbers of connected parts with and without ends, and of isolated points.
template <class Graph>
std::array<int, 3> parts(const Graph& graph) {
  std::vector<std::size_t> above(graph.nodes.size());
  std::vector<int> degree(graph.nodes.size(), 0);
  for (std::size_t i = 0; i < above.size(); ++i) above[i] = i;
  const auto root = [&](std::size_t i) {
    while (above[i] != i) i = above[i];
    return i;
  };
  for (const auto& arc : graph.arcs) {
    for (const int end : {arc.from, arc.to}) ++degree[static_cast<std::size_t>(end)];
    above[root(static_cast<std::size_t>(arc.from))] = root(static_cast<std::size_t>(arc.to));
  }
  std::map<std::size_t, std::array<int, 2>> ends;  // of degree 1, and all, of each part
  for (std::size_t i = 0; i < above.size(); ++i) {
    ends[root(i)][0] += degree[i] == 1 ? 1 : 0;
    ends[root(i)][1] += degree[i];
  }
  std::array<int, 3> counts = {0, 0, 0};
  for (const auto& [part, count] : ends) ++counts[count[1] == 0 ? 2 : count[0] > 0 ? 0 : 1];
  return counts;
}

TEST_CASE("boxes: a quarter of a cylinder is the patch with weights that it is") {
  const std::uint64_t seed = 51217;
  INFO("seed " << seed);
  test::Random random(seed);
  const auto point = [&] {
    return Point{Rational(random.integer(-8, 8), 4), Rational(random.integer(-8, 8), 4),
                 Rational(random.integer(-8, 8), 4)};
  };
  std::map<std::array<int, 3>, int> seen;
  for (int round = 0; round < 40; ++round) {
    const Rational radius = Rational(random.integer(2, 8), 4), size = Rational(random.integer(3, 12), 4);
    Point axis = point();
    if (is_zero(axis)) axis = up;
    const std::array<S, 4> wholes = {S::plane(point(), axis), S::cylinder(point(), axis, size),
                                     S::sphere(point(), size), S::cone(point(), axis, size)};
    const S other = halves(wholes[static_cast<std::size_t>(round) % 4])[0];
    const S face = quarter(S::cylinder(origin, up, radius), -1, 2);
    const IntersectResult known = intersect(other, quarter_patch(radius, -1, 2), within(1e-2));
    REQUIRE(known.status == Status::complete);
    const SurfaceIntersection result = intersect(face, other, within(1e-2));
    REQUIRE(result.status == Status::complete);
    const std::array<int, 3> count = parts(result);
    CHECK(count == parts(known.graph));
    ++seen[count];
  }
  CHECK(seen.size() >= 3);
}

TEST_CASE("boxes: polynomials in boxes") {
  // Two squares of one plane with a corner in common; as a polynomial a plane has no shape to be shared.
  const S one = tile({0, 0, 1}, up, right, back), other = tile({1, 1, 1}, up, {2, 0, 0}, {0, 3, 0});
  const auto unnamed = [](const S& face) { return S::polynomial(face.equation()).part_in(face.box()); };
  CHECK(census(one, other).starts_with("1 touch"));
  CHECK(census(unnamed(one), other) == census(one, other));
  CHECK(census(one, unnamed(other)) == census(one, other));
  CHECK(census(unnamed(one), unnamed(other)).starts_with("incomplete: two polynomials"));
  CHECK(census(unnamed(one), unnamed(one)) == "same");
  CHECK(census(unnamed(one), S::polynomial(other.equation())).starts_with("incomplete: two polynomials"));
}

TEST_CASE("boxes: places, sizes and turns of both faces change no answer") {
  const std::array<Point, 3> turn = {Point{-20, 4, 22}, Point{20, -10, 20}, Point{10, 28, 4}};
  for (const Rational& scale : {Rational(1), Rational(127, 5), power_of_two(-60)})
    for (const Rational& shift : {Rational(0), Rational(100000000) * scale}) {
      const auto turned = [&](const Point& d) {
        return Rational(1, 30) * Point{dot(turn[0], d), dot(turn[1], d), dot(turn[2], d)};
      };
      const auto placed = [&](const Point& p) { return scale * turned(p) + shift * skew; };
      SurfaceBox box;
      box.sector = AxisSector{turned(right), turned(back)};
      box.height = HeightRange{-scale, 2 * scale};
      const S face = boxed(S::cylinder(placed(origin), turned(up), scale), box);
      box.axis = turned(back);
      box.sector = AxisSector{turned(up), turned(right)};
      const S cap = boxed(S::sphere(placed({0, 0, 1}), Length(Rational(scale * Rational(5, 4)))), box);
      CHECK(census(face, cap) == "1 circle, 1 end 1:sector=from, 1 end 1:sector=to 2:sector=from");
    }
}

}  // namespace
}  // namespace exsect::boxed_equations_test

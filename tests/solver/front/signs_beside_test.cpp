// On which side of each other patches lie beside their curves: against points of the patches there, and where
// the answer is known.
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>

#include <cmath>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::signs_beside_test {
namespace {

using random_pairs::Generator;
using Vec3 = std::array<double, 3>;
using Net = std::vector<std::vector<Point>>;

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 times(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double inner(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 unit(const Vec3& a) {
  const double size = std::sqrt(inner(a, a));
  return {a[0] / size, a[1] / size, a[2] / size};
}

Vec3 at(const RationalPatch& x, double u, double v) {
  const Point p = x(from_double(u), from_double(v));
  return {to_double(p[0]), to_double(p[1]), to_double(p[2])};
}
Vec3 normal(const RationalPatch& y, double r, double s) {
  const double e = 0x1p-16;
  return unit(times(minus(at(y, r + e, s), at(y, r - e, s)), minus(at(y, r, s + e), at(y, r, s - e))));
}

/// The height above the tangent plane of y, by finite differences, of points of x to the left and to the
/// right of the middle of the arc; empty if it is no more than what the surfaces bend.
std::optional<SideSigns> seen(const Arc& arc, const RationalPatch& x, const RationalPatch& y) {
  const std::size_t i = arc.polyline.size() / 2;
  const auto& a = arc.polyline[i - 1].parameters;
  const auto& b = arc.polyline[i].parameters;
  const double du = b[0] - a[0], dv = b[1] - a[1], size = std::hypot(du, dv), e = 0x1p-16;
  if (size < 0x1p-20) return std::nullopt;
  const Vec3 n = normal(y, b[2], b[3]), on = at(x, b[0], b[1]);
  const auto height = [&](double sign) {
    const Vec3 off = minus(at(x, b[0] - sign * e * dv / size, b[1] + sign * e * du / size), on);
    return inner(n, off) / std::sqrt(inner(off, off));
  };
  const double left = height(1), right = height(-1);
  if (std::fabs(left) < 0.01 || std::fabs(right) < 0.01) return std::nullopt;
  return SideSigns{left > 0 ? 1 : -1, right > 0 ? 1 : -1};
}

IntersectResult complete(const RationalPatch& x, const RationalPatch& y,
                         const IntersectOptions& options = {}) {
  IntersectResult result = intersect(x, y, options);
  for (const Incomplete& reason : result.incomplete) UNSCOPED_INFO(reason.why);
  REQUIRE(result.status == Status::complete);
  return result;
}

/// Every arc has signs, and they are those that are seen. Returns the number of arcs that were seen.
int check_arcs(const RationalPatch& x, const RationalPatch& y, const IntersectOptions& options = {}) {
  int count = 0;
  for (const Arc& arc : complete(x, y, options).graph.arcs) {
    REQUIRE(arc.beside);
    CHECK(arc.beside->left == -arc.beside->right);
    const auto expected = seen(arc, x, y);
    if (!expected) continue;
    CHECK(*arc.beside == *expected);
    ++count;
  }
  return count;
}

/// Exchanged, transposed, and with one parameter reversed: the signs are seen anew.
int check_images(const RationalPatch& x, const RationalPatch& y) {
  int count = check_arcs(x, y) + check_arcs(y, x);
  count += check_arcs(x.transposed(), y) + check_arcs(x, y.transposed());
  count += check_arcs(x.restricted_to(1, 0, 0, 1), y) + check_arcs(x, y.restricted_to(0, 1, 1, 0));
  return count;
}

RationalPatch plane(const Point& origin, const Point& a, const Point& b) {
  return RationalPatch(Net{{origin, origin + b}, {origin + a, origin + a + b}});
}
/// z = 3/4 of the product of the bumps 4 t (1 - t), t = x/2 and y/2, over [0,2]^2.
RationalPatch bump() {
  return RationalPatch(Net{{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}},
                           {{1, 0, 0}, {1, 1, 3}, {1, 2, 0}},
                           {{2, 0, 0}, {2, 1, 0}, {2, 2, 0}}});
}
const RationalPatch quarter_up = plane({0, 0, Rational(1, 4)}, {2, 0, 0}, {0, 2, 0});

/// z = a x^2 + b y^2 over [-1,1]^2.
RationalPatch quadric(const Rational& a, const Rational& b, const Rational& c = 0) {
  const auto square = [](int i) { return i == 1 ? -1 : 1; };
  Net net(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      net[static_cast<std::size_t>(i)].push_back({i - 1, j - 1, a * square(i) + b * square(j) + c});
  return RationalPatch(net);
}

/// Twice the area that the polylines of the only component run around in the square of the first patch.
double turn_of(const IntersectionGraph& graph, const Arc& arc) {
  REQUIRE(graph.components.size() == 1);
  const auto& p = arc.polyline;
  double sum = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    sum += (p[i - 1].parameters[0] - 0.5) * (p[i].parameters[1] - 0.5) -
           (p[i].parameters[0] - 0.5) * (p[i - 1].parameters[1] - 0.5);
  return sum;
}

RationalPatch mapped(const RationalPatch& x, const Rational& scale, const Point& by) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= x.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= x.degree_v(); ++j) {
      HomogeneousPoint p = x.homogeneous(i, j);
      for (std::size_t k = 0; k < 3; ++k) p[k] = scale * p[k] + by[k] * p[3];
      net.back().push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

/// (p, 1) -> (p, 1 + p.c): a patch with weights.
RationalPatch projected(const RationalPatch& x) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= x.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= x.degree_v(); ++j) {
      HomogeneousPoint p = x.homogeneous(i, j);
      p[3] += (p[0] + 2 * p[1] - p[2]) / 64;
      net.back().push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace

TEST_CASE(
    "sides: the bump is above the plane inside of the closed curve, whatever turning points are nodes") {
  for (const auto& turning : std::vector<std::vector<Parameter>>{
           {all_parameters.begin(), all_parameters.end()}, {}, {Parameter::u}, {Parameter::s}}) {
    IntersectOptions options;
    options.turning = turning;
    for (const bool exact : {false, true}) {
      options.exact = exact;
      const IntersectResult result = complete(bump(), quarter_up, options);
      for (const Arc& arc : result.graph.arcs) {
        REQUIRE(arc.beside);
        CHECK((arc.beside->left == 1) == (turn_of(result.graph, arc) > 0));
        CHECK(arc.beside->right == -arc.beside->left);
      }
      // Seen from the plane, the bump's normal points outwards and up: the plane is below it inside.
      const IntersectResult exchanged = complete(quarter_up, bump(), options);
      for (const Arc& arc : exchanged.graph.arcs) {
        REQUIRE(arc.beside);
        CHECK((arc.beside->left == -1) == (turn_of(exchanged.graph, arc) > 0));
      }
    }
  }
}

TEST_CASE("sides: random pairs of every kind, exchanged, transposed, reversed") {
  const std::uint64_t seed = 20261125;
  INFO("seed " << seed);
  Generator generator(seed);
  int count = 0;
  for (int i = 0; i < 12; ++i) {
    INFO("pair " << i);
    const random_pairs::Pair pair = i % 4 == 0   ? random_pairs::small_rationals(generator)
                                    : i % 4 == 1 ? random_pairs::doubles(generator)
                                    : i % 4 == 2 ? random_pairs::scattered(generator)
                                                 : random_pairs::loop(generator);
    const RationalPatch x = pair.x, y = pair.y;
    count += check_images(x, y);
    if (i % 4 > 1) continue;
    count += check_images(x.elevated(3, 2), y);
    count += check_images(projected(x), projected(y));
  }
  CHECK(count > 250);
}

TEST_CASE("sides: far away, very large and very small") {
  const Rational big = power_of_two(1100), small = 1 / big;
  for (const auto& [scale, by] :
       std::vector<std::pair<Rational, Point>>{{Rational(254, 10), {0, 0, 0}},
                                               {1, {100000000, 123456789, Rational(-987654321, 10)}},
                                               {small, {0, 0, 0}}}) {
    const IntersectResult result = complete(mapped(bump(), scale, by), mapped(quarter_up, scale, by));
    for (const Arc& arc : result.graph.arcs) {
      REQUIRE(arc.beside);
      CHECK((arc.beside->left == 1) == (turn_of(result.graph, arc) > 0));
    }
  }
}

TEST_CASE("sides: the equation of a plane, and patches of it that face both ways") {
  const auto surface = ImplicitSurface::plane({0, 0, Rational(1, 4)}, {0, 0, 1});
  const IntersectResult by_equation = intersect(surface, bump());
  const IntersectResult by_patch = complete(bump(), quarter_up);
  const IntersectResult from_below = complete(bump(), quarter_up.transposed());
  for (const auto& [result, sign] :
       {std::pair(&by_equation, 1), std::pair(&by_patch, 1), std::pair(&from_below, -1)})
    for (const Arc& arc : result->graph.arcs) {
      REQUIRE(arc.beside);
      CHECK(arc.beside->left == (turn_of(result->graph, arc) > 0 ? sign : -sign));
    }
}

TEST_CASE("sides: patches that touch in a point or along a curve") {
  const RationalPatch ground = plane({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  const auto around = [](const RationalPatch& x, const RationalPatch& y) {
    const IntersectionGraph graph = complete(x, y).graph;
    REQUIRE(graph.isolated_points.size() == 1);
    return graph.nodes[static_cast<std::size_t>(graph.isolated_points[0])].around;
  };
  for (const Rational& a : {Rational(1), Rational(1, 1000), Rational(3)}) {
    CHECK(around(quadric(a, 1), ground) == 1);
    CHECK(around(ground, quadric(a, 1)) == -1);
    CHECK(around(quadric(a, 1), ground.transposed()) == -1);
    CHECK(around(quadric(-a, -1).transposed(), ground) == -1);
    CHECK(around(quadric(2 + a, 3), quadric(2, 1)) == 1);
    CHECK(around(quadric(2, 1), quadric(2 + a, 3)) == -1);
  }
  const auto beside = [](const RationalPatch& x, const RationalPatch& y) {
    const IntersectionGraph graph = complete(x, y).graph;
    REQUIRE(!graph.arcs.empty());
    for (const Arc& arc : graph.arcs) {
      CHECK(arc.contact == Contact::tangential);
      CHECK(arc.beside == graph.arcs[0].beside);
    }
    return graph.arcs[0].beside;
  };
  CHECK(beside(quadric(1, 0), ground) == SideSigns{1, 1});
  CHECK(beside(ground, quadric(0, 1)) == SideSigns{-1, -1});
  CHECK(beside(quadric(0, 1), ground.transposed()) == SideSigns{-1, -1});
  CHECK(beside(quadric(2, -1), quadric(1, -1)) == SideSigns{1, 1});
}

TEST_CASE("sides: the arcs of a crossing alternate, as seen from its node") {
  const IntersectionGraph graph = complete(quadric(1, -1), quadric(0, 0)).graph;
  REQUIRE(graph.arcs.size() == 4);
  for (const Arc& arc : graph.arcs) {
    REQUIRE(arc.beside);
    CHECK(*arc.beside == seen(arc, quadric(1, -1), quadric(0, 0)));
  }
}

TEST_CASE("overlaps: the same or opposite normals") {
  const RationalPatch whole = quadric(1, 1);
  const RationalPatch piece = whole.restricted_to(Rational(1, 4), 1, 0, Rational(2, 3));
  for (const auto& [x, y, sign] :
       {std::tuple(whole, piece, 1), std::tuple(piece, whole, 1), std::tuple(whole, piece.transposed(), -1),
        std::tuple(projected(whole), projected(piece), 1),
        std::tuple(projected(whole).transposed(), projected(piece), -1), std::tuple(whole, whole, 1)}) {
    const IntersectionGraph graph = complete(x, y).graph;
    REQUIRE(graph.overlaps.size() == 1);
    CHECK(graph.overlaps[0].normals == sign);
  }
}

}  // namespace exsect::signs_beside_test

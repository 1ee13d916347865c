// Patches that cover their image more than once, by affine symmetries of the parameters.
#include "shape/self_symmetry.h"

#include <exsect/solver/intersect.h>
#include <exsect/solver/self_intersect.h>

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "self/symmetric_pairs.h"
#include "support/catch.h"
#include "support/preimages.h"

namespace exsect::self_symmetry_test {

namespace {

const Rational half(1, 2);

using Random = std::mt19937_64;

Rational small(Random& random) { return static_cast<int>(random() % 9) - 4; }

Point vector(Random& random) { return {small(random), small(random), small(random)}; }

struct Term {
  int i;
  int j;
  Point p;
};

/// The sum of p (u - c0)^i (v - c1)^j.
BezierPatch patch_around(const PlanePoint& c, const std::vector<Term>& terms) {
  ControlNet net{};
  for (const Term& term : terms) {
    Point& entry = net[static_cast<std::size_t>(term.i)][static_cast<std::size_t>(term.j)];
    entry = entry + term.p;
  }
  return BezierPatch::from_power_basis(net).restricted_to(-c[0], 1 - c[0], -c[1], 1 - c[1]);
}

/// e0 + e1 s + e2 p + e3 s^2 + e4 s p + e5 p^2, s = u + v, p = u v.
BezierPatch symmetric_patch(const std::array<Point, 6>& e) {
  const Rational two = 2;
  return patch_around({0, 0}, {{0, 0, e[0]},
                               {1, 0, e[1]},
                               {0, 1, e[1]},
                               {1, 1, e[2] + two * e[3]},
                               {2, 0, e[3]},
                               {0, 2, e[3]},
                               {2, 1, e[4]},
                               {1, 2, e[4]},
                               {2, 2, e[5]}});
}

/// e1 a^2 + e2 a b + e3 b^2 + e4 a^2 b^2 around the centre.
BezierPatch even_patch(const PlanePoint& centre, const std::array<Point, 4>& e) {
  return patch_around(centre, {{2, 0, e[0]}, {1, 1, e[1]}, {0, 2, e[2]}, {2, 2, e[3]}});
}

BezierPatch random_symmetric(Random& random) {
  std::array<Point, 6> e;
  for (Point& p : e) p = vector(random);
  return symmetric_patch(e);
}

BezierPatch random_even(Random& random, const PlanePoint& centre) {
  return even_patch(centre, {vector(random), vector(random), vector(random), vector(random)});
}

std::array<double, 3> at(const BezierPatch& x, double u, double v) {
  const Point p = x(from_double(u), from_double(v));
  return {to_double(p[0]), to_double(p[1]), to_double(p[2])};
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

PlanePoint image(const Symmetry& symmetry, const PlanePoint& w) {
  PlanePoint result;
  for (std::size_t j = 0; j < 2; ++j)
    result[j] = symmetry.image[j][0] + symmetry.image[j][1] * w[0] + symmetry.image[j][2] * w[1];
  return result;
}

bool in_square(const PlanePoint& w) { return w[0] >= 0 && w[0] <= 1 && w[1] >= 0 && w[1] <= 1; }

/// The rim is closed, its pairs have one image, its polylines keep their bounds, and it has the area of the
/// region.
void check_region(const BezierPatch& x, const IntersectionGraph& graph, std::size_t index,
                  const Symmetry& symmetry) {
  REQUIRE(graph.overlaps[index].chains.size() == 1);
  const std::vector<Arc>& chain = graph.overlaps[index].chains[0];
  Rational twice_the_area = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    CHECK(chain[i].to == chain[(i + 1) % chain.size()].from);
    const ParameterBox& box = graph.nodes[static_cast<std::size_t>(chain[i].from)].box;
    const ParameterBox& next = graph.nodes[static_cast<std::size_t>(chain[i].to)].box;
    CHECK(x(box[0].lower, box[1].lower) == x(box[2].lower, box[3].lower));
    twice_the_area += box[0].lower * next[1].lower - box[1].lower * next[0].lower;
    for (std::size_t k = 0; k + 1 < chain[i].polyline.size(); ++k) {
      const PolylineVertex& p = chain[i].polyline[k];
      const PolylineVertex& q = chain[i].polyline[k + 1];
      std::array<double, 3> middle{};
      for (std::size_t j = 0; j < 3; ++j) middle[j] = (p.point[j] + q.point[j]) / 2;
      for (const std::size_t side : {0, 2}) {
        const auto truth = at(x, (p.parameters[side] + q.parameters[side]) / 2,
                              (p.parameters[side + 1] + q.parameters[side + 1]) / 2);
        CHECK(distance(middle, truth) <= chain[i].error_bound * (1 + 1e-9) + 1e-13);
      }
    }
  }
  constexpr int kCells = 24;
  int inside = 0;
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const PlanePoint w = {Rational(2 * i + 1, 2 * kCells), Rational(2 * j + 1, 2 * kCells)};
      const PlanePoint other = image(symmetry, w);
      CHECK(x(w[0], w[1]) == x(other[0], other[1]));
      inside += in_square(other) ? 1 : 0;
    }
  const bool both_orders = symmetry.cut[1] == 0 && symmetry.cut[2] == 0;
  const double area = std::fabs(to_double(twice_the_area)) / (both_orders ? 2 : 1);
  CHECK(std::fabs(area - inside / (1.0 * kCells * kCells)) < 0.1);
}

IntersectResult check_covers(const BezierPatch& x, std::size_t count) {
  const std::vector<Symmetry> known = symmetries(x);
  REQUIRE(known.size() == count);
  IntersectResult result = self_intersect(x);
  REQUIRE(result.graph.overlaps.size() == count);
  CHECK(result.graph.arcs.empty());
  for (std::size_t i = 0; i < count; ++i) check_region(x, result.graph, i, known[i]);
  return result;
}

/// A preimage of x(w) other than those under the symmetries.
bool has_other_preimage(const BezierPatch& x, const PlanePoint& w, Random& random) {
  std::vector<PlanePoint> known = {w};
  for (const Symmetry& symmetry : symmetries(x)) {
    known.push_back(image(symmetry, w));
    known.push_back(image(symmetry, image(symmetry, image(symmetry, w))));
  }
  return preimage_apart_from(x, w, known, random).has_value();
}

PlanePoint random_point(Random& random) { return {Rational(random() % 97, 96), Rational(random() % 97, 96)}; }

}  // namespace

TEST_CASE("self symmetry: of the square, of patches of every kind") {
  const std::vector<std::string> names = {"(1 - u, v)",     "(u, 1 - v)",     "(v, u)",
                                          "(1 - v, 1 - u)", "(1 - u, 1 - v)", "(1 - v, u)"};
  using Index = std::array<std::size_t, 2>;
  const std::vector<std::function<Index(Index)>> maps = {
      [](Index k) { return Index{3 - k[0], k[1]}; },     [](Index k) { return Index{k[0], 3 - k[1]}; },
      [](Index k) { return Index{k[1], k[0]}; },         [](Index k) { return Index{3 - k[1], 3 - k[0]}; },
      [](Index k) { return Index{3 - k[0], 3 - k[1]}; }, [](Index k) { return Index{3 - k[1], k[0]}; }};
  Random random(4);
  for (const bool weighted : {false, true})
    for (std::size_t map = 0; map < names.size(); ++map) {
      std::vector<std::vector<Point>> points(4, std::vector<Point>(4));
      std::vector<std::vector<Rational>> weights(4, std::vector<Rational>(4));
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
          const Point p = vector(random);
          const Rational w = weighted ? small(random) + 6 : Rational(1);
          Index k = {i, j};
          do {
            points[k[0]][k[1]] = p;
            weights[k[0]][k[1]] = w;
            k = maps[map](k);
          } while (k != Index{i, j});
        }
      std::vector<std::string> found;
      for (const Symmetry& symmetry : symmetries_of_square(RationalPatch(points, weights)))
        found.push_back(image_text(symmetry));
      std::vector<std::string> expected = {names[map]};
      if (map == 5) expected.insert(expected.begin(), names[4]);
      CHECK(found == expected);
      points[0][1][0] += 1;
      CHECK(symmetries_of_square(RationalPatch(points, weights)).empty());
    }
}

TEST_CASE("self_intersect: patches covered twice, four and eight times") {
  const Rational third(1, 3);
  const Rational c(2, 5);
  const std::array<Point, 4> cone = {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 0}}};
  CHECK(check_covers(even_patch({half, half}, cone), 1).status == Status::complete);
  CHECK(check_covers(even_patch({third, c}, cone), 1).status == Status::complete);
  CHECK(check_covers(symmetric_patch({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {}, {}, {0, 0, 1}}}), 1).status ==
        Status::complete);
  const BezierPatch antisymmetric =
      symmetric_patch({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {}, {0, 0, 1}, {}}}).reversed_second();
  const auto other = check_covers(antisymmetric, 1);
  CHECK(other.status == Status::complete);
  CHECK(image_text(symmetries(antisymmetric)[0]) == "(1 - v, 1 - u)");
  // Both diagonals; two folds; all eight symmetries of a square.
  CHECK(check_covers(even_patch({half, half}, {{{1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}), 3).status ==
        Status::complete);
  CHECK(check_covers(even_patch({third, c}, {{{1, 0, 0}, {}, {0, 1, 0}, {0, 0, 1}}}), 3).status ==
        Status::complete);
  CHECK(check_covers(even_patch({third, third}, {{{1, 0, 0}, {}, {1, 0, 0}, {0, 0, 1}}}), 6).status ==
        Status::complete);
  const auto half_turn = symmetries(even_patch({third, c}, cone));
  CHECK(image_text(half_turn[0]) == "(2/3 - u, 4/5 - v)");
  // The centre is not inside.
  CHECK(symmetries(even_patch({0, half}, cone)).empty());
  CHECK(symmetries(even_patch({half, 1}, cone)).empty());
}

TEST_CASE("self_intersect: a patch covered twice against itself given twice") {
  const std::array<Point, 4> cone = {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 0}}};
  const BezierPatch x = even_patch({half, half}, cone);
  const auto result = intersect(x, x);
  CHECK(result.status == Status::complete);
  CHECK(result.graph.overlaps.size() == 3);
  // Four corners of one half and the centre, which the other half shares with the ends of the cut; those of
  // the square.
  CHECK(result.graph.nodes.size() == 5 + 2 + 4);
}

TEST_CASE("self_intersect: an apex of a folded patch") {
  // (v u (1 - u), v, v^2): the side v = 0 is one point.
  const BezierPatch x =
      patch_around({0, 0}, {{1, 1, {1, 0, 0}}, {2, 1, {-1, 0, 0}}, {0, 1, {0, 1, 0}}, {0, 2, {0, 0, 1}}});
  for (const bool exchanged : {false, true}) {
    const auto result = self_intersect(exchanged ? x.exchanged() : x);
    CHECK(result.status == Status::complete);
    CHECK(result.graph.overlaps.size() == 1);
    REQUIRE(result.graph.isolated_points.size() == 1);
    const Node& apex = result.graph.nodes[static_cast<std::size_t>(result.graph.isolated_points[0])];
    CHECK(apex.free == (exchanged ? std::vector<Parameter>{Parameter::v, Parameter::s}
                                  : std::vector<Parameter>{Parameter::u, Parameter::r}));
    CHECK(apex.box[exchanged ? 0 : 1].upper == 0);
  }
}

TEST_CASE("self_intersect: random patches with symmetries") {
  Random random(7);
  int complete = 0;
  constexpr int kPatches = 16;
  for (int i = 0; i < kPatches; ++i) {
    CAPTURE(i);
    const bool even = i % 2 == 1;
    const BezierPatch x =
        even ? random_even(random, {Rational(1 + i % 3, 4), half}) : random_symmetric(random);
    const auto result = check_covers(x, 1);
    if (result.status != Status::complete) {
      REQUIRE(result.incomplete.size() == 1);
      CHECK(result.incomplete[0].why.find("covers its image more than once") != std::string::npos);
      continue;
    }
    ++complete;
    for (int j = 0; j < 4; ++j) CHECK(!has_other_preimage(x, random_point(random), random));
  }
  CAPTURE(complete);
  CHECK(complete >= kPatches / 3);
}

TEST_CASE("self_intersect: another pair on a patch with a symmetry is not overlooked") {
  // One condition on e, linear in it, gives p and q one image.
  Random random(11);
  int tried = 0;
  for (int i = 0; i < 60; ++i) {
    const PlanePoint p = random_point(random);
    const PlanePoint q = random_point(random);
    const auto s = [](const PlanePoint& w) -> Rational { return w[0] + w[1]; };
    const auto m = [](const PlanePoint& w) -> Rational { return w[0] * w[1]; };
    if (s(p) == s(q) || m(p) == m(q)) continue;
    ++tried;
    CAPTURE(i);
    std::array<Point, 6> e;
    for (Point& c : e) c = vector(random);
    const Point rest = (m(p) - m(q)) * e[2] + (s(p) * s(p) - s(q) * s(q)) * e[3] +
                       (s(p) * m(p) - s(q) * m(q)) * e[4] + (m(p) * m(p) - m(q) * m(q)) * e[5];
    e[1] = Rational(-1) / (s(p) - s(q)) * rest;
    const BezierPatch x = symmetric_patch(e);
    REQUIRE(x(p[0], p[1]) == x(q[0], q[1]));
    CHECK(!has_only_symmetric_pairs(x));
    const BezierPatch y = x.reversed_second();
    CHECK(!has_only_symmetric_pairs(y));
    const PlanePoint centre = {Rational(1 + random() % 3, 4), half};
    std::array<Point, 4> f = {vector(random), vector(random), vector(random), vector(random)};
    const PlanePoint a = {p[0] - centre[0], p[1] - centre[1]};
    const PlanePoint b = {q[0] - centre[0], q[1] - centre[1]};
    if (m(a) * m(a) == m(b) * m(b) || a[0] * a[0] == b[0] * b[0]) continue;
    const Point others =
        (m(a) - m(b)) * f[1] + (a[1] * a[1] - b[1] * b[1]) * f[2] + (m(a) * m(a) - m(b) * m(b)) * f[3];
    f[0] = Rational(-1) / (a[0] * a[0] - b[0] * b[0]) * others;
    const BezierPatch z = even_patch(centre, f);
    REQUIRE(z(p[0], p[1]) == z(q[0], q[1]));
    CHECK(!has_only_symmetric_pairs(z));
    // With a^2 + b^2 alone it is reflected in the diagonals.
    const Rational squares = a[0] * a[0] + a[1] * a[1] - b[0] * b[0] - b[1] * b[1];
    if (centre[0] != half || squares == 0) continue;
    f[0] = f[2] = Rational(-1) / squares * ((m(a) - m(b)) * f[1] + (m(a) * m(a) - m(b) * m(b)) * f[3]);
    const BezierPatch both = even_patch(centre, f);
    REQUIRE(both(p[0], p[1]) == both(q[0], q[1]));
    REQUIRE(symmetries(both).size() == 3);
    CHECK(!has_only_symmetric_pairs(both));
  }
  CHECK(tried > 40);
}

}  // namespace exsect::self_symmetry_test

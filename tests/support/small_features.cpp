#include "support/small_features.h"

#include <utility>

#include "support/graph_patches.h"

namespace exsect::small_features {
namespace {

using random_pairs::Generator;
using random_pairs::integer;
using testing::graph;
using testing::plane;
using testing::Terms;

/// In [1/4, 1].
Rational slope(Generator& generator) { return Rational(integer(generator, 3, 12), 12); }
/// In (1/4, 3/4).
Rational place(Generator& generator) { return Rational(integer(generator, 30, 70), 101); }

/// c + a u + b v
Terms linear(const Rational& c, const Rational& a, const Rational& b) {
  return {{{0, 0}, c}, {{1, 0}, a}, {{0, 1}, b}};
}
/// a (u - c) + b (v - d)
Terms through(const Rational& c, const Rational& d, const Rational& a, const Rational& b) {
  return linear(-a * c - b * d, a, b);
}
Terms constant(const Rational& c) { return {{{0, 0}, c}}; }
Terms square(const Terms& f) { return f * f; }

/// The plane over [-1, 2]², on which r turns with u and s with v.
BezierPatch wide_plane() { return plane({-1, -1, 0}, {3, 0, 0}, {0, 3, 0}); }

Feature over_wide_plane(const Terms& h, const Numbers& numbers) {
  return {{graph(h), wide_plane()}, numbers};
}

Feature arc_across_a_corner(const Rational& e, Generator& g) {
  return over_wide_plane(linear(-e, 1, slope(g)), {.open = 1, .boundary = 2});
}

Feature arc_between_sides_of_both(const Rational& e, Generator& g) {
  const Terms line = through(0, place(g), -slope(g), 1);
  return {{graph(line), plane({e - 2, -1, 0}, {2, 0, 0}, {0, 3, 0})}, {.open = 1, .boundary = 2}};
}

/// u = e - a (v - c)²
Feature chord(const Rational& e, Generator& g) {
  const Terms h = linear(-e, 1, 0) + constant(slope(g)) * square(through(0, place(g), 0, 1));
  return over_wide_plane(h, {.open = 1, .boundary = 2, .turning = {1, 0, 1, 0}});
}

/// u = a (v - c)² - e
Feature gap_at_a_side(const Rational& e, Generator& g) {
  const Terms h = linear(e, 1, 0) + constant(-slope(g)) * square(through(0, place(g), 0, 1));
  return over_wide_plane(h, {.open = 2, .boundary = 4});
}

/// (u - c)² + a (v - d)² = e²
Terms ellipse(const Rational& c, const Rational& d, const Rational& e, Generator& g) {
  return constant(-e * e) + square(through(c, d, 1, 0)) + constant(slope(g)) * square(through(c, d, 0, 1));
}

Feature loop(const Rational& e, Generator& g) {
  return over_wide_plane(ellipse(place(g), place(g), e / 4, g), {.closed = 1, .turning = {2, 2, 2, 2}});
}

Feature loop_at_a_side(const Rational& e, Generator& g) {
  return over_wide_plane(ellipse(2 * e, place(g), e, g), {.closed = 1, .turning = {2, 2, 2, 2}});
}

Feature loop_cut_by_a_side(const Rational& e, Generator& g) {
  return over_wide_plane(ellipse(e / 3, place(g), e, g), {.open = 1, .boundary = 2, .turning = {1, 2, 1, 2}});
}

Feature twin_arcs(const Rational& e, Generator& g) {
  const Terms line = through(Rational(1, 2), place(g), slope(g) / 8, 1);
  return over_wide_plane(square(line) + constant(-e * e / 16), {.open = 2, .boundary = 4});
}

Feature hyperbola(const Rational& e, Generator& g) {
  const Rational c = place(g), d = place(g);
  const Terms lines = through(c, d, -slope(g), 1) * through(c, d, slope(g), 1);
  const bool turns_in_v = g() % 2 == 0;
  return over_wide_plane(
      lines + constant((turns_in_v ? -1 : 1) * e * e / 16),
      {.open = 2,
       .boundary = 4,
       .turning = {turns_in_v ? 0 : 2, turns_in_v ? 2 : 0, turns_in_v ? 0 : 2, turns_in_v ? 2 : 0}});
}

Feature two_arcs_across_a_corner(const Rational& e, Generator& g) {
  const Rational a = slope(g);
  return over_wide_plane(linear(-e, 1, a) * linear(-e - e * slope(g), 1, a), {.open = 2, .boundary = 4});
}

/// An ellipse on which u and r turn at the distance of about e.
Feature order_of_turning_points(const Rational& e, Generator& g) {
  return {{graph(ellipse(Rational(1, 2), Rational(1, 2), Rational(1, 5), g)),
           plane({-1, -1, 0}, {3, 0, 0}, {e, 3, 0})},
          {.closed = 1, .turning = {2, 2, 2, 2}}};
}

Feature crossing_at_a_side(const Rational& e, Generator& g) {
  const Rational d = place(g);
  return over_wide_plane(through(e, d, -slope(g), 1) * through(e, d, slope(g), 1),
                         {.branched = 1, .boundary = 4});
}

Feature crossing_at_a_corner(const Rational& e, Generator& g) {
  const Rational a = slope(g);
  const Rational d = e * a * Rational(integer(g, 9, 15), 8);
  return over_wide_plane(through(e, d, -a, 1) * through(e, d, slope(g), 1), {.branched = 1, .boundary = 4});
}

Feature contact_across_a_corner(const Rational& e, Generator& g) {
  return over_wide_plane(square(linear(-e, 1, slope(g))), {.open = 1, .boundary = 2});
}

/// u = e (1 + a v)
Feature curve_along_a_side(const Rational& e, Generator& g) {
  return over_wide_plane(linear(-e, 1, -e * slope(g)), {.open = 1, .boundary = 2});
}

Feature touch_at_a_corner(const Rational& e, Generator& g) {
  return over_wide_plane(square(through(e, 0, 1, 0)) + constant(slope(g)) * square(through(0, e / 3, 0, 1)),
                         {.isolated = 1});
}

/// Orthogonal, from a quaternion of small integers.
random_pairs::AffineMap motion(Generator& g) {
  const Rational a = integer(g, 1, 5), b = integer(g, -5, 5), c = integer(g, -5, 5), d = integer(g, -5, 5);
  const Rational n = a * a + b * b + c * c + d * d;
  const Rational scale = Rational(integer(g, 1, 9), integer(g, 1, 9)) / n;
  random_pairs::AffineMap map;
  map.rows = {Point{scale * (a * a + b * b - c * c - d * d), scale * 2 * (b * c - a * d),
                    scale * 2 * (b * d + a * c)},
              Point{scale * 2 * (b * c + a * d), scale * (a * a - b * b + c * c - d * d),
                    scale * 2 * (c * d - a * b)},
              Point{scale * 2 * (b * d - a * c), scale * 2 * (c * d + a * b),
                    scale * (a * a - b * b - c * c + d * d)}};
  for (Rational& t : map.translation) t = Rational(integer(g, -20, 20), integer(g, 1, 9));
  return map;
}

/// (X, Y, Z + q(X,Y)) of a patch of which X and Y are linear.
BezierPatch bent(const BezierPatch& patch, const std::array<Rational, 3>& q) {
  ControlNet c = patch.power_basis();
  const auto coordinate = [&](std::size_t k) { return linear(c[0][0][k], c[1][0][k], c[0][1][k]); };
  const Terms x = coordinate(0), y = coordinate(1);
  const Terms added = constant(q[0]) * x * x + constant(q[1]) * x * y + constant(q[2]) * y * y;
  for (const auto& [i, a] : added) c[i.first][i.second][2] += a;
  return BezierPatch::from_power_basis(c);
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"arc across a corner", arc_across_a_corner},
      {"arc between sides of both", arc_between_sides_of_both},
      {"chord", chord},
      {"gap at a side", gap_at_a_side},
      {"loop", loop},
      {"loop at a side", loop_at_a_side},
      {"loop cut by a side", loop_cut_by_a_side},
      {"twin arcs", twin_arcs},
      {"hyperbola", hyperbola},
      {"two arcs across a corner", two_arcs_across_a_corner},
      {"order of turning points", order_of_turning_points},
      {"crossing at a side", crossing_at_a_side},
      {"crossing at a corner", crossing_at_a_corner},
      {"contact across a corner", contact_across_a_corner},
      {"curve along a side", curve_along_a_side},
      {"touch at a corner", touch_at_a_corner},
  };
  return all;
}

Feature disguised(Feature feature, Generator& g) {
  auto& [x, y] = feature.pair;
  std::array<int, 4>& turning = feature.numbers.turning;
  if (g() % 2 == 0) {
    const std::array<Rational, 3> q = {Rational(integer(g, -9, 9), 10), Rational(integer(g, -9, 9), 10),
                                       Rational(integer(g, -9, 9), 10)};
    x = bent(x, q);
    y = bent(y, q);
  }
  const random_pairs::AffineMap map = motion(g);
  x = map(x);
  y = map(y);
  for (const std::size_t first : {std::size_t{0}, std::size_t{2}}) {
    BezierPatch& patch = first == 0 ? x : y;
    if (g() % 2 == 0) patch = patch.reversed_first();
    if (g() % 2 == 0) patch = patch.reversed_second();
    if (g() % 2 == 0) {
      patch = patch.exchanged();
      std::swap(turning[first], turning[first + 1]);
    }
  }
  if (g() % 2 == 0) {
    std::swap(x, y);
    std::swap(turning[0], turning[2]);
    std::swap(turning[1], turning[3]);
  }
  return feature;
}

Feature example(const Family& family, int bits, std::uint64_t seed) {
  Generator generator(seed);
  const Rational size = power_of_two(-bits) * Rational(integer(generator, 16, 31), 16);
  return disguised(family.make(size, generator), generator);
}

std::string failure(const Family& family, int bits, std::uint64_t seed, bool exact) {
  const Feature feature = example(family, bits, seed);
  return counted_failure(feature.pair, feature.numbers, exact);
}

}  // namespace exsect::small_features

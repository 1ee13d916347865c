#include "round_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/random_nets.h"

namespace exsect::round_pieces {
namespace {

using random_nets::ProjectiveMap;
using random_pairs::Generator;
using random_pairs::integer;

/// Of the plane curve (w a, w b, w), control points of a rational Bézier curve.
using Profile = std::vector<std::array<Rational, 3>>;

/// ((1 - t^2), 2 t) / (1 + t^2), from (1,0) to (0,1).
Profile quarter_arc() { return {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}}; }

/// The first half of it, 0 <= t <= 1/2, by one step of de Casteljau's algorithm.
Profile half_of_arc() { return {{1, 0, 1}, {1, Rational(1, 2), 1}, {Rational(3, 4), 1, Rational(5, 4)}}; }

/// The profile (a, b) = (distance from the z-axis, height), turned by a quarter about the z-axis. The
/// parameter of the turn is the first one.
RationalPatch turned(const Profile& profile) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const auto& [c, s, w] : quarter_arc()) {
    net.emplace_back();
    for (const auto& [a, b, weight] : profile) net.back().push_back({a * c, a * s, b * w, weight * w});
  }
  return RationalPatch::from_homogeneous(net);
}

Profile arc_about(const Profile& arc, const Rational& centre, const Rational& across, const Rational& up) {
  Profile result;
  for (const auto& [a, b, w] : arc) result.push_back({centre * w + across * a, up * b, w});
  return result;
}

Rational halves(Generator& generator, long lowest, long highest) {
  return Rational(integer(generator, lowest, highest), 2);
}

Rational sign(Generator& generator) { return integer(generator, 0, 1) == 0 ? 1 : -1; }

RationalPatch piece(Generator& generator) {
  const Rational radius = halves(generator, 1, 4), height = integer(generator, 1, 3);
  switch (integer(generator, 0, 5)) {
    case 0:
      return RationalPatch(
          {{{-radius, -height, 0}, {-radius, height, 0}}, {{radius, -height, 0}, {radius, height, 0}}});
    case 1:
      return turned({{radius, 0, 1}, {radius, height, 1}});
    case 2:
      return turned({{radius, 0, 1}, {radius + halves(generator, 1, 3), height, 1}});
    case 3:
      return turned(arc_about(quarter_arc(), 0, radius, radius));
    case 4:
      return turned(arc_about(half_of_arc(), 0, radius, radius));
    default: {
      const Rational minor = halves(generator, 1, 2), outwards = sign(generator);
      return turned(arc_about(quarter_arc(), minor + radius, minor * outwards, minor * sign(generator)));
    }
  }
}

/// A large one, or a small quarter of a cylinder, a cone with its apex, an octant of a sphere or a quarter of
/// a tube of a torus.
RationalPatch large_piece(Generator& generator) {
  const Rational radius = integer(generator, 1, 2), height = integer(generator, 1, 2);
  switch (integer(generator, 0, 4)) {
    case 0:
      return RationalPatch({{{-4, -4, 0}, {-4, 4, 0}}, {{4, -4, 0}, {4, 4, 0}}});
    case 1:
      return turned({{radius, -2, 1}, {radius, 2, 1}});
    case 2:
      return turned({{radius, 0, 1}, {0, height, 1}});
    case 3:
      return turned(arc_about(quarter_arc(), 0, radius, radius));
    default: {
      const Rational outwards = sign(generator);
      return turned(arc_about(quarter_arc(), 1 + radius, outwards, sign(generator)));
    }
  }
}

/// By right angles, or by a small quaternion; no shift.
ProjectiveMap rotation(Generator& generator, bool right) {
  std::array<Rational, 4> q;
  do {
    for (Rational& c : q) c = integer(generator, right ? 0 : -2, right ? 1 : 2);
  } while (std::count(q.begin(), q.end(), 0) == 4 || (right && std::count(q.begin(), q.end(), 0) == 1));
  const auto& [a, b, c, d] = q;
  const Rational n = a * a + b * b + c * c + d * d;
  ProjectiveMap m = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 0},
                      {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b), 0},
                      {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d, 0},
                      {0, 0, 0, n}}};
  return m;
}

/// A point of the patch with simple parameters.
Point simple_point(Generator& generator, const RationalPatch& patch) {
  const auto parameter = [&]() -> Rational {
    const std::array<Rational, 5> values = {0, Rational(1, 3), Rational(1, 2), Rational(1, 2), 1};
    return values[static_cast<std::size_t>(integer(generator, 0, 4))];
  };
  const Rational u = parameter();
  return patch(u, parameter());
}

/// From a point of y to one of x, or some halves.
Point shift(Generator& generator, const RationalPatch& x, const RationalPatch& y) {
  const long choice = integer(generator, 0, 9);
  if (choice == 0) return {halves(generator, -2, 2), halves(generator, -2, 2), halves(generator, -2, 2)};
  const Point p = simple_point(generator, x);
  Point result = p - simple_point(generator, y);
  if (choice < 5) return result;
  for (Rational& c : result) {
    c = Rational(std::lround(4 * to_double(c)), 4);
    if (choice < 9) continue;
    Rational small = integer(generator, -3, 3);
    for (long digits = integer(generator, 1, 8); digits > 0; --digits) small /= 10;
    c += small;
  }
  return result;
}

ProjectiveMap translation(const Point& by) {
  return {{{1, 0, 0, by[0]}, {0, 1, 0, by[1]}, {0, 0, 1, by[2]}, {0, 0, 0, 1}}};
}

}  // namespace

RationalPatch round_piece(Generator& generator) {
  const RationalPatch of = piece(generator);
  const bool right = integer(generator, 0, 3) != 0;
  return random_nets::image(of, rotation(generator, right));
}

std::pair<RationalPatch, RationalPatch> round_pair(Generator& generator) {
  const RationalPatch x = round_piece(generator), y = round_piece(generator);
  const Point by = shift(generator, x, y);
  return {x, random_nets::image(y, translation(by))};
}

std::pair<RationalPatch, RationalPatch> placed_pair(Generator& generator) {
  const auto piece_at = [&](const Point& by) {
    const RationalPatch of = large_piece(generator);
    return random_nets::image(random_nets::image(of, rotation(generator, true)), translation(by));
  };
  const RationalPatch x = piece_at({0, 0, 0});
  Point by;
  for (Rational& c : by) c = integer(generator, 0, 1) * integer(generator, -1, 1);
  return {x, piece_at(by)};
}

}  // namespace exsect::round_pieces

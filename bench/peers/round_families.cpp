#include "round_families.h"

#include <exsect/geometry/number.h>
#include <exsect/geometry/point.h>

#include <cmath>

#include "pair_families.h"

namespace peers {
namespace {

using exsect::Point;
using exsect::Rational;
using exsect::operator-;
using exsect::operator*;
using Json = nlohmann::ordered_json;

Json text(const Rational& q) { return exsect::to_string(q); }
Json text(const Point& p) { return {text(p[0]), text(p[1]), text(p[2])}; }

Point random_point(Generator& generator) {
  const Rational x = sixteenths(generator, -8, 8);
  const Rational y = sixteenths(generator, -8, 8);
  return {x, y, sixteenths(generator, -8, 8)};
}

/// Integers between -4 and 4, not all 0.
Point random_axis(Generator& generator) {
  Point axis;
  do {
    for (Rational& c : axis) c = integer(generator, -4, 4);
  } while (exsect::is_zero(axis));
  return axis;
}

/// The squared cosine of the angle.
Rational cosine_squared(const Point& a, const Point& b) {
  const Rational product = exsect::dot(a, b);
  return product * product / (exsect::dot(a, a) * exsect::dot(b, b));
}

/// A multiple of the axis, by sixteenths, about as long as `length`.
Point along(const Point& axis, const Rational& length) {
  const double measure = std::sqrt(exsect::to_double(exsect::dot(axis, axis)));
  return Rational(std::lround(16 * exsect::to_double(length) / measure), 16) * axis;
}

/// The surface of this kind through or around a point; `radius` is that of a sphere or cylinder, and of a
/// cone that of its circle around the point.
Json surface(Round kind, const Point& point, const Point& axis, const Rational& radius,
             const Rational& minor) {
  switch (kind) {
    case Round::plane:
      return {{"type", "plane"}, {"point", text(point)}, {"normal", text(axis)}};
    case Round::cylinder:
      return {{"type", "cylinder"}, {"point", text(point)}, {"axis", text(axis)}, {"radius", text(radius)}};
    case Round::cone: {
      const Point apex = point - along(axis, 2 * radius);
      return {{"type", "cone"}, {"apex", text(apex)}, {"axis", text(axis)}, {"slope", "1/2"}};
    }
    case Round::sphere:
      return {{"type", "sphere"}, {"centre", text(point)}, {"radius", text(radius)}};
    default:
      return {{"type", "torus"},
              {"centre", text(point)},
              {"axis", text(axis)},
              {"major", text(radius)},
              {"minor", text(minor)}};
  }
}

Json named(const char* name, const Json& surface) {
  Json entry = {{"name", name}};
  entry.update(surface);
  return entry;
}

Json random_surface(Generator& generator, Round kind, const Point& axis) {
  const Point point = random_point(generator);
  const bool is_torus = kind == Round::torus;
  const Rational radius = is_torus ? sixteenths(generator, 16, 20) : sixteenths(generator, 8, 16);
  return surface(kind, point, axis, radius, is_torus ? sixteenths(generator, 4, 8) : Rational(0));
}

/// With the round surface through, or around, a point near the middle of the patch.
Json beside_patch(Generator& generator, Round kind, int degree) {
  const exsect::RationalPatch patch = degree == 2 ? random_doubles(generator).x : bicubic(generator).x;
  const Rational half(1, 2);
  Point middle = patch(half, half);
  for (Rational& c : middle) c = Rational(std::lround(16 * exsect::to_double(c)), 16);
  const Rational radius = kind == Round::torus ? Rational(3, 8) : sixteenths(generator, 4, 8);
  const Point axis = random_axis(generator);
  Json pair = entries({patch, patch});
  pair[1] = named("y", surface(kind, middle, axis, radius, Rational(1, 8)));
  return pair;
}

}  // namespace

Json round_pair(Generator& generator, Round first, Round second) {
  const Point axis = random_axis(generator);
  Point other = random_axis(generator);
  if (first == Round::plane)
    while (cosine_squared(axis, other) < Rational(3, 4)) other = random_axis(generator);
  else
    while (cosine_squared(axis, other) > Rational(1, 4)) other = random_axis(generator);
  const Json x = named("x", random_surface(generator, first, axis));
  return {x, named("y", random_surface(generator, second, other))};
}

Json quadric_and_patch(Generator& generator, int degree) {
  return beside_patch(generator, static_cast<Round>(integer(generator, 0, 3)), degree);
}

Json torus_and_patch(Generator& generator, int degree) {
  return beside_patch(generator, Round::torus, degree);
}

}  // namespace peers

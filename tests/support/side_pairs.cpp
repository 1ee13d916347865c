#include "support/side_pairs.h"

#include <array>
#include <cmath>
#include <vector>

namespace exsect::side_pairs {
namespace {

using random_pairs::integer;
using Vector = std::array<double, 3>;
using Grid = std::array<std::array<Vector, 4>, 4>;
/// The Bézier control points of a curve of degree two.
using Curve = std::array<Point, 3>;

double uniform(Generator& g, double lowest, double highest) {
  return std::uniform_real_distribution<double>(lowest, highest)(g);
}

double rounded(double x, int bits) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
}

/// All results are rounded to doubles.
Vector turned(const Vector& p, double angle, double scale) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Vector q = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return {scale * q[0], scale * (c * q[1] - s * q[2]), scale * (s * q[1] + c * q[2])};
}

Vector combined(const Vector& p, const Vector& q, double t) {
  Vector result;
  for (std::size_t c = 0; c < 3; ++c) result[c] = t == 0.5 ? (p[c] + q[c]) / 2 : (1 - t) * p[c] + t * q[c];
  return result;
}

/// A surface of 2 x 2 spans. Where two of them meet along the i-th parameter the curve point divides the
/// segment of control points i and i + 1.
struct Spline {
  Grid grid;
  std::array<double, 3> division;

  std::array<Vector, 3> span(const std::array<Vector, 3>& p, std::size_t i) const {
    return {combined(p[0], p[1], division[i]), p[1], combined(p[1], p[2], division[i + 1])};
  }
  BezierPatch patch(std::size_t a, std::size_t b, double angle, double scale) const {
    std::array<std::array<Vector, 3>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
      rows[i] = span({grid[a + i][b], grid[a + i][b + 1], grid[a + i][b + 2]}, b);
    ControlNet net;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto column = span({rows[0][j], rows[1][j], rows[2][j]}, a);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector p = angle == 0 && scale == 1 ? column[i] : turned(column[i], angle, scale);
        net[i][j] = {from_double(p[0]), from_double(p[1]), from_double(p[2])};
      }
    }
    return BezierPatch(net);
  }
};

Point noise(Generator& g, long size) {
  return {Rational(integer(g, -size, size), 64), Rational(integer(g, -size, size), 64),
          Rational(integer(g, -size, size), 64)};
}

/// Over about [0,1] x [0,1].
BezierPatch bumpy(Generator& g, long size) {
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = Point{Rational(i, 2), Rational(j, 2), 0} + noise(g, size);
  return BezierPatch(net);
}

/// From a curve along v, `away` from it after one unit of u, and bumpy.
BezierPatch sheet(Generator& g, const Curve& curve, const std::array<Point, 3>& away, long size) {
  ControlNet net;
  for (std::size_t j = 0; j < 3; ++j) {
    net[0][j] = curve[j];
    net[1][j] = curve[j] + Rational(1, 2) * away[j];
    net[2][j] = curve[j] + away[j] + noise(g, size);
  }
  return BezierPatch(net);
}

Curve side_of(const BezierPatch& patch, std::size_t row) {
  return {patch.net()[row][0], patch.net()[row][1], patch.net()[row][2]};
}

/// In any position in space, in their parameters, and order; possibly scaled from inches.
Pair placed(Generator& g, BezierPatch x, BezierPatch y) {
  random_pairs::AffineMap map = random_pairs::affine_map(g);
  if (integer(g, 0, 2) == 0)
    map = {{Point{Rational(127, 5), 0, 0}, Point{0, Rational(127, 5), 0}, Point{0, 0, Rational(127, 5)}},
           map.translation};
  for (BezierPatch* patch : {&x, &y}) {
    *patch = map(*patch);
    if (integer(g, 0, 1) == 1) *patch = patch->exchanged();
    if (integer(g, 0, 1) == 1) *patch = patch->reversed_first();
    if (integer(g, 0, 1) == 1) *patch = patch->reversed_second();
  }
  return integer(g, 0, 1) == 1 ? Pair{x, y} : Pair{y, x};
}

/// y begins on the part from a to b of the side u = 1 of x.
Pair attached(Generator& g, const Rational& a, const Rational& b) {
  const BezierPatch x = bumpy(g, 10);
  const BezierPatch part = x.restricted_to(0, 1, a, b);
  std::array<Point, 3> away;
  const bool smooth = integer(g, 0, 1) == 1;
  const Point lift = {Rational(integer(g, -2, 4), 4), 0, Rational(integer(g, -4, 4), 4)};
  for (std::size_t j = 0; j < 3; ++j)
    away[j] =
        smooth ? Rational(2) * (part.net()[2][j] - part.net()[1][j]) : lift + Point{Rational(1, 4), 0, 0};
  return placed(g, x, sheet(g, side_of(part, 2), away, smooth ? 2 : 6));
}

}  // namespace

Pair spline_neighbours(Generator& g) {
  const int bits = static_cast<int>(integer(g, 24, 53));
  const double noise = uniform(g, 0, 0.3);
  Spline spline;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b) {
      const auto s = static_cast<double>(a);
      const auto t = static_cast<double>(b);
      spline.grid[a][b] = {s, t, 0.2 * std::sin(1.3 * s + 0.7 * t)};
      for (double& c : spline.grid[a][b]) c = rounded(c + uniform(g, -noise, noise), bits);
    }
  const bool knots = integer(g, 0, 1) == 1;
  for (double& t : spline.division) t = knots ? uniform(g, 0.2, 0.8) : 0.5;
  const double angle = integer(g, 0, 1) == 1 ? uniform(g, 0, 3) : 0;
  const double scale = integer(g, 0, 1) == 1 ? 25.4 : 1;
  const bool corner = integer(g, 0, 3) == 0;
  BezierPatch x = spline.patch(0, 0, angle, scale);
  BezierPatch y = spline.patch(1, corner ? 1 : 0, angle, scale);
  for (BezierPatch* patch : {&x, &y}) {
    if (integer(g, 0, 1) == 1) *patch = patch->exchanged();
    if (integer(g, 0, 1) == 1) *patch = patch->reversed_second();
  }
  return integer(g, 0, 1) == 1 ? Pair{x, y} : Pair{y, x};
}

Pair parts_of_sides(Generator& g) {
  const Rational a(integer(g, -4, 12), 16);
  return attached(g, a, a + Rational(integer(g, 4, 14), 16));
}

Pair half_sides(Generator& g) { return attached(g, Rational(1, 2), 1); }

Pair sides_on_lines(Generator& g) {
  const BezierPatch x = bumpy(g, 10);
  const Rational u(integer(g, 1, 10), integer(g, 0, 1) == 1 ? 11 : 16);
  const Rational a(integer(g, -4, 12), 16);
  const BezierPatch line = x.restricted_to(u, u, a, a + Rational(integer(g, 4, 14), 16));
  const Point away = {Rational(integer(g, -3, 3), 4), 0, Rational(integer(g, 1, 4), 4)};
  return placed(g, x, sheet(g, side_of(line, 0), {away, away, away}, 6));
}

Pair sheets_on_planes(Generator& g) {
  const int bits = static_cast<int>(integer(g, 10, 53));
  const auto number = [&](double lowest, double highest) {
    return from_double(rounded(uniform(g, lowest, highest), bits));
  };
  const Point origin = {number(-1, 0), number(-1, 0), number(-1, 1)};
  const Point first = {number(1, 2), number(-0.3, 0.3), number(-1, 1)};
  const Point second = {number(-0.3, 0.3), number(1, 2), number(-1, 1)};
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = origin + Rational(i, 2) * first + Rational(j, 2) * second;
  const auto place = [&] { return std::array{number(-0.2, 1.2), number(-0.2, 1.2)}; };
  const auto from = place();
  const auto to = integer(g, 0, 1) == 1 ? place() : std::array{from[0], number(-0.2, 1.2)};
  const Point a = origin + from[0] * first + from[1] * second;
  const Point b = origin + to[0] * first + to[1] * second;
  const Point away = {number(-0.5, 0.5), number(-0.5, 0.5), number(2, 3)};
  return placed(g, BezierPatch(net), sheet(g, {a, Rational(1, 2) * (a + b), b}, {away, away, away}, 10));
}

}  // namespace exsect::side_pairs

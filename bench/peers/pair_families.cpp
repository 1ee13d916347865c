#include "pair_families.h"

#include <functional>

namespace peers {
namespace {

using exsect::BezierPatch;
using exsect::ControlNet;
using exsect::Point;
using exsect::Rational;

/// Uniform in {lowest, ..., highest}.
long integer(Generator& generator, long lowest, long highest) {
  const auto count = static_cast<std::uint64_t>(highest - lowest + 1);
  return lowest + static_cast<long>(generator() % count);
}

Rational sixteenths(Generator& generator, long largest) {
  return Rational(integer(generator, -largest, largest), 16);
}

/// The unit square in the plane z = 0 and an upright, steep or nearly flat square through it, or the same
/// square turned over; each coordinate is moved by unit() times a width, unit() in [-1,1].
ExactPair near_grids(Generator& generator, const std::function<Rational()>& unit) {
  const long placement = integer(generator, 0, 3);
  const Rational half(1, 2);
  ControlNet x;
  ControlNet y;
  for (long i = 0; i < 3; ++i) {
    for (long j = 0; j < 3; ++j) {
      const Rational a(i, 2);
      const Rational b(j, 2);
      const std::array<Point, 4> grids = {Point{a, half, b - half}, Point{a, (a + b) * half, b - half},
                                          Point{a, b, (a - half) / 4}, Point{b, a, 0}};
      const Point grid = grids[static_cast<std::size_t>(placement)];
      const Rational bend(placement < 2 ? 1 : 2, 2);
      const auto row = static_cast<std::size_t>(i);
      const auto column = static_cast<std::size_t>(j);
      x[row][column] = {a + unit() / 8, b + unit() / 8, bend * unit()};
      y[row][column] = {grid[0] + unit() / 8, grid[1] + unit() / 4, grid[2] + bend * unit()};
    }
  }
  return {BezierPatch(x), BezierPatch(y)};
}

/// Coefficients of a polynomial of bidegree (2,2): c[i][j] belongs to X^i Y^j.
using Quadratic = std::array<std::array<Rational, 3>, 3>;

/// (X, Y, f(X,Y)) over [x0,x1] x [y0,y1].
BezierPatch graph(const Quadratic& f, const std::array<Rational, 4>& over) {
  ControlNet c{};
  c[1][0] = {1, 0, 0};
  c[0][1] = {0, 1, 0};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) c[i][j][2] = f[i][j];
  return BezierPatch::from_power_basis(c).restricted_to(over[0], over[1], over[2], over[3]);
}

/// A square (p + q X + r Y)^2 as coefficients.
Quadratic square_of(const Rational& p, const Rational& q, const Rational& r) {
  Quadratic c{};
  c[0][0] = p * p;
  c[1][0] = 2 * p * q;
  c[0][1] = 2 * p * r;
  c[2][0] = q * q;
  c[0][2] = r * r;
  c[1][1] = 2 * q * r;
  return c;
}

Quadratic sum(const Quadratic& a, const Rational& factor, const Quadratic& b) {
  Quadratic c = a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) c[i][j] += factor * b[i][j];
  return c;
}

/// P -> matrix P with entries in multiples of 1/4 and a determinant of at least 1/4.
std::function<BezierPatch(const BezierPatch&)> affine_map(Generator& generator) {
  std::array<Point, 3> rows;
  do {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        rows[i][k] = Rational(integer(generator, -3, 3) + (i == k ? 3 : 0), 4);
  } while (abs(exsect::determinant(rows[0], rows[1], rows[2])) < Rational(1, 4));
  return [rows](const BezierPatch& patch) {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (Point& p : row) p = {exsect::dot(rows[0], p), exsect::dot(rows[1], p), exsect::dot(rows[2], p)};
    return BezierPatch(net);
  };
}

/// Patches whose intersection lies over the zero set of h in the unit square of the (X,Y) plane: graphs of f
/// and f + h, f random; the second patch is larger than the first or turned by a quarter.
ExactPair graphs(Generator& generator, const Quadratic& h) {
  Quadratic f{};
  for (auto& row : f)
    for (Rational& c : row) c = sixteenths(generator, 6);
  const auto map = affine_map(generator);
  const BezierPatch x = graph(sum(f, 1, h), {0, 1, 0, 1});
  const Rational margin(integer(generator, 1, 4), 16);
  const BezierPatch y = graph(f, {-margin, 1 + margin, -margin, 1 + margin});
  return {map(x), map(integer(generator, 0, 1) == 0 ? y : y.exchanged().reversed_first())};
}

enum class Shape { definite, indefinite, square };

/// The shape with its centre, or its line of zeros, in the middle of the unit square.
Quadratic difference(Generator& generator, Shape shape) {
  const Rational a = Rational(1, 2) + sixteenths(generator, 3);
  const Rational b = Rational(1, 2) + sixteenths(generator, 3);
  const Rational slope = sixteenths(generator, 8);
  const Rational factor(integer(generator, 4, 16), 16);
  const Quadratic first = square_of(-a - slope * b, 1, slope);
  if (shape == Shape::square) return first;
  const Quadratic second = square_of(-b + slope * a, -slope, 1);
  return sum(first, shape == Shape::definite ? factor : Rational(-factor), second);
}

Shape any_shape(Generator& generator) { return static_cast<Shape>(integer(generator, 0, 2)); }

/// As tangent, with 2^-least to 2^-most added to the difference or taken away.
ExactPair off_tangent(Generator& generator, int least, int most) {
  const Shape shape = any_shape(generator);
  Quadratic h = difference(generator, shape);
  const Rational e = exsect::power_of_two(-integer(generator, least, most));
  h[0][0] += integer(generator, 0, 2) == 0 ? e : Rational(-e);
  return graphs(generator, h);
}

}  // namespace

ExactPair random_rationals(Generator& generator) {
  return near_grids(generator, [&] {
    const long denominator = integer(generator, 1, 16);
    return Rational(integer(generator, -denominator, denominator), denominator);
  });
}

ExactPair random_doubles(Generator& generator) {
  ExactPair pair = near_grids(generator, [&] {
    return exsect::from_double(static_cast<double>(generator() >> 11U) * 0x1p-52 - 1);  // in [-1,1)
  });
  const auto rounded = [](const BezierPatch& patch) {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (Point& p : row)
        for (Rational& c : p) c = exsect::from_double(exsect::to_double(c));
    return BezierPatch(net);
  };
  return {rounded(pair.x), rounded(pair.y)};
}

ExactPair loop(Generator& generator) {
  Quadratic h = difference(generator, Shape::definite);
  h[0][0] -= Rational(integer(generator, 1, 16), 512);
  return graphs(generator, h);
}

ExactPair tangent(Generator& generator) {
  const Shape shape = any_shape(generator);
  return graphs(generator, difference(generator, shape));
}

ExactPair near(Generator& generator) { return off_tangent(generator, 6, 14); }

ExactPair nearer(Generator& generator) { return off_tangent(generator, 14, 24); }

ExactPair overlap(Generator& generator) {
  const ExactPair random = near_grids(generator, [&] { return sixteenths(generator, 16); });
  const BezierPatch& x = random.x;
  switch (integer(generator, 0, 2)) {
    case 0: {
      ControlNet net = random.y.net();
      net[0] = x.net()[0];
      return {x, BezierPatch(net)};
    }
    case 1:
      return {x, x.restricted_to(0, -1, 0, 1)};
    default: {
      const Rational u(integer(generator, -6, 6), 8);
      const Rational v(integer(generator, -6, 6), 8);
      return {x, x.restricted_to(u, u + 1, v, v + 1)};
    }
  }
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = {{"random-rational", random_rationals},
                                          {"random-double", random_doubles},
                                          {"loop", loop},
                                          {"tangent", tangent},
                                          {"near", near},
                                          {"nearer", nearer},
                                          {"overlap", overlap}};
  return all;
}

}  // namespace peers

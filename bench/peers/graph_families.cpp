#include <functional>

#include "pair_families.h"

namespace peers {
namespace {

using exsect::BezierPatch;
using exsect::ControlNet;
using exsect::Point;
using exsect::Rational;

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
    for (Rational& c : row) c = sixteenths(generator, -6, 6);
  const auto map = affine_map(generator);
  const BezierPatch x = graph(sum(f, 1, h), {0, 1, 0, 1});
  const Rational margin(integer(generator, 1, 4), 16);
  const BezierPatch y = graph(f, {-margin, 1 + margin, -margin, 1 + margin});
  return {map(x), map(integer(generator, 0, 1) == 0 ? y : y.exchanged().reversed_first())};
}

enum class Shape { definite, indefinite, square };

/// The shape with its centre, or its line of zeros, in the middle of the unit square.
Quadratic difference(Generator& generator, Shape shape) {
  const Rational a = Rational(1, 2) + sixteenths(generator, -3, 3);
  const Rational b = Rational(1, 2) + sixteenths(generator, -3, 3);
  const Rational slope = sixteenths(generator, -8, 8);
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

}  // namespace peers

#include "support/random_pairs.h"

#include <functional>

namespace exsect::random_pairs {
namespace {

/// Where the second grid stands in relation to the first, which is the unit square in the plane z = 0.
Point crossing_grid(long placement, long i, long j) {
  const Rational a(i, 2);
  const Rational b(j, 2);
  const Rational half(1, 2);
  if (placement == 0) return {a, half, b - half};                  // upright, along an axis
  if (placement == 1) return {a, (a + b) * half, b - half};        // steep, along a diagonal
  if (placement == 2) return {a, b, (a - half) * Rational(1, 4)};  // nearly flat
  return {b, a, Rational(0)};                                      // the same square
}

/// Both grids, each coordinate moved by `move(height)`; the flat pairs are bent more.
Pair near_grids(Generator& generator, const std::function<Rational(long)>& move) {
  const long placement = integer(generator, 0, 3);
  const long bend = placement < 2 ? 6 : 16;
  ControlNet x;
  ControlNet y;
  for (long i = 0; i < 3; ++i) {
    for (long j = 0; j < 3; ++j) {
      const Point shift_x = {move(2), move(2), move(bend)};
      const Point shift_y = {move(3), move(placement < 2 ? bend : 3), move(placement < 2 ? 3 : bend)};
      const auto row = static_cast<std::size_t>(i);
      const auto column = static_cast<std::size_t>(j);
      x[row][column] = Point{Rational(i, 2), Rational(j, 2), Rational(0)} + shift_x;
      y[row][column] = crossing_grid(placement, i, j) + shift_y;
    }
  }
  return {BezierPatch(x), BezierPatch(y)};
}

Rational sixteenths(Generator& generator, long largest) {
  return Rational(integer(generator, -largest, largest), 16);
}

}  // namespace

long integer(Generator& generator, long lowest, long highest) {
  const auto count = static_cast<std::uint64_t>(highest - lowest + 1);
  return lowest + static_cast<long>(generator() % count);
}

Pair small_rationals(Generator& generator) {
  return near_grids(generator, [&](long largest) { return sixteenths(generator, largest); });
}

Pair doubles(Generator& generator) {
  return near_grids(generator, [&](long largest) {
    const double unit = static_cast<double>(generator() >> 11U) * 0x1p-52 - 1;  // in [-1,1)
    return from_double(unit * static_cast<double>(largest) / 16);
  });
}

Pair scattered(Generator& generator) {
  const auto net = [&] {
    ControlNet result;
    for (auto& row : result) {
      for (Point& point : row) {
        for (Rational& coordinate : point) coordinate = Rational(integer(generator, 0, 16), 16);
      }
    }
    return BezierPatch(result);
  };
  const BezierPatch x = net();
  return {x, net()};
}

Pair loop(Generator& generator) {
  const auto near_half = [&] { return Rational(1, 2) + sixteenths(generator, 2); };
  const Rational a = near_half();
  const Rational b = near_half();
  const Rational height(integer(generator, 1, 12), 256);
  const Rational steep = 1 + sixteenths(generator, 4);
  // z = height - (u - a)^2 - steep (v - b)^2 over the unit square, and a nearly flat square that is larger.
  ControlNet cap{};
  cap[0][0] = {0, 0, height - a * a - steep * b * b};
  cap[1][0] = {1, 0, 2 * a};
  cap[0][1] = {0, 1, 2 * steep * b};
  cap[2][0] = {0, 0, -1};
  cap[0][2] = {0, 0, -steep};
  ControlNet flat;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      flat[i][j] = {Rational(static_cast<long>(i)) - Rational(1, 2) + sixteenths(generator, 1),
                    Rational(static_cast<long>(j)) - Rational(1, 2) + sixteenths(generator, 1),
                    sixteenths(generator, 3) / 64};
    }
  }
  const AffineMap map = affine_map(generator);
  return {map(BezierPatch::from_power_basis(cap)), map(BezierPatch(flat))};
}

Point AffineMap::operator()(const Point& p) const {
  return Point{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + translation;
}

BezierPatch AffineMap::operator()(const BezierPatch& patch) const {
  ControlNet net = patch.net();
  for (auto& row : net) {
    for (Point& point : row) point = (*this)(point);
  }
  return BezierPatch(net);
}

AffineMap affine_map(Generator& generator) {
  const auto entry = [&] { return Rational(integer(generator, -6, 6), integer(generator, 1, 4)); };
  AffineMap map;
  do {
    for (Point& row : map.rows) row = {entry(), entry(), entry()};
  } while (determinant(map.rows[0], map.rows[1], map.rows[2]) == 0);
  map.translation = {entry(), entry(), entry()};
  return map;
}

}  // namespace exsect::random_pairs

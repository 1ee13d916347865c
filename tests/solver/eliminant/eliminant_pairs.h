// Seeded patches of many shapes for the tests of the turning eliminant.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <random>

namespace exsect::eliminant_pairs {

using Random = std::mt19937_64;

template <class Coordinate>
ControlNet net_of(const Coordinate& coordinate) {
  ControlNet net;
  for (auto& row : net)
    for (auto& point : row)
      for (auto& c : point) c = coordinate();
  return net;
}

inline Rational small_rational(Random& random) {
  const int denominator = std::uniform_int_distribution<int>(1, 16)(random);
  return Rational(std::uniform_int_distribution<int>(-denominator, denominator)(random), denominator);
}

inline ControlNet random_net(Random& random) {
  return net_of([&] { return small_rational(random); });
}

inline BezierPatch random_patch(Random& random) { return BezierPatch(random_net(random)); }

/// Power-basis coefficients c[i][j] with i <= m and j <= n only.
inline ControlNet random_coefficients(Random& random, std::size_t m, std::size_t n) {
  ControlNet c = random_net(random);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i > m || j > n) c[i][j] = Point{};
  return c;
}

/// Coefficients of (r, s, h(r,s)) with random h.
inline ControlNet height_field_coefficients(Random& random) {
  ControlNet c = random_net(random);
  for (auto& row : c)
    for (auto& point : row) point[0] = point[1] = 0;
  c[1][0][0] = 1;
  c[0][1][1] = 1;
  return c;
}

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

struct Parameters {
  Rational u;
  Rational v;
  Rational r;
  Rational s;
};

/// x + constant + linear terms in u and v such that x(u,v) = point, x_v(u,v) = along_v and, where given,
/// x_u(u,v) = along_u.
inline BezierPatch osculating(const BezierPatch& x, const Rational& u, const Rational& v, const Point& point,
                              const Point& along_v, const Point* along_u = nullptr) {
  ControlNet c = x.power_basis();
  c[0][1] = c[0][1] + (along_v - x.derivative_second(u, v));
  if (along_u != nullptr) c[1][0] = c[1][0] + (*along_u - x.derivative_first(u, v));
  c[0][0] = c[0][0] + (point - BezierPatch::from_power_basis(c)(u, v));
  return BezierPatch::from_power_basis(c);
}

}  // namespace exsect::eliminant_pairs

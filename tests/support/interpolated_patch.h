// Patches from functions that are polynomials of bidegree (2,2).
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <array>

namespace exsect::testing {

/// The patch with the values f(u,v), exactly, if every coordinate is a polynomial of bidegree at most (2,2).
template <class Function>
BezierPatch interpolated(const Function& f) {
  using exsect::operator*;
  using exsect::operator+;
  using exsect::operator-;
  const auto middle = [](const Point& a, const Point& m, const Point& b) {
    return Rational(2) * m - Rational(1, 2) * (a + b);
  };
  const std::array<Rational, 3> at = {0, Rational(1, 2), 1};
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = f(at[i], at[j]);
    net[i][1] = middle(net[i][0], net[i][1], net[i][2]);
  }
  for (std::size_t j = 0; j < 3; ++j) net[1][j] = middle(net[0][j], net[1][j], net[2][j]);
  return BezierPatch(net);
}

}  // namespace exsect::testing

// Random rationals, points and patches for the tests of this layer; the seed is the caller's to print.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <random>

namespace exsect {

using Random = std::mt19937_64;

inline Rational random_rational(Random& random, int bound = 20) {
  const int p = std::uniform_int_distribution<int>(-bound, bound)(random);
  return Rational(p, std::uniform_int_distribution<int>(1, bound)(random));
}

inline Point random_point(Random& random) {
  const Rational x = random_rational(random);
  const Rational y = random_rational(random);
  return {x, y, random_rational(random)};
}

inline ControlNet random_net(Random& random) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row) p = random_point(random);
  return net;
}

inline BezierPatch random_patch(Random& random) { return BezierPatch(random_net(random)); }

}  // namespace exsect

// Curves that the tests share.
#pragma once

#include <exsect/geometry/bezier_curve.h>

#include "random_shapes.h"

namespace exsect {

/// The profile of the examples of surfaces of revolution.
inline BezierCurve profile_cubic() {
  return BezierCurve({{Rational(3, 10), Rational(3, 10)},
                      {Rational(1, 2), Rational(7, 10)},
                      {1, 1},
                      {Rational(1, 2), Rational(7, 5)}});
}

/// ((1 - t^2)/(1 + t^2), 2t/(1 + t^2)).
inline BezierCurve quarter_circle() { return BezierCurve({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}); }

/// Space cubic with monotone x.
inline BezierCurve space_cubic() {
  return BezierCurve({{Rational(1, 10), Rational(1, 5), Rational(1, 10)},
                      {Rational(2, 5), Rational(11, 10), Rational(1, 5)},
                      {Rational(4, 5), Rational(1, 10), Rational(11, 10)},
                      {Rational(11, 10), Rational(9, 10), Rational(6, 5)}});
}

inline BezierCurve random_curve(Random& random, int degree, int dimension, bool weighted) {
  std::vector<std::vector<Rational>> points;
  std::vector<Rational> weights;
  for (int i = 0; i <= degree; ++i) {
    points.emplace_back();
    for (int k = 0; k < dimension; ++k) points.back().push_back(random_rational(random));
    weights.push_back(weighted ? Rational(1 + static_cast<int>(random() % 7), 3) : Rational(1));
  }
  return BezierCurve(points, weights);
}

}  // namespace exsect

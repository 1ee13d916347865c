#include "point.h"

#include "vector_algebra.h"

namespace exsect {

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point operator*(const Rational& c, const Point& a) { return {c * a[0], c * a[1], c * a[2]}; }

Rational dot(const Point& a, const Point& b) { return dot_over(a, b); }

Point cross(const Point& a, const Point& b) { return cross_over(a, b); }

Rational determinant(const Point& a, const Point& b, const Point& c) { return dot(a, cross(b, c)); }

bool is_zero(const Point& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

Point least_parallel_axis(const Point& direction) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (abs(direction[k]) < abs(direction[least])) least = k;
  Point axis = {0, 0, 0};
  axis[least] = 1;
  return axis;
}

}  // namespace exsect

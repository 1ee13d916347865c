// Points and vectors of space with rational coordinates.
#pragma once

#include <exsect/algebra/rational.h>

#include <array>

namespace exsect {

/// Point or vector, coordinates x, y, z.
using Point = std::array<Rational, 3>;

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
Point operator*(const Rational& c, const Point& a);
Rational dot(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);
Rational determinant(const Point& a, const Point& b, const Point& c);
bool is_zero(const Point& a);
/// The unit vector of the axis of coordinates along which `direction` goes least: not parallel unless it is
/// 0.
Point least_parallel_axis(const Point& direction);

}  // namespace exsect

// A patch along a parameter line, on which an arc of the line can be traced. Internal to solver/;
// docs/method.md, equation (6.1).
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/point.h>

#include <array>

namespace exsect {

/// The direction across a line p(t): the coefficients of 1, t, t^2.
using RibbonNormal = std::array<Point, 3>;

/// p(t) + (h - 1/2) n(t), of degree (2,1) in (t,h): the line is h = 1/2.
BezierPatch ribbon(const ParameterLine& line, const RibbonNormal& n);

/// The direction of a vector, rounded to some 16 bits, of about the given length; zero for zero.
Point with_length(const Point& v, double length);

/// The quadratic polynomial with the given values at `from`, the middle and `to`, which differ.
RibbonNormal interpolated(const std::array<Point, 3>& at, const Rational& from, const Rational& to);

}  // namespace exsect

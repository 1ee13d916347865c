// Pairs of height fields f + h and f, of which h has a double point: they meet over h = 0.
#pragma once

#include "support/power_nets.h"
#include "support/random_pairs.h"

namespace exsect::height_pairs {

using random_pairs::Generator;
using testing::Terms;

/// The graphs of f + h over [0,1]^2 and of f over a larger parallelogram.
struct Heights {
  RationalPatch x;
  RationalPatch y;
  RationalPatch difference;        // the graph of h over [0,1]^2
  std::array<Rational, 4> centre;  // a singular point of h
};

/// c + a X + b Y
Terms linear(const Rational& c, const Rational& a, const Rational& b);
Terms times(const Rational& factor, const Terms& h);

/// (X,Y) = (1/2,1/2) + (p (r - 1/2) - q (s - 1/2), q (r - 1/2) + p (s - 1/2)) on the second patch. Requires f
/// of total degree `degree` at most. Where q = 0 the parameters u and r turn together.
Heights heights(const Terms& f, const Terms& h, int degree, const Rational& p, const Rational& q,
                const std::array<Rational, 2>& at);

/// h begins with a definite (sign 1) or an indefinite form about a rational point; `moved` is added to it.
Heights with_double_point(Generator& generator, int sign, int degree, const Rational& moved = 0);

/// ((X - 1/4)(Y - 3/4))² + factor (X - Y)²: double points over (1/4,1/4) and (3/4,3/4), the first of which is
/// the centre. Of degree 2.
Heights with_two_double_points(Generator& generator, const Rational& factor);

}  // namespace exsect::height_pairs

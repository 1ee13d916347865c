#include "space_curve_surfaces.h"

#include <exsect/algebra/bernstein_box.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/homogeneous_composition.h>
#include <exsect/geometry/implicit_curve.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "curve/positivity.h"
#include "curve/short_rational.h"

namespace exsect {
namespace {

void require_spatial(const BezierCurve& curve) {
  if (curve.dimension() != 3) throw std::invalid_argument("space curve: points must have 3 coordinates");
  if (curve.is_point()) throw std::invalid_argument("space curve: all points are equal");
}

/// The two other coordinates, ascending.
std::array<int, 2> others(int axis) {
  if (axis < 0 || axis > 2) throw std::invalid_argument("space curve: no such coordinate");
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

/// W^2 times the derivative of a coordinate.
Polynomial scaled_derivative(const HomogeneousCurve& curve, int axis) {
  const Polynomial& x = curve.numerators[static_cast<std::size_t>(axis)];
  return x.derivative() * curve.denominator - x * curve.denominator.derivative();
}

using Gradient = std::array<Polynomial, 3>;

/// The gradient along the curve times W^(d-1), d the total degree.
Gradient gradient_along(const SpacePolynomial& f, const HomogeneousCurve& curve) {
  Gradient result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const SpacePolynomial derivative = f.derivative(axis);
    Polynomial along = composed(derivative, curve);
    for (int d = std::max(derivative.degree(), 0); d < f.degree() - 1; ++d) along *= curve.denominator;
    result[axis] = std::move(along);
  }
  return result;
}

/// The square of |cos| at t in doubles; 0 where it is not defined.
double squared_cosine(const Polynomial& ab, const Polynomial& aa, const Polynomial& bb, const Rational& t) {
  const Rational lengths = aa(t) * bb(t);
  if (lengths == 0) return 0;
  const Rational product = ab(t);
  return to_double(Rational(product * product / lengths));
}

/// A parameter near the largest value: the best of equidistant ones, then of finer ones around it.
Rational best_parameter(const Polynomial& ab, const Polynomial& aa, const Polynomial& bb) {
  Rational best = 0, step = Rational(1, 128), centre = Rational(1, 2);
  double largest = -1;
  int reach = 64;
  for (int round = 0; round < 5; ++round) {
    for (int k = -reach; k <= reach; ++k) {
      const Rational t = centre + k * step;
      if (t < 0 || t > 1) continue;
      const double here = squared_cosine(ab, aa, bb, t);
      if (here > largest) {
        largest = here;
        best = t;
      }
    }
    centre = best;
    step /= 8;
    reach = 8;
  }
  return best;
}

}  // namespace

Polynomial composed(const SpacePolynomial& f, const HomogeneousCurve& curve) {
  std::array<std::vector<Polynomial>, 3> of;
  for (std::size_t k = 0; k < 3; ++k)
    of[k] = powers_up_to(curve.numerators[k], std::max(f.degree_in(k), 0), Polynomial(1));
  const std::vector<Polynomial> of_w =
      powers_up_to(curve.denominator, std::max(f.degree(), 0), Polynomial(1));
  Polynomial sum;
  for (const auto& [e, c] : f.terms()) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    sum += Polynomial(c) * of[0][at(e[0])] * of[1][at(e[1])] * of[2][at(e[2])] *
           of_w[at(f.degree() - e[0] - e[1] - e[2])];
  }
  return sum;
}

bool is_strictly_monotone(const BezierCurve& curve, int axis) {
  require_spatial(curve);
  others(axis);
  const Polynomial derivative = scaled_derivative(homogeneous(curve), axis);
  return !not_positive(derivative, {0, 1}) || !not_positive(-derivative, {0, 1});
}

AxisChoice choose_axis(const BezierCurve& curve) {
  require_spatial(curve);
  const auto has_projections = [&](int axis) {
    const auto [second, third] = others(axis);
    return !curve.projected(axis, second).is_point() && !curve.projected(axis, third).is_point();
  };
  for (int axis = 0; axis < 3; ++axis)
    if (is_strictly_monotone(curve, axis)) return {axis, true};
  for (int axis = 0; axis < 3; ++axis)
    if (has_projections(axis) && !scaled_derivative(homogeneous(curve), axis).is_zero()) return {axis, false};
  return {0, false};
}

ProjectedPair exact_projections(const BezierCurve& curve, int axis) {
  require_spatial(curve);
  const auto [second, third] = others(axis);
  return {axis, second, third, implicit_curve(curve.projected(axis, second)).equation,
          implicit_curve(curve.projected(axis, third)).equation};
}

SpacePolynomial cylinder(const BivariatePolynomial& f, int first_axis, int second_axis) {
  SpacePolynomial::Terms terms;
  for (int i = 0; i <= f.degree_r(); ++i) {
    const Polynomial row = f.coefficient(i);
    for (int j = 0; j <= row.degree(); ++j) {
      Exponents e = {0, 0, 0};
      e[static_cast<std::size_t>(first_axis)] = i;
      e[static_cast<std::size_t>(second_axis)] = j;
      terms[e] = row.coefficient(j);
    }
  }
  return SpacePolynomial(terms);
}

BivariatePolynomial with_unit_gradients(const BivariatePolynomial& f, const BezierCurve& projection) {
  return in_nearest_rounding([&]() -> BivariatePolynomial {
    const HomogeneousCurve curve = homogeneous(projection);
    const BivariatePolynomial dx = f.derivative_r(), dy = f.derivative_s();
    constexpr int steps = 100;
    Rational sum = 0;
    for (int k = 0; k <= steps; ++k) {
      const Rational t(k, steps);
      const Rational w = curve.denominator(t);
      const Rational x = curve.numerators[0](t) / w, y = curve.numerators[1](t) / w;
      const Rational a = dx(x, y), b = dy(x, y);
      sum += root_above(a * a + b * b);
    }
    if (sum == 0) return f;
    BivariatePolynomial scaled = f;
    scaled *= Polynomial(rounded_down(Rational(steps + 1) / sum, 16));
    return scaled;
  });
}

SurfacePair cylinders(const ProjectedPair& pair) {
  return {cylinder(pair.f, pair.axis, pair.second), cylinder(pair.g, pair.axis, pair.third)};
}

SurfacePair nearly_orthogonal(const ProjectedPair& pair, const BivariatePolynomial& norm_f,
                              const BivariatePolynomial& norm_g) {
  const auto [f, g] = cylinders(pair);
  const SpacePolynomial a = cylinder(norm_f, pair.axis, pair.second) * g;
  const SpacePolynomial b = cylinder(norm_g, pair.axis, pair.third) * f;
  return {a + b, a - b};
}

SurfacePair orthogonal(const ProjectedPair& pair) {
  const auto [f, g] = cylinders(pair);
  SpacePolynomial ff, fg;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const SpacePolynomial df = f.derivative(axis);
    ff += df * df;
    fg += df * g.derivative(axis);
  }
  return {f, ff * g - fg * f};
}

bool is_positive_on(const BivariatePolynomial& f, const PlanarBox& box) {
  return in_nearest_rounding([&]() -> bool {
    const BernsteinBox whole(f, box.x, box.y);
    const auto positive = [](const auto& self, const BernsteinBox& part, int depth) -> bool {
      const int sign = part.sign();
      if (sign != 0 || depth == 0) return sign > 0;
      const auto [a, b] = depth % 2 == 0 ? part.split_r() : part.split_s();
      return self(self, a, depth - 1) && self(self, b, depth - 1);
    };
    return positive(positive, whole, 10);
  });
}

GradientAngle largest_cosine(const SurfacePair& surfaces, const BezierCurve& curve) {
  return in_nearest_rounding([&]() -> GradientAngle {
    require_spatial(curve);
    const HomogeneousCurve reduced = homogeneous(curve);
    const Gradient a = gradient_along(surfaces.first, reduced), b = gradient_along(surfaces.second, reduced);
    const Polynomial ab = dot_over(a, b), aa = dot_over(a, a), bb = dot_over(b, b);
    const bool regular = !not_positive(aa, {0, 1}) && !not_positive(bb, {0, 1});
    if (ab.is_zero()) return {regular ? std::optional(Rational(0)) : std::nullopt, 0};
    const Rational t = best_parameter(ab, aa, bb);
    const Rational lengths = aa(t) * bb(t);
    const Rational product = ab(t);
    const Rational largest = lengths == 0 ? Rational(0) : Rational(product * product / lengths);
    GradientAngle result = {std::nullopt, rounded_down(root_below(largest))};
    if (!regular) return result;
    // c^2 |a|^2 |b|^2 - (a.b)^2 > 0 on [0,1] proves |cos| < c.
    for (int bits = 24; bits >= 4; bits -= 4) {
      const Rational squared = rounded_up(largest * (1 + power_of_two(-bits)));
      if (not_positive(Polynomial(squared) * aa * bb - ab * ab, {0, 1})) continue;
      result.upper = std::min<Rational>(1, root_above(squared));
      break;
    }
    if (!result.upper) result.upper = 1;  // Cauchy and Schwarz
    return result;
  });
}

std::optional<Rational> first_order_squared_distance(const SurfacePair& surfaces, const Point& p) {
  const auto gradient_at = [&](const SpacePolynomial& f) {
    return Point{f.derivative(0)(p), f.derivative(1)(p), f.derivative(2)(p)};
  };
  const Rational f = surfaces.first(p);
  const Rational g = surfaces.second(p);
  const Point a = gradient_at(surfaces.first);
  const Point b = gradient_at(surfaces.second);
  const Rational ab = dot(a, b);
  const Rational gram = dot(a, a) * dot(b, b) - ab * ab;
  if (gram == 0) return std::nullopt;
  return Rational((f * f * dot(b, b) - 2 * f * g * ab + g * g * dot(a, a)) / gram);
}

}  // namespace exsect

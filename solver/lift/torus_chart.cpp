#include "lift/torus_chart.h"

#include <optional>
#include <vector>

namespace exsect {
namespace {

/// The vector mirrored in the plane through the origin orthogonal to the normal.
Point mirrored(const Point& vector, const Point& normal) {
  return vector - 2 * dot(vector, normal) / dot(normal, normal) * normal;
}

/// Bernstein coefficients of the cosine, the sine and the denominator on one half of the circle.
struct HalfCircle {
  std::array<Rational, 3> cosine, sine, weight;
};

HalfCircle half_circle(const UnitVector& middle, int half) {
  const Rational flip = half == 0 ? 1 : -1;
  HalfCircle result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational c = i == 1 ? flip : Rational(0), s = i == 1 ? Rational(0) : (i == 0 ? -flip : flip);
    const UnitVector turned = middle + UnitVector{c, s};
    result.cosine[i] = turned.cosine;
    result.sine[i] = turned.sine;
    result.weight[i] = i == 1 ? 0 : 1;
  }
  return result;
}

/// f with its first variable r replaced by (r - 1) / (2r - 1), times the power of the denominator.
BivariatePolynomial with_other_half_of_r(const BivariatePolynomial& f) {
  const BivariatePolynomial one = BivariatePolynomial::constant(1), r = BivariatePolynomial::r();
  const BivariatePolynomial above = r - one, below = r + r - one;
  BivariatePolynomial sum, power = one;
  for (int i = f.degree_r(); i >= 0; --i) {  // Horner's scheme with both powers
    sum = sum * above + power * f.coefficient(i);
    power = power * below;
  }
  return sum;
}

}  // namespace

std::optional<TorusFrame> torus_frame(const SurfaceData& torus) {
  const std::optional<Rational> length = rational_root(dot(torus.axis, torus.axis), 2);
  const std::optional<Rational> major = rational_root(torus.squared, 2);
  const std::optional<Rational> minor = rational_root(torus.minor_squared, 2);
  if (!length || !major || !minor) return std::nullopt;
  const Point along = 1 / *length * torus.axis, up = {0, 0, 1};
  const Point normal = along[2] >= 0 ? along + up : along - up;  // never zero
  return TorusFrame{torus.point, mirrored({1, 0, 0}, normal), mirrored({0, 1, 0}, normal), along, *major,
                    *minor};
}

UnitVector turn_by(const Rational& half_tangent) {
  const Rational square = half_tangent * half_tangent;
  return {(1 - square) / (1 + square), 2 * half_tangent / (1 + square)};
}

UnitVector operator+(const UnitVector& a, const UnitVector& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

RationalPatch torus_chart(const TorusFrame& frame, const TorusTurns& turns, int half_u, int half_v) {
  const HalfCircle a = half_circle(turns.around, half_u), b = half_circle(turns.across, half_v);
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational weight = a.weight[i] * b.weight[j];
      const Rational outwards = frame.major * b.weight[j] + frame.minor * b.cosine[j];
      const Point x = weight * frame.centre +
                      outwards * (a.cosine[i] * frame.across + a.sine[i] * frame.beside) +
                      frame.minor * b.sine[j] * a.weight[i] * frame.along;
      net[i].push_back({x[0], x[1], x[2], weight});
    }
  return RationalPatch::from_homogeneous(net);
}

BivariatePolynomial on_other_half(const BivariatePolynomial& f, bool in_u, bool in_v) {
  const BivariatePolynomial g = in_u ? with_other_half_of_r(f) : f;
  return in_v ? with_other_half_of_r(g.exchanged()).exchanged() : g;
}

}  // namespace exsect

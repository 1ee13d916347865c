#include "shape/shifted_copy.h"

namespace exsect {

namespace {

/// g0 + g1 t + g2 t²
using Quadratic = std::array<Point, 3>;

/// The number c with a = c b, if there is one that is not zero.
std::optional<Rational> ratio(const Point& a, const Point& b) {
  if (is_zero(a) || is_zero(b) || !is_zero(cross(a, b))) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k)
    if (b[k] != 0) return Rational(a[k] / b[k]);
  return std::nullopt;
}

/// The c with a = c b, 0 for a = 0; b is not zero.
std::optional<Rational> multiple(const Point& a, const Point& b) {
  return is_zero(a) ? std::optional(Rational(0)) : ratio(a, b);
}

/// The map A with h = k g(A(t)) for some number k, if the direction of g is not constant: k and A are unique.
std::optional<AffineMap> map_between(const Quadratic& g, const Quadratic& h) {
  if (is_zero(g[2])) {  // h1 = k b g1, h0 = k (g0 + a g1)
    const auto k = ratio(cross(h[0], g[1]), cross(g[0], g[1]));
    const auto kb = ratio(h[1], g[1]);
    if (!k || !kb) return std::nullopt;
    const auto a = multiple(h[0] - *k * g[0], *k * g[1]);
    return a ? std::optional(AffineMap{*a, *kb / *k}) : std::nullopt;
  }
  // h2 = k b² g2, h1 = k b (g1 + 2 a g2)
  const auto kbb = ratio(h[2], g[2]);
  const auto kb = ratio(cross(h[1], g[2]), cross(g[1], g[2]));
  if (!kbb || !kb) return std::nullopt;
  const auto a = multiple(h[1] - *kb * g[1], Rational(2) * *kb * g[2]);
  return a ? std::optional(AffineMap{*a, *kbb / *kb}) : std::nullopt;
}

/// Half of x_vv.
Quadratic second_derivative(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  return {c[0][2], c[1][2], c[2][2]};
}

}  // namespace

std::optional<ShiftedCopy> shifted_copy(const BezierPatch& x, const BezierPatch& y) {
  const auto r = map_between(second_derivative(x), second_derivative(y));
  const auto s = map_between(second_derivative(x.exchanged()), second_derivative(y.exchanged()));
  if (!r || !s || !(y == x.restricted_to((*r)(0), (*r)(1), (*s)(0), (*s)(1)))) return std::nullopt;
  return ShiftedCopy{{*r, *s}};
}

}  // namespace exsect

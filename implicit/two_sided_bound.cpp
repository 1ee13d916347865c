#include "two_sided_bound.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/homogeneous_composition.h>
#include <exsect/geometry/planar_space.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "answer/parameter_box.h"
#include "curve/positivity.h"
#include "curve/short_rational.h"

namespace exsect {
namespace {

/// The strip (X + s N1, Y + s N2, W)(t), (N1, N2) = (-(Y'W - YW'), X'W - XW'), (10.10). Polynomials in (s,t)
/// have the offset s as their first variable and t as their second.
class Strip {
 public:
  Strip(const PlanarFunction& f, const HomogeneousCurve& curve);

  /// |f| / (grad f . N) at s = 0, the largest of some t: about the least half width; 0 if f vanishes there.
  Rational estimate() const;
  /// The first interval of t where one of the conditions of the strip of half width d > 0 could not be
  /// proved.
  std::optional<Unproved> obstacle(const Rational& d);
  /// An upper bound of |N|/W on [0,1].
  Rational reach() const;
  /// f vanishes on the curve.
  bool is_exact();

 private:
  struct Pulled {
    BivariatePolynomial f;
    BivariatePolynomial along;  // W^degree f(X(s,t)), increasing in s near the curve
    BivariatePolynomial slope;  // its derivative by s
  };
  const Pulled& pulled(const BivariatePolynomial& f);
  PlanarBox around(const RationalInterval& t, const Rational& d) const;
  std::optional<Unproved> obstacle_on(const RationalInterval& t, const Rational& d);

  const PlanarFunction& f_;
  const HomogeneousCurve& curve_;
  std::array<Polynomial, 2> normal_;
  BivariatePolynomial jacobian_;
  Rational orientation_ = 1;
  std::deque<Pulled> pulled_;
};

BivariatePolynomial in_t(const Polynomial& f) { return BivariatePolynomial({f}); }

/// f as a function of s and t: a + s b.
BivariatePolynomial shifted(const Polynomial& a, const Polynomial& b) { return BivariatePolynomial({a, b}); }

Strip::Strip(const PlanarFunction& f, const HomogeneousCurve& curve) : f_(f), curve_(curve) {
  const Polynomial& x = curve.numerators[0];
  const Polynomial& y = curve.numerators[1];
  const Polynomial& w = curve.denominator;
  const Polynomial dx = x.derivative() * w - x * w.derivative();
  const Polynomial dy = y.derivative() * w - y * w.derivative();
  normal_ = {-dy, dx};
  // det(V, V_t, V_s) of V = (X + s N1, Y + s N2, W) is W^3 times the Jacobian of the strip (10.11).
  const std::array<BivariatePolynomial, 2> v = {shifted(x, normal_[0]), shifted(y, normal_[1])};
  const std::array<BivariatePolynomial, 2> vt = {v[0].derivative_s(), v[1].derivative_s()};
  const std::array<BivariatePolynomial, 2> vs = {in_t(normal_[0]), in_t(normal_[1])};
  jacobian_ =
      (vt[0] * vs[1] - vt[1] * vs[0]) * in_t(w) - (v[0] * vs[1] - v[1] * vs[0]) * in_t(w.derivative());
  // f or -f: whichever grows along N at most of some points.
  int votes = 0;
  for (int k = 0; k <= 8; ++k) {
    const Rational t(k, 8);
    const Rational at_x = x(t) / w(t), at_y = y(t) / w(t);
    for (const BivariatePolynomial& g : f.polynomials_on({{at_x, at_x}, {at_y, at_y}})) {
      votes += sign(Rational(g.derivative_r()(at_x, at_y) * normal_[0](t) +
                             g.derivative_s()(at_x, at_y) * normal_[1](t)));
      break;
    }
  }
  if (votes < 0) orientation_ = -1;
}

const Strip::Pulled& Strip::pulled(const BivariatePolynomial& f) {
  for (const Pulled& known : pulled_)
    if (known.f == f) return known;
  const BivariatePolynomial x = shifted(curve_.numerators[0], normal_[0]);
  const BivariatePolynomial y = shifted(curve_.numerators[1], normal_[1]);
  BivariatePolynomial along =
      homogeneous_composition(f, x, y, in_t(curve_.denominator), std::max(f.total_degree(), 0));
  along *= Polynomial(orientation_);
  pulled_.push_back({f, along, along.derivative_r()});
  return pulled_.back();
}

Rational Strip::estimate() const {
  Rational largest = 0;
  constexpr int samples = 128;
  for (int k = 0; k <= samples; ++k) {
    const Rational t(k, samples);
    const Rational w = curve_.denominator(t);
    const Rational x = curve_.numerators[0](t) / w, y = curve_.numerators[1](t) / w;
    const std::vector<BivariatePolynomial> there = f_.polynomials_on({{x, x}, {y, y}});
    if (there.empty()) continue;
    const BivariatePolynomial& g = there.front();
    const Rational slope =
        (g.derivative_r()(x, y) * normal_[0](t) + g.derivative_s()(x, y) * normal_[1](t)) / w;
    if (slope != 0) largest = std::max<Rational>(largest, abs(g(x, y) / slope));
  }
  return largest;
}

PlanarBox Strip::around(const RationalInterval& t, const Rational& d) const {
  PlanarBox box = control_box(curve_, t.lower, t.upper);
  const Rational least = positive_lower_bound(curve_.denominator, t);
  const auto widen = [&](RationalInterval& side, const Polynomial& normal) {
    Rational largest = 0;
    for (const Rational& b : bernstein_coefficients(normal, std::max(normal.degree(), 0), t.lower, t.upper))
      largest = std::max<Rational>(largest, abs(b));
    side.lower -= d * largest / least;
    side.upper += d * largest / least;
  };
  widen(box.x, normal_[0]);
  widen(box.y, normal_[1]);
  return box;
}

std::optional<Unproved> Strip::obstacle_on(const RationalInterval& t, const Rational& d) {
  const std::vector<BivariatePolynomial> polynomials = f_.polynomials_on(around(t, d));
  if (polynomials.empty()) return Unproved{t, "the spline is not defined on the whole strip"};
  for (const BivariatePolynomial& polynomial : polynomials) {
    const Pulled& f = pulled(polynomial);
    if (auto part = not_positive(f.along.at_r(d), t))
      return Unproved{*part, "f does not have one sign at s = d"};
    if (auto part = not_positive(-f.along.at_r(-d), t))
      return Unproved{*part, "f does not have the other sign at s = -d"};
    if (auto part = not_positive(f.slope, d, t)) return Unproved{*part, "f is not monotone across the strip"};
  }
  return std::nullopt;
}

std::optional<Unproved> Strip::obstacle(const Rational& d) {
  if (auto part = not_positive(jacobian_, d, {0, 1}))
    return Unproved{*part, "the normal segments fold: the curve bends too much or stands still"};
  const int parts = f_.is_polynomial() ? 1 : 64;
  for (int k = 0; k < parts; ++k)
    if (auto found = obstacle_on({Rational(k, parts), Rational(k + 1, parts)}, d)) return found;
  return std::nullopt;
}

Rational Strip::reach() const {
  const Polynomial square = normal_[0] * normal_[0] + normal_[1] * normal_[1];
  const int n = std::max(square.degree(), 0);
  constexpr int parts = 64;
  Rational largest = 0;
  for (int k = 0; k < parts; ++k) {
    const Rational from(k, parts), to(k + 1, parts);
    const std::vector<Rational> b = bernstein_coefficients(square, n, from, to);
    const Rational least = positive_lower_bound(curve_.denominator, {from, to});
    largest = std::max<Rational>(largest, *std::max_element(b.begin(), b.end()) / (least * least));
  }
  return root_above(largest);
}

bool Strip::is_exact() { return f_.is_polynomial() && pulled(f_.polynomial()).along.at_r(0).is_zero(); }

}  // namespace

TwoSidedBound two_sided_bound(const PlanarFunction& f, const BezierCurve& curve) {
  return in_nearest_rounding([&]() -> TwoSidedBound {
    if (curve.dimension() != 2) throw std::invalid_argument("distance bound: the curve must be planar");
    if (curve.is_point()) throw std::invalid_argument("distance bound: all points are equal");
    const HomogeneousCurve reduced = homogeneous(curve);
    Strip strip(f, reduced);
    const Rational reach = strip.reach();
    const bool exact = strip.is_exact();
    // An exact equation is tried with strips that become narrower, others with strips that become wider.
    std::vector<Rational> widths;
    if (exact) {
      const PlanarBox box = control_box(reduced, 0, 1);
      const Rational size = std::max(box.x.width(), box.y.width());
      for (int k = 4; k <= 12; k += 2) widths.push_back(rounded_down(size * power_of_two(-k) / reach, 12));
    } else {
      const Rational least = strip.estimate();
      for (const Rational& factor : {Rational(2001, 2000), Rational(501, 500), Rational(101, 100),
                                     Rational(26, 25), Rational(6, 5), Rational(2), Rational(4)})
        widths.push_back(least == 0 ? Rational(0) : rounded_up(least * factor, 14));
    }
    TwoSidedBound result;
    for (const Rational& d : widths) {
      const auto obstacle = d > 0 ? strip.obstacle(d) : Unproved{{0, 1}, "f does not grow across the curve"};
      if (!obstacle) return {TwoSidedBound::Strip{d, exact ? Rational(0) : rounded_up(d * reach)}, {}};
      result.unproved = {*obstacle};
    }
    return result;
  });
}

}  // namespace exsect

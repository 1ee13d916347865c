#include "line/patch_ray.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/resultant.h>
#include <exsect/geometry/surface_pull_back.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "curve/plane_curve.h"

namespace exsect {
namespace {

constexpr int kMostShears = 64;

/// The half space or plane normal . (P - origin).
SpacePolynomial linear(const Point& normal, const Point& origin) {
  SpacePolynomial result = SpacePolynomial::constant(-dot(normal, origin));
  for (std::size_t k = 0; k < 3; ++k) result += normal[k] * SpacePolynomial::variable(k);
  return result;
}

/// A vector other than zero that is orthogonal to it.
Point orthogonal(const Point& direction) {
  for (std::size_t k = 0; k < 3; ++k) {
    Point axis = {0, 0, 0};
    axis[k] = 1;
    const Point across = cross(direction, axis);
    if (!is_zero(across)) return across;
  }
  throw std::invalid_argument("intersect_ray: the direction is zero");
}

bool is_constant(const BivariatePolynomial& f) { return f.degree_r() <= 0 && f.degree_s() <= 0; }

/// f(r, s - k r).
BivariatePolynomial sheared(const BivariatePolynomial& f, int k) {
  const BivariatePolynomial s =
      BivariatePolynomial::s() - BivariatePolynomial::constant(k) * BivariatePolynomial::r();
  BivariatePolynomial result;
  for (int j = f.degree_s(); j >= 0; --j) {
    std::vector<Polynomial> of_r;
    for (int i = 0; i <= f.degree_r(); ++i) of_r.emplace_back(f.coefficient(i, j));
    result = result * s + BivariatePolynomial(std::move(of_r));
  }
  return result;
}

/// Whether the curves have a common point in [0,1]^2.
bool meet_in_square(BivariatePolynomial f, BivariatePolynomial g) {
  const BivariatePolynomial common = gcd(f, g);
  if (!is_constant(common)) {
    if (!component_points(squarefree(common)).empty()) return true;
    f = exact_quotient(f, common);
    g = exact_quotient(g, common);
  }
  return !common_points(f, g).empty();
}

/// A rational number between two different ones.
Rational between(RealAlgebraic a, RealAlgebraic b) {
  for (Rational width = power_of_two(-10); a.interval().upper >= b.interval().lower; width *= width) {
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
  return (a.interval().upper + b.interval().lower) / 2;
}

class PatchRay {
 public:
  PatchRay(const Point& origin, const Point& direction, const RationalPatch& x)
      : x_(x.reduced()), square_(dot(direction, direction)) {
    const Point a = orthogonal(direction);
    f_ = pull_back(linear(a, origin), x_);
    g_ = pull_back(linear(cross(direction, a), origin), x_);
    h_ = pull_back(linear(direction, origin), x_);
    w_ = x_.component(3) * Polynomial(square_);
  }

  RayIntersection run() {
    const BivariatePolynomial common = gcd(f_, g_);
    if (common.is_zero()) {
      const Rational t = h_(0, 0) / w_(0, 0);
      if (h_ == BivariatePolynomial::constant(t) * w_)
        add_point(t, RayContact::singular);
      else
        result_.incomplete = "the patch is a piece of the line of the ray";
      return result_;
    }
    const BivariatePolynomial f = exact_quotient(f_, common), g = exact_quotient(g_, common);
    if (!is_constant(f) && !is_constant(g))
      for (const TriangularPoint& p : common_points(f, g))
        if (is_constant(common) || sign_at(common, p) != 0) add_hit(f, g, p);
    if (!is_constant(common)) add_overlaps(squarefree(common));
    std::sort(result_.hits.begin(), result_.hits.end(),
              [](const RayHit& a, const RayHit& b) { return a.t < b.t; });
    return result_;
  }

 private:
  std::optional<RealAlgebraic> parameter_at(const TriangularPoint& p) {
    std::optional<RealAlgebraic> t = quotient_at(h_, w_, p);
    if (!t) result_.incomplete = "a base point of the patch is beside a point of the ray";
    return t;
  }

  void add_hit(const BivariatePolynomial& f, const BivariatePolynomial& g, const TriangularPoint& p) {
    if (sign_at(h_, p) < 0) return;
    const std::optional<RealAlgebraic> t = parameter_at(p);
    if (!t) return;
    const bool crosses = sign_at(jacobian(f_, g_), p) != 0;
    result_.hits.push_back({*t, crosses ? 1 : multiplicity(f, g, p),
                            crosses          ? RayContact::transversal
                            : is_singular(p) ? RayContact::singular
                                             : RayContact::tangential,
                            p});
  }

  /// The normal vanishes: X, X_u, X_v are linearly dependent.
  bool is_singular(const TriangularPoint& p) const {
    std::array<std::array<BivariatePolynomial, 4>, 3> rows;
    for (std::size_t k = 0; k < 4; ++k) {
      rows[0][k] = x_.component(static_cast<int>(k));
      rows[1][k] = rows[0][k].derivative_r();
      rows[2][k] = rows[0][k].derivative_s();
    }
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<std::size_t, 3> c{};
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != left_out) c[n++] = k;
      BivariatePolynomial minor;
      for (std::size_t k = 0; k < 3; ++k)
        minor += rows[0][c[k]] * (rows[1][c[(k + 1) % 3]] * rows[2][c[(k + 2) % 3]] -
                                  rows[1][c[(k + 2) % 3]] * rows[2][c[(k + 1) % 3]]);
      if (sign_at(minor, p) != 0) return false;
    }
    return true;
  }

  /// The order of a zero of Res_r(F, G), F and G sheared so that p is the only common zero, complex or at
  /// infinity, over its value of s + k r. There are at most 17 other zeros and 12 directions at infinity,
  /// each of which excludes one k.
  static int multiplicity(const BivariatePolynomial& f, const BivariatePolynomial& g,
                          const TriangularPoint& p) {
    for (int k = 0; k < kMostShears; ++k) {
      const BivariatePolynomial a = sheared(f, k), b = sheared(g, k);
      const RealAlgebraic s =
          value_at(BivariatePolynomial::s() + BivariatePolynomial::constant(k) * BivariatePolynomial::r(), p);
      const bool at_infinity =
          sign_at(a.coefficient(a.degree_r()), s) == 0 && sign_at(b.coefficient(b.degree_r()), s) == 0;
      const BivariatePolynomial common = gcd_at(a, b, s);
      const bool is_alone = gcd_at(common, common.derivative_r(), s).degree_r() == common.degree_r() - 1;
      if (at_infinity || !is_alone) continue;
      for (const PolynomialPower& power : squarefree_factors(resultant_r(a, b)))
        if (sign_at(power.factor, s) == 0) return power.multiplicity;
    }
    throw std::logic_error("intersect_ray: no direction of elimination separates a point from others");
  }

  /// Where all of a curve c = 0 of parameters is on the line: t runs through intervals, whose ends are at its
  /// critical values, on sides of the square, or are values on whole components.
  void add_overlaps(const BivariatePolynomial& c) {
    const BivariatePolynomial slope = jacobian(c, h_) * w_ - h_ * jacobian(c, w_);
    const BivariatePolynomial varying = exact_quotient(c, gcd(c, slope));
    std::vector<TriangularPoint> points = component_points(c);
    const auto append = [&](const std::vector<TriangularPoint>& more) {
      points.insert(points.end(), more.begin(), more.end());
    };
    append(side_points(c));
    if (!is_constant(varying)) append(common_points(varying, slope));
    std::vector<RealAlgebraic> values;
    for (const TriangularPoint& p : points)
      if (const std::optional<RealAlgebraic> t = parameter_at(p)) values.push_back(*t);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    join(c, values);
  }

  void join(const BivariatePolynomial& c, const std::vector<RealAlgebraic>& values) {
    const auto is_covered_after = [&](std::size_t i) {
      const Rational t = between(values[i], values[i + 1]);
      return meet_in_square(c, h_ - BivariatePolynomial::constant(t) * w_);
    };
    for (std::size_t i = 0, last = 0; i < values.size(); i = last + 1) {
      last = i;
      while (last + 1 < values.size() && is_covered_after(last)) ++last;
      if (last == i)
        add_point(values[i], RayContact::singular);
      else
        add_interval(values[i], values[last]);
    }
  }

  void add_interval(const RealAlgebraic& from, const RealAlgebraic& to) {
    const RealAlgebraic start(0);
    if (to < start) return;
    if (to == start) return add_point(start, RayContact::tangential);
    result_.overlaps.push_back({from < start ? start : from, to});
  }

  void add_point(const RealAlgebraic& t, RayContact contact) {
    if (!(t < RealAlgebraic(0))) result_.hits.push_back({t, 0, contact});
  }

  RationalPatch x_;
  Rational square_;
  BivariatePolynomial f_, g_;  // two planes through the line
  BivariatePolynomial h_, w_;  // t = h / w, w > 0
  RayIntersection result_;
};

}  // namespace

RayIntersection intersect_ray(const Point& origin, const Point& direction, const RationalPatch& patch) {
  if (is_zero(direction)) throw std::invalid_argument("intersect_ray: the direction is zero");
  return in_nearest_rounding([&] { return PatchRay(origin, direction, patch).run(); });
}

}  // namespace exsect

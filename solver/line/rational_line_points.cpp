#include "line/rational_line_points.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <array>
#include <utility>

#include "curve/plane_curve.h"
#include "line/line_curve.h"
#include "line/line_place.h"
#include "line/moving_planes.h"

namespace exsect {
namespace {

constexpr int kMostCombinations = 16;

using ComponentsOfPatch = std::array<BivariatePolynomial, 4>;
using PolynomialList = std::vector<BivariatePolynomial>;
using LineParameters = std::vector<RealAlgebraic>;

ComponentsOfPatch components_of(const RationalPatch& patch) {
  return {patch.component(0), patch.component(1), patch.component(2), patch.component(3)};
}

HomogeneousCurve curve_of(const RationalPatch& patch, const Rational& value) {
  HomogeneousCurve curve;
  for (int k = 0; k < 4; ++k) curve[static_cast<std::size_t>(k)] = patch.component(k).at_r(value);
  return without_common_factor(curve);
}

/// The 2 x 2 minors: zero where the vectors are proportional.
PolynomialList minors(const ComponentsOfPatch& a, const ComponentsOfPatch& b) {
  PolynomialList result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) result.push_back(a[i] * b[j] - a[j] * b[i]);
  return result;
}

/// a + b t, a and b on the patch.
struct LinearInT {
  BivariatePolynomial a;
  BivariatePolynomial b;
};

/// The line's carrier as equations in the parameters of the patch.
class Carrier {
 public:
  Carrier(const HomogeneousCurve& curve, const ComponentsOfPatch& x)
      : curve_(curve), x_(x), degree_(degree(curve)) {
    fixed_ = moving_planes(curve, 0);
    for (const MovingPlane& plane : fixed_) equations_.push_back(on_patch(plane[0]));
    if (fixed_.size() >= 2) return;
    moving_ = moving_planes(curve, 1);
    for (const MovingPlane& plane : moving_) linear_.push_back({on_patch(plane[0]), on_patch(plane[1])});
    for (std::size_t i = 0; i < linear_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        equations_.push_back(linear_[i].a * linear_[j].b - linear_[j].a * linear_[i].b);
    if (degree_ == 3 && fixed_.size() == 1) add_plane_cubic();
  }

  /// All vanish exactly at the points of the carrier, that of t = infinity included.
  const PolynomialList& equations() const { return equations_; }

  /// The t in [0,1] of the point at a common zero of the equations; false where a base point hides them.
  bool add_parameters(const TriangularPoint& p, LineParameters& to) const {
    if (moving_.empty()) return add_on_straight_line(p, to);
    const auto vanishes = [&](const LinearInT& f) { return sign_at(f.a, p) == 0 && sign_at(f.b, p) == 0; };
    if (std::all_of(linear_.begin(), linear_.end(), vanishes)) return add_at_node(to);
    for (int k = 0; k < kMostCombinations; ++k) {
      const LinearInT f = combined(k);
      if (vanishes(f)) continue;
      if (sign_at(f.b, p) == 0) return true;
      const auto t = quotient_at(BivariatePolynomial() - f.a, f.b, p);
      if (!t) continue;
      if (t->compare(0) >= 0 && t->compare(1) <= 0) to.push_back(*t);
      return true;
    }
    return false;
  }

 private:
  BivariatePolynomial on_patch(const std::array<Rational, 4>& plane) const {
    BivariatePolynomial result;
    for (std::size_t k = 0; k < 4; ++k) result += x_[k] * Polynomial(plane[k]);
    return result;
  }

  /// The sum of k^i times moving plane i: one vanishes at other points of the curve, another k does not.
  LinearInT combined(int k) const {
    LinearInT sum = linear_.front();
    Rational factor = 1;
    for (std::size_t i = 1; i < linear_.size(); ++i) {
      factor *= k;
      sum.a += linear_[i].a * Polynomial(factor);
      sum.b += linear_[i].b * Polynomial(factor);
    }
    return sum;
  }

  /// The resultants in t of the moving planes of degree 1 and 2: the equation of the cubic.
  void add_plane_cubic() {
    const std::vector<MovingPlane> quadratic = moving_planes(curve_, 2);
    for (const LinearInT& f : linear_)
      for (const MovingPlane& g : quadratic)
        equations_.push_back(on_patch(g[0]) * f.b * f.b - on_patch(g[1]) * f.a * f.b +
                             on_patch(g[2]) * f.a * f.a);
  }

  /// The only point where all moving planes of degree 1 vanish identically in t.
  bool add_at_node(LineParameters& to) const {
    RationalMatrix planes(2 * moving_.size(), 4);
    for (std::size_t i = 0; i < moving_.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        planes(2 * i, k) = moving_[i][0][k];
        planes(2 * i + 1, k) = moving_[i][1][k];
      }
    const std::vector<Integer> node = null_space(planes).at(0);
    Polynomial common;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        common = gcd(common,
                     curve_[i] * Polynomial(Rational(node[j])) - curve_[j] * Polynomial(Rational(node[i])));
    for (const RealAlgebraic& t : real_roots(common, 0, 1)) to.push_back(t);
    return true;
  }

  /// The line has a coordinate lambda = X_k / X_4, and C_k(t) - lambda C_4(t) = 0.
  bool add_on_straight_line(const TriangularPoint& p, LineParameters& to) const {
    std::size_t k = 0;
    while (curve_[k] * curve_[3].derivative() == curve_[k].derivative() * curve_[3]) ++k;
    const auto lambda = quotient_at(x_[k], x_[3], p);
    if (!lambda) return false;
    std::vector<Polynomial> of_t;
    for (int i = 0; i <= degree_; ++i)
      of_t.push_back(Polynomial{curve_[k].coefficient(i), -curve_[3].coefficient(i)});
    for (const TriangularPoint& t : roots_at(BivariatePolynomial(of_t), *lambda, 0, 1))
      to.push_back(value_at(BivariatePolynomial::r(), t));
    return true;
  }

  HomogeneousCurve curve_;
  ComponentsOfPatch x_;
  int degree_;
  std::vector<MovingPlane> fixed_;
  std::vector<MovingPlane> moving_;
  std::vector<LinearInT> linear_;
  PolynomialList equations_;
};

class LineOnPatch {
 public:
  LineOnPatch(const HomogeneousCurve& curve, const RationalPatch& patch)
      : curve_(curve), x_(components_of(patch)) {}

  RationalLinePoints run() {
    if (degree(curve_) == 0) {
      if (is_on_patch(0, {})) result_.on_patch.push_back({RealAlgebraic(0), RealAlgebraic(1)});
      return result_;
    }
    const Carrier carrier(curve_, x_);
    const CommonZeros zeros = common_zeros(carrier.equations());
    if (zeros.curve.is_zero()) {
      result_.incomplete = "the patch is a piece of the line's carrier";
      return result_;
    }
    for (const TriangularPoint& p : zeros.points)
      for (const RealAlgebraic& t : parameters(carrier, {p})) result_.points.push_back({t, p});
    std::stable_sort(result_.points.begin(), result_.points.end(),
                     [](const RationalLinePoint& a, const RationalLinePoint& b) { return a.t < b.t; });
    if (zeros.curve.degree_r() > 0 || zeros.curve.degree_s() > 0) add_curve(carrier, squarefree(zeros.curve));
    return result_;
  }

 private:
  LineParameters parameters(const Carrier& carrier, const std::vector<TriangularPoint>& points) {
    LineParameters values;
    for (const TriangularPoint& p : points)
      if (!carrier.add_parameters(p, values))
        result_.incomplete = "a base point of the patch is beside a point of the line";
    return values;
  }

  /// Whether the point at t has parameters in the square, zeros of the other equations too.
  bool is_on_patch(const Rational& t, PolynomialList equations) const {
    ComponentsOfPatch point;
    for (std::size_t k = 0; k < 4; ++k) point[k] = BivariatePolynomial::constant(curve_[k](t));
    const PolynomialList same = minors(x_, point);
    equations.insert(equations.end(), same.begin(), same.end());
    return have_common_zero(equations);
  }

  /// Where the point of the patch stands still along c = 0.
  PolynomialList standstill(const BivariatePolynomial& c) const {
    ComponentsOfPatch along;
    for (std::size_t k = 0; k < 4; ++k) along[k] = jacobian(c, x_[k]);
    return minors(x_, along);
  }

  /// Where the line stands still: its cusps, and the turns of a line run through more than once.
  LineParameters turns() const {
    Polynomial common;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        common = gcd(common, curve_[i] * curve_[j].derivative() - curve_[i].derivative() * curve_[j]);
    return real_roots(common, 0, 1);
  }

  void add_curve(const Carrier& carrier, const BivariatePolynomial& c) {
    std::vector<TriangularPoint> points = component_points(c);
    const auto append = [&](const std::vector<TriangularPoint>& more) {
      points.insert(points.end(), more.begin(), more.end());
    };
    append(side_points(c));
    PolynomialList still = standstill(c);
    still.push_back(c);
    const BivariatePolynomial constant = common_zeros(still).curve;
    const BivariatePolynomial varying = exact_quotient(c, gcd(c, constant));
    if (varying.degree_r() > 0 || varying.degree_s() > 0) {
      still = standstill(c);
      still.push_back(varying);
      append(common_zeros(still).points);
    }
    LineParameters met = parameters(carrier, points);
    sort_unique(met);
    LineParameters values = turns();
    values.insert(values.end(), met.begin(), met.end());
    values.emplace_back(0);
    values.emplace_back(1);
    sort_unique(values);
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
      if (is_on_patch(sample_between(values[i], values[i + 1]), {c}))
        result_.on_patch.push_back({values[i], values[i + 1]});
    for (const RealAlgebraic& t : met) result_.on_patch.push_back({t, t});
    result_.on_patch = merged(std::move(result_.on_patch));
  }

  HomogeneousCurve curve_;
  ComponentsOfPatch x_;
  RationalLinePoints result_;
};

}  // namespace

RationalLinePoints rational_line_points(const RationalPatch& x, const RationalPatch& y,
                                        const LineQuery& query) {
  line_place(query);  // refuses a value outside [0,1]
  const bool of_x = query.fixed == Parameter::u || query.fixed == Parameter::v;
  const bool of_second = query.fixed == Parameter::v || query.fixed == Parameter::s;
  const RationalPatch own = of_x ? x : y, other = of_x ? y : x;
  return in_nearest_rounding([&] {
    return LineOnPatch(curve_of(of_second ? own.transposed() : own, query.value), other.reduced()).run();
  });
}

}  // namespace exsect

#include "lift/space_sides.h"

#include <exsect/algebra/ball.h>
#include <exsect/geometry/surface_pull_back.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "curve/curve_sides.h"

namespace exsect {
namespace {

using Number = ArbBall<256>;
using Vector = std::array<Number, 3>;
using Box = std::array<RationalInterval, 3>;

/// Enclosures of polynomials on a box.
class BoxValues {
 public:
  explicit BoxValues(const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) powers_[axis] = {Number(1.0), Number::enclosing(box[axis])};
  }

  Number operator()(const SpacePolynomial& f) {
    Number sum(0.0);
    for (const auto& [e, c] : f.terms()) {
      Number term = Number::enclosing(c);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (e[axis] > 0) term = term * power(axis, static_cast<std::size_t>(e[axis]));
      sum = sum + term;
    }
    return sum;
  }

  Vector gradient(const SpacePolynomial& f) {
    return {(*this)(f.derivative(0)), (*this)(f.derivative(1)), (*this)(f.derivative(2))};
  }

 private:
  const Number& power(std::size_t axis, std::size_t exponent) {
    std::vector<Number>& known = powers_[axis];
    while (known.size() <= exponent) known.push_back(known.back() * known[1]);
    return known[exponent];
  }

  std::array<std::vector<Number>, 3> powers_;
};

/// D f of (17.27), on lines u = const or, on vertical arcs, v = const.
SheetFunction derivative_across(const SheetFunction& f, const SurfaceChart& chart, bool is_vertical) {
  const auto along = [&](const BivariatePolynomial& p) {
    return is_vertical ? p.derivative_r() : p.derivative_s();
  };
  const BivariatePolynomial a = along(f.a), b = along(f.b);
  if (chart.is_flat()) return {a, {}};
  const BivariatePolynomial& y2 = chart.radicand;
  return {y2 * (b + b) + along(y2) * f.b, a + a};
}

std::optional<SideSigns> known(int left, int right) {
  if (left == 0 || right == 0) return std::nullopt;
  return SideSigns{left, right};
}

SideSigns exchanged(const SideSigns& signs) { return {signs.right, signs.left}; }

/// The derivative of f along grad g x height: on g = 0, where u is constant.
SpacePolynomial derivative_beside(const SpacePolynomial& f, const SpacePolynomial& g, const Point& height) {
  SpacePolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    sum += f.derivative(k) * (height[j] * g.derivative(i) - height[i] * g.derivative(j));
  }
  return sum;
}

/// The sign of the scalar product of the gradients in a node of the arc.
int sign_of_normals(const SurfaceIntersection& result, const SpaceArc& arc, const SpacePolynomial& first,
                    const SpacePolynomial& second) {
  for (const int end : {arc.from, arc.to}) {
    BoxValues at(result.nodes[static_cast<std::size_t>(end)].box);
    const int sign = dot_over(at.gradient(first), at.gradient(second)).certain_sign();
    if (sign != 0) return sign;
  }
  return 0;
}

/// The form (17.31) on two tangents of f that span its tangent plane.
class TangentForm {
 public:
  TangentForm(BoxValues& at, const SpacePolynomial& f, const SpacePolynomial& g)
      : n_(at.gradient(f)), square_(dot_over(n_, n_)), product_(dot_over(n_, at.gradient(g))) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        hessian_[i][j] =
            square_ * at(g.derivative(i).derivative(j)) - product_ * at(f.derivative(i).derivative(j));
  }

  /// 0 unless it is definite.
  int sign() const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (n_[k].certain_sign() == 0) continue;
      Vector e, o;
      for (std::size_t i = 0; i < 3; ++i) {
        e[i] = Number(i == (k + 1) % 3 ? 1.0 : 0.0);
        o[i] = Number(i == (k + 2) % 3 ? 1.0 : 0.0);
      }
      const Vector a = cross_over(n_, e), b = cross_over(n_, o);
      const Number aa = of(a, a), ab = of(a, b), bb = of(b, b);
      return (aa * bb - ab * ab).is_positive() ? aa.certain_sign() : 0;
    }
    return 0;
  }

 private:
  Number of(const Vector& a, const Vector& b) const {
    return dot_over(a, {dot_over(hessian_[0], b), dot_over(hessian_[1], b), dot_over(hessian_[2], b)});
  }

  Vector n_;
  Number square_, product_;
  std::array<Vector, 3> hessian_;
};

}  // namespace

std::optional<SideSigns> sides_on_chart(const LiftedCurve& curve, const SheetFunction& other, std::size_t arc,
                                        int orientation) {
  const LiftedArc& at = curve.arcs[arc];
  const CurveBranch& below = curve.below.arcs[at.below];
  const bool is_vertical = curve.below.nodes[below.from].u == curve.below.nodes[below.to].u;
  SheetFunction derivative = other;
  for (int i = 0; i < at.multiplicity; ++i)
    derivative = derivative_across(derivative, curve.chart, is_vertical);
  const int beyond = sign_on_sheet(derivative, curve.chart, below.inside, at.sheet);
  const int before = at.multiplicity % 2 == 0 ? beyond : -beyond;
  return (orientation > 0) != is_vertical ? known(beyond, before) : known(before, beyond);
}

int chart_orientation(const SurfaceChart& chart, const ImplicitSurface& surface) {
  int orientation = sign(determinant(chart.along_u, chart.along_v, chart.along_y));
  if (chart.is_flat()) return orientation * sign(dot(chart.along_y, surface.data()->axis));
  if (chart.is_affine()) return orientation;
  const Rational middle(1, 2), below = chart.denominator(middle);  // t = 0 in (17.13)
  return orientation * sign((chart.width(middle) / below - 1) * chart.height.derivative()(middle) -
                            chart.height(middle) * chart.width.derivative()(middle));
}

void add_sides(SurfaceIntersection& result, const LiftedCurve& curve, const ImplicitSurface& surface,
               const ImplicitSurface& other) {
  if (result.arcs.empty()) return;
  const int orientation = chart_orientation(curve.chart, surface);
  const SheetFunction f = on_chart(other.equation(), curve.chart);
  for (std::size_t i = 0; i < curve.arcs.size(); ++i)
    result.arcs[i].beside = sides_on_chart(curve, f, i, orientation);
}

void add_sides(SurfaceIntersection& result, const RingCurve& curve, const ImplicitSurface& surface,
               const ImplicitSurface& other) {
  for (std::size_t half = 0; half < 2 && !result.arcs.empty(); ++half) {
    const SurfaceChart& chart = curve.halves[half].chart;
    const int orientation = chart_orientation(chart, surface);
    const SheetFunction f = on_chart(other.equation(), chart);
    for (std::size_t i = 0; i < curve.arcs.size(); ++i)
      if (curve.arcs[i].half == half)
        result.arcs[i].beside = sides_on_chart(curve.halves[half], f, curve.arcs[i].below, orientation);
  }
}

void add_sides(SurfaceIntersection& result, const TorusCurve& curve, const ImplicitSurface&,
               const ImplicitSurface& other) {
  if (result.arcs.empty()) return;
  const TorusFrame& frame = curve.frame;
  const bool is_right_handed = determinant(frame.across, frame.beside, frame.along) > 0;
  std::vector<BivariatePolynomial> sections;
  for (const TorusPart& part : curve.parts) sections.push_back(pull_back(other.equation(), part.patch));
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    const TorusArc& arc = curve.arcs[i];
    const CurveGraph& graph = curve.parts[arc.part].curve.graph;
    CurveBranch branch = graph.arcs[arc.below];
    branch.multiplicity = curve.factors[arc.factor].multiplicity;
    const SideSigns signs = signs_beside(sections[arc.part], graph, branch);
    result.arcs[i].beside = is_right_handed ? known(signs.left, signs.right) : known(signs.right, signs.left);
  }
}

std::optional<SideSigns> sides_from(const ArcStart& start, const SpacePolynomial& first,
                                    const SpacePolynomial& second, int multiplicity) {
  BoxValues at(start.box);
  if (multiplicity == 1) {
    const Vector own = cross_over(at.gradient(start.f), at.gradient(start.g));
    const Vector given = cross_over(at.gradient(first), at.gradient(second));
    const int along = start.sense * dot_over(own, given).certain_sign();  // (17.28)
    return known(-along, along);
  }
  SpacePolynomial derivative = second;
  for (int i = 0; i < multiplicity; ++i) derivative = derivative_beside(derivative, first, start.height);
  const int left = at(derivative).certain_sign();  // (17.29)
  return known(left, multiplicity % 2 == 0 ? left : -left);
}

void exchange_sides(SurfaceIntersection& result, const SpacePolynomial& first,
                    const SpacePolynomial& second) {
  for (SpaceArc& arc : result.arcs) {
    if (!arc.beside) continue;
    if (arc.multiplicity % 2 != 0) {
      arc.beside = exchanged(*arc.beside);
      continue;
    }
    const int sign = -arc.beside->left * sign_of_normals(result, arc, first, second);  // (17.30)
    arc.beside = known(sign, sign);
  }
}

void negate_sides(SurfaceIntersection& result) {
  for (SpaceArc& arc : result.arcs)
    if (arc.beside) arc.beside = SideSigns{-arc.beside->left, -arc.beside->right};
}

void add_sides_around(SurfaceIntersection& result, const SpacePolynomial& first,
                      const SpacePolynomial& second) {
  for (SpaceNode& node : result.nodes) {
    if (node.kind != SpaceNodeKind::touch || !node.bounds[0].empty() || !node.bounds[1].empty()) continue;
    BoxValues at(node.box);
    const int sign = TangentForm(at, first, second).sign();
    if (sign != 0) node.around = sign;
  }
}

std::optional<int> sign_of_quotient(const SpacePolynomial& first, const SpacePolynomial& second) {
  if (first.is_zero() || first.terms().size() != second.terms().size()) return std::nullopt;
  const auto& [exponents, top] = *first.terms().begin();
  const Rational quotient = second.coefficient(exponents) / top;
  if (quotient == 0 || !(quotient * first == second)) return std::nullopt;
  return sign(quotient);
}

}  // namespace exsect

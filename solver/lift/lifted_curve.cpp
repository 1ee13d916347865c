#include "lift/lifted_curve.h"

#include <exsect/algebra/bivariate_factors.h>

#include <algorithm>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/plane_curve.h"
#include "curve/turning_in_v.h"

namespace exsect {
namespace {

int sign_of(const BivariatePolynomial& f, const TriangularPoint& p) {
  return f.is_zero() ? 0 : sign_at(f.exchanged(), p);
}

std::vector<ShadowFactor> factors_of(const Shadow& shadow) {
  std::vector<ShadowFactor> result;
  for (const BivariatePower& power : irreducible_factors(shadow.common))
    result.push_back({power.factor, power.multiplicity, 0});
  for (const BivariatePower& power : irreducible_factors(shadow.norm)) {
    const auto same = std::find_if(result.begin(), result.end(),
                                   [&](const ShadowFactor& known) { return known.factor == power.factor; });
    if (same == result.end())
      result.push_back({power.factor, 0, power.multiplicity});
    else
      same->in_norm = power.multiplicity;
  }
  return result;
}

/// A bound of the region on the chart.
struct LiftedBound {
  SheetFunction form;
  SheetFunction where;
  bool is_named;
};

class Lifting {
 public:
  Lifting(const ImplicitSurface& surface, const ImplicitSurface& other, const SurfaceRegion& region,
          LiftedCurve& result)
      : result_(result), clauses_(region.clauses) {
    for (const SurfaceBound& bound : region.bounds)
      bounds_.push_back(
          {on_chart(bound.form, result.chart), on_chart(bound.where, result.chart), !bound.name.empty()});
    marks_ = BivariatePolynomial::constant(1);
    for (const ImplicitSurface* cone : {&surface, &other}) {
      if (cone->kind() != SurfaceKind::cone) continue;
      const Point& apex = cone->data()->point;
      if (surface.equation()(apex) != 0 || other.equation()(apex) != 0) continue;
      apexes_.push_back({coordinate(apex, result.chart.along_u), coordinate(apex, result.chart.along_v),
                         coordinate(apex, result.chart.along_y)});
      marks_ = marks_ * (BivariatePolynomial::r() - BivariatePolynomial::constant(apexes_.back()[0]));
    }
    for (const ShadowFactor& factor : result.factors) {
      shadow_ = shadow_.is_zero() ? factor.factor : shadow_ * factor.factor;
    }
    shadow_u_ = shadow_.derivative_r();
    shadow_v_ = shadow_.derivative_s();
  }

  void run() {
    if (result_.factors.empty()) return;
    result_.below = with_turning_in_v(curve_graph(shadow_ * marks_, region_below()));
    for (std::size_t i = 0; i < result_.below.arcs.size(); ++i) lift_arc(i);
    for (std::size_t i = 0; i < result_.below.nodes.size(); ++i) lift_node(i);
    drop_loose_nodes();
    for (std::size_t i = 0; i < result_.nodes.size(); ++i) result_.nodes[i].bounds = bounds_at(i);
  }

 private:
  /// Where y is real, with nodes in the zeros (17.12) of bounds with a name, and where one of them vanishes
  /// along an arc also of the function that tells its ends apart.
  CurveRegion region_below() const {
    CurveRegion region = result_.chart.is_flat() ? CurveRegion() : CurveRegion(result_.chart.radicand);
    const auto mark = [&](const SheetFunction& f) {
      BivariatePolynomial zeros = whole_shadow(f, result_.chart);
      const BivariatePolynomial common = gcd(zeros, shadow_);
      region.marked.push_back(region.bounds.size());
      region.bounds.push_back(std::move(zeros));
      return common.degree_r() > 0 || common.degree_s() > 0;
    };
    for (const LiftedBound& bound : bounds_)
      if (bound.is_named && mark(bound.form)) mark(bound.where);
    return region;
  }

  /// Those with a name that a node lies on. One that is not exact is on those that its arcs run along.
  std::vector<std::size_t> bounds_at(std::size_t i) const {
    const LiftedNode& node = result_.nodes[i];
    const std::optional<TriangularPoint>& exact = result_.below.nodes[node.below].exact;
    const TriangularPoint* at = exact ? &*exact : nullptr;
    for (const LiftedArc& arc : result_.arcs)
      if (!exact && (arc.from == i || arc.to == i)) at = &result_.below.arcs[arc.below].inside;
    std::vector<std::size_t> result;
    for (std::size_t k = 0; at != nullptr && k < bounds_.size(); ++k)
      if (bounds_[k].is_named && sign_on_sheet(bounds_[k].form, result_.chart, *at, node.sheet) == 0 &&
          sign_on_sheet(bounds_[k].where, result_.chart, *at, node.sheet) >= 0)
        result.push_back(k);
    return result;
  }

  Rational coordinate(const Point& p, const Point& along) const {
    return dot(p - result_.chart.origin, along) / dot(along, along);
  }

  /// One of the cones has its apex there.
  bool is_apex(const TriangularPoint& p, int sheet) const {
    return std::any_of(apexes_.begin(), apexes_.end(), [&](const Point& apex) {
      const BivariatePolynomial v = BivariatePolynomial::s() - BivariatePolynomial::constant(apex[1]);
      return p.s() == RealAlgebraic(apex[0]) && sign_of(v, p) == 0 && sheet == sign(apex[2]);
    });
  }

  /// y of the rest's zero over p, where its b is not 0.
  int own_sheet(const TriangularPoint& p) const {
    return -sign_of(result_.shadow.rest.a, p) * sign_of(result_.shadow.rest.b, p);
  }

  bool is_kept(const TriangularPoint& p, int sheet) const {
    return place_by_signs(clauses_, [&](std::size_t i) {
             return sign_on_sheet(bounds_[i].form, result_.chart, p, sheet);
           }) != RegionPlace::outside;
  }

  void lift_arc(std::size_t i) {
    const TriangularPoint& inside = result_.below.arcs[i].inside;
    for (std::size_t k = 0; k < result_.factors.size(); ++k) {
      const ShadowFactor& factor = result_.factors[k];
      if (sign_of(factor.factor, inside) != 0) continue;
      if (sign_of(result_.chart.radicand, inside) == 0) {
        add_arc(i, 0, k, result_.chart.is_flat() ? factor.in_norm : 2 * factor.in_common + factor.in_norm);
        return;
      }
      const int own = factor.in_norm > 0 ? own_sheet(inside) : 0;
      for (const int sheet : {-1, 1}) {
        const int multiplicity = factor.in_common + (sheet == own ? factor.in_norm : 0);
        if (multiplicity > 0) add_arc(i, sheet, k, multiplicity);
      }
      return;
    }
  }

  void add_arc(std::size_t i, int sheet, std::size_t factor, int multiplicity) {
    const CurveBranch& arc = result_.below.arcs[i];
    if (!is_kept(arc.inside, sheet)) return;
    result_.arcs.push_back(
        {i, sheet, node_over(arc.from, sheet), node_over(arc.to, sheet), factor, multiplicity});
    ++result_.nodes[result_.arcs.back().from].degree;
    ++result_.nodes[result_.arcs.back().to].degree;
  }

  /// The radicand has no zero at a node that is not exact, unless it vanishes on its arcs.
  std::size_t node_over(std::size_t below, int sheet) {
    const CurveNode& node = result_.below.nodes[below];
    if (sheet != 0 && node.exact && sign_of(result_.chart.radicand, *node.exact) == 0) sheet = 0;
    for (std::size_t i = 0; i < result_.nodes.size(); ++i)
      if (result_.nodes[i].below == below && result_.nodes[i].sheet == sheet) return i;
    const bool goes_on = node.is_on_side && (node.u == RealAlgebraic(0) || node.u == RealAlgebraic(1));
    result_.nodes.push_back({below, sheet, 0, false, goes_on});
    return result_.nodes.size() - 1;
  }

  /// An exact node of the shadow. Signs of the rest are 0 on the common part.
  struct ShadowNode {
    TriangularPoint p;
    bool is_smooth;  // of the shadow
    bool on_common;
    int a;
    int b;
  };

  /// Empty where the lines through apexes alone have a node.
  std::optional<ShadowNode> shadow_node(const CurveNode& node) const {
    if (!node.exact) return std::nullopt;
    // Narrow enough for almost every sign that is not 0.
    ShadowNode result{node.exact->refined_to(power_of_two(-64)), !node.is_singular, false, 0, 0};
    const TriangularPoint& p = result.p;
    if (marks_.degree_r() > 0 && sign_of(marks_, p) == 0) {  // which the graph below has as a part
      if (sign_of(shadow_, p) != 0) return std::nullopt;
      result.is_smooth = sign_of(shadow_u_, p) != 0 || sign_of(shadow_v_, p) != 0;
    }
    result.on_common = sign_of(result_.shadow.common, p) == 0;
    if (!result.on_common) {
      result.a = sign_of(result_.shadow.rest.a, p);
      result.b = sign_of(result_.shadow.rest.b, p);
    }
    return result;
  }

  /// Common points over an exact node without arcs on their sheet, and what kind of point the others are.
  void lift_node(std::size_t below) {
    const std::optional<ShadowNode> node = shadow_node(result_.below.nodes[below]);
    if (!node) return;
    const TriangularPoint& p = node->p;
    const bool is_free = node->a == 0 && node->b == 0;
    const bool on_silhouette = sign_of(result_.chart.radicand, p) == 0;
    for (const int sheet : {-1, 0, 1}) {
      if ((sheet == 0) != on_silhouette) continue;
      if (sheet != 0 && !is_free && sheet != -node->a * node->b) continue;
      if (!is_kept(p, sheet)) continue;
      const std::size_t i = node_over(below, sheet);
      LiftedNode& at = result_.nodes[i];
      at.is_singular = at.degree == 2 && (is_apex(p, sheet) || !is_regular(*node, sheet, runs_in_plane(i)));
    }
  }

  /// An arc that ends in the node keeps y = 0.
  bool runs_in_plane(std::size_t node) const {
    return std::any_of(result_.arcs.begin(), result_.arcs.end(), [&](const LiftedArc& arc) {
      return arc.sheet == 0 && (arc.from == node || arc.to == node);
    });
  }

  /// The curve is proved to be regular where two of its arcs meet: as its shadow is where y is a function of
  /// u and v on it, or else as the zeros of the other equation on the surface, where this is regular.
  bool is_regular(const ShadowNode& node, int sheet, bool in_plane) const {
    const TriangularPoint& p = node.p;
    const SheetFunction& rest = result_.shadow.rest;
    const BivariatePolynomial& y2 = result_.chart.radicand;
    if (result_.chart.is_flat()) return node.is_smooth;
    if (sheet == 0) {
      if (node.b != 0) return node.is_smooth;
      if (node.is_smooth) return in_plane || sign_of(jacobian(shadow_, y2), p) != 0;
      return !node.on_common && sign_of(jacobian(rest.a, y2), p) != 0;
    }
    if (node.is_smooth || node.on_common || node.b != 0) return node.is_smooth;
    const auto is_zero = [&](const SheetFunction& f) {
      return sign_on_sheet(f, result_.chart, p, sheet) == 0;
    };
    return !is_zero({rest.a.derivative_r(), rest.b.derivative_r()}) ||
           !is_zero({rest.a.derivative_s(), rest.b.derivative_s()});
  }

  /// Nodes without arcs that are not exact belonged to arcs that are not kept.
  void drop_loose_nodes() {
    std::vector<std::size_t> position(result_.nodes.size(), 0);
    std::vector<LiftedNode> kept;
    for (std::size_t i = 0; i < result_.nodes.size(); ++i) {
      const LiftedNode& node = result_.nodes[i];
      position[i] = kept.size();
      if (node.degree > 0 || result_.below.nodes[node.below].exact) kept.push_back(node);
    }
    result_.nodes = std::move(kept);
    for (LiftedArc& arc : result_.arcs) {
      arc.from = position[arc.from];
      arc.to = position[arc.to];
    }
  }

  LiftedCurve& result_;
  std::vector<Point> apexes_;  // (u, v, y) of those that are common points
  BivariatePolynomial marks_;  // lines u = const through them
  std::vector<LiftedBound> bounds_;
  std::vector<std::vector<std::size_t>> clauses_;
  BivariatePolynomial shadow_;  // every factor once
  BivariatePolynomial shadow_u_;
  BivariatePolynomial shadow_v_;
};

}  // namespace

int sign_on_sheet(const SheetFunction& f, const SurfaceChart& chart, const TriangularPoint& p, int sheet) {
  const int a = sign_of(f.a, p), b = sheet * (sheet == 0 ? 0 : sign_of(f.b, p));
  if (a * b >= 0) return a != 0 ? a : b;
  return a * sign_of(f.a * f.a - f.b * f.b * chart.radicand, p);
}

LiftedCurve unlifted_curve(SurfaceChart chart, const ImplicitSurface& other) {
  LiftedCurve result;
  result.chart = std::move(chart);
  const SheetFunction f = on_chart(other.equation(), result.chart);
  result.is_same = f.is_zero();
  if (result.is_same) return result;
  result.shadow = shadow(f, result.chart);
  result.factors = factors_of(result.shadow);
  return result;
}

void lift(LiftedCurve& curve, const ImplicitSurface& surface, const ImplicitSurface& other,
          const SurfaceRegion& region) {
  Lifting(surface, other, region, curve).run();
}

std::optional<LiftedCurve> lifted_curve(const ImplicitSurface& surface, const ImplicitSurface& other,
                                        const SurfaceRegion& region) {
  std::optional<SurfaceChart> chart = chart_of(surface, other, region);
  if (!chart) return std::nullopt;
  LiftedCurve result = unlifted_curve(*std::move(chart), other);
  if (!result.is_same) lift(result, surface, other, region);
  return result;
}

}  // namespace exsect

#include "lift/ring_curve.h"

#include <exsect/algebra/interruption.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_values.h"
#include "curve/short_rational.h"
#include "lift/connected_parts.h"

namespace exsect {
namespace {

constexpr int kMostRingTurns = 100;

BivariatePolynomial product_of(const std::vector<ShadowFactor>& factors) {
  BivariatePolynomial result = BivariatePolynomial::constant(1);
  for (const ShadowFactor& factor : factors) result = result * factor.factor;
  return result;
}

/// Over u = 0 and u = 1 the shadow has simple zeros alone, and none where y or a bound is 0 but along it.
bool is_general_on_sides(const LiftedCurve& half, const SurfaceRegion& region) {
  const BivariatePolynomial f = product_of(half.factors);
  const std::vector<BivariatePolynomial> cuts = cuts_of(region, half.chart);
  return std::ranges::all_of(std::array{0, 1}, [&](int side) {
    const Polynomial on = f.at_r(side);
    if (on.is_zero() || !is_squarefree(on)) return false;
    return std::ranges::all_of(cuts, [&](const BivariatePolynomial& cut) {
      if (cut.is_zero()) return true;
      const Polynomial at = without_factors_of(f, cut).at_r(side);
      return !at.is_zero() && gcd(on, at).degree() < 1;
    });
  });
}

/// Denominators are factors without a real zero.
void drop_nowhere_real(std::vector<ShadowFactor>& factors) {
  std::erase_if(factors, [](const ShadowFactor& factor) { return is_nowhere_real(factor.factor); });
}

/// Puts both halves together.
class RingGluing {
 public:
  explicit RingGluing(RingCurve& curve) : curve_(curve) {
    for (std::size_t half = 0; half < 2; ++half) {
      position_[half].assign(curve.halves[half].nodes.size(), 0);
      first_class_[half] = parent_.size();
      parent_.resize(parent_.size() + curve.halves[half].factors.size());
    }
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  void run() {
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t i = 0; i < curve_.halves[half].nodes.size(); ++i) {
        const LiftedNode& node = curve_.halves[half].nodes[i];
        if (node.goes_on && half == 1) continue;
        position_[half][i] = curve_.nodes.size();
        curve_.nodes.push_back({half, i, node.degree});
      }
    for (const int side : {0, 1}) glue(side);
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t i = 0; i < curve_.halves[half].arcs.size(); ++i) {
        const LiftedArc& arc = curve_.halves[half].arcs[i];
        curve_.arcs.push_back({half, i, position_[half][arc.from], position_[half][arc.to],
                               root(first_class_[half] + arc.factor)});
      }
  }

 private:
  std::size_t root(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }

  /// By v and y.
  std::vector<std::size_t> nodes_on(const LiftedCurve& half, int side) const {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < half.nodes.size(); ++i)
      if (half.nodes[i].goes_on && half.below.nodes[half.nodes[i].below].u == RealAlgebraic(side))
        nodes.push_back(i);
    std::ranges::sort(nodes, {}, [&](std::size_t i) {
      return std::pair(half.below.nodes[half.nodes[i].below].v.lower, half.nodes[i].sheet);
    });
    return nodes;
  }

  std::size_t class_at(std::size_t half, std::size_t node) const {
    for (const LiftedArc& arc : curve_.halves[half].arcs)
      if (arc.from == node || arc.to == node) return first_class_[half] + arc.factor;
    throw ProofFailure(whole_domain(), "a curve on a torus ends between its halves");
  }

  /// Both halves have the same points over this circle.
  void glue(int side) {
    const std::vector<std::size_t> here = nodes_on(curve_.halves[0], side),
                                   there = nodes_on(curve_.halves[1], side);
    if (here.size() != there.size()) throw ProofFailure(whole_domain(), "halves of a torus do not fit");
    for (std::size_t k = 0; k < here.size(); ++k) {
      const LiftedNode &a = curve_.halves[0].nodes[here[k]], &b = curve_.halves[1].nodes[there[k]];
      if (a.sheet != b.sheet || a.degree != 1 || b.degree != 1)
        throw ProofFailure(whole_domain(), "halves of a torus do not fit");
      position_[1][there[k]] = position_[0][here[k]];
      curve_.nodes[position_[0][here[k]]].degree = 2;
      parent_[root(class_at(0, here[k]))] = root(class_at(1, there[k]));
    }
  }

  RingCurve& curve_;
  std::array<std::vector<std::size_t>, 2> position_;  // in curve_.nodes
  std::array<std::size_t, 2> first_class_{};          // of the factors of each half, numbered through
  std::vector<std::size_t> parent_;
};

/// A rational point p^2 + bend q^2 = squared with p = 0 or q = 0.
std::optional<std::array<Rational, 2>> point_of_tube(const Rational& squared, const Rational& bend) {
  if (const auto p = rational_root(squared, 2)) return std::array<Rational, 2>{*p, 0};
  if (const auto q = rational_root(squared / bend, 2)) return std::array<Rational, 2>{0, *q};
  return std::nullopt;
}

/// A circle of the torus, where one parameter of the half is constant; without data unless it is known.
SpaceCurve circle_of(const LiftedCurve& half, const BivariatePolynomial& factor) {
  const SurfaceChart& chart = half.chart;
  SpaceCurve circle{0, SpaceCurveKind::circle, {}, false, 1};
  if (factor.degree_s() > 0) return circle;
  circle.direction = shortened(chart.along_u);
  const Polynomial in_u = factor.at_s(0);
  if (in_u.degree() != 1) return circle;
  const Rational u = -in_u.coefficient(0) / in_u.coefficient(1), below = chart.denominator(u);
  circle.point = chart.origin + chart.height(u) / below * chart.along_u;
  const Rational width = chart.width(u) / below;  // in radii of the circle in the middle
  circle.radius_squared = width * width * chart.radicand(0, chart.middle) * dot(chart.along_y, chart.along_y);
  return circle;
}

}  // namespace

std::optional<std::array<SurfaceChart, 2>> ring_charts(const SurfaceData& torus, const Rational& turn) {
  const Point axis = shortened(torus.axis), e1 = shortened(cross(axis, least_parallel_axis(axis))),
              e2 = shortened(cross(axis, e1));
  const Rational bend = dot(axis, axis) / torus.squared;
  const std::optional<std::array<Rational, 2>> base =
      point_of_tube(torus.minor_squared / torus.squared, bend);
  if (!base) return std::nullopt;
  const Rational xx = dot(e1, e1), yy = dot(e2, e2);
  const Rational top = root_above(1 / bend);  // about where bend t^2 = 1
  const Rational reach = Rational(9, 8) * root_above(torus.squared / xx);
  const BivariatePolynomial x = BivariatePolynomial::constant(2 * reach) * BivariatePolynomial::s() -
                                BivariatePolynomial::constant(reach);
  const BivariatePolynomial radicand =
      BivariatePolynomial::constant(torus.squared / yy) - BivariatePolynomial::constant(xx / yy) * x * x;
  std::array<SurfaceChart, 2> charts;
  for (const int half : {0, 1}) {
    const Rational end = half == 0 ? Rational(top * turn) : Rational(1 / (bend * top * turn));
    const Rational sign = half == 0 ? 1 : -1, p = sign * (*base)[0], q = sign * (*base)[1];
    const Polynomial t = {-sign * end, 2 * sign * end}, square = Polynomial(bend) * t * t;
    const Polynomial straight = Polynomial(1) - square, twice = Polynomial(2) * t;
    charts[static_cast<std::size_t>(half)] = {
        torus.point,
        axis,
        2 * reach * e1,
        e2,
        radicand,
        Polynomial(q) * straight + Polynomial(p) * twice,
        Polynomial(1) + square + Polynomial(p) * straight - Polynomial(bend * q) * twice,  // (17.13)
        Polynomial(1) + square,
        Rational(1, 2)};
  }
  return charts;
}

std::optional<RingCurve> ring_curve(const ImplicitSurface& torus, const ImplicitSurface& other,
                                    const SurfaceRegion& region) {
  for (int i = 0; i < kMostRingTurns; ++i) {
    interruption_point();
    std::optional<std::array<SurfaceChart, 2>> charts = ring_charts(*torus.data(), 1 + Rational(i, i + 7));
    if (!charts) return std::nullopt;
    RingCurve result;
    bool is_general = true;
    for (std::size_t half = 0; half < 2 && is_general && !result.is_same; ++half) {
      result.halves[half] = unlifted_curve(std::move((*charts)[half]), other);
      result.is_same = result.halves[half].is_same;
      drop_nowhere_real(result.halves[half].factors);
      is_general = result.is_same || is_general_on_sides(result.halves[half], region);
    }
    if (!is_general) continue;
    if (result.is_same) return result;
    for (LiftedCurve& half : result.halves) lift(half, torus, other, region);
    RingGluing(result).run();
    return result;
  }
  throw ProofFailure(whole_domain(), "no general position of the halves of a torus is found");
}

double extent_of(const RingCurve& curve) {
  const SurfaceChart& chart = curve.halves[0].chart;
  return 2 * std::sqrt(to_double(chart.radicand(0, chart.middle) * dot(chart.along_y, chart.along_y)));
}

std::vector<SpaceCurve> named_curves(const RingCurve& curve) {
  std::vector<SpaceCurve> curves;
  std::map<std::array<std::size_t, 3>, std::size_t> position;
  std::map<std::size_t, ConnectedParts> parts;
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    const RingArc& arc = curve.arcs[i];
    const LiftedCurve& half = curve.halves[arc.half];
    const LiftedArc& below = half.arcs[arc.below];
    const auto part = parts.try_emplace(arc.factor, curve, arc.factor).first;
    const auto [at, is_new] =
        position.emplace(std::array{arc.factor, static_cast<std::size_t>(part->second(arc)),
                                    static_cast<std::size_t>(below.multiplicity)},
                         curves.size());
    if (is_new) {
      const BivariatePolynomial& factor = half.factors[below.factor].factor;
      const bool is_circle = factor.degree_r() == 0 || factor.degree_s() == 0;
      curves.push_back(is_circle ? circle_of(half, factor)
                                 : SpaceCurve{0, SpaceCurveKind::general, {}, false, 1});
      curves.back().id = static_cast<int>(at->second);
      curves.back().multiplicity = below.multiplicity;
    }
    curves[at->second].arcs.push_back(static_cast<int>(i));
  }
  return curves;
}

}  // namespace exsect

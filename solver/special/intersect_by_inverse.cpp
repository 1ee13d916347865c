#include "special/intersect_by_inverse.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/placement.h"
#include "answer/proof.h"
#include "curve/curve_values.h"
#include "curve/plane_curve.h"
#include "special/pole_on_patch.h"

namespace exsect {
namespace {

/// Of the squarefree curve without lines, in u and v together: a bicubic patch on a quadric has 12.
constexpr int kMostDegrees = 12;
/// Of each bound of a region likewise, as all of them are swept together.
constexpr int kMostDegreesOfBound = 8;

/// a D(b) - b D(a) for the derivative D along f = 0, up to a positive factor.
BivariatePolynomial slope_along(const BivariatePolynomial& f, const BivariatePolynomial& a,
                                const BivariatePolynomial& b) {
  return a * jacobian(f, b) - b * jacobian(f, a);
}

bool is_constant(const BivariatePolynomial& f) { return f.degree_r() < 1 && f.degree_s() < 1; }

/// f without its factors in s alone that have no zero in [0,1], with the same signs.
BivariatePolynomial without_positive_content(BivariatePolynomial f) {
  for (const PolynomialPower& power : irreducible_factors(split_content(f).content))
    if (real_roots(power.factor, 0, 1).empty()) {
      const Polynomial positive = power.factor(0) > 0 ? power.factor : -1 * power.factor;
      const BivariatePolynomial divisor({positive});
      for (int i = 0; i < power.multiplicity; ++i) f = exact_quotient(f, divisor);
    }
  return f;
}

/// The same signs on the square, of less degree: conics of a patch that go through circular points of space
/// leave such factors of spheres and tori.
BivariatePolynomial shortened(const BivariatePolynomial& f) {
  return without_positive_content(without_positive_content(f).exchanged()).exchanged();
}

/// The degrees of the curve without its lines.
int degrees_to_sweep(const BivariatePolynomial& f) {
  const BivariatePolynomial rest = split_content(split_content(f).primitive.exchanged()).primitive;
  return rest.degree_r() + rest.degree_s();
}

/// x is one point along a part of the squarefree curve f = 0 of the square.
bool is_contracted(const BivariatePolynomial& f, const RationalPatch& x) {
  BivariatePolynomial common = f;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) common = gcd(common, slope_along(f, x.component(i), x.component(j)));
  return !is_constant(common) && !component_points(common).empty();
}

/// 0 on this side of x alone, and positive in the square else.
BivariatePolynomial distance_from(const Side& side) {
  const BivariatePolynomial p =
      side.parameter == Parameter::u ? BivariatePolynomial::r() : BivariatePolynomial::s();
  return side.value == 0 ? p : BivariatePolynomial::constant(1) - p;
}

bool is_zero_on(const Side& side, const BivariatePolynomial& f) {
  return (side.parameter == Parameter::u ? f.at_r(side.value) : f.at_s(side.value)).is_zero();
}

/// The sides of x that are one point of the surface, with what is 0 on them divided out of the section.
std::vector<Side> take_poles(BivariatePolynomial& section, const RationalPatch& x) {
  std::vector<Side> poles;
  for (const Parameter p : {Parameter::u, Parameter::v})
    for (const int value : {0, 1}) {
      const Side side{p, value};
      if (!is_zero_on(side, section) || !is_pole(x, side)) continue;
      while (is_zero_on(side, section)) section = exact_quotient(section, distance_from(side));
      poles.push_back(side);
    }
  return poles;
}

/// Two sides, one in u and one in v.
bool have_corner(const std::vector<Side>& sides) {
  return std::ranges::any_of(sides,
                             [&](const Side& side) { return side.parameter != sides.front().parameter; });
}

bool is_positive(const BivariatePolynomial& f) {
  return std::ranges::all_of(bernstein_values(f), [](const Rational& c) { return c > 0; });
}

/// Where the inverse is in the square (17.23), without the bounds that are positive on all of x.
class Sides {
 public:
  Sides(const PatchInverse& inverse, InverseCurve& known) : known_(known), x_(components(known.x)) {
    for (const std::size_t i : {0, 1}) {
      const ParameterQuotient& quotient = inverse.parameters[i];
      const Parameter parameter = i == 0 ? Parameter::r : Parameter::s;
      SpaceForm rest = quotient.denominator, beyond = quotient.denominator;
      for (std::size_t c = 0; c < rest.coefficients.size(); ++c)
        rest.coefficients[c] -= quotient.numerator.coefficients[c];
      beyond.coefficients.back() -= quotient.bound;
      add(quotient.numerator, Side{parameter, 0});
      add(rest, Side{parameter, 1});
      add(beyond, std::nullopt);
    }
  }

 private:
  void add(const SpaceForm& form, const std::optional<Side>& side) {
    const BivariatePolynomial bound = on_patch(form, x_);
    if (is_positive(bound)) return;
    CurveRegion& region = known_.curve.region;
    if (side) known_.sides.push_back({region.bounds.size(), *side});
    region.clauses.push_back({region.bounds.size()});
    region.bounds.push_back(bound.is_zero() ? bound : shortened(bound));
  }

  InverseCurve& known_;
  VectorPolynomial x_;
};

/// On x, with the slope along the squarefree curve f = 0.
ParameterOnCurve on_curve(const ParameterQuotient& quotient, const VectorPolynomial& x,
                          const BivariatePolynomial& f) {
  const BivariatePolynomial p = on_patch(quotient.numerator, x), q = on_patch(quotient.denominator, x);
  if (q.is_zero()) return {p, q, quotient.map, {}};
  const BivariatePolynomial common = gcd(p, q);
  return {p, q, quotient.map, slope_along(f, exact_quotient(p, common), exact_quotient(q, common))};
}

/// The side of y that is this point of x, if no other point of y is: where a denominator is 0, y is on a
/// side.
std::optional<Side> pole_at(const TriangularPoint& at, const VectorPolynomial& x, const RationalPatch& y) {
  for (const Parameter p : {Parameter::u, Parameter::v})
    for (const int value : {0, 1}) {
      if (!is_pole(y, Side{p, value})) continue;
      const Point point = p == Parameter::u ? y(value, 0) : y(0, value);
      bool is_there = true;
      for (std::size_t k = 0; k < 3 && is_there; ++k) {
        const BivariatePolynomial off = x[k] - BivariatePolynomial::constant(point[k]) * x[3];
        is_there = off.is_zero() || sign_at(off.exchanged(), at) == 0;
      }
      if (!is_there) continue;
      if (!is_pole_alone(y, Side{p, value})) return std::nullopt;
      return Side{p == Parameter::u ? Parameter::r : Parameter::s, value};
    }
  return std::nullopt;
}

/// The denominators that are positive on y but for poles (17.23) are 0 in no point of the curve but these
/// poles, which are nodes.
bool has_parameters(InverseCurve& known, const PatchInverse& inverse, const RationalPatch& y) {
  const BivariatePolynomial f = squarefree(known.curve.section);
  const VectorPolynomial of_x = components(known.x);
  for (const std::size_t i : {0, 1}) {
    if (inverse.parameters[i].bound > 0) continue;
    const BivariatePolynomial& denominator = known.parameters[2 + i].denominator;
    if (!is_constant(gcd(f, denominator))) return false;
    const BivariatePolynomial in_v = denominator.exchanged();
    for (std::size_t n = 0; n < known.curve.graph.nodes.size(); ++n) {
      const std::optional<TriangularPoint>& exact = known.curve.graph.nodes[n].exact;
      if (!exact || sign_at(in_v, *exact) != 0) continue;
      const std::optional<Side> pole = pole_at(*exact, of_x, y);
      if (!pole) return false;
      known.in_poles.emplace(n, *pole);
    }
  }
  return true;
}

/// Keeps the poles that are points of y; false if one of them is a pole of y (17.23).
bool keep_poles(InverseCurve& known) {
  const CurveRegion& region = known.curve.region;
  const auto at = [](const BivariatePolynomial& f, const Side& side) {
    const Rational value(side.value), middle(1, 2);
    return side.parameter == Parameter::u ? f(value, middle) : f(middle, value);
  };
  std::erase_if(known.poles, [&](const Side& side) {
    return std::ranges::any_of(region.clauses,
                               [&](const auto& clause) { return at(region.bounds[clause[0]], side) < 0; });
  });
  return std::ranges::all_of(known.poles, [&](const Side& side) {
    return at(known.parameters[2].denominator, side) > 0 && at(known.parameters[3].denominator, side) > 0;
  });
}

/// The number of points of x in the region with a denominator 0; empty if they are no isolated ones.
std::optional<std::size_t> count_poles(const InverseCurve& known) {
  std::size_t count = 0;
  for (const std::size_t p : {2, 3}) {
    const BivariatePolynomial negative = BivariatePolynomial::constant(-1) * known.parameters[p].denominator;
    if (is_positive(known.parameters[p].denominator)) continue;
    CurveRegion poles = known.curve.region;
    poles.clauses.push_back({poles.bounds.size()});
    poles.bounds.push_back(negative);
    const RegionOutline found = outline(poles);
    if (!found.parts.empty() || !found.curves.empty()) return std::nullopt;
    count += found.points.size();
  }
  return count;
}

/// The side of y on which all of the arc is, of those across the pole.
std::optional<Side> side_across(const Side& pole, const CurveBranch& arc, const InverseCurve& known) {
  for (const SideBound& bound : known.sides)
    if (bound.side.parameter != pole.parameter &&
        sign_at(known.curve.region.bounds[bound.position].exchanged(), arc.inside) == 0)
      return bound.side;
  return std::nullopt;
}

/// Of a node that is this pole of y, if one chain alone runs through it, once, from one side of y to the
/// other one.
std::optional<RimPole> rim_pole(std::size_t node, const Side& pole, const InverseCurve& known) {
  const RegionOutline& of = *known.outline;
  std::vector<Side> in, out;
  const auto is_at = [&](std::size_t arc) {
    return of.graph.arcs[arc].from == node || of.graph.arcs[arc].to == node;
  };
  if (std::ranges::any_of(of.curves, is_at)) return std::nullopt;
  for (const RegionPart& part : of.parts)
    for (const std::vector<OutlineArc>& chain : part.chains)
      for (const OutlineArc& at : chain) {
        if (!is_at(at.arc)) continue;
        const CurveBranch& arc = of.graph.arcs[at.arc];
        const std::optional<Side> side = side_across(pole, arc, known);
        if (!side) return std::nullopt;
        ((arc.to == node) != at.is_reversed ? in : out).push_back(*side);
      }
  if (in.size() != 1 || out.size() != 1 || in[0] == out[0]) return std::nullopt;
  return RimPole{pole, {in[0], out[0]}};
}

/// x, X_u and X_v are independent.
bool is_immersed(const VectorPolynomial& x, const TriangularPoint& at) {
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    std::array<BivariatePolynomial, 3> of;
    for (std::size_t k = 0, i = 0; k < 4; ++k)
      if (k != left_out) of[i++] = x[k];
    const BivariatePolynomial minor =
        of[0] * jacobian(of[1], of[2]) - of[1] * jacobian(of[0], of[2]) + of[2] * jacobian(of[0], of[1]);
    if (sign_at(minor.exchanged(), at) != 0) return true;
  }
  return false;
}

/// Finds the poles of y among the nodes of the outline, all `count` of them, where x is regular; each is
/// alone there or in one rim (Lemma 17.15a).
bool find_poles_in_region(std::size_t count, InverseCurve& known, const RationalPatch& y) {
  if (count == 0) return true;
  const VectorPolynomial of_x = components(known.x);
  const CurveGraph& graph = known.outline->graph;
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const std::optional<TriangularPoint>& exact = graph.nodes[n].exact;
    const std::optional<Side> pole = exact ? pole_at(*exact, of_x, y) : std::nullopt;
    if (!pole) continue;
    --count;
    if (std::ranges::count(known.outline->points, n) > 0) {
      known.in_poles.emplace(n, *pole);
      continue;
    }
    const std::optional<RimPole> rim = rim_pole(n, *pole, known);
    if (!rim || !is_immersed(of_x, *exact)) return false;
    known.rim_poles.emplace(n, *rim);
  }
  return count == 0;
}

/// x depends on one number alone, as r and s do.
bool is_curve(const InverseCurve& known) {
  const ParameterOnCurve &r = known.parameters[2], &s = known.parameters[3];
  const auto along = [&](const BivariatePolynomial& f) { return slope_along(f, s.numerator, s.denominator); };
  return (r.denominator * along(r.numerator) - r.numerator * along(r.denominator)).is_zero();
}

/// For x on the surface of y; not if the region has bounds of too high degrees, or a pole of y otherwise than
/// in find_poles_in_region, or x is a curve.
std::optional<InverseCurve> inverse_region(InverseCurve known, const PatchInverse& inverse,
                                           const RationalPatch& y) {
  SurfaceCurve& curve = known.curve;
  const VectorPolynomial of_x = components(known.x);
  for (const std::size_t i : {0, 1}) {
    const ParameterQuotient& quotient = inverse.parameters[i];
    known.parameters[2 + i] = {
        on_patch(quotient.numerator, of_x), on_patch(quotient.denominator, of_x), quotient.map, {}};
  }
  const Sides sides(inverse, known);
  if (is_curve(known)) return std::nullopt;
  const auto is_short = [](const BivariatePolynomial& bound) {
    return bound.is_zero() || degrees_to_sweep(bound) <= kMostDegreesOfBound;
  };
  if (!std::ranges::all_of(curve.region.bounds, is_short)) return std::nullopt;
  const std::optional<std::size_t> poles = count_poles(known);
  if (!poles) return std::nullopt;
  curve.contains_patch = true;
  known.outline = outline(curve.region);
  if (!find_poles_in_region(*poles, known, y)) return std::nullopt;
  curve.graph = known.outline->graph;
  return known;
}

std::optional<InverseCurve> inverse_curve(const RationalPatch& x, const RationalPatch& y,
                                          const PatchInverse& inverse, double extent,
                                          const std::vector<Parameter>& turning) {
  InverseCurve known{{}, {}, {}, {}, {}, {}, {}, x.reduced(), extent};
  SurfaceCurve& curve = known.curve;
  const VectorPolynomial of_x = components(known.x);
  curve.section = on_patch(inverse.equation, of_x);
  if (curve.section.is_zero()) return inverse_region(std::move(known), inverse, y);
  known.poles = take_poles(curve.section, known.x);
  curve.section = shortened(curve.section);
  const BivariatePolynomial f = squarefree(curve.section);
  if (degrees_to_sweep(f) > kMostDegrees || is_contracted(f, known.x) || have_corner(known.poles))
    return std::nullopt;
  known.parameters[0] = {BivariatePolynomial::r(), BivariatePolynomial::constant(1), {}, f.derivative_s()};
  known.parameters[1] = {BivariatePolynomial::s(),
                         BivariatePolynomial::constant(1),
                         {},
                         BivariatePolynomial::constant(-1) * f.derivative_r()};
  for (const std::size_t i : {0, 1}) known.parameters[2 + i] = on_curve(inverse.parameters[i], of_x, f);
  const Sides sides(inverse, known);
  if (!keep_poles(known)) return std::nullopt;
  for (const Parameter p : turning) {
    const BivariatePolynomial& slope = known.parameters[index(p)].slope;
    if (p == Parameter::u || slope.is_zero()) continue;  // folds are nodes
    const BivariatePolynomial zeros = without_factors_of(f, shortened(squarefree(slope)));
    if (is_constant(zeros)) continue;
    curve.region.marked.push_back(curve.region.bounds.size());
    curve.region.bounds.push_back(zeros);
  }
  curve.graph = curve_graph(curve.section, curve.region);
  if (!has_parameters(known, inverse, y)) return std::nullopt;
  return known;
}

IntersectResult drawn(const InverseCurve& known, const Run& run) {
  GraphBuilder graph = inverse_graph(known, run.drawn_tolerance(known.extent), run.turning());
  IntersectResult result = finished(std::move(graph), {run.turning()}, {});
  result.coarse = coarse_drawing(result.graph, run.tolerance(known.extent));
  return result;
}

}  // namespace

std::shared_ptr<const InverseCurve> curve_by_inverse(const RationalPatch& x, const RationalPatch& y,
                                                     const PatchInverse& of_y, const Run& run) {
  std::vector<Point> points = affine_points(x.reduced());
  std::ranges::copy(affine_points(y.reduced()), std::back_inserter(points));
  std::optional<InverseCurve> known;
  run.timed("curve",
            [&] { known = inverse_curve(x, y, of_y, to_double(model_extent(points)), run.turning()); });
  return known ? std::make_shared<const InverseCurve>(*std::move(known)) : nullptr;
}

std::optional<IntersectResult> intersect_by_inverse(std::shared_ptr<const InverseCurve> curve,
                                                    const Run& run) {
  return first_drawn(
      [kept = std::move(curve)](const Run& given) { return std::optional(drawn(*kept, given)); }, run);
}

}  // namespace exsect

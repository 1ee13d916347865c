#include "special/intersect_by_inverse.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "answer/arc_joints.h"
#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/parameter_box.h"
#include "answer/placement.h"
#include "answer/proof.h"
#include "answer/proof_failure.h"
#include "curve/curve_place.h"
#include "curve/curve_values.h"
#include "curve/plane_curve.h"
#include "curve/surface_graph.h"

namespace exsect {
namespace {

using Ball = ArbBall<256>;

/// Of the parameters of nodes behind a quadratic map.
constexpr int kParameterBits = 256;

/// Of the squarefree curve without lines, in u and v together: a bicubic patch on a quadric has 12, and may
/// take minutes to be drawn.
constexpr int kMostDegrees = 8;

/// One of (u,v,r,s) on the curve: map(p) = numerator / denominator, the denominator positive there.
struct ParameterOnCurve {
  BivariatePolynomial numerator;
  BivariatePolynomial denominator;
  UnitMap map;
  BivariatePolynomial slope;  // (17.25)
};

/// Of the bound of the region at this position, if it is one.
struct SideBound {
  std::size_t position;
  Side side;
};

struct InverseCurve {
  SurfaceCurve curve;
  std::array<ParameterOnCurve, 4> parameters;
  std::vector<SideBound> sides;  // of y
  RationalPatch x;
  double extent;  // of the model
};

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
    if (std::ranges::all_of(bernstein_values(bound), [](const Rational& c) { return c > 0; })) return;
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

/// The denominators that are positive on y but for poles (17.23) are not 0 in a point of the curve.
bool has_parameters(const InverseCurve& known, const PatchInverse& inverse) {
  const BivariatePolynomial f = squarefree(known.curve.section);
  for (const std::size_t i : {0, 1}) {
    if (inverse.parameters[i].bound > 0) continue;
    const BivariatePolynomial& denominator = known.parameters[2 + i].denominator;
    if (!is_constant(gcd(f, denominator))) return false;
    const BivariatePolynomial in_v = denominator.exchanged();
    for (const CurveNode& node : known.curve.graph.nodes)
      if (node.exact && sign_at(in_v, *node.exact) == 0) return false;
  }
  return true;
}

std::optional<InverseCurve> inverse_curve(const RationalPatch& x, const PatchInverse& inverse, double extent,
                                          const std::vector<Parameter>& turning) {
  InverseCurve known{{}, {}, {}, x.reduced(), extent};
  SurfaceCurve& curve = known.curve;
  const VectorPolynomial of_x = components(known.x);
  curve.section = on_patch(inverse.equation, of_x);
  if (curve.section.is_zero()) return std::nullopt;
  curve.section = shortened(curve.section);
  const BivariatePolynomial f = squarefree(curve.section);
  if (degrees_to_sweep(f) > kMostDegrees || is_contracted(f, known.x)) return std::nullopt;
  known.parameters[0] = {BivariatePolynomial::r(), BivariatePolynomial::constant(1), {}, f.derivative_s()};
  known.parameters[1] = {BivariatePolynomial::s(),
                         BivariatePolynomial::constant(1),
                         {},
                         BivariatePolynomial::constant(-1) * f.derivative_r()};
  for (const std::size_t i : {0, 1}) known.parameters[2 + i] = on_curve(inverse.parameters[i], of_x, f);
  const Sides sides(inverse, known);
  for (const Parameter p : turning) {
    const BivariatePolynomial& slope = known.parameters[index(p)].slope;
    if (p == Parameter::u || slope.is_zero()) continue;  // folds are nodes
    const BivariatePolynomial zeros = without_factors_of(f, shortened(squarefree(slope)));
    if (is_constant(zeros)) continue;
    curve.region.marked.push_back(curve.region.bounds.size());
    curve.region.bounds.push_back(zeros);
  }
  curve.graph = curve_graph(curve.section, curve.region);
  if (!has_parameters(known, inverse)) return std::nullopt;
  return known;
}

Ball value_at(const BivariatePolynomial& f, const Ball& u, const Ball& v) {
  Ball sum;
  for (int i = f.degree_r(); i >= 0; --i) {
    Ball row;
    for (int j = f.degree_s(); j >= 0; --j) row = row * v + Ball::enclosing(f.coefficient(i, j));
    sum = sum * u + row;
  }
  return sum;
}

/// Of map(p). Empty if the denominator may be 0 there.
std::optional<RationalInterval> enclosed(const ParameterOnCurve& p, const Ball& u, const Ball& v) {
  const RationalInterval a = value_at(p.numerator, u, v).interval();
  const RationalInterval b = value_at(p.denominator, u, v).interval();
  if (!(b.lower > 0)) return std::nullopt;
  return RationalInterval{a.lower / (a.lower > 0 ? b.upper : b.lower),
                          a.upper / (a.upper > 0 ? b.lower : b.upper)};
}

/// The nodes and arcs of the curve with the parameters of y.
class InverseGraph {
 public:
  InverseGraph(const InverseCurve& known, double tolerance)
      : known_(known),
        graph_(known.curve.graph),
        patch_(known.x),
        drawn_(surface_graph(known.curve, patch_, tolerance)) {}

  GraphBuilder run(const std::vector<Parameter>& turning) {
    std::vector<std::vector<ArcEnd>> ends(graph_.nodes.size());
    for (const CurveBranch& arc : graph_.arcs) {
      const Arrow along = directions_of(arc);
      const std::vector<Side> sides = sides_along(arc);
      ends[arc.from].push_back({along, sides});
      ends[arc.to].push_back({{-along[0], -along[1], -along[2], -along[3]}, sides});
    }
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) add_node(i, ends[i]);
    for (std::size_t i = 0; i < graph_.arcs.size(); ++i) add_arc(i);
    for (const int node : drawn_.isolated_points()) result_.add_isolated(node);
    join_at_nodes_of_no_kind(result_, 0);
    join_at_other_turning_points(result_, 0, 0, turning);
    return std::move(result_);
  }

 private:
  /// The sign of the change of each parameter along an arc from one of its ends.
  using Arrow = std::array<int, 4>;

  struct ArcEnd {
    Arrow away;               // from the node
    std::vector<Side> sides;  // on which all of the arc is
  };

  /// Arcs lead to greater u, or v where u is constant.
  Arrow directions_of(const CurveBranch& arc) const {
    Arrow result;
    for (std::size_t p = 0; p < 4; ++p)
      result[p] = sign_at(known_.parameters[p].slope.exchanged(), arc.inside);
    const int along = result[0] != 0 ? result[0] : result[1];
    for (int& sign : result) sign *= along;
    return result;
  }

  /// 0 is a side's bound at the node, which is exact, or on one of its arcs.
  std::vector<Side> sides_at(std::size_t node) const {
    const TriangularPoint* at = graph_.nodes[node].exact ? &*graph_.nodes[node].exact : nullptr;
    for (std::size_t i = 0; at == nullptr && i < graph_.arcs.size(); ++i)
      if (graph_.arcs[i].from == node || graph_.arcs[i].to == node) at = &graph_.arcs[i].inside;
    return at != nullptr ? sides_at(*at) : std::vector<Side>{};
  }
  std::vector<Side> sides_at(const TriangularPoint& at) const {
    std::vector<Side> sides;
    for (const SideBound& bound : known_.sides)
      if (sign_at(known_.curve.region.bounds[bound.position].exchanged(), at) == 0)
        sides.push_back(bound.side);
    return sides;
  }

  /// Of both patches.
  std::vector<Side> sides_along(const CurveBranch& arc) const {
    std::vector<Side> sides = sides_at(arc.inside);
    const RationalInterval v = arc.inside.r_interval();
    for (const int value : {0, 1}) {
      if (arc.inside.s() == RealAlgebraic(value)) sides.push_back({Parameter::u, value});
      if (v.lower == value && v.upper == value) sides.push_back({Parameter::v, value});
    }
    return sides;
  }

  void add_node(std::size_t i, const std::vector<ArcEnd>& ends) {
    const CurveNode& at = graph_.nodes[i];
    Node node = drawn_.node(static_cast<int>(i));
    for (const Side& side : sides_at(i)) node.on.push_back(side);
    node.around.reset();
    place(i, node);
    node.wrt.clear();
    if (ends.size() == 2 && !at.is_singular && node.on.empty())
      for (const Parameter p : all_parameters)
        if (ends[0].away[index(p)] * ends[1].away[index(p)] > 0) node.wrt.push_back(p);
    node.kinds = passes(at, node, ends) ? std::vector<NodeKind>{} : kinds(at, node);
    result_.add_node(std::move(node));
  }

  /// The curve goes on there, along the same sides: a zero of (17.25) that is no extremum.
  static bool passes(const CurveNode& at, const Node& node, const std::vector<ArcEnd>& ends) {
    return ends.size() == 2 && !at.is_singular && node.wrt.empty() &&
           std::ranges::all_of(node.on, [&](const Side& side) {
             return std::ranges::all_of(
                 ends, [&](const ArcEnd& end) { return std::ranges::count(end.sides, side) > 0; });
           });
  }

  /// As of two patches: a corner is one of a patch.
  std::vector<NodeKind> kinds(const CurveNode& at, const Node& node) const {
    std::vector<NodeKind> kinds = kinds_of(at, node);
    const auto on = [&](Parameter p) { return side_of(node, p) != nullptr; };
    if (!(on(Parameter::u) && on(Parameter::v)) && !(on(Parameter::r) && on(Parameter::s)))
      std::erase(kinds, NodeKind::corner);
    if (at.degree() == 0 && !at.is_singular && is_touched(*at.exact)) kinds.push_back(NodeKind::touch);
    return kinds;
  }

  /// The tangent planes agree: all that the sides leave of a curve of contact.
  bool is_touched(const TriangularPoint& at) const {
    const BivariatePolynomial& section = known_.curve.section;
    return sign_at(section.derivative_r().exchanged(), at) == 0 &&
           sign_at(section.derivative_s().exchanged(), at) == 0;
  }

  static const Side* side_of(const Node& node, Parameter p) {
    const auto side = std::ranges::find(node.on, p, &Side::parameter);
    return side == node.on.end() ? nullptr : &*side;
  }

  /// The box in r and s, so small that it is inside of the square but for the sides of the node.
  void place(std::size_t i, Node& node) const {
    for (long bits = 60; bits < 500; bits *= 2) {
      if (has_place(node)) return;
      const std::array<RationalInterval, 2> at = place_of(graph_, i, power_of_two(-2 * bits));
      node.box[0] = at[0];
      node.box[1] = at[1];
    }
    throw ProofFailure(node.box, "the parameters of a point of a curve are too near to a side");
  }

  bool has_place(Node& node) const {
    const Ball u = Ball::enclosing(node.box[0]), v = Ball::enclosing(node.box[1]);
    for (const Parameter p : {Parameter::r, Parameter::s}) {
      RationalInterval& box = node.box[index(p)];
      if (const Side* side = side_of(node, p)) {
        box = {side->value, side->value};
      } else {
        const auto at = enclosed(known_.parameters[index(p)], u, v);
        if (!at || !(at->lower > 0 && at->upper < 1)) return false;
        box = preimage(known_.parameters[index(p)].map, *at, kParameterBits);
        if (!(box.lower > 0 && box.upper < 1)) return false;
      }
      node.approx[index(p)] = to_double(box.midpoint());
    }
    return true;
  }

  void add_arc(std::size_t i) {
    Arc arc = drawn_.arcs()[i];
    arc.beside.reset();
    if (!sides_along(graph_.arcs[i]).empty()) arc.place = ArcPlace::patch_boundary;
    for (PolylineVertex& vertex : arc.polyline) {
      const Ball u(vertex.parameters[0]), v(vertex.parameters[1]);
      for (const std::size_t p : {2, 3}) {
        const auto at = enclosed(known_.parameters[p], u, v);
        if (!at) throw ProofFailure(whole_domain(), "a vertex of a curve is beyond the square");
        const double value = std::clamp(to_double(at->midpoint()), 0.0, 1.0);
        vertex.parameters[p] = approximate_preimage(known_.parameters[p].map, value);
      }
    }
    for (const std::size_t p : {2, 3}) {
      arc.polyline.front().parameters[p] = result_.node(arc.from).approx[p];
      arc.polyline.back().parameters[p] = result_.node(arc.to).approx[p];
    }
    result_.add_arc(std::move(arc));
  }

  const InverseCurve& known_;
  const CurveGraph& graph_;
  DrawnPatch patch_;
  GraphBuilder drawn_;
  GraphBuilder result_;
};

IntersectResult drawn(const InverseCurve& known, const Run& run) {
  GraphBuilder graph = InverseGraph(known, run.drawn_tolerance(known.extent)).run(run.turning());
  IntersectResult result = finished(std::move(graph), {run.turning()}, {});
  result.coarse = coarse_drawing(result.graph, run.tolerance(known.extent));
  return result;
}

}  // namespace

std::optional<IntersectResult> intersect_by_inverse(const RationalPatch& x, const RationalPatch& y,
                                                    const PatchInverse& of_y, const Run& run) {
  std::vector<Point> points = affine_points(x.reduced());
  std::ranges::copy(affine_points(y.reduced()), std::back_inserter(points));
  std::optional<InverseCurve> known;
  run.timed("curve", [&] { known = inverse_curve(x, of_y, to_double(model_extent(points)), run.turning()); });
  if (!known) return std::nullopt;
  const auto kept = std::make_shared<const InverseCurve>(*std::move(known));
  return first_drawn([kept](const Run& given) { return std::optional(drawn(*kept, given)); }, run);
}

}  // namespace exsect

#include "special/inverse_graph.h"

#include <exsect/algebra/bivariate_value.h>

#include <algorithm>
#include <utility>

#include "answer/arc_joints.h"
#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_place.h"
#include "curve/outline_graph.h"
#include "curve/surface_graph.h"
#include "special/pole_on_patch.h"

namespace exsect {
namespace {

using Ball = ArbBall<256>;

/// Of the parameters of nodes behind a quadratic map.
constexpr int kParameterBits = 256;
const Rational kInsideWidth = power_of_two(-80);

Ball value_at(const BivariatePolynomial& f, const Ball& u, const Ball& v) {
  return value_in(f, u, v, [](const Rational& c) { return Ball::enclosing(c); });
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
        drawn_(known.outline ? outline_graph(known.curve, *known.outline, patch_, tolerance)
                             : surface_graph(known.curve, patch_, tolerance)) {}

  GraphBuilder run(const std::vector<Parameter>& turning) {
    find_named();
    find_poles();
    std::vector<std::vector<ArcEnd>> ends(graph_.nodes.size());
    for (const CurveBranch& arc : graph_.arcs) {
      if (!is_named_[arc.from] && !is_named_[arc.to]) continue;
      const Arrow along = known_.outline ? Arrow{} : directions_of(arc);
      const std::vector<Side> sides = sides_along(arc);
      ends[arc.from].push_back({along, sides});
      ends[arc.to].push_back({{-along[0], -along[1], -along[2], -along[3]}, sides});
    }
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) add_node(i, ends[i]);
    for (const auto& [i, rim] : known_.rim_poles) {
      ends_of_rim_[i] = result_.add_node(rim_node(i, rim, 1));
      is_named_.push_back(true);
    }
    for (std::size_t i = 0; i < drawn_.arcs().size(); ++i) {
      const std::size_t branch = known_.outline ? known_.outline->curves[i] : i;
      Arc arc = with_parameters(drawn_.arcs()[i], &graph_.arcs[branch].inside);
      const std::vector<Side> sides = sides_along(graph_.arcs[branch]);
      if (std::ranges::any_of(poles_, [&](const Side& pole) { return std::ranges::count(sides, pole) > 0; }))
        continue;
      if (!sides.empty()) arc.place = ArcPlace::patch_boundary;
      result_.add_arc(std::move(arc));
    }
    for (const Overlap& overlap : drawn_.overlaps()) add_overlap(overlap);
    for (const int node : drawn_.isolated_points()) result_.add_isolated(node);
    for (const Side& pole : poles_) contract(pole);
    if (known_.outline) name_contacts();
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

  /// What is outside of y has no parameters.
  void find_named() {
    is_named_.assign(graph_.nodes.size(), false);
    const auto find = [&](const Arc& arc) {
      is_named_[static_cast<std::size_t>(arc.from)] = is_named_[static_cast<std::size_t>(arc.to)] = true;
    };
    std::ranges::for_each(drawn_.arcs(), find);
    for (const Overlap& overlap : drawn_.overlaps())
      for (const std::vector<Arc>& chain : overlap.chains) std::ranges::for_each(chain, find);
    for (const int node : drawn_.isolated_points()) is_named_[static_cast<std::size_t>(node)] = true;
  }

  /// An overlap with a pole in its rim has the whole side there.
  void find_poles() {
    poles_ = known_.poles;
    if (!known_.outline) return;
    for (const Side& side :
         {Side{Parameter::u, 0}, Side{Parameter::u, 1}, Side{Parameter::v, 0}, Side{Parameter::v, 1}}) {
      const auto is_on = [&](const Arc& arc) {
        return std::ranges::count(drawn_.node(arc.from).on, side) > 0;
      };
      const auto ends_there = [&](const Overlap& overlap) {
        return std::ranges::any_of(overlap.chains,
                                   [&](const auto& chain) { return std::ranges::any_of(chain, is_on); });
      };
      if (is_pole(known_.x, side) && std::ranges::none_of(drawn_.overlaps(), ends_there))
        poles_.push_back(side);
    }
    const auto is_across = [&](const Side& side) { return side.parameter != poles_.front().parameter; };
    if (std::ranges::any_of(poles_, is_across)) poles_.clear();  // with a corner in common
  }

  /// The nodes on the side become one, with the parameter along it free. Where a curve has none the pole is
  /// one alone.
  void contract(const Side& pole) {
    std::vector<int> there;
    for (const Node& node : result_.nodes())
      if (is_named_[static_cast<std::size_t>(node.id)] && std::ranges::count(node.on, pole) > 0)
        there.push_back(node.id);
    if (there.empty() && known_.outline) return;
    const Parameter along = pole.parameter == Parameter::u ? Parameter::v : Parameter::u;
    Node node = known_.outline ? result_.node(there.front()) : node_in(pole);
    node.box[index(along)] = {0, 1};
    node.approx[index(along)] = 0.5;
    node.free = {along};
    std::erase_if(node.on, [&](const Side& side) { return side.parameter == along; });
    node.kinds = kinds_on_rim(node);
    result_.contract(there, std::move(node));
    is_named_.push_back(true);
  }

  /// In the middle of the side, which is one point of y. The box in r and s is that of the quotients there.
  Node node_in(const Side& pole) const {
    const Rational at(pole.value), middle(1, 2);
    const bool is_in_u = pole.parameter == Parameter::u;
    const Rational u = is_in_u ? at : middle, v = is_in_u ? middle : at;
    Node node = node_at({RationalInterval{u, u}, RationalInterval{v, v}}, patch_);
    for (const SideBound& bound : known_.sides)
      if (known_.curve.region.bounds[bound.position](u, v) == 0) node.on.push_back(bound.side);
    for (const Parameter p : {Parameter::r, Parameter::s}) {
      const ParameterOnCurve& of = known_.parameters[index(p)];
      const Side* side = side_of(node, p);
      const Rational w = side ? Rational(side->value) : of.numerator(u, v) / of.denominator(u, v);
      node.box[index(p)] = side ? RationalInterval{w, w} : preimage(of.map, {w, w}, kParameterBits);
      node.approx[index(p)] = to_double(node.box[index(p)].midpoint());
      if (!side && !(node.box[index(p)].lower > 0 && node.box[index(p)].upper < 1))
        throw ProofFailure(node.box, "the parameters of a pole are too near to a side");
    }
    return node;
  }

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
    if (!is_named_[i]) {
      result_.add_node(std::move(node));
      return;
    }
    if (const auto rim = known_.rim_poles.find(i); rim != known_.rim_poles.end()) {
      result_.add_node(rim_node(i, rim->second, 0));
      return;
    }
    const auto pole = known_.in_poles.find(i);
    for (const Side& side : sides_at(i)) node.on.push_back(side);
    node.around.reset();
    if (pole != known_.in_poles.end()) set_pole(pole->second, node);
    place(i, node);
    node.wrt.clear();
    if (ends.size() == 2 && !at.is_singular && node.on.empty())
      for (const Parameter p : all_parameters)
        if (ends[0].away[index(p)] * ends[1].away[index(p)] > 0) node.wrt.push_back(p);
    node.kinds = passes(at, node, ends) ? std::vector<NodeKind>{} : kinds(at, node);
    result_.add_node(std::move(node));
  }

  /// The end of a pole's side that is on the arc of the rim before the pole (0), or after it (1).
  Node rim_node(std::size_t i, const RimPole& rim, std::size_t end) const {
    Node node = drawn_.node(static_cast<int>(i));
    std::erase_if(node.on, [](const Side& side) { return index(side.parameter) >= 2; });
    node.on.push_back(rim.pole);
    node.on.push_back(rim.sides[end]);
    node.around.reset();
    node.wrt.clear();
    place(i, node);
    node.kinds = kinds_on_rim(node);
    return node;
  }

  /// The node is all of this side of y.
  static void set_pole(const Side& pole, Node& node) {
    std::erase_if(node.on, [](const Side& side) {
      return side.parameter == Parameter::r || side.parameter == Parameter::s;
    });
    node.on.push_back(pole);
    node.free = {pole.parameter == Parameter::r ? Parameter::s : Parameter::r};
  }

  static bool is_free(const Node& node, Parameter p) { return std::ranges::count(node.free, p) > 0; }

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
    if (known_.outline || !node.free.empty()) return kinds_on_rim(node);
    std::vector<NodeKind> kinds = kinds_of(at, node);
    if (!is_corner(node)) std::erase(kinds, NodeKind::corner);
    if (at.degree() == 0 && !at.is_singular && is_touched(*at.exact)) kinds.push_back(NodeKind::touch);
    return kinds;
  }

  static std::vector<NodeKind> kinds_on_rim(const Node& node) {
    std::vector<NodeKind> kinds = {NodeKind::boundary};
    if (is_corner(node)) kinds.push_back(NodeKind::corner);
    return kinds;
  }

  static bool is_corner(const Node& node) {
    const auto on = [&](Parameter p) { return side_of(node, p) != nullptr; };
    return (on(Parameter::u) && on(Parameter::v)) || (on(Parameter::r) && on(Parameter::s));
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
      if (is_free(node, p)) {
        box = {0, 1};
      } else if (const Side* side = side_of(node, p)) {
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

  /// About the parameter where the curve has this (u,v), which are no pole of y.
  double parameter_at(std::size_t p, const Ball& u, const Ball& v) const {
    const auto at = enclosed(known_.parameters[p], u, v);
    if (!at) throw ProofFailure(whole_domain(), "a vertex of a curve is beyond the square");
    const double value = std::clamp(to_double(at->midpoint()), 0.0, 1.0);
    return approximate_preimage(known_.parameters[p].map, value);
  }

  /// Of an arc with this inner point, or of a rim. An end in a pole of y has the parameter along its side of
  /// what is next to it.
  Arc with_parameters(Arc arc, const TriangularPoint* inside = nullptr) const {
    arc.beside.reset();
    std::vector<PolylineVertex>& line = arc.polyline;
    for (const std::size_t p : {2, 3}) {
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
        line[i].parameters[p] = parameter_at(p, Ball(line[i].parameters[0]), Ball(line[i].parameters[1]));
      const bool is_chord = line.size() == 2;
      const auto end = [&](const Node& node, const PolylineVertex& next) {
        if (!is_free(node, all_parameters[p])) return node.approx[p];
        if (!is_chord || inside == nullptr) return next.parameters[p];
        const TriangularPoint at = inside->refined_to(kInsideWidth);
        return parameter_at(p, Ball::enclosing(at.s().interval()), Ball::enclosing(at.r_interval()));
      };
      const double first = end(result_.node(arc.from), line[1]),
                   last = end(result_.node(arc.to), line[line.size() - 2]);
      line.front().parameters[p] = first;
      line.back().parameters[p] = last;
    }
    return arc;
  }

  /// Besides overlaps: isolated points but for poles, and where curves end in the rim of one.
  void name_contacts() {
    for (const int node : result_.isolated_points())
      if (result_.node(node).free.empty()) result_.add_kind(node, NodeKind::touch);
    for (const Overlap& overlap : result_.overlaps())
      for (const std::vector<Arc>& chain : overlap.chains)
        for (const Arc& rim : chain)
          for (const Arc& arc : result_.arcs())
            if (arc.from == rim.from || arc.to == rim.from)
              result_.add_kind(rim.from, NodeKind::end_of_overlap);
  }

  /// From the end of an arc of the rim along the side of y that is a pole there.
  Arc along_pole(const Arc& before, int to) const {
    Arc arc = before;
    arc.from = before.to;
    arc.to = to;
    PolylineVertex last = before.polyline.back();
    for (const std::size_t p : {2, 3}) last.parameters[p] = result_.node(to).approx[p];
    arc.polyline = {before.polyline.back(), last};
    return arc;
  }

  /// Its chains go on through nodes of no kind.
  void add_overlap(const Overlap& overlap) {
    std::vector<std::vector<Arc>> chains;
    for (const std::vector<Arc>& chain : overlap.chains) {
      std::vector<Arc> arcs;
      for (Arc arc : chain) {
        const auto from = ends_of_rim_.find(static_cast<std::size_t>(arc.from));
        if (from != ends_of_rim_.end()) arc.from = from->second;
        arcs.push_back(with_parameters(std::move(arc)));
        arcs.back().place = ArcPlace::patch_boundary;
        const auto pole = ends_of_rim_.find(static_cast<std::size_t>(arcs.back().to));
        if (pole != ends_of_rim_.end()) arcs.push_back(along_pole(arcs.back(), pole->second));
      }
      const auto is_wanted = [&](int id) { return !result_.node(id).kinds.empty(); };
      chains.push_back(joined_chain(std::move(arcs), is_wanted));
    }
    result_.add_overlap(std::move(chains));
  }

  const InverseCurve& known_;
  const CurveGraph& graph_;
  DrawnPatch patch_;
  GraphBuilder drawn_;
  std::vector<bool> is_named_;  // of the nodes of drawn_: by its arcs, overlaps or isolated points
  std::vector<Side> poles_;     // sides of x that are one point, each to become one node
  std::map<std::size_t, int> ends_of_rim_;  // nodes of result_ in which rims leave poles of y
  GraphBuilder result_;
};

}  // namespace

GraphBuilder inverse_graph(const InverseCurve& known, double tolerance,
                           const std::vector<Parameter>& turning) {
  return InverseGraph(known, tolerance).run(turning);
}

}  // namespace exsect

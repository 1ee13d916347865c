#include "answer/graph_invariant.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "answer/parameter_box.h"

namespace exsect {

namespace {

/// Parameters of nodes and vertices are rounded to doubles in [0,1].
constexpr double kRounding = 0x1p-50;
/// Parameters next to a cuspidal point are square roots of rounded numbers.
constexpr double kCuspRounding = 0x1p-20;
/// A parameter that keeps within this may be constant.
constexpr double kNearlyConstant = 0x1p-30;

template <class T>
bool has(const std::vector<T>& items, const T& item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

bool is_singular(const Node& node) {
  return has(node.kinds, NodeKind::touch) || has(node.kinds, NodeKind::crossing) ||
         has(node.kinds, NodeKind::cusp);
}

bool lies_on(const Node& node, Parameter p) {
  return std::any_of(node.on.begin(), node.on.end(), [&](const Side& side) { return side.parameter == p; });
}

double reach_of(const Node& node) {
  double reach = 0;
  for (const Parameter p : all_parameters) {
    if (has(node.free, p)) continue;
    const Rational at = from_double(node.approx[index(p)]);
    const RationalInterval& box = node.box[index(p)];
    reach = std::max(reach, to_double(std::max<Rational>(at - box.lower, box.upper - at)));
  }
  return reach * (1 + kRounding);
}

class Invariant {
 public:
  Invariant(const IntersectionGraph& graph, std::vector<double> reach, const GraphFacts& facts)
      : graph_(graph),
        reach_(std::move(reach)),
        facts_(facts),
        degree_(degrees(graph)),
        on_side_(graph.nodes.size(), 0),
        on_overlap_(graph.nodes.size(), false),
        neighbours_(graph.nodes.size(), {-1, -1}) {
    for (std::size_t i = 0; i < reach_.size(); ++i) {
      if (!(reach_[i] >= 0)) reach_[i] = reach_of(graph.nodes[i]);
    }
    for (const Overlap& overlap : graph.overlaps) {
      for (const std::vector<Arc>& chain : overlap.chains) {
        for (const Arc& arc : chain) on_overlap_[at(arc.from)] = on_overlap_[at(arc.to)] = true;
      }
    }
    for (const Arc& arc : graph.arcs) {
      add_neighbour(arc.from, arc.to);
      add_neighbour(arc.to, arc.from);
      if (arc.place == ArcPlace::patch_boundary) {
        ++on_side_[at(arc.from)];
        ++on_side_[at(arc.to)];
      }
    }
  }

  std::vector<Incomplete> run() {
    for (const Node& node : graph_.nodes) check_node(node);
    for (const int id : graph_.isolated_points) {
      if (degree_[at(id)] != 0) violated(id, "an arc ends in an isolated point");
    }
    for (const Arc& arc : graph_.arcs) check_arc(arc);
    for (const Component& component : graph_.components) {
      if (component.shape == ComponentShape::closed) check_closed(component);
    }
    check_places();
    check_twins();
    return std::move(violations_);
  }

 private:
  static std::size_t at(int id) { return static_cast<std::size_t>(id); }
  const Node& node(int id) const { return graph_.nodes[at(id)]; }

  void add_neighbour(int of, int id) {
    std::array<int, 2>& known = neighbours_[at(of)];
    known[known[0] < 0 ? 0 : 1] = id;
  }

  void violated(int id, const std::string& what) { violations_.push_back({node(id).box, what}); }

  /// Several solutions, an end of an overlap, or a point where a box cuts the curve: no rule of this file
  /// holds.
  bool is_special(const Node& node) const {
    return !node.free.empty() || !node.bounds.empty() || on_overlap_[at(node.id)] ||
           has(node.kinds, NodeKind::end_of_overlap);
  }

  void check_node(const Node& node) {
    if (has(node.kinds, NodeKind::boundary) != (!node.on.empty() || !node.bounds.empty())) {
      violated(node.id, "a boundary point on no side, or a point on a side that is none");
    }
    for (const Side& side : node.on) {
      const RationalInterval& box = node.box[index(side.parameter)];
      if (box.lower != side.value || box.upper != side.value) {
        violated(node.id, "a boundary point off its side");
      }
    }
    if (has(node.kinds, NodeKind::turning) != !node.wrt.empty()) {
      violated(node.id, "a turning point with respect to no parameter");
    }
    if (is_special(node)) return;
    check_degree(node);
    check_on_side(node);
    check_order(node);
  }

  /// The half branches of a curve at one of its points are even in number: those at an inner point are all
  /// shown.
  void check_degree(const Node& node) {
    const int degree = degree_[at(node.id)];
    const bool inside = node.on.empty();
    const auto wrong = [&](const char* what) {
      violated(node.id, std::to_string(degree) + " arcs end in " + what);
    };
    const auto known = facts_.degree ? facts_.degree(node) : std::nullopt;
    if (known && (facts_.one_order ? degree > *known : degree != *known)) {
      wrong(inside ? "a regular point" : "a point where the curve crosses a side");
    } else if (has(node.kinds, NodeKind::turning) && degree != 2) {
      wrong("a turning point");
    } else if (!is_singular(node)) {
      // On a side a singular point of a patch, from which more arcs can come, has no kind of its own.
      if (inside && degree > 2) wrong("a point that is no crossing");
      if (inside && degree == 1 && !facts_.one_order) wrong("an inner point");
    } else if (!facts_.one_order && !has(node.kinds, NodeKind::cusp)) {
      const bool crossing = has(node.kinds, NodeKind::crossing);
      if (!crossing && degree != 0) wrong("a point where the patches touch");
      if (crossing && inside && (degree < 3 || degree % 2 != 0)) wrong("an inner crossing");
    }
  }

  /// Points of one patch on a side of the other are a curve in the parameters of the first. Its half branches
  /// at a point inside are even in number, and so are the arcs over them.
  void check_on_side(const Node& node) {
    const int count = on_side_[at(node.id)];
    if (node.on.size() == 1 && count % 2 != 0 && !facts_.one_order) {
      violated(node.id, std::to_string(count) + " arcs on a side end in a point inside that side");
    }
  }

  bool turns_at(const Node& node, Parameter p) const { return has(node.wrt, p) || lies_on(node, p); }

  /// Both arcs of a regular node are monotone: they lie on one side of it with respect to a parameter that
  /// turns there, and on two sides otherwise. A curve that goes on at a side of the square turns there.
  void check_order(const Node& node) {
    const auto [first, second] = neighbours_[at(node.id)];
    if (degree_[at(node.id)] != 2 || is_singular(node) || first == second) return;
    // On a side, and where a patch meets itself, a singular point of a patch has no kind of its own.
    const bool is_regular = facts_.degree && facts_.degree(node);
    if ((!node.on.empty() || facts_.one_order) && !is_regular) return;
    for (const Parameter p : facts_.turning) {
      const int before = order(node.id, first, p);
      const int behind = order(node.id, second, p);
      if (before == 0 || behind == 0 || has(node.kinds, NodeKind::corner)) continue;
      if ((before == behind) != turns_at(node, p)) {
        violated(node.id,
                 std::string(name(p)) + " turns at a point that is no turning point, or goes on at one");
      }
    }
  }

  /// -1, 1: the parameter at `other` is certainly below, above that at `id`; 0: not known.
  int order(int id, int other, Parameter p) const {
    if (has(node(other).free, p)) return 0;
    const double d = node(other).approx[index(p)] - node(id).approx[index(p)];
    const double doubt = reach_[at(id)] + reach_[at(other)] + kRounding;
    return d > doubt ? 1 : d < -doubt ? -1 : 0;
  }

  void check_arc(const Arc& arc) {
    if (arc.polyline.size() < 2 || !(arc.error_bound >= 0 && std::isfinite(arc.error_bound))) {
      violated(arc.from, "an arc without a polyline or a bound");
      return;
    }
    check_end(arc, arc.from, arc.polyline.front());
    check_end(arc, arc.to, arc.polyline.back());
  }

  void check_end(const Arc& arc, int id, const PolylineVertex& vertex) {
    const double rounding = has(node(id).kinds, NodeKind::cusp) ? kCuspRounding : kRounding;
    for (const Parameter p : all_parameters) {
      const double off = std::fabs(vertex.parameters[index(p)] - node(id).approx[index(p)]);
      if (!(off <= reach_[at(id)] + rounding) && !has(node(id).free, p) && !has(arc.free, p)) {
        violated(id, "a polyline that ends off its node");
        return;
      }
    }
  }

  /// A node on a side is a boundary point alone: other parameters that turn there are told by the arcs' other
  /// ends, if these tell it.
  std::optional<bool> turns_at_end(const Node& node, Parameter p) const {
    if (turns_at(node, p)) return true;
    const auto [first, second] = neighbours_[at(node.id)];
    if (node.on.empty() || first == second) return false;
    const int before = order(node.id, first, p), behind = order(node.id, second, p);
    if (before == 0 || behind == 0) return std::nullopt;
    return before == behind;
  }

  /// A closed curve without singular points, along which a parameter is constant or turns an even number of
  /// times, at least twice.
  void check_closed(const Component& component) {
    std::array<int, 4> turns{};
    std::array<bool, 4> is_known = {true, true, true, true};
    for (const int id : component.arcs) {
      const Arc& arc = graph_.arcs[at(id)];
      const Node& from = node(arc.from);
      for (const Node* end : {&from, &node(arc.to)}) {
        if (is_special(*end) || is_singular(*end) || has(end->kinds, NodeKind::corner)) return;
        // On a side a singular point of a patch, at which anything may turn, has no kind of its own.
        if (!end->on.empty() && facts_.degree && !facts_.degree(*end)) return;
      }
      if (arc.place != ArcPlace::interior || !arc.free.empty()) return;
      // every node has two arc ends
      for (const Node* end : {&from, &node(arc.to)}) {
        for (const Parameter p : all_parameters) {
          const auto turning = turns_at_end(*end, p);
          is_known[index(p)] = is_known[index(p)] && turning;
          turns[index(p)] += turning.value_or(false) ? 1 : 0;
        }
      }
    }
    const int place = graph_.arcs[at(component.arcs.front())].from;
    if (is_known == std::array{true, true, true, true} &&
        std::all_of(turns.begin(), turns.end(), [](int t) { return t == 0; })) {
      violated(place, "a closed curve without turning points");
      return;
    }
    for (const Parameter p : facts_.turning) {
      if (!is_known[index(p)]) continue;
      const int count = turns[index(p)] / 2;
      if (count % 2 != 0 || (count == 0 && !may_be_constant(component, p))) {
        violated(place, "a closed curve with " + std::to_string(count) + " turning points with respect to " +
                            name(p));
      }
    }
  }

  bool may_be_constant(const Component& component, Parameter p) const {
    const double first = graph_.arcs[at(component.arcs.front())].polyline.front().parameters[index(p)];
    return std::all_of(component.arcs.begin(), component.arcs.end(), [&](int id) {
      const auto& polyline = graph_.arcs[at(id)].polyline;
      return std::all_of(polyline.begin(), polyline.end(), [&](const PolylineVertex& vertex) {
        return std::fabs(vertex.parameters[index(p)] - first) <= kNearlyConstant;
      });
    });
  }

  /// A box holds one point of its node's kind: no other node of that kind has its box in it.
  void check_places() {
    for (const Node& a : graph_.nodes) {
      for (std::size_t j = at(a.id) + 1; j < graph_.nodes.size(); ++j) {
        const Node& b = graph_.nodes[j];
        if (!is_far(a, b) && !is_special(a) && !is_special(b) && a.on == b.on && a.wrt == b.wrt &&
            (lies_in(a.box, b.box) || lies_in(b.box, a.box))) {
          violated(a.id, "two nodes for one point");
        }
      }
    }
  }

  bool is_far(const Node& a, const Node& b) const {
    const double doubt = reach_[at(a.id)] + reach_[at(b.id)] + kRounding;
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::fabs(a.approx[i] - b.approx[i]) > doubt) return true;
    }
    return false;
  }

  /// Two arcs with one polyline, unless they are so short that doubles do not tell them apart.
  void check_twins() {
    for (const Arc& a : graph_.arcs) {
      for (std::size_t j = at(a.id) + 1; j < graph_.arcs.size(); ++j) {
        const Arc& b = graph_.arcs[j];
        const bool same = a.from == b.from && a.to == b.to;
        const bool reversed = a.from == b.to && a.to == b.from;
        if ((same || reversed) && is_long(a) && a.free == b.free &&
            ((same && are_same(a.polyline.begin(), a.polyline.end(), b.polyline)) ||
             (reversed && are_same(a.polyline.rbegin(), a.polyline.rend(), b.polyline)))) {
          violated(a.from, "an arc that is shown twice");
        }
      }
    }
  }

  template <class Iterator>
  static bool are_same(Iterator first, Iterator last, const std::vector<PolylineVertex>& other) {
    return std::equal(first, last, other.begin(), other.end(),
                      [](const PolylineVertex& a, const PolylineVertex& b) {
                        return a.parameters == b.parameters && a.point == b.point;
                      });
  }

  static bool is_long(const Arc& arc) {
    return std::any_of(arc.polyline.begin(), arc.polyline.end(), [&](const PolylineVertex& vertex) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (std::fabs(vertex.parameters[i] - arc.polyline.front().parameters[i]) > kNearlyConstant)
          return true;
      }
      return false;
    });
  }

  const IntersectionGraph& graph_;
  std::vector<double> reach_;
  const GraphFacts& facts_;
  std::vector<int> degree_;
  std::vector<int> on_side_;  // ends of arcs on sides at every node
  std::vector<bool> on_overlap_;
  std::vector<std::array<int, 2>> neighbours_;  // other ends of the first arc and the last one
  std::vector<Incomplete> violations_;
};

}  // namespace

std::vector<int> degrees(const IntersectionGraph& graph) {
  std::vector<int> result(graph.nodes.size(), 0);
  for (const Arc& arc : graph.arcs) {
    ++result[static_cast<std::size_t>(arc.from)];
    ++result[static_cast<std::size_t>(arc.to)];
  }
  return result;
}

std::vector<Incomplete> violations_of(const IntersectionGraph& graph, std::vector<double> reach,
                                      const GraphFacts& facts) {
  return Invariant(graph, std::move(reach), facts).run();
}

bool have_same_counts(const IntersectionGraph& graph, const IntersectionGraph& of_exchanged) {
  const auto counts = [](const IntersectionGraph& g, std::size_t first) {
    std::array<std::size_t, 10> result = {g.isolated_points.size(), g.overlaps.size(),
                                          static_cast<std::size_t>(g.boundary_points())};
    std::size_t i = 3;
    for (const auto shape : {ComponentShape::open, ComponentShape::closed, ComponentShape::branched}) {
      result[i++] = static_cast<std::size_t>(g.count(shape));
    }
    for (std::size_t j = 0; j < 4; ++j) {
      result[i++] = static_cast<std::size_t>(g.turning_points(all_parameters[(first + j) % 4]));
    }
    return result;
  };
  return counts(graph, 0) == counts(of_exchanged, 2);
}

}  // namespace exsect

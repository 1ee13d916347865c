#include "support/exact_case.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "intersect_exactly.h"

namespace exsect {
namespace {

using Vector3 = std::array<double, 3>;
using Vector4 = std::array<double, 4>;

struct Different : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require(bool holds, const std::string& what) {
  if (!holds) throw Different(what);
}

bool has(const std::vector<Parameter>& list, std::size_t i) {
  return std::any_of(list.begin(), list.end(), [&](Parameter p) { return index(p) == i; });
}

std::string text(const ExactNode& node) {
  std::string result = "(";
  for (std::size_t i = 0; i < 4; ++i) {
    result += (i > 0 ? ", " : "") + (has(node.free, i) ? "free" : std::to_string(node.at[i].to_double()));
  }
  return result + ")";
}

std::string text(const Node& node) {
  std::string result = "[";
  for (const NodeKind kind : node.kinds) result += std::string(name(kind)) + " ";
  for (const Side& side : node.on)
    result += std::string(name(side.parameter)) + "=" + std::to_string(side.value) + " ";
  for (const Parameter p : node.wrt) result += std::string("wrt ") + name(p) + " ";
  for (const double a : node.approx) result += std::to_string(a) + " ";
  return result + "]";
}

std::set<int> sides(const ExactNode& node) {
  std::set<int> result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (const int value : {0, 1}) {
      if (!has(node.free, i) && node.at[i].compare(value) == 0) {
        result.insert(2 * static_cast<int>(i) + value);
      }
    }
  }
  return result;
}

std::set<int> sides(const Node& node) {
  std::set<int> result;
  for (const Side& side : node.on) result.insert(2 * static_cast<int>(index(side.parameter)) + side.value);
  return result;
}

std::set<Parameter> as_set(const std::vector<Parameter>& list) { return {list.begin(), list.end()}; }

bool holds_point(const Node& node, const ExactNode& expected) {
  if (as_set(node.free) != as_set(expected.free)) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (has(expected.free, i)) {
      if (node.box[i].lower != 0 || node.box[i].upper != 1) return false;
    } else if (expected.at[i].compare(node.box[i].lower) < 0 ||
               expected.at[i].compare(node.box[i].upper) > 0) {
      return false;
    }
  }
  return true;
}

std::set<NodeKind> regular_kinds(const ExactNode& node) {
  const std::set<int> on = sides(node);
  std::set<NodeKind> kinds;
  if (!on.empty()) kinds.insert(NodeKind::boundary);
  const auto on_first = std::count_if(on.begin(), on.end(), [](int side) { return side < 4; });
  if (on_first == 2 || static_cast<long>(on.size()) - on_first == 2) kinds.insert(NodeKind::corner);
  if (!node.wrt.empty()) kinds.insert(NodeKind::turning);
  return kinds;
}

/// The kinds as they should be; at singular points turning is left open.
void check_kinds(const Node& node, const ExactNode& expected) {
  std::set<NodeKind> kinds(node.kinds.begin(), node.kinds.end());
  std::set<NodeKind> due = regular_kinds(expected);
  if (expected.kind) {
    due.insert(*expected.kind);
    due.erase(NodeKind::turning);
    kinds.erase(NodeKind::turning);
  } else {
    require(as_set(node.wrt) == as_set(expected.wrt),
            "turning parameters at " + text(expected) + ": " + text(node));
  }
  require(kinds == due, "kinds at " + text(expected) + ": " + text(node));
}

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  double along = 0;
  double length = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    along += (b[c] - a[c]) * (p[c] - a[c]);
    length += (b[c] - a[c]) * (b[c] - a[c]);
  }
  const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double d = a[c] + t * (b[c] - a[c]) - p[c];
    sum += d * d;
  }
  return std::sqrt(sum);
}

double distance_to_polyline(const Vector3& p, const std::vector<PolylineVertex>& line) {
  double best = HUGE_VAL;
  for (std::size_t k = 1; k < line.size(); ++k) {
    best = std::min(best, distance_to_segment(p, line[k - 1].point, line[k].point));
  }
  return best;
}

Vector3 space_point(const BezierPatch& x, const Vector4& z) {
  const Point p = x(from_double(z[0]), from_double(z[1]));
  return {to_double(p[0]), to_double(p[1]), to_double(p[2])};
}

double size_of(const ExactCase& c) {
  double size = 0;
  for (const BezierPatch* patch : {&c.x, &c.y}) {
    for (const auto& row : patch->net()) {
      for (const Point& p : row) {
        for (const Rational& a : p) size = std::max(size, std::fabs(to_double(a)));
      }
    }
  }
  return size;
}

/// Of z from the polyline in the parameters, which tells sheets that lie over each other in space apart.
double parameter_distance(const Vector4& z, const std::vector<PolylineVertex>& line) {
  const auto segment = [&](const Vector4& a, const Vector4& b) {
    double along = 0;
    double length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      along += (b[i] - a[i]) * (z[i] - a[i]);
      length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    double result = 0;
    for (std::size_t i = 0; i < 4; ++i) result = std::max(result, std::fabs(a[i] + t * (b[i] - a[i]) - z[i]));
    return result;
  };
  double best = HUGE_VAL;
  for (std::size_t k = 1; k < line.size(); ++k) {
    best = std::min(best, segment(line[k - 1].parameters, line[k].parameters));
  }
  return best;
}

constexpr double parameter_slack = 2e-2;

class Comparison {
 public:
  Comparison(const IntersectionGraph& graph, const ExactCase& expected)
      : graph_(graph), case_(expected), graph_node_(expected.graph.nodes.size(), -1) {}

  void run() {
    match_nodes();
    match_arcs();
    check_components();
    check_isolated();
    check_overlaps();
  }

 private:
  void match_nodes() {
    const std::vector<ExactNode>& nodes = case_.graph.nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Node* found = nullptr;
      for (const Node& node : graph_.nodes) {
        if (!holds_point(node, nodes[k])) continue;
        require(found == nullptr, "two nodes at " + text(nodes[k]));
        found = &node;
      }
      require(found != nullptr,
              "no node at " + text(nodes[k]) + " among " + std::to_string(graph_.nodes.size()));
      check_node(*found, nodes[k]);
      require(std::count(graph_node_.begin(), graph_node_.end(), found->id) == 0, "one node for two points");
      graph_node_[k] = found->id;
    }
    for (const Node& node : graph_.nodes) {
      require(std::count(graph_node_.begin(), graph_node_.end(), node.id) == 1,
              "a node too many: " + text(node));
    }
  }

  void check_node(const Node& node, const ExactNode& expected) const {
    require(sides(node) == sides(expected), "sides at " + text(expected) + ": " + text(node));
    for (std::size_t i = 0; i < 4; ++i) {
      const Rational width = node.box[i].upper - node.box[i].lower;
      require(has(expected.free, i) || width < Rational(1, 1000000000), "a wide box at " + text(expected));
    }
    if (!in_overlap(expected)) check_kinds(node, expected);
  }

  bool in_overlap(const ExactNode& node) const {
    const auto k = static_cast<std::size_t>(&node - case_.graph.nodes.data());
    for (const auto& overlap : case_.graph.overlaps) {
      for (const auto& chain : overlap) {
        for (const ExactArc& arc : chain) {
          if (arc.from == k || arc.to == k) return true;
        }
      }
    }
    return false;
  }

  /// Arcs of the graph that can be this one: same ends, and the samples on the polyline.
  std::string mismatch(const Arc& arc, const ExactArc& expected, bool compare_labels) const {
    const auto ends = std::minmax(graph_node_[expected.from], graph_node_[expected.to]);
    if (std::minmax(arc.from, arc.to) != ends) return "other ends";
    const double rounding = 1e-13 * size_of(case_);
    for (const Vector4& z : expected.samples) {
      if (distance_to_polyline(space_point(case_.x, z), arc.polyline) > arc.error_bound + rounding) {
        return "a point off the polyline by more than its bound";
      }
      if (parameter_distance(z, arc.polyline) > parameter_slack) return "a point with other parameters";
    }
    if (!compare_labels) return "";
    if (arc.place != expected.place) return std::string("place ") + name(arc.place);
    if (arc.contact != expected.contact) return std::string("contact ") + name(arc.contact);
    return "";
  }

  void match(const std::vector<Arc>& arcs, const std::vector<ExactArc>& expected, bool compare_labels) const {
    require(arcs.size() == expected.size(),
            "number of arcs: " + std::to_string(arcs.size()) + " for " + std::to_string(expected.size()));
    std::set<int> taken;
    for (const ExactArc& e : expected) {
      std::string reasons;
      const auto match = std::find_if(arcs.begin(), arcs.end(), [&](const Arc& arc) {
        const std::string reason = taken.count(arc.id) > 0 ? "taken" : mismatch(arc, e, compare_labels);
        if (!reason.empty() && reason != "other ends") reasons += reason + "; ";
        return reason.empty();
      });
      require(match != arcs.end(), "no arc from " + text(case_.graph.nodes[e.from]) + " to " +
                                       text(case_.graph.nodes[e.to]) + ": " + reasons);
      taken.insert(match->id);
    }
  }

  void match_arcs() const {
    match(graph_.arcs, case_.graph.arcs, true);
    for (const Arc& arc : graph_.arcs) require(arc.polyline.size() >= 2, "an arc without a polyline");
  }

  std::vector<int> shapes_due() const {
    const std::size_t n = case_.graph.nodes.size();
    std::vector<std::size_t> root(n);
    std::vector<int> degree(n, 0);
    std::iota(root.begin(), root.end(), 0U);
    for (const ExactArc& arc : case_.graph.arcs) {
      ++degree[arc.from];
      ++degree[arc.to];
      const std::size_t from = root[arc.from];
      std::replace(root.begin(), root.end(), from, root[arc.to]);
    }
    std::vector<int> count(3, 0);
    for (std::size_t k = 0; k < n; ++k) {
      int largest = 0;
      int least = 9;
      for (std::size_t i = 0; i < n; ++i) {
        if (root[i] != k) continue;
        largest = std::max(largest, degree[i]);
        least = std::min(least, degree[i]);
      }
      if (largest == 0) continue;
      const auto shape = largest > 2  ? ComponentShape::branched
                         : least == 1 ? ComponentShape::open
                                      : ComponentShape::closed;
      ++count[static_cast<std::size_t>(shape)];
    }
    return count;
  }

  void check_components() const {
    const std::vector<int> due = shapes_due();
    for (const auto shape : {ComponentShape::open, ComponentShape::closed, ComponentShape::branched}) {
      const int expected = due[static_cast<std::size_t>(shape)];
      require(graph_.count(shape) == expected, std::string("number of components ") + name(shape) + ": " +
                                                   std::to_string(graph_.count(shape)) + " for " +
                                                   std::to_string(expected));
    }
  }

  void check_isolated() const {
    std::set<int> due(graph_node_.begin(), graph_node_.end());
    const auto remove = [&](const ExactArc& arc) {
      due.erase(graph_node_[arc.from]);
      due.erase(graph_node_[arc.to]);
    };
    std::for_each(case_.graph.arcs.begin(), case_.graph.arcs.end(), remove);
    for (const auto& overlap : case_.graph.overlaps) {
      for (const auto& chain : overlap) std::for_each(chain.begin(), chain.end(), remove);
    }
    require(std::set<int>(graph_.isolated_points.begin(), graph_.isolated_points.end()) == due,
            "number of isolated points: " + std::to_string(graph_.isolated_points.size()));
  }

  void check_overlaps() const {
    require(graph_.overlaps.size() == case_.graph.overlaps.size(), "number of overlaps");
    for (std::size_t k = 0; k < graph_.overlaps.size(); ++k) {
      const auto& expected = case_.graph.overlaps[k];
      const auto& chains = graph_.overlaps[k].chains;
      require(chains.size() == expected.size(), "number of chains");
      for (std::size_t i = 0; i < chains.size(); ++i) match(chains[i], expected[i], false);
    }
  }

  const IntersectionGraph& graph_;
  const ExactCase& case_;
  std::vector<int> graph_node_;  // of each expected node
};

RealAlgebraic reversed(const RealAlgebraic& a) {
  if (a.is_rational()) return {1 - a.rational()};
  const RationalInterval i = a.interval();
  return RealAlgebraic::root_of(a.polynomial().compose(Polynomial{1, -1}), {1 - i.upper, 1 - i.lower});
}

std::vector<Parameter> renamed(const std::vector<Parameter>& list, const Renaming& renaming) {
  std::vector<Parameter> result;
  for (const Parameter p : list) result.push_back(all_parameters[renaming.to[index(p)]]);
  return result;
}

void rename(ExactArc& arc, const Renaming& renaming) {
  for (Vector4& z : arc.samples) {
    const Vector4 old = z;
    for (std::size_t i = 0; i < 4; ++i) z[renaming.to[i]] = renaming.reversed[i] ? 1 - old[i] : old[i];
  }
}

/// The case's graph under other names, for the patches given.
ExactCase renamed(const ExactCase& c, const BezierPatch& x, const BezierPatch& y, const Renaming& renaming) {
  ExactCase result = {c.name, x, y, c.graph, renamed(c.turning, renaming)};
  for (ExactNode& node : result.graph.nodes) {
    const ExactPoint old = node.at;
    for (std::size_t i = 0; i < 4; ++i) {
      node.at[renaming.to[i]] = renaming.reversed[i] ? reversed(old[i]) : old[i];
    }
    node.wrt = renamed(node.wrt, renaming);
    node.free = renamed(node.free, renaming);
  }
  for (ExactArc& arc : result.graph.arcs) rename(arc, renaming);
  for (auto& overlap : result.graph.overlaps) {
    for (auto& chain : overlap) {
      for (ExactArc& arc : chain) rename(arc, renaming);
    }
  }
  return result;
}

ExactCase mapped(const ExactCase& c, const random_pairs::AffineMap& map) {
  return renamed(c, map(c.x), map(c.y), {});
}

random_pairs::AffineMap dyadic_map(random_pairs::Generator& generator) {
  const auto entry = [&] {
    return Rational(random_pairs::integer(generator, -(1L << 20), 1L << 20), 1L << 20);
  };
  random_pairs::AffineMap map;
  do {
    for (Point& row : map.rows) row = {entry(), entry(), entry()};
  } while (determinant(map.rows[0], map.rows[1], map.rows[2]) == 0);
  map.translation = {entry(), entry(), entry()};
  return map;
}

}  // namespace

std::string difference(const IntersectResult& result, const ExactCase& expected) {
  if (result.status == Status::incomplete) return "incomplete: " + result.incomplete.at(0).why;
  try {
    Comparison(result.graph, expected).run();
    return "";
  } catch (const Different& different) {
    return different.what();
  }
}

std::string failure(const ExactCase& expected) {
  IntersectOptions options;
  options.turning = expected.turning;
  options.tolerance = 1e-5;
  const IntersectResult result = intersect(expected.x, expected.y, options);
  std::string found = difference(result, expected);
  if (!found.empty() || result.work.steps.count("filtered") == 0) return found;
  options.exact = true;
  found = difference(intersect(expected.x, expected.y, options), expected);
  return found.empty() ? difference(intersect_exactly(expected.x, expected.y, options), expected) : found;
}

ExactArc arc_along(std::size_t from, std::size_t to, Contact contact, ArcPlace place,
                   const std::function<std::array<double, 4>(double)>& point) {
  ExactArc arc{from, to, place, contact, {}};
  constexpr int count = 24;
  for (int k = 0; k <= count; ++k) arc.samples.push_back(point(static_cast<double>(k) / count));
  return arc;
}

std::vector<CaseChange> case_changes() {
  using random_pairs::Generator;
  return {{"patches exchanged",
           [](const ExactCase& c, Generator&) {
             return renamed(c, c.y, c.x, {{2, 3, 0, 1}, {}});
           }},
          {"u and v exchanged",
           [](const ExactCase& c, Generator&) {
             return renamed(c, c.x.exchanged(), c.y, {{1, 0, 2, 3}, {}});
           }},
          {"r and s exchanged",
           [](const ExactCase& c, Generator&) {
             return renamed(c, c.x, c.y.exchanged(), {{0, 1, 3, 2}, {}});
           }},
          {"u and s reversed",
           [](const ExactCase& c, Generator&) {
             return renamed(c, c.x.reversed_first(), c.y.reversed_second(),
                            {{0, 1, 2, 3}, {true, false, false, true}});
           }},
          {"v and r reversed",
           [](const ExactCase& c, Generator&) {
             return renamed(c, c.x.reversed_second(), c.y.reversed_first(),
                            {{0, 1, 2, 3}, {false, true, true, false}});
           }},
          {"mapped affinely",
           [](const ExactCase& c, Generator& generator) {
             return mapped(c, random_pairs::affine_map(generator));
           }},
          {"mapped by 20-bit dyadic numbers",
           [](const ExactCase& c, Generator& generator) { return mapped(c, dyadic_map(generator)); }}};
}

bool in_doubles(const ExactCase& c) {
  for (const BezierPatch* patch : {&c.x, &c.y}) {
    for (const auto& row : patch->net()) {
      for (const Point& p : row) {
        for (const Rational& a : p) {
          if (from_double(to_double(a)) != a) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace exsect

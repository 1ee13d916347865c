#include "support/graph_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "support/oracle.h"

namespace exsect {
namespace {

using Vector4 = std::array<double, 4>;

struct Violation : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require(bool holds, const std::string& what) {
  if (!holds) throw Violation(what);
}

std::string text(const Vector4& z) {
  std::string result;
  for (const double a : z) result += (result.empty() ? "(" : ", ") + std::to_string(a);
  return result + ")";
}

bool is_free(const Node& node, std::size_t i) {
  return std::any_of(node.free.begin(), node.free.end(), [&](Parameter p) { return index(p) == i; });
}

/// Bound of |x_u| and of |x_v| on the unit square, by coordinate.
Rational slope(const BezierPatch& x, std::size_t coordinate) {
  const ControlNet& net = x.net();
  Rational largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      largest = std::max<Rational>(largest, abs(Rational(net[i][j + 1][coordinate] - net[i][j][coordinate])));
      largest = std::max<Rational>(largest, abs(Rational(net[j + 1][i][coordinate] - net[j][i][coordinate])));
    }
  }
  return 2 * largest;
}

/// The domain of the property: x and y over the box have a common point, as far as slopes can tell.
void check_on_both(const BezierPatch& x, const BezierPatch& y, const Node& node) {
  std::array<Rational, 4> middle;
  std::array<Rational, 4> reach;
  for (std::size_t i = 0; i < 4; ++i) {
    middle[i] = (node.box[i].lower + node.box[i].upper) / 2;
    reach[i] = is_free(node, i) ? Rational(0) : Rational((node.box[i].upper - node.box[i].lower) / 2);
  }
  for (const Rational& at : {Rational(0), Rational(1, 3), Rational(1)}) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_free(node, i)) middle[i] = node.box[i].lower + at * (node.box[i].upper - node.box[i].lower);
    }
    const Point d = x(middle[0], middle[1]) - y(middle[2], middle[3]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational bound = slope(x, k) * (reach[0] + reach[1]) + slope(y, k) * (reach[2] + reach[3]);
      require(abs(d[k]) <= bound, "a node that is not on both patches: " + text(node.approx));
    }
    if (node.free.empty()) return;
  }
}

void check_node(const BezierPatch& x, const BezierPatch& y, const Node& node) {
  for (std::size_t i = 0; i < 4; ++i) {
    const RationalInterval& side = node.box[i];
    require(0 <= side.lower && side.lower <= side.upper && side.upper <= 1,
            "a node's box outside the domain");
  }
  for (const Side& side : node.on) {
    const RationalInterval& i = node.box[index(side.parameter)];
    require(i.lower == side.value && i.upper == side.value,
            "a node's box off its side: " + text(node.approx));
  }
  check_on_both(x, y, node);
}

double distance(const Point& p, const std::array<double, 3>& q) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::pow(to_double(p[k]) - q[k], 2);
  return std::sqrt(sum);
}

double size_of(const BezierPatch& x) {
  double size = 0;
  for (const auto& row : x.net()) {
    for (const Point& p : row) {
      for (const Rational& a : p) size = std::max(size, std::fabs(to_double(a)));
    }
  }
  return size;
}

void check_arc(const BezierPatch& x, const BezierPatch& y, const IntersectionGraph& graph, const Arc& arc) {
  const auto node = [&](int id) -> const Node& { return graph.nodes.at(static_cast<std::size_t>(id)); };
  require(node(arc.from).id == arc.from && node(arc.to).id == arc.to, "an arc's end is no node");
  require(arc.polyline.size() >= 2, "an arc without a polyline");
  require(std::isfinite(arc.error_bound) && arc.error_bound >= 0, "an arc without a bound");
  const double bound = arc.error_bound + 1e-12 * (size_of(x) + size_of(y));
  for (const PolylineVertex& vertex : arc.polyline) {
    const Vector4& z = vertex.parameters;
    for (const double a : z) require(a >= 0 && a <= 1, "a vertex outside the domain: " + text(z));
    const Point on_x = x(from_double(z[0]), from_double(z[1]));
    const Point on_y = y(from_double(z[2]), from_double(z[3]));
    require(distance(on_x, vertex.point) <= bound && distance(on_y, vertex.point) <= bound,
            "a vertex off the patches: " + text(z));
  }
}

ComponentShape shape_of(const IntersectionGraph& graph, const Component& component) {
  std::map<int, int> degree;
  for (const int id : component.arcs) {
    const Arc& arc = graph.arcs.at(static_cast<std::size_t>(id));
    ++degree[arc.from];
    ++degree[arc.to];
  }
  bool branched = false;
  bool ends = false;
  for (const auto& [node, count] : degree) {
    branched = branched || count > 2;
    ends = ends || count == 1;
  }
  return branched ? ComponentShape::branched : ends ? ComponentShape::open : ComponentShape::closed;
}

void check_components(const IntersectionGraph& graph) {
  std::vector<int> node_component(graph.nodes.size(), -1);
  std::size_t arcs = 0;
  for (const Component& component : graph.components) {
    require(!component.arcs.empty(), "a component without arcs");
    require(component.shape == shape_of(graph, component), "the shape of a component");
    arcs += component.arcs.size();
    for (const int id : component.arcs) {
      const Arc& arc = graph.arcs.at(static_cast<std::size_t>(id));
      require(arc.component == component.id, "an arc's component");
      for (const int end : {arc.from, arc.to}) {
        int& owner = node_component.at(static_cast<std::size_t>(end));
        require(owner == -1 || owner == component.id, "components that share a node");
        owner = component.id;
      }
    }
  }
  require(arcs == graph.arcs.size(), "an arc in no component or in two");
  for (const int id : graph.isolated_points) {
    require(node_component.at(static_cast<std::size_t>(id)) == -1, "an isolated point with an arc");
  }
}

double parameter_distance(const Vector4& z, const Arc& arc) {
  double best = HUGE_VAL;
  for (std::size_t k = 1; k < arc.polyline.size(); ++k) {
    const Vector4& a = arc.polyline[k - 1].parameters;
    const Vector4& b = arc.polyline[k].parameters;
    double along = 0;
    double length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      along += (b[i] - a[i]) * (z[i] - a[i]);
      length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool free =
          std::any_of(arc.free.begin(), arc.free.end(), [&](Parameter p) { return index(p) == i; });
      if (!free) largest = std::max(largest, std::fabs(a[i] + t * (b[i] - a[i]) - z[i]));
    }
    best = std::min(best, largest);
  }
  return best;
}

constexpr double same_parameters = 2e-2;

bool shown(const IntersectionGraph& graph, const std::array<Rational, 4>& z) {
  const auto in_box = [&](const Node& node) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (z[i] < node.box[i].lower || z[i] > node.box[i].upper) return false;
    }
    return true;
  };
  if (std::any_of(graph.nodes.begin(), graph.nodes.end(), in_box)) return true;
  const Vector4 near = {to_double(z[0]), to_double(z[1]), to_double(z[2]), to_double(z[3])};
  return std::any_of(graph.arcs.begin(), graph.arcs.end(),
                     [&](const Arc& arc) { return parameter_distance(near, arc) < same_parameters; });
}

int compare_coincidences(const BezierPatch& x, const BezierPatch& y, const IntersectionGraph& graph) {
  const std::array<Rational, 5> values = {Rational(0), Rational(1, 3), Rational(1, 2), Rational(2, 3),
                                          Rational(1)};
  int count = 0;
  for (const Rational& u : values) {
    for (const Rational& v : values) {
      const Point p = x(u, v);
      for (const Rational& r : values) {
        for (const Rational& s : values) {
          if (y(r, s) != p) continue;
          ++count;
          const Vector4 z = {to_double(u), to_double(v), to_double(r), to_double(s)};
          require(shown(graph, {u, v, r, s}), "a common point is missing: " + text(z));
        }
      }
    }
  }
  return count;
}

/// The arcs that cross the parameter's value: between nodes on both sides, as turning points are nodes.
std::vector<const Arc*> arcs_over(const IntersectionGraph& graph, std::size_t i, const Rational& value) {
  std::vector<const Arc*> result;
  for (const Arc& arc : graph.arcs) {
    const RationalInterval& a = graph.nodes.at(static_cast<std::size_t>(arc.from)).box[i];
    const RationalInterval& b = graph.nodes.at(static_cast<std::size_t>(arc.to)).box[i];
    if ((a.upper < value && value < b.lower) || (b.upper < value && value < a.lower)) result.push_back(&arc);
  }
  return result;
}

/// False if the oracle doubts.
bool compare_line(const BezierPatch& x, const BezierPatch& y, const IntersectionGraph& graph, std::size_t i,
                  double value) {
  const oracle::LinePoints line = oracle::line_points(x, y, i, value);
  if (!line.conclusive()) return false;
  std::vector<const Arc*> arcs = arcs_over(graph, i, from_double(value));
  const std::string place = std::string(name(all_parameters[i])) + " = " + std::to_string(value);
  require(arcs.size() == line.points.size(), std::to_string(arcs.size()) + " arcs for " +
                                                 std::to_string(line.points.size()) + " points at " + place);
  for (const Vector4& z : line.points) {
    const auto near = std::find_if(arcs.begin(), arcs.end(), [&](const Arc* arc) {
      return parameter_distance(z, *arc) < same_parameters;
    });
    require(near != arcs.end(), "no arc at " + text(z));
  }
  return true;
}

}  // namespace

std::string unsound(const BezierPatch& x, const BezierPatch& y, const IntersectResult& result) {
  try {
    require((result.status == Status::complete) == result.incomplete.empty(), "status and reasons disagree");
    for (const Node& node : result.graph.nodes) check_node(x, y, node);
    for (const Arc& arc : result.graph.arcs) check_arc(x, y, result.graph, arc);
    for (const Overlap& overlap : result.graph.overlaps) {
      for (const auto& chain : overlap.chains) {
        for (const Arc& arc : chain) check_arc(x, y, result.graph, arc);
      }
    }
    check_components(result.graph);
    return "";
  } catch (const Violation& violation) {
    return violation.what();
  }
}

Comparison compare_with_oracle(const BezierPatch& x, const BezierPatch& y, const IntersectionGraph& graph) {
  Comparison result;
  if (!graph.overlaps.empty()) return result;
  try {
    result.coincidences = compare_coincidences(x, y, graph);
    const bool free =
        std::any_of(graph.arcs.begin(), graph.arcs.end(), [](const Arc& a) { return !a.free.empty(); });
    for (std::size_t i = 0; i < 4 && !free; ++i) {
      // At a side that is one point arcs end at values of a free parameter that its node does not tell.
      if (std::any_of(graph.nodes.begin(), graph.nodes.end(),
                      [&](const Node& node) { return is_free(node, i); }))
        continue;
      for (const double value : {0.15434, 0.43771, 0.82903}) {
        result.lines += compare_line(x, y, graph, i, value) ? 1 : 0;
      }
    }
  } catch (const Violation& violation) {
    result.difference = violation.what();
  }
  return result;
}

}  // namespace exsect

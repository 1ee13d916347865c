#include "certificate/free.h"

#include <exsect/geometry/number.h>

#include <algorithm>
#include <map>

namespace exsect::cli {
namespace {

/// The value of the parameter where the arc reaches a node, a short rational near that of the polyline.
Rational reached(const PolylineVertex& vertex, std::size_t p) {
  const Rational value = from_double(vertex.parameters[p]);
  const Rational width = power_of_two(-30);
  return std::clamp<Rational>(simplest_between(value - width, value + width), 0, 1);
}

class FreeNode {
 public:
  FreeNode(IntersectionGraph& graph, int id)
      : graph_(graph), node_(graph.nodes[static_cast<std::size_t>(id)]), p_(index(node_.free[0])) {}

  /// Returns the new arcs.
  std::vector<int> expand() {
    std::map<Rational, bool> reached_by_others = {{0, false}, {1, false}};
    for (const Arc& arc : graph_.arcs) {
      if (arc.from == node_.id) reached_by_others[reached(arc.polyline.front(), p_)] = true;
      if (arc.to == node_.id) reached_by_others[reached(arc.polyline.back(), p_)] = true;
    }
    std::map<Rational, int> nodes;
    for (const auto& [value, others] : reached_by_others) nodes[value] = add_node(value, others);
    for (Arc& arc : graph_.arcs) {
      const int from = arc.from == node_.id ? nodes[reached(arc.polyline.front(), p_)] : arc.from;
      arc.to = arc.to == node_.id ? nodes[reached(arc.polyline.back(), p_)] : arc.to;
      arc.from = from;
    }
    std::vector<int> arcs;
    for (auto next = std::next(nodes.begin()); next != nodes.end(); ++next)
      arcs.push_back(add_arc(std::prev(next)->second, next->second));
    return arcs;
  }

 private:
  /// The first one takes the place of the node.
  int add_node(const Rational& value, bool others) {
    Node node = node_;
    if (value > 0) node.id = static_cast<int>(graph_.nodes.size());
    node.free.clear();
    node.wrt.clear();
    node.kinds = {others ? NodeKind::crossing : NodeKind::boundary};
    if (value == 0 || value == 1) node.on.push_back({all_parameters[p_], value == 0 ? 0 : 1});
    node.box[p_] = {value, value};
    node.approx[p_] = to_double(value);
    if (value > 0)
      graph_.nodes.push_back(node);
    else
      graph_.nodes[static_cast<std::size_t>(node.id)] = node;
    return node.id;
  }

  int add_arc(int from, int to) {
    const auto vertex = [&](int n) {
      return PolylineVertex{graph_.nodes[static_cast<std::size_t>(n)].approx, node_.point};
    };
    const int id = static_cast<int>(graph_.arcs.size());
    const ArcPlace place = node_.on.empty() ? ArcPlace::interior : ArcPlace::patch_boundary;
    graph_.arcs.push_back(
        {id, -1, from, to, place, Contact::transversal, {vertex(from), vertex(to)}, 0x1p-40});
    return id;
  }

  IntersectionGraph& graph_;
  const Node node_;
  const std::size_t p_;
};

ComponentShape shape_of(const IntersectionGraph& graph, const Component& component) {
  std::map<int, int> degrees;
  for (const int a : component.arcs) {
    ++degrees[graph.arcs[static_cast<std::size_t>(a)].from];
    ++degrees[graph.arcs[static_cast<std::size_t>(a)].to];
  }
  const auto any = [&](auto is) {
    return std::any_of(degrees.begin(), degrees.end(), [&](const auto& d) { return is(d.second); });
  };
  return any([](int d) { return d > 2; })    ? ComponentShape::branched
         : any([](int d) { return d == 1; }) ? ComponentShape::open
                                             : ComponentShape::closed;
}

}  // namespace

IntersectionGraph with_free_arcs(IntersectionGraph graph) {
  const std::size_t nodes = graph.nodes.size();
  for (std::size_t n = 0; n < nodes; ++n) {
    if (graph.nodes[n].free.size() != 1) continue;
    const int id = static_cast<int>(n);
    const auto reaches = [&](const Arc& arc) { return arc.from == id || arc.to == id; };
    const auto other = std::find_if(graph.arcs.begin(), graph.arcs.end(), reaches);
    int c = static_cast<int>(graph.components.size());
    if (other != graph.arcs.end())
      c = other->component;
    else
      graph.components.push_back({c, ComponentShape::open, {}});
    auto& isolated = graph.isolated_points;
    isolated.erase(std::remove(isolated.begin(), isolated.end(), id), isolated.end());
    Component& component = graph.components[static_cast<std::size_t>(c)];
    for (const int arc : FreeNode(graph, id).expand()) {
      graph.arcs[static_cast<std::size_t>(arc)].component = c;
      component.arcs.push_back(arc);
    }
    component.shape = shape_of(graph, component);
  }
  return graph;
}

}  // namespace exsect::cli

// Nodes of curves, and points of a line.
#pragma once

#include "check_tubes.h"

namespace exsect::checker {

template <class N>
class NodeCheck {
 public:
  explicit NodeCheck(const Replay<N>& replay) : replay_(replay), nodes_(replay.certificate.nodes) {}

  void check(std::size_t i) const {
    const Node<N>& node = nodes_[i];
    const bool cusp = node.star >= 0 ? false : check_in_tube(node);
    for (std::size_t k = 0; k <= i; ++k) {
      const auto& [u, v, r, s] = nodes_[k].at;
      require(k == i || disjoint(node.at, nodes_[k].at, node.radius + nodes_[k].radius),
              "its box meets the box of an earlier node");
      require(!replay_.certificate.self || (k == i && cusp) ||
                  disjoint(node.at, {r, s, u, v}, node.radius + nodes_[k].radius),
              "its box meets the mirrored box of a node");
    }
  }

  static bool disjoint(const Vector4<N>& a, const Vector4<N>& b, const N& radius) {
    for (std::size_t j = 0; j < 4; ++j)
      if (magnitude(N(a[j] - b[j])) > radius) return true;
    return false;
  }

 private:
  /// The node is on the curve of its tube, in its box; true if it is a cuspidal point.
  bool check_in_tube(const Node<N>& node) const {
    const ProvedTube<N>& tube = element(replay_.tubes, node.tube, "names no tube");
    const Box<N> box = node_box(tube.claim, node);
    require(node.radius > 0 && tube.claim.contains(box), "its box is not in its tube");
    for (std::size_t j = 0; j < 4; ++j) check_parameter(node, j);
    const N near = distance(tube, middles(box));
    require(near <= node.radius, "its box may miss the curve");
    require(node.on.empty() || node.wrt.empty(), "both on a side and a turning point");
    if (!node.on.empty())
      check_sides(node, tube);
    else if (tube.claim.chart == Chart::pair)
      check_turning(node, tube, near);
    return tube.claim.chart != Chart::pair;
  }

  /// On one of the two sides or strictly between them.
  static void check_parameter(const Node<N>& node, std::size_t j) {
    int sides = 0;
    for (const Side& side : node.on) {
      if (side.parameter != j) continue;
      ++sides;
      require(node.place[j] == side.value, "not on the side it is said to be on");
    }
    require(sides <= 1, "on two sides of one parameter");
    require(sides == 1 || (node.at[j] - node.radius > 0 && node.at[j] + node.radius < 1),
            "its box leaves (0,1)");
  }

  /// The component of the tube's map is monotone in w_i.
  bool monotone(const ProvedTube<N>& tube, std::size_t d, std::size_t i) const {
    const Map<N> local = tube.map.at(tube.claim.centre);
    return Ranges(local, tube.claim.extent()).first(i)[d].sign() != 0;
  }

  /// The axis is one of the sides; another one follows if a component of the map is monotone in its parameter
  /// and vanishes wherever it and those known hold; or `at` is a solution.
  void check_sides(const Node<N>& node, const ProvedTube<N>& tube) const {
    std::vector<Side> open = node.on;
    std::vector<Side> known;
    const auto follows = [&](const Side& side) {
      if (known.empty()) return side.parameter == tube.claim.axis;
      std::vector<Side> all = known;
      all.push_back(side);
      for (std::size_t d = 0; d < 3; ++d)
        if (vanishes(replay_.exact_map(tube.claim), d, all) && monotone(tube, d, side.parameter)) return true;
      return false;
    };
    while (!open.empty()) {
      const auto next = std::find_if(open.begin(), open.end(), follows);
      require(next != open.end() || !known.empty(), "its tube has another axis");
      if (next == open.end() && is_solution(replay_.exact, node.place)) break;
      require(next != open.end(), "a side does not follow from that of the tube's axis");
      known.push_back(*next);
      open.erase(next);
    }
  }

  /// i and j turn together: a component of the map is a product g h, where h, without them, is not 0, and g,
  /// of them alone, is monotone in both.
  bool related(const ProvedTube<N>& tube, std::size_t i, std::size_t j) const {
    for (std::size_t d = 0; d < 3; ++d)
      if (monotone(tube, d, i) && monotone(tube, d, j) &&
          separates(component(replay_.exact_map(tube.claim), d), i, j))
        return true;
    return false;
  }

  /// w' has exactly one zero on the tube's curve, and it is in the node's box.
  void check_turning(const Node<N>& node, const ProvedTube<N>& tube, const N& near) const {
    require(!node.wrt.empty(), "neither on a side nor a turning point");
    const std::size_t i = node.wrt[0];
    const std::size_t k = tube.claim.axis;
    const Ball<N>& second = tube.bounds.second[i];
    require(i != k && second.sign() != 0, "the second derivative may vanish");
    for (std::size_t j = 1; j < node.wrt.size(); ++j) {
      require(node.wrt[j - 1] < node.wrt[j], "parameters not in order");
      require(std::any_of(node.wrt.begin(), node.wrt.begin() + static_cast<std::ptrdiff_t>(j),
                          [&](std::size_t other) { return related(tube, other, node.wrt[j]); }),
              "the parameters need not turn together");
    }
    const Box<N> t = tangent(tube.map.at(node.at), {near, near, near, near});
    require(t[k].sign() != 0, "no derivative here");
    // |w'| / min|w''| bounds the distance from the zero, along the axis.
    const N away = t[i].magnitude() / (t[k].least() * second.least());
    require(magnitude(N(node.at[k] - tube.claim.centre[k])) + away <= tube.claim.reach,
            "the turning point may be outside its tube");
    for (std::size_t j = 0; j < 4; ++j)
      require(near + away * tube.bounds.first[j].magnitude() <= node.radius,
              "its box may miss the turning point");
  }

  const Replay<N>& replay_;
  const std::vector<Node<N>>& nodes_;
};

/// A point of a parameter line: alone in the slice of its tube.
template <class N>
void check_point(const Replay<N>& replay, std::size_t i) {
  const std::vector<Node<N>>& points = replay.certificate.nodes;
  const Node<N>& point = points[i];
  const ProvedTube<N>& tube = element(replay.tubes, point.tube, "names no tube");
  require(tube.claim.axis == replay.certificate.fixed->parameter, "its tube has another axis");
  require(point.radius > 0 && distance(tube, point.at) <= point.radius, "its box may miss the solution");
  const N margin = is_solution(replay.exact, point.place) ? N(0) : point.radius;
  for (const std::size_t j : others(tube.claim.axis))
    require(point.at[j] - margin >= 0 && point.at[j] + margin <= 1, "its box leaves [0,1]");
  for (std::size_t m = 0; m < i; ++m)
    require(NodeCheck<N>::disjoint(point.at, points[m].at, point.radius + points[m].radius),
            "its box meets that of an earlier point");
}

}  // namespace exsect::checker

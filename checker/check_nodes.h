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
    const bool star = node.star >= 0;
    const std::string where = star ? place("stars", static_cast<std::size_t>(node.star)) : place("nodes", i);
    const bool cusp = star ? false : check_in_tube(node, where);
    for (std::size_t k = 0; k <= i; ++k) {
      const auto& [u, v, r, s] = nodes_[k].at;
      require(k == i || disjoint(node.at, nodes_[k].at, node.radius + nodes_[k].radius), where,
              "its box meets the box of an earlier node");
      require(!replay_.certificate.self || (k == i && cusp) ||
                  disjoint(node.at, {r, s, u, v}, node.radius + nodes_[k].radius),
              where, "its box meets the mirrored box of a node");
    }
  }

  static bool disjoint(const Vector4<N>& a, const Vector4<N>& b, const N& radius) {
    for (std::size_t j = 0; j < 4; ++j)
      if (magnitude(N(a[j] - b[j])) > radius) return true;
    return false;
  }

 private:
  /// The node is on the curve of its tube, in its box; true if it is a cuspidal point.
  bool check_in_tube(const Node<N>& node, const std::string& where) const {
    const ProvedTube<N>& tube = element(replay_.tubes, node.tube, where, "names no tube");
    const Box<N> box = node_box(tube.claim, node, where);
    require(node.radius > 0 && tube.claim.contains(box), where, "its box is not in its tube");
    for (std::size_t j = 0; j < 4; ++j) check_parameter(node, j, where);
    const N near = distance(replay_, tube, middles(box), where);
    require(near <= node.radius, where, "its box may miss the curve");
    require(node.on.empty() || node.wrt.empty(), where, "both on a side and a turning point");
    if (!node.on.empty())
      check_sides(node, tube, where);
    else if (tube.claim.chart == Chart::pair)
      check_turning(node, tube, near, where);
    return tube.claim.chart != Chart::pair;
  }

  /// On one of the two sides or strictly between them.
  void check_parameter(const Node<N>& node, std::size_t j, const std::string& where) const {
    const auto on =
        std::count_if(node.on.begin(), node.on.end(), [&](const Side& s) { return s.parameter == j; });
    if (on == 0)
      require(node.at[j] - node.radius > 0 && node.at[j] + node.radius < 1, where, "its box leaves (0,1)");
    else
      require(on == 1, where, "on two sides of one parameter");
  }

  /// There is a relation between i and j, and, if sides are meant, i = a exactly where j = b.
  bool related(std::size_t i, std::size_t j, const std::optional<std::array<int, 2>>& values) const {
    if (i > j) return related(j, i, values ? std::optional(std::array{(*values)[1], (*values)[0]}) : values);
    const auto& relations = replay_.certificate.relations;
    return std::any_of(relations.begin(), relations.end(), [&](const Relation& relation) {
      if (relation.first != i || relation.second != j) return false;
      const auto value = [&](std::size_t p, int t) {
        const auto f = *in_one_parameter(replay_.exact[p / 2], relation, p);
        return Rational(t == 0 ? f[0] : f[0] + f[1] + f[2]);
      };
      return !values || value(i, (*values)[0]) == value(j, (*values)[1]);
    });
  }

  /// The axis is one of the sides; all other sides are constant on the line that the curve is, or follow by
  /// relations, or `at` is a solution.
  void check_sides(const Node<N>& node, const ProvedTube<N>& tube, const std::string& where) const {
    std::vector<Side> open = node.on;
    for (const Side& side : open)
      require(node.at[side.parameter] == side.value, where, "not on the side it is said to be on");
    std::vector<Side> known;
    const auto follows = [&](const Side& side) {
      const auto by_relation = [&](const Side& other) {
        return related(other.parameter, side.parameter, std::array{other.value, side.value});
      };
      return side.parameter == tube.claim.axis ||
             (tube.constant[side.parameter] &&
              replay_.certificate.lines[static_cast<std::size_t>(tube.claim.line)].at[side.parameter][0] ==
                  side.value) ||
             std::any_of(known.begin(), known.end(), by_relation);
    };
    while (!open.empty()) {
      const auto next = std::find_if(open.begin(), open.end(), follows);
      if (next == open.end() && is_zero_at(replay_.exact, node.place)) break;
      require(next != open.end(), where, "a side does not follow from that of the tube's axis");
      known.push_back(*next);
      open.erase(next);
    }
    const auto on_axis = [&](const Side& side) { return side.parameter == tube.claim.axis; };
    require(std::any_of(node.on.begin(), node.on.end(), on_axis), where, "its tube has another axis");
  }

  /// w' has exactly one zero on the tube's curve, and it is in the node's box.
  void check_turning(const Node<N>& node, const ProvedTube<N>& tube, const N& near,
                     const std::string& where) const {
    require(!node.wrt.empty(), where, "neither on a side nor a turning point");
    const std::size_t i = node.wrt[0];
    const Ball<N>& second = tube.bounds.second[i];
    require(i != tube.claim.axis && second.sign() != 0, where, "the second derivative may vanish");
    for (std::size_t j = 1; j < node.wrt.size(); ++j) {
      require(node.wrt[j - 1] < node.wrt[j], where, "parameters not in order");
      require(std::any_of(node.wrt.begin(), node.wrt.begin() + static_cast<std::ptrdiff_t>(j),
                          [&](std::size_t k) { return related(k, node.wrt[j], std::nullopt); }),
              where, "no relation makes the parameters turn together");
    }
    const Box<N> t = tangent(replay_.equation[0].at(node.at), {near, near, near, near});
    require(t[tube.claim.axis].sign() != 0, where, "no derivative here");
    // |w'| / min|w''| bounds the distance from the zero, along the axis.
    const N away = t[i].magnitude() / (t[tube.claim.axis].least() * second.least());
    const N axis = node.at[tube.claim.axis] - tube.claim.centre[tube.claim.axis];
    require(magnitude(axis) + away <= tube.claim.reach, where, "the turning point may be outside its tube");
    for (std::size_t j = 0; j < 4; ++j)
      require(near + away * tube.bounds.first[j].magnitude() <= node.radius, where,
              "its box may miss the turning point");
  }

  const Replay<N>& replay_;
  const std::vector<Node<N>>& nodes_;
};

/// The points of a parameter line: each alone in the slice of its tube.
template <class N>
void check_points(const Replay<N>& replay) {
  const Certificate<N>& certificate = replay.certificate;
  const std::size_t k = certificate.fixed->parameter;
  const std::vector<Node<N>>& points = certificate.nodes;
  std::vector<bool> used(replay.tubes.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string where = place("points", i);
    const Node<N>& point = points[i];
    const ProvedTube<N>& tube = element(replay.tubes, point.tube, where, "names no tube");
    require(tube.claim.axis == k, where, "its tube has another axis");
    used[point.tube] = true;
    require(point.radius > 0 && distance(replay, tube, point.at, where) <= point.radius, where,
            "its box may miss the solution");
    const N margin = is_zero_at(replay.exact, point.place) ? N(0) : point.radius;
    for (const std::size_t j : others(k))
      require(point.at[j] - margin >= 0 && point.at[j] + margin <= 1, where, "its box leaves [0,1]");
    for (std::size_t m = 0; m < i; ++m)
      require(NodeCheck<N>::disjoint(point.at, points[m].at, point.radius + points[m].radius), where,
              "its box meets that of an earlier point");
  }
  for (std::size_t i = 0; i < used.size(); ++i) require(used[i], place("tubes", i), "no point is in it");
  const std::array<std::size_t, 9> claims = {0, 0, 0, used.size(), points.size(), 0, certificate.cover.size(),
                                             0, 0};
  require(certificate.summary.claims == claims, "$.summary", "does not agree with the claims");
}

}  // namespace exsect::checker

// Connected parts of the arcs of one factor of a curve in space. Internal to solver/.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace exsect {

/// A number for each of the connected parts.
class ConnectedParts {
 public:
  /// Of a curve with nodes, and with arcs that have ends `from` and `to` and a factor.
  template <class Curve>
  ConnectedParts(const Curve& curve, std::size_t factor) : parent_(curve.nodes.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const auto& arc : curve.arcs)
      if (arc.factor == factor) parent_[root(arc.from)] = root(arc.to);
  }

  template <class Arc>
  int operator()(const Arc& arc) const {
    return static_cast<int>(root(arc.from));
  }

 private:
  std::size_t root(std::size_t node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }

  std::vector<std::size_t> parent_;
};

}  // namespace exsect

// Checks of a self-intersection in both orders of the parameters.
#pragma once

#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/catch.h"
#include "support/graph_checks.h"
#include "support/self_locus.h"

namespace exsect::testing {

/// Nine control points, row by row.
inline BezierPatch patch(const std::vector<int>& coordinates) {
  ControlNet net;
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t k = 0; k < 3; ++k) net[i / 3][i % 3][k] = coordinates.at(3 * i + k);
  return BezierPatch(net);
}

/// Coordinates from -largest to largest.
inline BezierPatch random_patch(std::mt19937& generator, int largest) {
  std::uniform_int_distribution<int> coordinate(-largest, largest);
  std::vector<int> net(27);
  for (int& c : net) c = coordinate(generator);
  return patch(net);
}

/// Complete, sound, and with as many crossings of parameter lines as these have pairs, in both orders.
inline IntersectionGraph checked(const BezierPatch& x) {
  IntersectOptions options;
  options.tolerance = 1e-3;
  IntersectionGraph graph;
  for (const BezierPatch& patch : {x.exchanged(), x}) {
    const IntersectResult result = self_intersect(patch, options);
    for (const Incomplete& reason : result.incomplete) UNSCOPED_INFO(reason.why);
    REQUIRE(result.status == Status::complete);
    CHECK(unsound(patch, patch, result) == "");
    for (const std::size_t parameter : {0U, 1U})
      for (const Rational& value : {Rational(2, 13), Rational(27, 61), Rational(34, 41), Rational(60, 61)}) {
        INFO("parameter " << parameter << " = " << value);
        CHECK(polyline_crossings(result.graph, parameter, to_double(value)) ==
              static_cast<int>(self_fibre(patch, parameter, value).size()));
      }
    graph = result.graph;
  }
  return graph;
}

/// How many arcs end in each node of the kind, ascending.
inline std::vector<int> degrees(const IntersectionGraph& graph, NodeKind kind) {
  std::vector<int> result;
  for (const Node& node : graph.nodes) {
    if (std::ranges::count(node.kinds, kind) == 0) continue;
    result.push_back(0);
    for (const Arc& arc : graph.arcs)
      result.back() += (arc.from == node.id ? 1 : 0) + (arc.to == node.id ? 1 : 0);
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace exsect::testing

// A hand-made intersection result with every feature the writers know.
#pragma once

#include <exsect/solver/result.h>

namespace exsect {

inline ParameterBox box_around(const std::array<double, 4>& at) {
  ParameterBox box;
  for (std::size_t i = 0; i < 4; ++i) {
    box[i] = {at[i] == 0 || at[i] == 1 ? from_double(at[i]) : from_double(at[i]) - power_of_two(-40),
              at[i] == 0 || at[i] == 1 ? from_double(at[i]) : from_double(at[i]) + power_of_two(-40)};
  }
  return box;
}

inline Node node(int id, std::vector<NodeKind> kinds, std::vector<Side> on, std::vector<Parameter> wrt,
                 const std::array<double, 4>& at) {
  return {id, std::move(kinds), std::move(on), std::move(wrt), box_around(at), at, {at[0], at[1], at[2] / 3}};
}

inline Arc arc(int id, int component, int from, int to, const std::vector<std::array<double, 4>>& through,
               double error_bound) {
  Arc arc{id, component, from, to, ArcPlace::interior, Contact::transversal, {}, error_bound};
  for (const auto& at : through) arc.polyline.push_back({at, {at[0], at[1], at[2] / 3}});
  return arc;
}

/// An open component with a turning point, a closed one along a side and tangential, an isolated touch, an
/// overlap and an undecided region.
inline IntersectResult sample_result() {
  IntersectResult result{Status::incomplete, {}, {}, {12.5, {{"tubes", 42}}}};
  IntersectionGraph& graph = result.graph;
  graph.nodes = {node(0, {NodeKind::boundary}, {{Parameter::u, 0}}, {}, {0, 0.25, 0.125, 0.5}),
                 node(1, {NodeKind::turning}, {}, {Parameter::v}, {0.5, 0.75, 0.5, 0.75}),
                 node(2, {NodeKind::boundary, NodeKind::corner}, {{Parameter::r, 1}, {Parameter::s, 1}}, {},
                      {0.75, 0.5, 1, 1}),
                 node(3, {NodeKind::crossing}, {}, {Parameter::u, Parameter::s}, {0.25, 0.125, 0.25, 0.125}),
                 node(4, {NodeKind::touch}, {}, {}, {0.875, 0.875, 0.25, 0.75}),
                 node(5, {NodeKind::cusp, NodeKind::end_of_overlap}, {}, {}, {0.6, 0.1, 0.7, 0.2})};
  graph.nodes[4].free = {Parameter::r};
  graph.nodes[4].box[2] = {0, Rational(1) / 2};
  graph.arcs = {
      arc(0, 0, 0, 1, {{0, 0.25, 0.125, 0.5}, {0.25, 0.625, 0.25, 0.7}, {0.5, 0.75, 0.5, 0.75}}, 0.1),
      arc(1, 0, 1, 2, {{0.5, 0.75, 0.5, 0.75}, {0.75, 0.5, 1, 1}}, 1e-9),
      arc(2, 1, 3, 3,
          {{0.25, 0.125, 0.25, 0.125},
           {0.5, 0.125, 0.5, 0.125},
           {0.5, 0.25, 0.5, 0.25},
           {0.25, 0.125, 0.25, 0.125}},
          0)};
  graph.arcs[2].place = ArcPlace::patch_boundary;
  graph.arcs[2].contact = Contact::tangential;
  graph.arcs[2].free = {Parameter::s};
  graph.components = {{0, ComponentShape::open, {0, 1}}, {1, ComponentShape::closed, {2}}};
  graph.isolated_points = {4};
  graph.overlaps = {
      {0,
       {{arc(0, 0, 5, 4, {{0.6, 0.1, 0.7, 0.2}, {0.9, 0.1, 0.9, 0.2}, {0.875, 0.875, 0.25, 0.75}}, 1e-8),
         arc(1, 0, 5, 4, {{0.6, 0.1, 0.7, 0.2}, {0.875, 0.875, 0.25, 0.75}}, 1e-8)}}}};
  result.incomplete = {
      {{{{0, Rational(1) / 8}, {Rational(7) / 8, 1}, {0, 1}, {0, 1}}}, "not regular & not decided"}};
  return result;
}

}  // namespace exsect

// A pair of patches with its exact intersection, and the comparison of a computed result with it.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/intersect.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect {

/// (u,v,r,s), exact.
using ExactPoint = std::array<RealAlgebraic, 4>;

/// A node of the true graph. The sides it lies on, and that it is a boundary or corner point, follow from the
/// parameters.
struct ExactNode {
  ExactPoint at;
  /// touch, crossing, cusp or end_of_overlap: has to be among the kinds of the node. Empty: none of them may.
  std::optional<NodeKind> kind = std::nullopt;
  /// Not compared at a node that has a `kind`.
  std::vector<Parameter> wrt = {};
  /// These run through [0,1]; their entries in `at` are not used.
  std::vector<Parameter> free = {};
};

/// A piece of the curve between two nodes.
struct ExactArc {
  std::size_t from;  // indices of nodes
  std::size_t to;
  ArcPlace place;
  Contact contact;
  /// Points of the arc, within 1e-15, in order: both ends and at least one in between.
  std::vector<std::array<double, 4>> samples;
};

/// The true graph. Nodes that are in no arc are the isolated points.
struct ExactGraph {
  std::vector<ExactNode> nodes;
  std::vector<ExactArc> arcs;
  /// Of each overlap its closed chains of arcs; their place and contact are not compared.
  std::vector<std::vector<std::vector<ExactArc>>> overlaps = {};
};

struct ExactCase {
  std::string name;
  BezierPatch x;
  BezierPatch y;
  ExactGraph graph;
  /// The parameters whose turning points are among the nodes.
  std::vector<Parameter> turning = {all_parameters.begin(), all_parameters.end()};
};

/// Empty if the result is complete and its graph the true one: nodes in bijection, the exact parameters
/// inside the boxes, which are smaller than 1e-9, with the same kinds and sides; arcs in bijection, the
/// samples within the stated bound of the polylines; components of the right shapes; isolated points;
/// overlaps. Otherwise the first difference in words.
std::string difference(const IntersectResult& result, const ExactCase& expected);

/// difference(intersect(...)) with the case's parameters, in exact mode and, where they suffice, in doubles.
std::string failure(const ExactCase& expected);

/// The samples of an arc given by a map of [0,1].
ExactArc arc_along(std::size_t from, std::size_t to, Contact contact, ArcPlace place,
                   const std::function<std::array<double, 4>(double)>& point);

/// A change of a case that changes its graph by renaming alone.
struct CaseChange {
  const char* name;
  std::function<ExactCase(const ExactCase&, random_pairs::Generator&)> apply;
};
/// Patches exchanged, parameters exchanged, parameters reversed, coordinates mapped affinely (rational
/// entries), and mapped by a matrix of 20-bit dyadic numbers.
std::vector<CaseChange> case_changes();

/// True if every coordinate of both nets is a double.
bool in_doubles(const ExactCase& c);

}  // namespace exsect

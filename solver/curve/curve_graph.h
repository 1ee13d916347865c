// A plane algebraic curve f(u,v) = 0 in the closed unit square as a graph, exact: every singular and isolated
// point, multiple factors, parts on the sides. docs/method-equations.md, section 17.1.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/solver/curve_region.h>

#include <optional>
#include <vector>

namespace exsect {

/// A point (u,v) of the curve.
struct CurveNode {
  RealAlgebraic u;
  RationalInterval v;                    // closed, no other point of the curve over u in it
  std::optional<TriangularPoint> exact;  // with u as its s and v as its r; not of most turning points
  bool is_singular;                      // f_u = f_v = 0 for the product of the irreducible factors of f
  bool is_on_side;                       // of the square
  int left, right;                       // ends of arcs that come from smaller and from greater u
  int vertical;                          // ends of arcs on u = const
  bool turns_in_v = false;               // added by with_turning_in_v()
  int degree() const { return left + right + vertical; }
};

/// A connected piece of the curve without a node inside: the graph of a function of u from node `from` to
/// node `to`, of greater u, or a piece of a line u = const from smaller to greater v.
struct CurveBranch {
  std::size_t from;
  std::size_t to;
  int multiplicity;        // the exponent in f of the factor that vanishes on it
  TriangularPoint inside;  // one of its inner points
  std::size_t factor = 0;  // of CurveGraph::factors, which is 0 on it; 0 on lines u = const
};

/// The curve over an open interval between neighbouring critical values: of every zero of the swept curve in
/// [0,1], ascending in v, the position of its arc in CurveGraph::arcs, or CurveGraph::dropped.
using CurveColumn = std::vector<std::size_t>;

/// Of {f = 0}, or of its part in a region, in [0,1]^2. Nodes: singular points, isolated ones among them;
/// turning points u = const, which have two arcs from one side; points on the sides, but for inner points of
/// arcs that lie on v = 0 or v = 1; points on the rim of the region, all of them unless a bound vanishes on a
/// whole arc. Ascending in u. All other points of the curve are in exactly one arc.
struct CurveGraph {
  /// In a column: an arc outside the region.
  static constexpr std::size_t dropped = static_cast<std::size_t>(-1);

  std::vector<CurveNode> nodes;
  std::vector<CurveBranch> arcs;
  BivariatePolynomial swept;                 // the irreducible factors of f but those in u alone, each once
  std::vector<BivariatePolynomial> factors;  // coprime ones, whose product is `swept`
  std::vector<RealAlgebraic> values;  // critical ones: ascending from 0 to 1, with disjoint closed intervals
  std::vector<CurveColumn> columns;   // one fewer; column i lies between values i and i + 1
  bool is_monotone_in_v = false;      // every arc is known to be, as after with_turning_in_v()

  /// Nodes of degree 0.
  int isolated_points() const;
  /// Connected parts, isolated points among them.
  int components() const;
};

/// Throws std::domain_error for f = 0.
CurveGraph curve_graph(const BivariatePolynomial& f, const CurveRegion& region = {});
/// Of the product, which is not formed but for `swept`. Requires squarefree factors that are pairwise
/// coprime.
CurveGraph curve_graph_of_factors(const std::vector<BivariatePolynomial>& factors,
                                  const CurveRegion& region = {});

}  // namespace exsect

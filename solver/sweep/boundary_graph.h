// The part of the graph that lies on sides of the squares. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include <string>
#include <vector>

#include "side/boundary_lines.h"
#include "star/star_neighbourhood.h"
#include "trace/trace_graph.h"

namespace exsect {

/// Other arcs than those on sides end in the star. Else its centre is a point like any other on its side:
/// which of these are critical values depends on the sweep.
bool leaves_sides(const StarNeighbourhood& star);

/// Adds the arcs on sides to a graph whose node i is that of boundary point i, and `star_nodes` those of the
/// stars.
template <class Ball>
class BoundaryGraph {
 public:
  struct Patches {
    const BezierPatch& x;
    const BezierPatch& y;
  };

  BoundaryGraph(const Patches& pair, const PairSystem<Ball>& system, const ModelFrame& frame,
                const BoundaryLines& sides, const std::vector<StarNeighbourhood>& stars,
                const std::vector<int>& star_nodes, GraphBuilder& graph, std::vector<Incomplete>& undecided)
      : pair_(pair),
        system_(system),
        frame_(frame),
        sides_(sides),
        stars_(stars),
        star_nodes_(star_nodes),
        graph_(graph),
        undecided_(undecided) {}

  /// The arcs on sides that are curves.
  void add_arcs();

  /// Sides that are one point, and common poles: all nodes on them are one. To be called last.
  void contract();

 private:
  void incomplete(const ParameterBox& where, const std::string& why);
  void add_side_arc(const SideArc& whole);
  void contract_side(const SideArc& arc);
  void contract_pole(const CommonPole& pole);
  bool lies_inside(const CertifiedPoint& centre, const SideArc& arc, const Side& side, std::size_t along);
  void push_side_arc(int from, int to, const SideArc& whole, const std::vector<PolylineVertex>& polyline,
                     bool tangential);
  bool tangential_at(const CertifiedPoint& inside);

  Patches pair_;
  const PairSystem<Ball>& system_;
  const ModelFrame& frame_;
  const BoundaryLines& sides_;
  const std::vector<StarNeighbourhood>& stars_;
  const std::vector<int>& star_nodes_;
  GraphBuilder& graph_;
  std::vector<Incomplete>& undecided_;
};

}  // namespace exsect

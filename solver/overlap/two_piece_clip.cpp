#include "overlap/two_piece_clip.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "answer/arc_joints.h"
#include "answer/parameter_box.h"
#include "overlap/pair_map.h"
#include "overlap/two_piece_cuts.h"
#include "self/cut_self_intersection.h"
#include "shape/special_cusps.h"

namespace exsect {
namespace {

constexpr int kFinestBoxBits = 256;

bool has(const std::vector<Side>& sides, const Side& side) { return std::ranges::count(sides, side) > 0; }

class Clip {
 public:
  Clip(GraphBuilder& graph, const TwoPieces& pieces, const OverlapBoundary& boundary,
       const std::vector<int>& nodes, const Run& run)
      : graph_(graph),
        pieces_(pieces),
        boundary_(boundary),
        nodes_(nodes),
        run_(run),
        to_hull_(maps_to_hull(pieces)),
        from_hull_(pieces.copy, pieces.around),
        hull_(pieces.hull()) {}

  std::optional<std::vector<int>> run() {
    auto cuts = two_piece_cuts(pieces_, boundary_);
    if (!cuts) return std::nullopt;
    auto self = cut_self_intersection(hull_, run_, cuts->cuts);
    if (!self) return std::nullopt;
    points_ = std::move(cuts->points);
    self_ = *std::move(self);
    find_boxes(cuts->cuts);
    const auto first_node = static_cast<int>(graph_.nodes().size());
    const auto first_arc = static_cast<int>(graph_.arcs().size());
    for (const bool exchanged : {false, true}) {
      place_nodes(exchanged);
      for (const Arc& arc : self_.graph.arcs())
        if (!append(arc, exchanged)) return std::nullopt;
      for (const int node : self_.graph.isolated_points())
        if (!append_isolated(node, exchanged)) return std::nullopt;
    }
    join_at_nodes_of_no_kind(graph_, first_arc);  // cuts of the other order
    join_at_other_turning_points(graph_, first_node, first_arc, run_.turning());
    add_isolated_cuts();
    return std::move(inside_boundary_arcs_);
  }

 private:
  /// Where a node of the hull's graph lies, its pair in one of the two orders.
  struct Place {
    enum { inside, outside, unknown } where = unknown;
    std::vector<Side> sides;                // if it is inside: all sides it lies on
    std::optional<std::size_t> point = {};  // of the boundary
  };

  /// Of the nodes, in the hull. That of a cut is the box of the point of the boundary: exact in parameters
  /// that are constant along an arc through it.
  void find_boxes(const std::vector<PairCut>& cuts) {
    for (const Node& node : self_.graph.nodes()) boxes_.push_back(node.box);
    for (std::size_t k = 0; k < cuts.size(); ++k)
      for (const auto& at : self_.cuts[k]) {
        const ParameterBox box = cuts[k].at.box();
        boxes_[static_cast<std::size_t>(at.node)] = at.exchanged ? exchanged_pair(box) : box;
      }
  }

  void place_nodes(bool exchanged) {
    places_.clear();
    for (const Node& node : self_.graph.nodes()) places_.push_back(place_of(node, exchanged));
    for (std::size_t k = 0; k < points_.size(); ++k)
      for (const auto& at : self_.cuts[k]) {
        if (at.exchanged != exchanged) continue;
        const std::size_t point = points_[k];
        places_[static_cast<std::size_t>(at.node)] = {Place::inside, boundary_.points[point].at.sides(),
                                                      point};
      }
  }

  ParameterBox box_of(const Node& node, bool exchanged) const {
    ParameterBox box = boxes_[static_cast<std::size_t>(node.id)];
    if (exchanged) box = exchanged_pair(box);
    for (std::size_t j = 0; j < 4; ++j) box[j] = from_hull_(box[j], j);
    return box;
  }

  /// Of a node that is no cut in this order. Off the diagonal, no such node is on a side of the domain but
  /// inside of an arc along it.
  Place place_of(const Node& node, bool exchanged) const {
    const ParameterBox box = box_of(node, exchanged);
    Place place{Place::inside, {}};
    bool is_outside = false;
    for (std::size_t j = 0; j < 4; ++j) {
      const bool beyond = box[j].upper < 0 || box[j].lower > 1;
      is_outside = is_outside || beyond;
      if (beyond || (box[j].lower > 0 && box[j].upper < 1)) continue;
      const int side = box[j].lower <= 0 ? 0 : 1;
      const bool is_on_diagonal = is_cuspidal(node) && lies_on(node, j, side);
      if (is_on_diagonal || (box[j].lower == side && box[j].upper == side))
        place.sides.push_back({static_cast<Parameter>(j), side});
      if (!is_on_diagonal) place.where = Place::unknown;
    }
    if (is_outside) place.where = Place::outside;
    return place;
  }

  static bool is_cuspidal(const Node& node) {
    return std::ranges::count(node.kinds, NodeKind::cusp) > 0 && lies_in(diagonal_of(node), node.box) &&
           lies_in(node.box, diagonal_of(node));
  }

  static ParameterBox diagonal_of(const Node& node) {
    return {node.box[0], node.box[1], node.box[0], node.box[1]};
  }

  /// A cuspidal point: its box holds the only one on the side, and no other one is near.
  bool lies_on(const Node& node, std::size_t j, int side) const {
    const std::size_t fixed = j % 2;
    const Rational value = to_hull_[j](side);
    const RationalInterval& at = node.box[fixed];
    const RationalInterval& along = node.box[1 - fixed];
    if (at.width() == 0) return at.lower == value;
    const auto near = std::ranges::count_if(self_.graph.nodes(), [&](const Node& other) {
      return is_cuspidal(other) && meet(other.box, node.box);
    });
    if (near > 1 || value <= 0 || value >= 1 || cuspidal_points(fixed, value, along) != 1) return false;
    return (along.lower > 0 && along.upper < 1) ||
           (along.width() == 0 && cuspidal_points(1 - fixed, along.lower, at) == 1);
  }

  /// Of the hull, on the line u (0) or v (1) = value; empty if the line is cuspidal as a whole.
  std::optional<std::size_t> cuspidal_points(std::size_t fixed, const Rational& value,
                                             const RationalInterval& range) const {
    return cuspidal_points_on(fixed == 0 ? hull_ : hull_.exchanged(), value, range);
  }

  /// Every arc is monotone or constant in every parameter. So one with both ends on one side runs along it,
  /// and is known if it is inside; one with an end outside is outside, one with both ends inside is inside.
  bool append(const Arc& arc, bool exchanged) {
    const Place& from = places_[static_cast<std::size_t>(arc.from)];
    const Place& to = places_[static_cast<std::size_t>(arc.to)];
    if (std::ranges::any_of(from.sides, [&](const Side& side) { return has(to.sides, side); })) return true;
    if (from.where == Place::outside || to.where == Place::outside) return true;
    if (from.where == Place::unknown || to.where == Place::unknown) return false;
    const auto start = node_at(arc.from, exchanged);
    const auto end = node_at(arc.to, exchanged);
    if (!start || !end) return false;
    Arc made = arc;
    made.place = ArcPlace::interior;
    made.from = *start;
    made.to = *end;
    for (PolylineVertex& vertex : made.polyline)
      vertex.parameters = from_hull_(exchanged ? exchanged_pair(vertex.parameters) : vertex.parameters);
    move_to_node(made, made.polyline.front(), made.from);
    move_to_node(made, made.polyline.back(), made.to);
    graph_.add_arc(std::move(made));
    return true;
  }

  void move_to_node(Arc& arc, PolylineVertex& vertex, int id) const {
    const Node& node = graph_.node(id);
    arc.error_bound += length_bound(node.point[0] - vertex.point[0], node.point[1] - vertex.point[1],
                                    node.point[2] - vertex.point[2]);
    arc.error_bound *= kSlack;
    vertex = {node.approx, node.point};
  }

  bool append_isolated(int node, bool exchanged) {
    const Place& place = places_[static_cast<std::size_t>(node)];
    if (place.where == Place::outside || place.point) return true;
    if (place.where == Place::unknown) return false;
    graph_.add_isolated(*node_at(node, exchanged));
    return true;
  }

  /// Empty if it is not decided which point of the boundary this is.
  std::optional<int> node_at(int id, bool exchanged) {
    const Node& node = self_.graph.node(id);
    const Place& place = places_[static_cast<std::size_t>(id)];
    if (place.point) {
      const int known = nodes_[*place.point];
      for (const NodeKind kind : {NodeKind::crossing, NodeKind::touch})
        if (std::ranges::count(node.kinds, kind) > 0) graph_.add_kind(known, kind);
      return known;
    }
    const bool cuspidal = is_cuspidal(node);
    const auto known = made_.find({id, exchanged && !cuspidal});
    if (known != made_.end()) return known->second;
    const auto corner = cuspidal ? boundary_point_at(node, place.sides) : std::optional<int>(-1);
    if (!corner) return std::nullopt;
    const int made = *corner >= 0 ? *corner : add_node(node, exchanged, place.sides);
    made_[{id, exchanged && !cuspidal}] = made;
    if (cuspidal && *corner < 0 && !place.sides.empty()) inside_boundary_arcs_.push_back(made);
    return made;
  }

  /// The node of the boundary point that the cuspidal point on these sides is, or -1. In a corner of the
  /// common rectangle, which is a boundary point, it is the only one that may be; empty if it may be one
  /// elsewhere.
  std::optional<int> boundary_point_at(const Node& node, const std::vector<Side>& sides) {
    std::vector<std::size_t> near;
    const ParameterBox box = box_of(node, false);
    for (std::size_t i = 0; i < boundary_.points.size() && !sides.empty(); ++i)
      if (meet(boundary_.points[i].at.refined_to(power_of_two(-kFinestBoxBits)).box(), box))
        near.push_back(i);
    if (near.empty()) return -1;
    const auto in_direction = [&](std::size_t k) {
      return std::ranges::any_of(sides, [&](const Side& side) { return index(side.parameter) % 2 == k; });
    };
    if (near.size() > 1 || !in_direction(0) || !in_direction(1)) return std::nullopt;
    graph_.add_kind(nodes_[near.front()], NodeKind::cusp);
    return nodes_[near.front()];
  }

  int add_node(Node node, bool exchanged, const std::vector<Side>& sides) {
    node.box = box_of(node, exchanged);
    node.approx = from_hull_(exchanged ? exchanged_pair(node.approx) : node.approx);
    for (Parameter& p : node.wrt) p = static_cast<Parameter>((index(p) + (exchanged ? 2 : 0)) % 4);
    std::ranges::sort(node.wrt);
    std::erase(node.kinds, NodeKind::boundary);
    std::erase(node.kinds, NodeKind::corner);
    node.on = sides;
    for (const Side& side : sides) {
      node.box[index(side.parameter)] = {side.value, side.value};
      node.approx[index(side.parameter)] = side.value;
    }
    if (!sides.empty()) node.kinds.push_back(NodeKind::boundary);
    if (is_cuspidal(self_.graph.node(node.id)) && sides.empty())
      node.kinds.push_back(NodeKind::end_of_overlap);
    return graph_.add_node(std::move(node));
  }

  void add_isolated_cuts() {
    for (const std::size_t i : points_) {
      if (boundary_.points[i].kind != BoundaryPointKind::other) continue;
      const bool used = std::ranges::any_of(
          graph_.arcs(), [&](const Arc& arc) { return arc.from == nodes_[i] || arc.to == nodes_[i]; });
      if (!used) graph_.add_isolated(nodes_[i]);
    }
  }

  GraphBuilder& graph_;
  const TwoPieces& pieces_;
  const OverlapBoundary& boundary_;
  const std::vector<int>& nodes_;
  const Run& run_;
  std::array<AffineMap, 4> to_hull_;
  PairMap from_hull_;
  BezierPatch hull_;
  std::vector<std::size_t> points_;  // of the boundary, by number of cuts
  CutSelfIntersection self_;
  std::vector<ParameterBox> boxes_;           // of its nodes
  std::vector<Place> places_;                 // of these, in the order of pairs at hand
  std::map<std::pair<int, bool>, int> made_;  // from its nodes, by order
  std::vector<int> inside_boundary_arcs_;
};

}  // namespace

std::optional<std::vector<int>> append_clipped_curves(GraphBuilder& graph, const TwoPieces& pieces,
                                                      const OverlapBoundary& boundary,
                                                      const std::vector<int>& nodes, const Run& run) {
  return Clip(graph, pieces, boundary, nodes, run).run();
}

}  // namespace exsect

#include "self/glued_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/parameter_names.h"
#include "self/chart.h"
#include "self/pinch_arc.h"
#include "self/placed_cells.h"

namespace exsect {
namespace {

constexpr ParameterNames kOtherOrder = {Parameter::r, Parameter::s, Parameter::u, Parameter::v};

/// A node on cuts: which, and what the arc that ends in it goes on in: that of another one, or a pinch cell.
struct CutNode {
  std::size_t cells;
  std::size_t node;
  int partner = -1;
  bool exchanged = false;  // the partner is the pair in the other order
  int pinch = -1;
  int point = -1;  // node of the graph
};

/// The cells of a node on cuts: bit k says that they lie below its cut k.
using CutSides = unsigned;

bool overlap(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

class Gluing {
 public:
  Gluing(const CellPairs& pairs, double tolerance) : pairs_(pairs), tolerance_(tolerance) {
    for (const SolvedCells& solved : pairs.solved) placed_.push_back(placed_cells(pairs.cells, solved));
  }

  GluedCells run() {
    if (collect() && match()) {
      add_points();
      add_poles();
      add_arcs();
      add_pinches();
      add_isolated_poles();
    }
    return std::move(glued_);
  }

 private:
  const ParameterRectangle& where_of(std::size_t cell) const { return pairs_.cells[cell].where; }
  const PlacedNode& at(const CutNode& cut) const { return placed_[cut.cells].nodes[cut.node]; }

  bool problem(const ParameterBox& where, const char* why) {
    glued_.problems.push_back({where, why, Reason::corner});
    return false;
  }

  /// Every curve crosses the cuts, or runs along sides of the square across them.
  bool collect() {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      if (placed_[i].along_cut) return problem(whole_domain(), "a curve along a cut not decided");
      for (std::size_t k = 0; k < placed_[i].nodes.size(); ++k) {
        const PlacedNode& node = placed_[i].nodes[k];
        if (!node.node.free.empty() && !pole_at(node.node))
          return problem(node.node.box, "points on a side that is one point not decided");
        if (node.cuts.empty()) continue;
        if (node.arcs > 1)
          return problem(node.node.box, "a curve through a corner of cells, or along a cut, not decided");
        cuts_.push_back({i, k});
      }
    }
    return true;
  }

  /// (14.65): what lies beyond is the only thing that can.
  bool match() {
    exits_.resize(pairs_.pinches.size());
    for (std::size_t i = 0; i < cuts_.size(); ++i)
      if (!match(i)) return problem(at(cuts_[i]).node.box, "where a curve goes on across a cut not decided");
    for (std::size_t k = 0; k < exits_.size(); ++k)
      if (exits_[k].size() > 2) {
        const ParameterRectangle& cell = pairs_.cells[pairs_.pinches[k].cell].where;
        return problem({cell.u, cell.v, cell.u, cell.v}, "curves next to a pinch point not decided");
      }
    return true;
  }

  /// One node in each pair of cells around it, and two arcs that end there.
  bool match(std::size_t i) {
    const PlacedNode& own = at(cuts_[i]);
    std::vector<CutSides> around = {sides_of(own, false)};
    int arcs = own.arcs;
    for (std::size_t j = 0; j < cuts_.size(); ++j)
      for (const bool exchanged : {false, true}) {
        const PlacedNode& other = at(cuts_[j]);
        if ((i == j && !exchanged) || !may_be_one(own, other, exchanged)) continue;
        if (std::ranges::count(around, sides_of(other, exchanged)) > 0) return false;
        around.push_back(sides_of(other, exchanged));
        arcs += other.arcs;
        if (other.arcs == 0) continue;
        if (own.arcs == 1 && !are_alike(arc_at(cuts_[i]), arc_at(cuts_[j]))) return false;
        cuts_[i].partner = static_cast<int>(j);
        cuts_[i].exchanged = exchanged;
      }
    for (std::size_t k = 0; k < pairs_.pinches.size() && own.cuts.size() == 1; ++k)
      if (may_enter(own, pairs_.cells[pairs_.pinches[k].cell].where)) {
        around.push_back(sides_of(own, false) ^ 1U);
        ++arcs;
        cuts_[i].pinch = static_cast<int>(k);
        exits_[k].push_back(i);
      }
    return around.size() == std::size_t{1} << own.cuts.size() && arcs == 2;
  }

  const Arc& arc_at(const CutNode& cut) const {
    return *std::ranges::find_if(placed_[cut.cells].arcs, [&](const Arc& arc) {
      return arc.from == static_cast<int>(cut.node) || arc.to == static_cast<int>(cut.node);
    });
  }

  static bool are_alike(const Arc& a, const Arc& b) { return a.place == b.place && a.contact == b.contact; }

  /// In the order of its cuts when the pair is exchanged.
  static std::vector<Cut> cuts_of(const PlacedNode& node, bool exchanged) {
    std::vector<Cut> cuts = node.cuts;
    for (Cut& cut : cuts)
      if (exchanged) cut.parameter = (cut.parameter + 2) % 4;
    std::ranges::sort(cuts, {}, &Cut::parameter);
    return cuts;
  }

  static CutSides sides_of(const PlacedNode& node, bool exchanged) {
    CutSides sides = 0;
    CutSides bit = 1;
    for (const Cut& cut : cuts_of(node, exchanged)) {
      if (cut.upper) sides |= bit;
      bit <<= 1U;
    }
    return sides;
  }

  static bool may_be_one(const PlacedNode& a, const PlacedNode& b, bool exchanged) {
    const auto same = [](const Cut& s, const Cut& t) {
      return s.parameter == t.parameter && s.value == t.value;
    };
    return std::ranges::equal(cuts_of(a, false), cuts_of(b, exchanged), same) &&
           meet(a.node.box, exchanged ? exchanged_pair(b.node.box) : b.node.box);
  }

  /// The cell with itself lies on the other side of the cut.
  static bool may_enter(const PlacedNode& node, const ParameterRectangle& cell) {
    const Cut& cut = node.cuts[0];
    const RationalInterval& range = cut.parameter % 2 == 0 ? cell.u : cell.v;
    const ParameterBox& box = node.node.box;
    return (cut.upper ? range.lower : range.upper) == cut.value && overlap(box[0], cell.u) &&
           overlap(box[1], cell.v) && overlap(box[2], cell.u) && overlap(box[3], cell.v);
  }

  /// Where arcs end, each in both orders.
  void add_points() {
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      CutNode& cut = cuts_[i];
      if (at(cut).arcs == 0) continue;
      if (cut.partner >= 0 && static_cast<std::size_t>(cut.partner) < i) {
        const CutNode& known = cuts_[static_cast<std::size_t>(cut.partner)];
        cut.point = known.point + (cut.exchanged ? 1 : 0);
        continue;
      }
      Node node = at(cut).node;
      node.kinds = {NodeKind::turning};
      node.wrt.clear();
      cut.point = glued_.graph.add_node(node);
      rename_parameters(node, kOtherOrder);
      glued_.mates.push_back(static_cast<std::size_t>(glued_.graph.add_node(std::move(node))));
      glued_.mates.push_back(static_cast<std::size_t>(cut.point));
    }
  }

  /// It is no other pair of cells' as well.
  bool is_inner(const PlacedNode& node) const { return node.cuts.empty() && !pole_at(node.node); }

  /// Of which both points of the node's pairs are on the side.
  std::optional<std::size_t> pole_at(const Node& node) const {
    if (node.free.empty()) return std::nullopt;
    for (std::size_t k = 0; k < pairs_.poles.size(); ++k)
      if (std::ranges::is_permutation(node.on, pole_node(pairs_.poles[k]).on)) return k;
    return std::nullopt;
  }

  void add_poles() {
    for (const Pole& pole : pairs_.poles) poles_.push_back(glued_.graph.add_node(pole_node(pole), 0));
  }

  void add_isolated_poles() {
    for (const int pole : poles_)
      if (std::ranges::none_of(glued_.graph.arcs(),
                               [&](const Arc& arc) { return arc.from == pole || arc.to == pole; }))
        glued_.graph.add_isolated(pole);
  }

  void add_arcs() {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      std::vector<int> names(placed_[i].nodes.size(), -1);
      for (const CutNode& cut : cuts_)
        if (cut.cells == i) names[cut.node] = cut.point;
      for (std::size_t k = 0; k < names.size(); ++k)
        if (const auto pole = pole_at(placed_[i].nodes[k].node)) names[k] = poles_[*pole];
      for (std::size_t k = 0; k < names.size(); ++k)
        if (is_inner(placed_[i].nodes[k]))
          names[k] = glued_.graph.add_node(std::move(placed_[i].nodes[k].node));
      for (Arc& arc : placed_[i].arcs) {
        arc.from = names[static_cast<std::size_t>(arc.from)];
        arc.to = names[static_cast<std::size_t>(arc.to)];
        move_end(arc, arc.polyline.front(), arc.from);
        move_end(arc, arc.polyline.back(), arc.to);
        glued_.graph.add_arc(std::move(arc));
        glued_.cells.push_back({where_of(pairs_.solved[i].first), where_of(pairs_.solved[i].second)});
      }
      for (const int id : placed_[i].isolated)
        if (const PlacedNode& node = placed_[i].nodes[static_cast<std::size_t>(id)]; is_inner(node))
          glued_.graph.add_isolated(names[static_cast<std::size_t>(id)]);
    }
  }

  /// Puts the end of a polyline into the node on a cut, which moves its chord by no more than the end.
  void move_end(Arc& arc, PolylineVertex& end, int id) const {
    if (static_cast<std::size_t>(id) >= glued_.mates.size()) return;
    const Node& node = glued_.graph.node(id);
    arc.error_bound += length_bound(end.point[0] - node.point[0], end.point[1] - node.point[1],
                                    end.point[2] - node.point[2]);
    arc.error_bound *= kSlack;
    end = {node.approx, node.point};
  }

  /// (14.64): one curve from the pinch point to the only exit, or from one exit to the other one.
  void add_pinches() {
    for (std::size_t k = 0; k < exits_.size() && glued_.problems.empty(); ++k) {
      const PinchCell& pinch = pairs_.pinches[k];
      const ParameterCell& cell = pairs_.cells[pinch.cell];
      if (exits_[k].empty() && !pinch.on) continue;
      std::vector<int> ends;
      for (const std::size_t i : exits_[k]) ends.push_back(cuts_[i].point);
      if (!add_pinch_arc(glued_.graph, glued_.mates, pinch, cell, ends, tolerance_))
        problem({cell.where.u, cell.where.v, cell.where.u, cell.where.v}, "a pinch point not decided");
      glued_.cells.push_back({cell.where, cell.where});
    }
  }

  const CellPairs& pairs_;
  double tolerance_;
  std::vector<PlacedCells> placed_;
  std::vector<CutNode> cuts_;
  std::vector<std::vector<std::size_t>> exits_;  // of pinch cells, in cuts_
  std::vector<int> poles_;                       // nodes of the graph
  GluedCells glued_;
};

}  // namespace

GluedCells glued_cells(const CellPairs& pairs, double tolerance) { return Gluing(pairs, tolerance).run(); }

}  // namespace exsect

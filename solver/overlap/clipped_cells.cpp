#include "overlap/clipped_cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "answer/arc_joints.h"
#include "answer/parameter_names.h"

namespace exsect {
namespace {

constexpr ParameterNames kOtherOrderOfPair = {Parameter::r, Parameter::s, Parameter::u, Parameter::v};
constexpr ParameterNames kSecondExchanged = {Parameter::u, Parameter::v, Parameter::s, Parameter::r};

RationalInterval image(const AffineMap& map, const RationalInterval& of) {
  const auto [lower, upper] = std::minmax({map(of.lower), map(of.upper)});
  return {lower, upper};
}

bool lies_within(const RationalInterval& a, const RationalInterval& b) {
  return b.lower <= a.lower && a.upper <= b.upper;
}

class CellClip {
 public:
  CellClip(GraphBuilder& graph, const GluedCells& cells, const PiecesInHull& pieces)
      : graph_(graph), cells_(cells), pieces_(pieces), from_hull_({pieces.pieces.maps}, pieces.around) {}

  bool run() {
    for (const bool exchanged : {false, true})
      for (std::size_t i = 0; i < cells_.graph.arcs().size(); ++i) append_arc(i, exchanged);
    for (const bool exchanged : {false, true})
      for (const Node& node : cells_.graph.nodes())
        if (stands_alone(node, exchanged)) graph_.add_isolated(made(node.id, exchanged));
    return divide_rim();
  }

 private:
  /// A node of the cells' graph, and whether its pair is taken in the other order.
  using Key = std::pair<int, bool>;

  /// A point that is its own pair, and a side that is one, are one node in both orders.
  static bool is_on_diagonal(const Node& node) {
    return !node.free.empty() || std::ranges::count(node.kinds, NodeKind::cusp) > 0;
  }
  bool is_cut(const Node& node) const { return static_cast<std::size_t>(node.id) < cells_.mates.size(); }

  Key key(int id, bool exchanged) const {
    const Node& node = cells_.graph.node(id);
    if (!exchanged || is_on_diagonal(node)) return {id, false};
    return is_cut(node) ? Key(static_cast<int>(cells_.mates[static_cast<std::size_t>(id)]), false)
                        : Key(id, true);
  }

  /// No cell has a side of the squares inside: an arc is in both squares as a whole, or but for its ends in
  /// none.
  void append_arc(std::size_t i, bool exchanged) {
    std::array<ParameterRectangle, 2> where = cells_.cells[i];
    if (exchanged) std::swap(where[0], where[1]);
    if (!pieces_.contain(where)) return;
    Arc arc = cells_.graph.arcs()[i];
    arc.from = made(arc.from, exchanged);
    arc.to = made(arc.to, exchanged);
    if (exchanged) rename_parameters(arc, kOtherOrderOfPair);
    for (PolylineVertex& vertex : arc.polyline) vertex.parameters = from_hull_(vertex.parameters);
    if (pieces_.pieces.exchanged) rename_parameters(arc, kSecondExchanged);
    arc.polyline.front().parameters = graph_.node(arc.from).approx;
    arc.polyline.back().parameters = graph_.node(arc.to).approx;
    graph_.add_arc(std::move(arc));
  }

  /// A common point in which no arc ends: an isolated one of the surface, or one on a side of which the curve
  /// is outside.
  bool stands_alone(const Node& node, bool exchanged) const {
    const Key at = key(node.id, exchanged);
    if (made_.contains(at)) return false;
    const bool is_cuspidal = std::ranges::count(node.kinds, NodeKind::cusp) > 0;
    const bool is_isolated = std::ranges::count(cells_.graph.isolated_points(), node.id) > 0;
    if (is_cuspidal || !(is_isolated || is_cut(node) || !node.free.empty())) return false;
    const Node placed = placed_node(at);
    return std::ranges::all_of(all_parameters, [&](Parameter p) {
      return std::ranges::count(placed.free, p) > 0 || lies_within(placed.box[index(p)], {0, 1});
    });
  }

  int made(int id, bool exchanged) {
    const Key at = key(id, exchanged);
    const auto known = made_.find(at);
    if (known != made_.end()) return known->second;
    return made_[at] = graph_.add_node(placed_node(at));
  }

  /// In the parameters of the patches.
  Node placed_node(const Key& at) const {
    Node node = cells_.graph.node(at.first);
    if (at.second) rename_parameters(node, kOtherOrderOfPair);
    const std::size_t before = node.on.size();
    node.on.clear();
    node.approx = from_hull_(node.approx);
    for (const Parameter p : all_parameters) {
      if (std::ranges::count(node.free, p) > 0) {
        node.approx[index(p)] = 0.5;
        continue;
      }
      RationalInterval& range = node.box[index(p)];
      range = from_hull_(range, index(p));
      if (range.width() > 0 || (range.lower != 0 && range.lower != 1)) continue;
      node.on.push_back({p, range.lower == 0 ? 0 : 1});
      node.approx[index(p)] = range.lower == 0 ? 0 : 1;
    }
    if (node.on.size() > before) name_sides(node);
    if (is_on_diagonal(node)) node.kinds.push_back(NodeKind::end_of_overlap);
    if (pieces_.pieces.exchanged) rename_parameters(node, kSecondExchanged);
    return node;
  }

  /// A cut is on a side.
  static void name_sides(Node& node) {
    const auto add = [&](NodeKind kind) {
      if (std::ranges::count(node.kinds, kind) == 0) node.kinds.push_back(kind);
    };
    if (node.wrt.empty()) std::erase(node.kinds, NodeKind::turning);
    add(NodeKind::boundary);
    for (const std::size_t patch : {0U, 1U})
      if (std::ranges::count_if(node.on,
                                [&](const Side& side) { return index(side.parameter) / 2 == patch; }) > 1)
        add(NodeKind::corner);
  }

  /// Cuspidal points on sides are nodes of the overlap's rim.
  bool divide_rim() {
    for (const auto& [key, id] : made_) {
      const Node& node = graph_.node(id);
      if (std::ranges::count(node.kinds, NodeKind::cusp) == 0 || node.on.empty()) continue;
      double error = HUGE_VAL;  // of the node's point of space: that of arcs there is no less
      for (const Arc& arc : graph_.arcs())
        if (arc.from == id || arc.to == id) error = std::min(error, arc.error_bound);
      if (!divide_at(graph_, id, error)) return false;
    }
    return true;
  }

  GraphBuilder& graph_;
  const GluedCells& cells_;
  const PiecesInHull& pieces_;
  PairMap from_hull_;
  std::map<Key, int> made_;
};

}  // namespace

PiecesInHull::PiecesInHull(const filter::OverlapOfPieces& overlap) : pieces(overlap) {
  for (std::size_t j = 0; j < 2; ++j) {
    const AffineMap& map = pieces.maps[j];
    const auto [lower, upper] = std::minmax({Rational(0), Rational(1), map(0), map(1)});
    around[j] = {lower, upper - lower};
    to_hull[j] = quotient(around[j], {0, 1});
    to_hull[j + 2] = quotient(around[j], map);
  }
}

ParameterLines PiecesInHull::sides() const {
  ParameterLines lines;
  for (std::size_t j = 0; j < 4; ++j)
    for (const int side : {0, 1})
      if (const Rational value = to_hull[j](side); value > 0 && value < 1) lines[j % 2].push_back(value);
  return lines;
}

bool PiecesInHull::contain(const std::array<ParameterRectangle, 2>& cells) const {
  return std::ranges::all_of(std::array{0U, 1U, 2U, 3U}, [&](std::size_t j) {
    const ParameterRectangle& cell = cells[j / 2];
    return lies_within(j % 2 == 0 ? cell.u : cell.v, image(to_hull[j], {0, 1}));
  });
}

bool append_clipped_cells(GraphBuilder& graph, const GluedCells& cells, const PiecesInHull& pieces) {
  return CellClip(graph, cells, pieces).run();
}

}  // namespace exsect

#include "self/pinch_arc.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "answer/chord_count.h"

namespace exsect {
namespace {

/// Of the tolerance, for chords.
constexpr double kChordShare = 0.9;

/// The parameter of a cell with that of the square.
RationalInterval in_square(const DoubleBall& t, const RationalInterval& range) {
  const RationalInterval at = t.interval();
  const Rational lower = std::max<Rational>(at.lower, 0), upper = std::min<Rational>(at.upper, 1);
  return {range.lower + lower * range.width(), range.lower + upper * range.width()};
}

DoubleBall in_cell(const RationalInterval& t, const RationalInterval& range) {
  return DoubleBall::enclosing(
      RationalInterval{(t.lower - range.lower) / range.width(), (t.upper - range.lower) / range.width()});
}

/// How far a place may be from a point in doubles.
double distance_bound(const BallVector<DoubleBall>& from_origin, const Point& origin,
                      const std::array<double, 3>& point) {
  std::array<double, 3> off;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!std::isfinite(point[c])) return HUGE_VAL;
    const Rational exact = from_double(point[c]) - origin[c];
    off[c] = (from_origin[c] - DoubleBall::enclosing(exact)).upper_magnitude();
  }
  return length_bound(off[0], off[1], off[2]);
}

class PinchArc {
 public:
  PinchArc(GraphBuilder& graph, const PinchCell& pinch, const ParameterCell& cell, double tolerance)
      : graph_(graph), proof_(pinch.proof), cell_(cell), origin_(origin_of(cell)), tolerance_(tolerance) {
    if (pinch.along) side_ = pinch.on->value == 0 ? 0 : 1;
  }

  /// The pinch point, as a node.
  std::optional<int> cusp(const std::optional<KnownPinch>& on) {
    const auto place = proof_.at(0, side_);
    if (!place) return std::nullopt;
    const RationalInterval u = in_square(place->pair[0], cell_.where.u);
    const RationalInterval v = in_square(place->pair[1], cell_.where.v);
    const PolylineVertex vertex = vertex_of(*place);
    Node node{};
    node.kinds = {NodeKind::cusp};
    node.box = {u, v, u, v};
    if (on) {
      node.kinds.push_back(NodeKind::boundary);
      for (const std::size_t j : {on->fixed, on->fixed + 2}) {
        node.on.push_back({all_parameters[j], on->value == 0 ? 0 : 1});
        node.box[j] = {on->value, on->value};
      }
    }
    for (std::size_t j = 0; j < 4; ++j) node.approx[j] = to_double(node.box[j].midpoint());
    node.point = vertex.point;
    return graph_.add_node(std::move(node));
  }

  /// The sign of t (14.60) at a node, in its order; 0 if that is not known.
  int side_of(int id) const {
    const ParameterBox& box = graph_.node(id).box;
    const std::size_t j = proof_.exchanged() ? 1 : 0;
    return box[j].lower > box[j + 2].upper ? 1 : box[j].upper < box[j + 2].lower ? -1 : 0;
  }

  /// False if a vertex is not found. `sign`: of t along the arc.
  bool add(int from, int to, int sign) {
    const double first = t_at(from), last = t_at(to);
    const double length = std::fabs(last * last - first * first) * kSlack + 0x1p-48;
    const double bend = proof_.bend();
    const int n = chord_count(std::ceil(length * std::sqrt(bend / (8 * kChordShare * tolerance_))));
    Arc arc{};
    arc.from = from;
    arc.to = to;
    arc.place = side_ ? ArcPlace::patch_boundary : ArcPlace::interior;
    arc.contact = Contact::transversal;
    add_end(arc, from);
    for (int i = 1; i < n; ++i) {
      const double part = static_cast<double>(i) / n;
      const auto place = proof_.at(std::sqrt(first * first + part * (last * last - first * first)), side_);
      if (!place) return false;
      arc.polyline.push_back(vertex_of(*place));
      if (sign < 0) exchange(arc.polyline.back().parameters);
    }
    add_end(arc, to);
    // (5.4), and twice the errors of vertices, because the true end may be anywhere in its node's box.
    const double step = length / n * (1 + 0x1p-20) + 0x1p-48;
    arc.error_bound = (bend * step * step / 8 + 2 * error_) * kSlack + kUnderflowLoss;
    graph_.add_arc(std::move(arc));
    return true;
  }

 private:
  static void exchange(std::array<double, 4>& pair) { pair = {pair[2], pair[3], pair[0], pair[1]}; }

  /// Counts its error.
  PolylineVertex vertex_of(const PinchProof::Place& place) {
    PolylineVertex vertex{};
    for (std::size_t j = 0; j < 4; ++j)
      vertex.parameters[j] = to_double(in_square(place.pair[j], range(j)).midpoint());
    for (std::size_t c = 0; c < 3; ++c) {
      const double middle = place.point[c].approximation();
      vertex.point[c] = std::isfinite(middle) ? to_double(from_double(middle) + origin_[c]) : middle;
    }
    error_ = larger_bound(error_, distance_bound(place.point, origin_, vertex.point));
    return vertex;
  }

  void add_end(Arc& arc, int id) {
    const Node& node = graph_.node(id);
    const auto place =
        proof_.point({in_cell(node.box[0], cell_.where.u), in_cell(node.box[1], cell_.where.v)});
    error_ = larger_bound(error_, distance_bound(place, origin_, node.point));
    arc.polyline.push_back({node.approx, node.point});
  }

  const RationalInterval& range(std::size_t j) const { return j % 2 == 0 ? cell_.where.u : cell_.where.v; }

  /// Half the difference of the parameters of the node, of the cell, but for rounding.
  double t_at(int id) const {
    const std::size_t j = proof_.exchanged() ? 1 : 0;
    const ParameterBox& box = graph_.node(id).box;
    const Rational difference = (box[j].lower + box[j].upper - box[j + 2].lower - box[j + 2].upper) / 4;
    return std::fabs(to_double(difference / range(j).width()));
  }

  GraphBuilder& graph_;
  const PinchProof& proof_;
  const ParameterCell& cell_;
  Point origin_;
  double tolerance_;
  std::optional<double> side_;  // of the cell, on which the arc lies
  double error_ = 0;            // of vertices
};

}  // namespace

bool add_pinch_arc(GraphBuilder& graph, const std::vector<std::size_t>& mates, const PinchCell& pinch,
                   const ParameterCell& cell, const std::vector<int>& ends, double tolerance) {
  if (pinch.on && ends.size() != 1) return false;
  PinchArc arc(graph, pinch, cell, tolerance);
  const int sign = arc.side_of(ends[0]);
  if (sign == 0) return false;
  if (ends.size() == 1) {
    const auto cusp = arc.cusp(pinch.on);
    return cusp && arc.add(*cusp, ends[0], sign);
  }
  const int other = arc.side_of(ends[1]);
  const int to = other == sign ? ends[1] : static_cast<int>(mates[static_cast<std::size_t>(ends[1])]);
  return other != 0 && arc.add(ends[0], to, sign);
}

}  // namespace exsect

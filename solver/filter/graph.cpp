#include "filter/graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/series.h"
#include "filter/space_bounds.h"

namespace exsect::filter {

namespace {

constexpr std::size_t kMostVertices = 4000000;
/// Parts of the tolerance that are left to chords and, twice, to vertices.
constexpr double kChordShare = 0.93;
constexpr double kVertexShare = 0.015;

/// A place on the trace where an arc begins or ends.
template <class K>
struct Stop {
  int node;
  std::size_t piece;
  double tau;
  const PortOf<K>* port = nullptr;  // the node is the centre that this port leads to
};

template <class K>
class GraphMaker {
 public:
  GraphMaker(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
             const std::vector<CentreOf<K>>& centres, const std::array<std::size_t, 4>& coincident,
             const Drawing& drawing)
      : pair_(pair),
        points_(points),
        centres_(centres),
        coincident_(coincident),
        scale_(std::ldexp(1.0, static_cast<int>(pair.frame.exponent))),
        accepted_(drawing.accepted),
        scaled_tolerance_(drawing.tolerance / scale_),
        vertex_tolerance_(std::min(kVertexShare * scaled_tolerance_, drawing.vertex_tolerance / scale_)) {
    const auto& o = pair.frame.origin;
    // The values of x: Patch::error; origin + scaled point: two roundings of each coordinate's size.
    const double size = larger_bound(std::fabs(o[0]), std::fabs(o[1]), std::fabs(o[2])) / scale_ + 2;
    place_error_ = kSlack * kDiagonal * (pair.total_error + 2 * kUnit * size);
    origin_size_ = size;
  }

  void add_centres() {
    for (const CentreOf<K>& point : centres_) {
      BallOf<K> ball{};
      std::copy(point.centre.begin(), point.centre.end(), ball.middle.begin());
      const NodeKind kind = point.ports.empty() ? NodeKind::touch : NodeKind::crossing;
      Node node = node_at(is_on_side(point) ? NodeKind::boundary : kind, ball);
      node.box = point.box;
      if (is_on_side(point)) {
        put_on_sides(node, point.on);
        node.kinds.push_back(kind);
      }
      const int id = add_node(std::move(node), ball);
      if (point.ports.empty()) {
        graph_.add_isolated(id);
      }
    }
  }

  /// After the centres.
  void add_boundary_nodes() {
    for (const BoundaryPointOf<K>& point : points_) {
      if (point.centre >= 0) {
        node_of_.push_back(point.centre);
        continue;
      }
      Node node = node_at(NodeKind::boundary, point.ball);
      const bool upper = point.side > 0;
      node.on = {{static_cast<Parameter>(point.parameter), upper ? 1 : 0}};
      node.box[point.parameter] = {upper ? 1 : 0, upper ? 1 : 0};
      if (point.on != Vec4{}) {
        put_on_sides(node, point.on);
      }
      node_of_.push_back(add_node(std::move(node), point.ball));
      if (point.isolated) {
        graph_.add_isolated(node_of_.back());
      }
    }
  }

  static void put_on_sides(Node& node, const Vec4& on) {
    node.on.clear();
    for (std::size_t j = 0; j < 4; ++j) {
      if (on[j] == 0) continue;
      const int value = on[j] > 0 ? 1 : 0;
      node.on.push_back({static_cast<Parameter>(j), value});
      node.box[j] = {value, value};
    }
    if ((on[0] != 0 && on[1] != 0) || (on[2] != 0 && on[3] != 0)) {
      node.kinds.push_back(NodeKind::corner);
    }
  }

  bool add(const AnalysedTraceOf<K>& curve, const std::vector<Parameter>& wanted) {
    stops_.clear();
    const TraceOf<K>& trace = curve.trace;
    if (trace.start >= 0) {
      stops_.push_back(stop_at(trace.start, 0, trace.pieces.front().range.from()));
    }
    add_turning_stops(curve, wanted);
    if (stops_.empty()) {
      add_turning_stops(curve, {all_parameters.begin(), all_parameters.end()});
    }
    if (trace.start >= 0) {
      stops_.push_back(stop_at(trace.end, trace.pieces.size() - 1, trace.pieces.back().range.to()));
    }
    bounds_.clear();
    for (const PieceOf<K>& piece : trace.pieces) {
      bounds_.push_back(space_bounds(pair_, piece.tube));
    }
    if constexpr (K::weighted) {
      place_error_ = 0;
      for (const SpaceBounds& bounds : bounds_) {
        const double w = bounds.least_weight;
        place_error_ = larger_bound(
            place_error_, kSlack * kDiagonal *
                              (pair_.x_total_error * (1 + 1 / w) / w + 4 * kUnit * (origin_size_ + 1 / w)));
      }
    }
    bool proved = !stops_.empty();
    choose_chord_error();
    for (std::size_t i = 0; proved && i + 1 < stops_.size(); ++i) {
      proved = add_arc(trace, stops_[i], stops_[i + 1]);
    }
    return proved && (trace.start >= 0 || add_arc(trace, stops_.back(), stops_.front()));
  }

  GraphBuilder take() { return std::move(graph_); }

 private:
  Stop<K> stop_at(int point, std::size_t piece, double tau) const {
    const auto i = static_cast<std::size_t>(point);
    const int centre = points_[i].centre;
    return {node_of_[i], piece, tau,
            centre < 0 ? nullptr : &centres_[static_cast<std::size_t>(centre)].ports[points_[i].port]};
  }

  /// With the roundings of parameters.
  static double radius_of(const BallOf<K>& ball) { return kSlack * ball.radius + kPlaceRounding; }

  int add_node(Node node, const BallOf<K>& ball) {
    node_radius_.push_back(radius_of(ball));
    return graph_.add_node(std::move(node), node_radius_.back());
  }

  /// Parameters in [0,1]: the middle, in [-1/2,1/2] up to the radius, plus 1/2.
  Node node_at(NodeKind kind, const BallOf<K>& ball) const {
    Node node{};
    node.kinds = {kind};
    const double radius = radius_of(ball);
    for (std::size_t j = 0; j < 4; ++j) {
      const double t = std::clamp(ball.middle[j] + 0.5, 0.0, 1.0);
      node.approx[j] = t;
      node.box[j].lower = from_double(std::max(t - radius, 0.0));
      node.box[j].upper = from_double(std::min(t + radius, 1.0));
    }
    node.point = position(affine(expand(pair_.x, ball.middle[0], ball.middle[1])[0]));
    return node;
  }

  void add_turning_stops(const AnalysedTraceOf<K>& curve, const std::vector<Parameter>& wanted) {
    for (const TurnOf<K>& turn : curve.turns) {
      std::vector<Parameter> wrt;
      for (const Parameter p : all_parameters) {
        const bool turns = index(p) == turn.parameter || coincident_[index(p)] == turn.parameter;
        if (turns && std::find(wanted.begin(), wanted.end(), p) != wanted.end()) {
          wrt.push_back(p);
        }
      }
      if (!wrt.empty()) {
        Node node = node_at(NodeKind::turning, turn.ball);
        node.wrt = std::move(wrt);
        const int id = add_node(std::move(node), turn.ball);
        stops_.push_back({id, turn.piece, 0.5 * (turn.from + turn.to), nullptr});
      }
    }
  }

  /// Chords finer than the ends of the arcs can be told are no use.
  void choose_chord_error() {
    vertex_error_ = 0;
    for (const Stop<K>& stop : stops_) cover(stop);
    wanted_chord_error_ = std::max(kChordShare * scaled_tolerance_, 2 * (vertex_error_ + place_error_));
  }

  /// Chords over the offsets between a and b on a piece.
  int chords(std::size_t piece, double a, double b) const {
    const double step = std::sqrt(8 * wanted_chord_error_ / (bounds_[piece].curvature + kTiny));
    return static_cast<int>(std::min(std::ceil(std::fabs(b - a) / step), 1e7)) + (a == b ? 1 : 0);
  }

  /// The pieces from one stop to the next, which for the last arc of a closed curve pass its seam.
  template <class Visit>
  void visit(const TraceOf<K>& trace, const Stop<K>& from, const Stop<K>& to,
             const Visit& visit_piece) const {
    const std::size_t count = trace.pieces.size();
    const bool around = to.piece < from.piece || (to.piece == from.piece && is_behind(trace, from, to));
    const std::size_t last = to.piece + (around ? count : 0);
    for (std::size_t k = from.piece; k <= last; ++k) {
      const PieceOf<K>& piece = trace.pieces[k % count];
      visit_piece(k % count, k == from.piece ? from.tau : piece.range.from(),
                  k == last ? to.tau : piece.range.to(), k == last);
    }
  }

  static bool is_behind(const TraceOf<K>& trace, const Stop<K>& from, const Stop<K>& to) {
    return trace.start < 0 && !trace.pieces[from.piece].range.precedes(from.tau, to.tau);
  }

  bool add_arc(const TraceOf<K>& trace, const Stop<K>& from, const Stop<K>& to) {
    std::size_t count = 2;
    for (const Stop<K>* stop : {&from, &to}) {
      count += stop->port == nullptr ? 0 : stop->port->approach.size() + 1;
    }
    visit(trace, from, to, [&](std::size_t piece, double a, double b, bool) {
      count += static_cast<std::size_t>(chords(piece, a, b));
    });
    vertices_ += count;
    if (vertices_ > kMostVertices) {
      return false;
    }
    Arc arc{};
    arc.from = from.node;
    arc.to = to.node;
    arc.place = ArcPlace::interior;
    arc.contact = Contact::transversal;
    arc.polyline.reserve(count);
    chord_error_ = vertex_error_ = 0;
    cover(from);
    cover(to);
    push_node(arc, from.node);
    push_approach(arc, from);
    visit(trace, from, to, [&](std::size_t piece, double a, double b, bool last) {
      add_chords(arc, trace.pieces[piece].tube, bounds_[piece], a, b, chords(piece, a, b), !last);
    });
    const auto port = static_cast<std::ptrdiff_t>(arc.polyline.size());
    push_approach(arc, to);
    std::reverse(arc.polyline.begin() + port, arc.polyline.end());
    push_node(arc, to.node);
    // An end of the arc is anywhere in its node's box, and the vertex there too: twice.
    arc.error_bound = kSlack * scale_ * (chord_error_ + 2 * vertex_error_ + 2 * place_error_);
    const bool proved = arc.error_bound <= accepted_;
    graph_.add_arc(std::move(arc));
    return proved;
  }

  void push_node(Arc& arc, int id) const {
    const Node& node = graph_.node(id);
    arc.polyline.push_back({node.approx, node.point});
  }

  /// From the centre of the stop's port to the port.
  void push_approach(Arc& arc, const Stop<K>& stop) {
    if (stop.port == nullptr) {
      return;
    }
    const auto push = [&](const Vec4& w) {
      arc.polyline.push_back({{w[0] + 0.5, w[1] + 0.5, w[2] + 0.5, w[3] + 0.5},
                              position(affine(expand(pair_.x, w[0], w[1])[0]))});
    };
    std::for_each(stop.port->approach.begin(), stop.port->approach.end(), push);
    push(parameters_of(stop.port->ball));
    chord_error_ = larger_bound(chord_error_, stop.port->chord);
    vertex_error_ = larger_bound(vertex_error_, stop.port->vertex_error);
  }

  std::array<double, 3> position(const Vec3& scaled) const {
    std::array<double, 3> point;
    for (std::size_t c = 0; c < 3; ++c) {
      point[c] = pair_.frame.origin[c] + scale_ * scaled[c];
    }
    return point;
  }

  /// The node's box contains points of the tube; elsewhere in it |x_u| + |x_v| is greater by
  /// kSpeedChange<K::width> at most.
  void cover(const Stop<K>& stop) {
    const double radius = node_radius_[static_cast<std::size_t>(stop.node)];
    const SpaceBounds& bounds = bounds_[stop.piece];
    double change = kSpeedChange<K::width>;
    if constexpr (K::weighted) {
      // |x''| <= (|X''| + 2 |w'| |x'| + |w''| |x|) / w, |X''|, |w''| < 2^8, |X'|, |w'| < 2^4, |x| <= 1/w, and
      // w is above half of its bound on the tube.
      const double inverse = 2 / bounds.least_weight;
      change *= 4 * inverse * (1 + inverse) * (1 + inverse);
    }
    vertex_error_ = larger_bound(vertex_error_, 2 * (bounds.speed + change) * radius);
  }

  /// n chords over equal steps of tau; the vertices between them, and the last one if `with_end`. After a
  /// step w - C F(w) from a point of the region |w - w*| <= rho/(1 - rho) |C F(w)|, and the rounding.
  void add_chords(Arc& arc, const TubeOf<K>& tube, const SpaceBounds& bounds, double a, double b, int n,
                  bool with_end) {
    const double h = (b - a) / n;
    const double width = kSlack * std::fabs(h);
    chord_error_ = larger_bound(chord_error_, bounds.curvature * width * width / 8);
    const double rounding = kSlack * tube.value_error / (1 - tube.contraction) + kSumRounding;
    const double allowed = vertex_tolerance_ / (bounds.speed + kTiny);
    const VertexFormsOf<K::degree, K::rows> forms =
        vertex_forms(pair_, tube, allowed * (1 - tube.contraction) / (kSlack * tube.contraction));
    double worst = allowed;
    VertexBlock block;
    const int end = n + (with_end ? 1 : 0);
    for (int first = 1; first < end; first += kVertexBlock) {
      const int count = std::min(kVertexBlock, end - first);
      for (int l = 0; l < kVertexBlock; ++l) {
        const int i = first + std::min(l, count - 1);
        block.tau[l] = i == n ? b : a + i * h;
      }
      evaluate_vertices(forms, block);
      for (int l = 0; l < count; ++l) {
        if (block.doubt[l] == 0) {
          push_vertex(arc, block, l);
        } else {
          worst = larger_bound(worst, push_improved(arc, tube, forms, block.tau[l]));
        }
      }
    }
    vertex_error_ = larger_bound(vertex_error_, bounds.speed * (worst + rounding));
  }

  static void push_vertex(Arc& arc, const VertexBlock& block, int l) {
    const auto& p = block.parameters;
    const auto& x = block.point;
    arc.polyline.push_back({{p[0][l], p[1][l], p[2][l], p[3][l]}, {x[0][l], x[1][l], x[2][l]}});
  }

  /// A vertex where the polynomial of the arc is not good enough; returns the radius of its ball.
  double push_improved(Arc& arc, const TubeOf<K>& tube, const VertexFormsOf<K::degree, K::rows>& forms,
                       double tau) const {
    Unknowns<K> o;
    const double radius = point_at(tube, tau, &o).radius;
    PolylineVertex& vertex = arc.polyline.emplace_back();
    for (std::size_t j = 0; j < 4; ++j) {
      vertex.parameters[j] = (tube.centre[j] + o[j]) + 0.5;
    }
    const Vec3 x = affine(value_at<K>(tube.space, o[0], o[1]));
    for (std::size_t c = 0; c < 3; ++c) {
      vertex.point[c] = forms.origin[c] + forms.scale * x[c];
    }
    return radius;
  }

  const PairOf<K>& pair_;
  const std::vector<BoundaryPointOf<K>>& points_;
  const std::vector<CentreOf<K>>& centres_;
  const std::array<std::size_t, 4>& coincident_;
  double scale_;
  double accepted_;
  double scaled_tolerance_;
  double wanted_chord_error_ = 0;
  double vertex_tolerance_;
  double place_error_;
  double origin_size_;
  std::size_t vertices_ = 0;
  GraphBuilder graph_;
  std::vector<int> node_of_;  // of boundary points
  std::vector<double> node_radius_;
  std::vector<Stop<K>> stops_;
  std::vector<SpaceBounds> bounds_;
  double chord_error_ = 0;
  double vertex_error_ = 0;
};

}  // namespace

template <class K>
std::optional<GraphBuilder> make_graph(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                                       const std::vector<CentreOf<K>>& centres,
                                       const std::vector<AnalysedTraceOf<K>>& traces,
                                       const std::vector<Parameter>& wanted,
                                       const std::array<std::size_t, 4>& coincident, const Drawing& drawing) {
  GraphMaker<K> maker(pair, points, centres, coincident, drawing);
  maker.add_centres();
  maker.add_boundary_nodes();
  for (const AnalysedTraceOf<K>& curve : traces) {
    if (!maker.add(curve, wanted)) {
      return std::nullopt;
    }
  }
  return maker.take();
}

#define EXSECT_INSTANTIATE(K)                                                                    \
  template std::optional<GraphBuilder> make_graph<K>(                                            \
      const PairOf<K>&, const std::vector<BoundaryPointOf<K>>&, const std::vector<CentreOf<K>>&, \
      const std::vector<AnalysedTraceOf<K>>&, const std::vector<Parameter>&,                     \
      const std::array<std::size_t, 4>&, const Drawing&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

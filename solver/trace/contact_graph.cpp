#include "trace/contact_graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/chord_count.h"
#include "trace/bounded_vertex.h"
#include "trace/in_domain.h"
#include "trace/landmark_node.h"
#include "trace/tangential_enclosure.h"
#include "trace/tube_points.h"
namespace exsect {

namespace {

constexpr double kChordsTogether = 64;
constexpr std::size_t kMostVertices = kMostChords;
constexpr double kShortest = 0x1p-40;

/// Collects the polyline of one arc and its proved bound.
template <class Ball>
class ContactPolyline {
 public:
  ContactPolyline(const PairSystem<Ball>& system, const ModelFrame& frame, double tolerance)
      : system_(system), frame_(frame), tolerance_(tolerance) {}

  /// A vertex for the point in this box.
  void add_point(const BallPoint<Ball>& parameters) {
    const BoundedVertex v = bounded_vertex(parameters, system_.taylor_x(parameters)[0], frame_);
    vertices_.push_back(v.vertex);
    vertex_error_ = larger_bound(vertex_error_, v.error);
  }

  /// The vertex of the node that stands for the point in this box.
  void add_node(const Node& node, const BallPoint<Ball>& parameters) {
    const BoundedVertex v = bounded_vertex(parameters, system_.taylor_x(parameters)[0], frame_);
    vertices_.push_back({node.approx, node.point});
    vertex_error_ = larger_bound(vertex_error_, 2 * v.error);
  }
  void add_approach(const Approach& approach) {
    vertices_.insert(vertices_.end(), approach.vertices.begin(), approach.vertices.end());
    chord_error_ = larger_bound(chord_error_, approach.bound);
  }
  void add_vertex(const Node& node) { vertices_.push_back({node.approx, node.point}); }

  /// Chords between two offsets, whose vertices are added by others. A chord over an offset step h deviates
  /// by |X''| h²/8 at most. The bound is proved for some chords together.
  void add_chords(const TangentialTube<Ball>& tube, double first, double last) {
    const double second =
        std::ldexp(second_derivative_bound(system_, tube, first, last), static_cast<int>(frame_.exponent));
    const double wanted = std::ceil(std::fabs(last - first) * std::sqrt(second / (4 * tolerance_)));
    const double middle = 0.5 * (first + last);
    const bool may_divide = vertices_.size() < kMostVertices && std::fabs(last - first) > kShortest;
    if (may_divide && !(wanted <= kChordsTogether)) {
      add_chords(tube, first, middle);
      add_point(point_at(system_, tube, middle));
      add_chords(tube, middle, last);
      return;
    }
    const int n = static_cast<int>(std::clamp(wanted, 1.0, kChordsTogether));
    double from = first;
    for (int i = 1; i <= n; ++i) {
      const double to = i == n ? last : first + (last - first) * (static_cast<double>(i) / n);
      chord_error_ = larger_bound(chord_error_, second * (to - from) * (to - from) / 8 * kSlack);
      if (i < n) {
        add_point(point_at(system_, tube, to));
      }
      from = to;
    }
  }

  std::vector<PolylineVertex> take_vertices() { return std::move(vertices_); }
  /// Vertices, joints included, stand for true points within vertex_error.
  double bound() const { return (chord_error_ + 2 * vertex_error_) * kSlack; }

 private:
  const PairSystem<Ball>& system_;
  const ModelFrame& frame_;
  double tolerance_;
  std::vector<PolylineVertex> vertices_;
  double vertex_error_ = 0;
  double chord_error_ = 0;
};

/// A node on the curve: at a landmark (with the box of the curve's end), or at a turning point.
template <class Ball>
struct ContactStop {
  int node;
  std::size_t piece;
  double tau;
  BallPoint<Ball> box;
  const Approach* approach;
};

template <class Ball>
class ContactAppender {
 public:
  ContactAppender(GraphBuilder& graph, const PairSystem<Ball>& system, const AnalysedContact<Ball>& contact,
                  const ModelFrame& frame, double tolerance)
      : graph_(graph), system_(system), contact_(contact), frame_(frame), tolerance_(tolerance) {}

  void run(const Landmarks<Ball>& landmarks, const std::vector<TraceEnd>& ends,
           const std::vector<Parameter>& wanted) {
    const auto& pieces = contact_.curve.pieces;
    add_turns(wanted);
    if (contact_.curve.start >= 0) {
      const auto stop_at = [&](int landmark, std::size_t piece, double tau) {
        const auto i = static_cast<std::size_t>(landmark);
        return ContactStop<Ball>{ends[i].node, piece, tau, landmarks[i],
                                 ends[i].approach ? &*ends[i].approach : nullptr};
      };
      stops_.insert(stops_.begin(), stop_at(contact_.curve.start, 0, pieces.front().range.from()));
      stops_.push_back(stop_at(contact_.curve.end, pieces.size() - 1, pieces.back().range.to()));
    } else {
      if (stops_.empty()) {
        add_turns({all_parameters.begin(), all_parameters.end()});
      }
      stops_.push_back(stops_.front());
    }
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      add_arc(stops_[i], stops_[i + 1], contact_.curve.start < 0 && i + 2 == stops_.size());
    }
  }

 private:
  void add_turns(const std::vector<Parameter>& wanted) {
    for (const ContactTurn<Ball>& turn : contact_.turns) {
      if (std::count(wanted.begin(), wanted.end(), turn.parameter) == 0) {
        continue;
      }
      ParameterBox box;
      for (std::size_t j = 0; j < 4; ++j) {
        box[j] = in_domain(turn.box[j].interval());
      }
      Node node = landmark_node(system_, frame_, turn.box, box, {});
      node.kinds = {NodeKind::turning};
      node.wrt = {turn.parameter};
      const int id = graph_.add_node(std::move(node));
      stops_.push_back({id, turn.piece, 0.5 * (turn.from + turn.to), turn.box, nullptr});
    }
  }

  void add_arc(const ContactStop<Ball>& from, const ContactStop<Ball>& to, bool over_the_seam) {
    ContactPolyline<Ball> polyline(system_, frame_, tolerance_);
    add_end(polyline, from, true);
    const auto& pieces = contact_.curve.pieces;
    std::size_t piece = from.piece;
    double tau = from.tau;
    for (bool wrap = over_the_seam; piece != to.piece || wrap;) {
      polyline.add_chords(pieces[piece].tube, tau, pieces[piece].range.to());
      polyline.add_point(point_at(system_, pieces[piece].tube, pieces[piece].range.to()));
      wrap = wrap && piece + 1 < pieces.size();
      piece = piece + 1 < pieces.size() ? piece + 1 : 0;
      tau = pieces[piece].range.from();
    }
    polyline.add_chords(pieces[piece].tube, tau, to.tau);
    add_end(polyline, to, false);
    Arc arc{};
    arc.from = from.node;
    arc.to = to.node;
    arc.place = ArcPlace::interior;
    arc.contact = Contact::tangential;
    arc.polyline = polyline.take_vertices();
    arc.error_bound = polyline.bound();
    graph_.add_arc(std::move(arc));
  }

  void add_end(ContactPolyline<Ball>& polyline, const ContactStop<Ball>& stop, bool leaving) const {
    const Node& node = graph_.node(stop.node);
    if (stop.approach == nullptr) {
      polyline.add_node(node, stop.box);
      return;
    }
    Approach approach = *stop.approach;
    if (leaving) {
      std::reverse(approach.vertices.begin(), approach.vertices.end());
      polyline.add_vertex(node);
      polyline.add_approach(approach);
      polyline.add_point(stop.box);
    } else {
      polyline.add_point(stop.box);
      polyline.add_approach(approach);
      polyline.add_vertex(node);
    }
  }

  GraphBuilder& graph_;
  const PairSystem<Ball>& system_;
  const AnalysedContact<Ball>& contact_;
  const ModelFrame& frame_;
  double tolerance_;
  std::vector<ContactStop<Ball>> stops_;
};

}  // namespace

template <class Ball>
void append_contact(GraphBuilder& graph, const PairSystem<Ball>& system, const AnalysedContact<Ball>& contact,
                    const Landmarks<Ball>& landmarks, const std::vector<TraceEnd>& ends,
                    const ModelFrame& frame, const std::vector<Parameter>& wanted, double tolerance) {
  ContactAppender<Ball>(graph, system, contact, frame, tolerance).run(landmarks, ends, wanted);
}

#define EXSECT_INSTANTIATE_CONTACT(Ball)                                                                \
  template void append_contact(GraphBuilder&, const PairSystem<Ball>&, const AnalysedContact<Ball>&,    \
                               const Landmarks<Ball>&, const std::vector<TraceEnd>&, const ModelFrame&, \
                               const std::vector<Parameter>&, double);

EXSECT_INSTANTIATE_CONTACT(DoubleBall)
EXSECT_INSTANTIATE_CONTACT(DoubleDoubleBall)
EXSECT_INSTANTIATE_CONTACT(ArbBall<256>)
EXSECT_INSTANTIATE_CONTACT(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_CONTACT

}  // namespace exsect

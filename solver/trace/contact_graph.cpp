#include "trace/contact_graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/chord_count.h"
#include "trace/curve_appender.h"
#include "trace/tangential_enclosure.h"

namespace exsect {

namespace {

constexpr double kChordsTogether = 64;
constexpr double kShortest = 0x1p-40;

/// Draws a curve along which the patches touch (curve_appender.h).
template <class Ball>
struct ContactPen {
  using Number = Ball;
  static constexpr Contact contact = Contact::tangential;
  static constexpr bool exchanged = false;

  const PairSystem<Ball>& system;
  const AnalysedContact<Ball>& curve;
  const ModelFrame& frame;
  double tolerance;

  const auto& pieces() const { return curve.trace.pieces; }
  static const BallPoint<Ball>& pair(std::size_t /*piece*/, const BallPoint<Ball>& box) { return box; }
  BoundedVertex vertex(std::size_t /*piece*/, const BallPoint<Ball>& parameters) const {
    return bounded_vertex(parameters, system.taylor_x(parameters)[0], frame);
  }
  BoundedVertex vertex_at(std::size_t piece, double tau) const {
    return vertex(piece, point_at(system, tube(piece), tau));
  }

  /// A chord over an offset step h deviates by |X''| h^2/8 at most. The bound is proved for some chords
  /// together.
  void add_chords(ArcPolyline& line, std::size_t piece, double first, double last) const {
    const double second = std::ldexp(second_derivative_bound(system, tube(piece), first, last),
                                     static_cast<int>(frame.exponent));
    const double wanted = std::ceil(std::fabs(last - first) * std::sqrt(second / (4 * tolerance)));
    const double middle = 0.5 * (first + last);
    const bool may_divide = line.size() < kMostChords && std::fabs(last - first) > kShortest;
    if (may_divide && !(wanted <= kChordsTogether)) {
      add_chords(line, piece, first, middle);
      line.add_vertex(vertex_at(piece, middle));
      add_chords(line, piece, middle, last);
      return;
    }
    const int n = static_cast<int>(std::clamp(wanted, 1.0, kChordsTogether));
    double from = first;
    for (int i = 1; i <= n; ++i) {
      const double to = i == n ? last : first + (last - first) * (static_cast<double>(i) / n);
      line.cover(second * (to - from) * (to - from) / 8 * kSlack);
      if (i < n) {
        line.add_vertex(vertex_at(piece, to));
      }
      from = to;
    }
  }

  const TangentialTube<Ball>& tube(std::size_t piece) const { return curve.trace.pieces[piece].tube; }
};

}  // namespace

template <class Ball>
void append_contact(GraphBuilder& graph, const PairSystem<Ball>& system, const AnalysedContact<Ball>& contact,
                    const Landmarks<Ball>& landmarks, const std::vector<TraceEnd>& ends,
                    const ModelFrame& frame, const std::vector<Parameter>& wanted, double tolerance) {
  const ContactPen<Ball> pen{system, contact, frame, tolerance};
  append_curve(graph, pen, landmarks, ends, wanted);
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

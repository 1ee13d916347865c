#include "trace/trace_graph.h"

#include <cmath>

#include "trace/curve_appender.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

/// Of the parameters of a vertex, which are rounded to doubles.
constexpr double kVertexRadius = 0x1p-60;

/// Draws a curve along which the patches cross (curve_appender.h).
template <class Ball>
struct TracePen {
  using Number = Ball;
  static constexpr Contact contact = Contact::transversal;
  static constexpr bool exchanged = false;

  const AnalysedTrace<Ball>& curve;
  const ModelFrame& frame;
  double tolerance;

  const auto& pieces() const { return curve.trace.pieces; }
  static const BallPoint<Ball>& pair(std::size_t /*piece*/, const BallPoint<Ball>& box) { return box; }
  BoundedVertex vertex(std::size_t piece, const BallPoint<Ball>& parameters) const {
    return bounded_vertex(parameters, space_point(tube(piece), parameters), frame);
  }
  BoundedVertex vertex_at(std::size_t piece, double tau) const {
    return vertex(piece, point_at(tube(piece), tau, kVertexRadius));
  }

  void add_chords(ArcPolyline& line, std::size_t piece, double a, double b) const {
    const double k = std::ldexp(tube(piece).space_second_derivative, static_cast<int>(frame.exponent));
    line.add_chords(k, a, b, tolerance, [&](double tau) { return vertex_at(piece, tau); });
  }

  const Tube<Ball>& tube(std::size_t piece) const { return curve.trace.pieces[piece].tube; }
};

}  // namespace

template <class Ball>
void append_trace(GraphBuilder& graph, const AnalysedTrace<Ball>& curve, const Landmarks<Ball>& landmarks,
                  const std::vector<TraceEnd>& ends, const ModelFrame& frame,
                  const std::vector<Parameter>& wanted, double tolerance) {
  const TracePen<Ball> pen{curve, frame, tolerance};
  append_curve(graph, pen, landmarks, ends, wanted);
}

std::vector<TraceEnd> nodes_of_landmarks(std::size_t count) {
  std::vector<TraceEnd> ends;
  for (std::size_t i = 0; i < count; ++i) {
    ends.push_back({static_cast<int>(i), std::nullopt});
  }
  return ends;
}

#define EXSECT_INSTANTIATE_TRACE_GRAPH(Ball)                                                                 \
  template void append_trace(GraphBuilder&, const AnalysedTrace<Ball>&, const Landmarks<Ball>&,              \
                             const std::vector<TraceEnd>&, const ModelFrame&, const std::vector<Parameter>&, \
                             double);

EXSECT_INSTANTIATE_TRACE_GRAPH(DoubleBall)
EXSECT_INSTANTIATE_TRACE_GRAPH(DoubleDoubleBall)
EXSECT_INSTANTIATE_TRACE_GRAPH(ArbBall<256>)
EXSECT_INSTANTIATE_TRACE_GRAPH(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TRACE_GRAPH

}  // namespace exsect

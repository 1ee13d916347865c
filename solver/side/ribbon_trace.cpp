#include "side/ribbon_trace.h"

#include <algorithm>

#include "answer/graph_builder.h"
#include "trace/landmark_node.h"
#include "trace/trace_graph.h"

namespace exsect {

namespace {

constexpr int kHullsOfPiece = 8;

Point normal_at(const BezierPatch& patch, const Rational& a, const Rational& b) {
  return cross(patch.derivative_first(a, b), patch.derivative_second(a, b));
}

/// The point's box in the ribbon's parameters (t, h, r, s).
ParameterBox on_ribbon(const LinePlace& place, const CertifiedPoint& point, const Rational& width) {
  const ParameterBox box = point.refined_to(width).box();
  return {box[index(place.roles.line)], RationalInterval{Rational(1, 2), Rational(1, 2)},
          box[index(place.roles.first)], box[index(place.roles.second)]};
}

/// The part of the interval that is in [0,1], which both ends are near.
RationalInterval clipped(const Rational& lower, const Rational& upper) {
  return {std::clamp<Rational>(lower, 0, 1), std::clamp<Rational>(upper, 0, 1)};
}

/// Around the arc for tau from `from` to `to`, by the tube's bounds of positions at tau = 0 and of slopes.
template <class Ball>
ParameterBox box_between(const LinePlace& place, const Tube<Ball>& tube, const Rational& from,
                         const Rational& to) {
  const auto around = [&](std::size_t i) {
    const Rational centre = tube.centre[i].interval().midpoint();
    const Rational radius = from_double(tube.halfwidth[i]);
    if (i == tube.axis) return clipped(centre + from, centre + to);
    const Rational slope = from_double(tube.slope[i]);
    const Rational error = from_double(tube.slope_error[i]) * std::max(abs(from), abs(to));
    const Rational middle = centre + slope * (from + to) / 2;
    const Rational spread = abs(slope) * (to - from) / 2 + error + radius;
    return clipped(middle - spread, middle + spread);
  };
  ParameterBox box;
  box[index(place.roles.fixed)] = {place.value, place.value};
  box[index(place.roles.line)] = around(0);
  box[index(place.roles.first)] = around(2);
  box[index(place.roles.second)] = around(3);
  return box;
}

/// Around the piece, by parts: arcs beside each other have hulls that are apart.
template <class Ball>
void add_hulls(const LinePlace& place, const Piece<Ball>& piece, std::vector<ParameterBox>& hulls) {
  const double from = std::min<double>(piece.range.from(), piece.range.to()) - piece.range.doubt();
  const double to = std::max<double>(piece.range.from(), piece.range.to()) + piece.range.doubt();
  for (int i = 0; i < kHullsOfPiece; ++i) {
    const auto cut = [&](int k) {
      return from_double(from) + Rational(k, kHullsOfPiece) * (from_double(to) - from_double(from));
    };
    hulls.push_back(box_between(place, piece.tube, cut(i), cut(i + 1)));
  }
}

}  // namespace

std::vector<RibbonNormal> RibbonTracer::normals(const CertifiedPoint& point, const Rational& from,
                                                const Rational& to) const {
  std::vector<RibbonNormal> result;
  const bool along_second = place_.roles.fixed == Parameter::u || place_.roles.fixed == Parameter::r;
  std::array<Point, 3> at;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational t = from + Rational(static_cast<int>(i), 2) * (to - from);
    at[i] =
        with_length(along_second ? normal_at(owner_, place_.value, t) : normal_at(owner_, t, place_.value),
                    scale_.extent);
  }
  if (from != to && std::none_of(at.begin(), at.end(), is_zero)) result.push_back(interpolated(at, from, to));
  const ParameterBox& box = point.box();
  const Point n = with_length(normal_at(problem_.patch, box[index(place_.roles.first)].midpoint(),
                                        box[index(place_.roles.second)].midpoint()),
                              scale_.extent);
  result.push_back({n, Point{0, 0, 0}, Point{0, 0, 0}});
  return result;
}

template <class Ball>
std::variant<RibbonRun, std::string> RibbonTracer::run(const CertifiedPoint& start, int direction,
                                                       const std::vector<CertifiedPoint>& ends,
                                                       const std::vector<CertifiedPoint>& targets,
                                                       const RibbonNormal& normal,
                                                       const Rational& width) const {
  const BezierPatch carrier = ribbon(problem_.line, normal);
  const PairSystem<Ball> system(carrier, problem_.patch, scale_.origin, scale_.frame.exponent);
  Landmarks<Ball> landmarks;
  GraphBuilder scratch;
  const auto add = [&](const CertifiedPoint& point) {
    const ParameterBox box = on_ribbon(place_, point, width);
    landmarks.push_back(
        {Ball::enclosing(box[0]), Ball::enclosing(box[1]), Ball::enclosing(box[2]), Ball::enclosing(box[3])});
    scratch.add_node(landmark_node(system, scale_.frame, landmarks.back(), box, {}));
  };
  std::for_each(ends.begin(), ends.end(), add);
  std::for_each(targets.begin(), targets.end(), add);
  add(start);
  const int forward = Expansion<Ball>(system, landmarks.back()).tangent()[0].certain_sign();
  if (forward == 0) return "the patch is singular there";
  auto outcome =
      trace_arc(system, landmarks, static_cast<int>(landmarks.size()) - 1, direction * forward, stop_);
  if (const auto* failure = std::get_if<TraceFailure>(&outcome)) return failure->why;
  AnalysedTrace<Ball> curve{std::get<Trace<Ball>>(std::move(outcome)), {}};
  append_trace(scratch, curve, landmarks, nodes_of_landmarks(landmarks.size()), scale_.frame, {}, tolerance_);
  Arc arc = std::move(scratch.take_arcs(0).front());
  RibbonRun run{static_cast<std::size_t>(curve.trace.end), std::move(arc.polyline), arc.error_bound, {}};
  for (const Piece<Ball>& piece : curve.trace.pieces) add_hulls(place_, piece, run.hulls);
  return run;
}

#define EXSECT_INSTANTIATE_RIBBON(Ball)                                                                   \
  template std::variant<RibbonRun, std::string> RibbonTracer::run<Ball>(                                  \
      const CertifiedPoint&, int, const std::vector<CertifiedPoint>&, const std::vector<CertifiedPoint>&, \
      const RibbonNormal&, const Rational&) const;

EXSECT_INSTANTIATE_RIBBON(DoubleBall)
EXSECT_INSTANTIATE_RIBBON(ArbBall<256>)
#undef EXSECT_INSTANTIATE_RIBBON

}  // namespace exsect

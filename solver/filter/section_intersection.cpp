#include "filter/section_intersection.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/proof.h"
#include "filter/section_trace.h"
#include "trace/arc_polyline.h"

namespace exsect {
namespace {

/// What doubles have decided.
struct KnownSection {
  SectionForms forms;
  double extent;  // of the patch
  std::vector<Parameter> turning;
  std::vector<SectionLandmark> landmarks;  // ascending in u
  std::vector<SectionTrace> arcs;          // with f > 0 to the left
};

double parameter_of(double p) { return 0.5 + 0.5 * p; }

/// The interval of parameters about a coordinate.
RationalInterval interval_about(double centre, double reach) {
  const Rational middle = (1 + from_double(centre)) / 2, half = from_double(reach) / 2;
  return {middle - half, middle + half};
}

Node node_of(const SectionForms& forms, const SectionLandmark& landmark) {
  const auto& [centre, reach] = landmark.box;
  Node node{};
  node.box = {interval_about(centre[0], reach[0]), interval_about(centre[1], reach[1]), {0, 0}, {0, 0}};
  node.approx = {parameter_of(centre[0]), parameter_of(centre[1]), 0, 0};
  node.point = section_point(forms, centre);
  const Parameter parameter = landmark.coordinate == 0 ? Parameter::u : Parameter::v;
  if (landmark.side == 0) {
    node.wrt = {parameter};
    node.kinds = {NodeKind::turning};
  } else {
    node.on = {{parameter, landmark.side > 0 ? 1 : 0}};
    node.kinds = {NodeKind::boundary};
  }
  return node;
}

/// The vertices on one tube, each looked for where the last ones lead to.
class SectionVertices {
 public:
  SectionVertices(const SectionForms& forms, const SectionTube& tube, double tolerance)
      : forms_(forms), tube_(tube), speeds_(section_speeds(forms.patch, tube)), tolerance_(tolerance) {
    wanted_ = tolerance / 64 / speeds_.speed;
  }

  /// Of the arc on this length from its chords.
  double deviation(double length) const {
    return ArcPolyline::deviation(speeds_.acceleration, speeds_.normal, speeds_.least_speed, length,
                                  tolerance_);
  }

  BoundedVertex operator()(double s) {
    const PlaceNearCurve near = place_near_curve(forms_.section, tube_, s, likely_off(s), wanted_);
    for (std::size_t k = last_.size() - 1; k > 0; --k) last_[k] = last_[k - 1];
    last_[0] = {s, near.off};
    count_ = std::min(count_ + 1, last_.size());
    // The place is over an offset within 2^-50 of s.
    return vertex_at(near.place, near.error * speeds_.speed + 0x1p-50 * speeds_.rate);
  }
  /// That of a box in the tube.
  BoundedVertex operator()(const SectionBox& box) const {
    return vertex_at(box.centre, box.reach[tube_.axis] * along() + box.reach[1 - tube_.axis] * speeds_.speed);
  }

 private:
  struct Known {
    double s, off;
  };

  /// Of the point's speed where the parameter across the axis follows the curve.
  double along() const { return (speeds_.rate + tube_.slopes.upper_magnitude() * speeds_.speed) * kSlack; }

  /// A place beside the square, by less than the error of places, is moved to its side.
  BoundedVertex vertex_at(const std::array<double, 2>& place, double error) const {
    const std::array<double, 2> inside = {std::clamp(place[0], -1.0, 1.0), std::clamp(place[1], -1.0, 1.0)};
    const std::size_t across = 1 - tube_.axis;
    const double moved = std::abs(place[tube_.axis] - inside[tube_.axis]) * along() +
                         std::abs(place[across] - inside[across]) * speeds_.speed;
    return {{{parameter_of(inside[0]), parameter_of(inside[1]), 0, 0}, section_point(forms_, inside)},
            (error + moved + speeds_.rounding) * kSlack};
  }

  /// By interpolation of the last four (Neville), or as far as they go.
  double likely_off(double s) const {
    if (count_ == 0) return tube_.slope * s;
    std::array<double, 4> value;
    for (std::size_t i = 0; i < count_; ++i) value[i] = last_[i].off;
    if (count_ == 1) return value[0] + tube_.slope * (s - last_[0].s);
    for (std::size_t k = 1; k < count_; ++k)
      for (std::size_t i = 0; i + k < count_; ++i)
        value[i] += (s - last_[i].s) * (value[i + 1] - value[i]) / (last_[i + k].s - last_[i].s);
    return value[0];
  }

  const SectionForms& forms_;
  const SectionTube& tube_;
  SectionSpeeds speeds_;
  double tolerance_, wanted_;
  std::array<Known, 4> last_{};
  std::size_t count_ = 0;
};

/// The polyline of a trace from landmark to landmark.
ArcPolyline drawn_trace(const SectionForms& forms, const SectionTrace& trace, double tolerance) {
  ArcPolyline polyline;
  for (std::size_t i = 0; i < trace.pieces.size(); ++i) {
    interruption_point();
    const auto& [tube, range] = trace.pieces[i];
    SectionVertices vertices(forms, tube, tolerance);
    if (i == 0) polyline.add_vertex(vertices(trace.ends[0]));
    polyline.add_chords(vertices.deviation(range.length() * kSlack), range.from(), range.to(), tolerance,
                        [&](double s) { return vertices(s); });
    polyline.add_vertex(i + 1 < trace.pieces.size() ? vertices(range.to()) : vertices(trace.ends[1]));
  }
  return polyline;
}

/// From smaller to greater u.
Arc arc_of(const KnownSection& known, const SectionTrace& trace, ArcPolyline polyline) {
  Arc arc{};
  arc.from = trace.start;
  arc.to = trace.end;
  arc.place = ArcPlace::interior;
  arc.contact = Contact::transversal;
  arc.error_bound = polyline.bound();
  arc.polyline = polyline.take_vertices();
  arc.beside = SideSigns{1, -1};
  const auto p_of = [&](int landmark) {
    return known.landmarks[static_cast<std::size_t>(landmark)].box.centre[0];
  };
  if (p_of(arc.from) <= p_of(arc.to)) return arc;
  std::swap(arc.from, arc.to);
  std::reverse(arc.polyline.begin(), arc.polyline.end());
  arc.beside = SideSigns{-1, 1};
  return arc;
}

/// Empty where doubles do not keep the tolerance.
std::optional<IntersectResult> drawn_section(const KnownSection& known, const Run& run) {
  const double tolerance = run.drawn_tolerance(known.extent);
  GraphBuilder builder;
  for (const SectionLandmark& landmark : known.landmarks)
    builder.add_node(node_of(known.forms, landmark),
                     std::max(landmark.box.reach[0], landmark.box.reach[1]) + 0x1p-53);
  std::vector<Arc> arcs;
  for (const SectionTrace& trace : known.arcs) {
    arcs.push_back(arc_of(known, trace, drawn_trace(known.forms, trace, tolerance)));
    if (!(arcs.back().error_bound <= tolerance)) return std::nullopt;
  }
  // From one node the lower one first.
  std::ranges::sort(arcs, {},
                    [](const Arc& arc) { return std::pair(arc.from, arc.polyline[1].parameters[1]); });
  for (Arc& arc : arcs) builder.add_arc(std::move(arc));
  IntersectResult result = finished(std::move(builder), {known.turning}, {});
  result.coarse = coarse_drawing(result.graph, run.tolerance(known.extent));
  return result;
}

/// All arcs: from each landmark inside and from each side where the curve comes in, to what is arrived at
/// once (Lemma 17.18). False if doubles do not prove it.
bool trace_all(KnownSection& known, const StopRequest& stop) {
  std::vector<int> arrivals;  // that are to come
  for (const SectionLandmark& landmark : known.landmarks) {
    const int direction = section_direction(known.forms.section, landmark);
    if (direction == 0) return false;
    arrivals.push_back(landmark.side == 0 || direction < 0 ? 1 : 0);
  }
  const std::vector<int> expected = arrivals;
  for (std::size_t i = 0; i < known.landmarks.size(); ++i) {
    if (known.landmarks[i].side != 0 && expected[i] > 0) continue;  // the curve goes out there
    auto trace = section_trace(known.forms.section, known.landmarks, i, stop);
    if (!trace || trace->end < 0 || --arrivals[static_cast<std::size_t>(trace->end)] < 0) return false;
    known.arcs.push_back(*std::move(trace));
  }
  return std::ranges::all_of(arrivals, [](int left) { return left == 0; });
}

/// 1: the point belongs to the surface, 0: that is not known, -1: it is on the other nappe of a cone.
int nappe_sign(const SquareForm& bound, const SectionBox& box) {
  return bound.about(box.centre[0], box.centre[1])
      .derivative_over(0, 0, box.reach[0], box.reach[1])
      .certain_sign();
}

/// Takes away the landmarks on the nappe that does not belong to the surface. A part of the curve is on one
/// nappe, as it is not singular and so does not go through the apex. False if doubles do not tell.
bool keep_nappe(const HalfSpaceBound& bound, const RationalPatch& patch,
                std::vector<SectionLandmark>& landmarks) {
  SpacePolynomial form = SpacePolynomial::constant(bound.constant);
  for (std::size_t k = 0; k < 3; ++k) form += bound.normal[k] * SpacePolynomial::variable(k);
  const auto forms = section_forms(form, patch);
  if (!forms) return false;
  const auto sign_at_landmark = [&](const SectionLandmark& landmark) {
    return nappe_sign(forms->section, landmark.box);
  };
  if (std::ranges::any_of(landmarks, [&](const auto& landmark) { return sign_at_landmark(landmark) == 0; }))
    return false;
  std::erase_if(landmarks, [&](const auto& landmark) { return sign_at_landmark(landmark) < 0; });
  return true;
}

}  // namespace

std::optional<IntersectResult> section_intersection(const ImplicitSurface& surface, const RationalPatch& x,
                                                    const Run& run) {
  if (!surface.box().clauses.empty()) return std::nullopt;
  const RationalPatch& patch = x.reduced();
  auto forms = section_forms(surface.equation(), patch);
  if (!forms) return std::nullopt;
  KnownSection known{
      *std::move(forms), to_double(largest_extent(bounding_box(patch))), {Parameter::u}, {}, {}};
  const bool with_second = std::ranges::find(run.turning(), Parameter::v) != run.turning().end();
  if (with_second) known.turning.push_back(Parameter::v);
  const StopRequest stop = run.stop();
  auto landmarks = section_landmarks(known.forms.section, with_second, stop);
  if (!landmarks) return std::nullopt;
  if (surface.bound() && !keep_nappe(*surface.bound(), patch, *landmarks)) return std::nullopt;
  known.landmarks = *std::move(landmarks);
  std::ranges::sort(known.landmarks, {},
                    [](const SectionLandmark& landmark) { return landmark.box.centre[0]; });
  if (!trace_all(known, stop)) return std::nullopt;
  const auto kept = std::make_shared<const KnownSection>(std::move(known));
  auto result = first_drawn([kept](const Run& given) { return drawn_section(*kept, given); }, run);
  if (result) run.count("filtered", 1);
  return result;
}

}  // namespace exsect

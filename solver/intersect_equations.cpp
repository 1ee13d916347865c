#include "intersect_equations.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/beyond_doubles.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "answer/placement.h"
#include "answer/run.h"
#include "curve/short_rational.h"
#include "filter/round_intersection.h"
#include "lift/coaxial_tori.h"
#include "lift/crossing_curve.h"
#include "lift/crossing_names.h"
#include "lift/curve_names.h"
#include "lift/ellipse_section.h"
#include "lift/lifted_course.h"
#include "lift/lifted_curve.h"
#include "lift/pair_region.h"
#include "lift/ring_curve.h"
#include "lift/shared_box.h"
#include "lift/space_sides.h"
#include "lift/sphere_boxes.h"
#include "lift/torus_drawing.h"
#include "lift/villarceau_circles.h"

namespace exsect {
namespace {

constexpr const char* kBeyondDoubles = "the common points must lie in the range of doubles";

/// Surfaces of smaller rank have the simpler charts.
int rank(const ImplicitSurface& surface) {
  switch (surface.kind()) {
    case SurfaceKind::cylinder:
      return 0;
    case SurfaceKind::sphere:
      return 1;
    case SurfaceKind::cone:
      return 2;
    case SurfaceKind::plane:
      return 3;
    case SurfaceKind::torus:
      return 4;
    default:
      return 5;
  }
}

SpaceNodeKind node_kind(int degree, bool is_singular, bool goes_on = false) {
  if (goes_on && degree == 1) return SpaceNodeKind::cut;
  if (degree == 0) return SpaceNodeKind::touch;
  if (degree == 1) return SpaceNodeKind::end;
  if (degree > 2) return SpaceNodeKind::crossing;
  return is_singular ? SpaceNodeKind::singular : SpaceNodeKind::joint;
}

void add_node(SurfaceIntersection& result, SpaceNodeKind kind, int degree, SpaceBox box,
              std::array<std::vector<std::string>, 2> bounds) {
  std::array<double, 3> approx{};
  for (std::size_t k = 0; k < 3; ++k) approx[k] = to_double(box[k].midpoint());
  result.nodes.push_back(
      {static_cast<int>(result.nodes.size()), kind, degree, std::move(box), approx, std::move(bounds)});
}

/// Every node of the curve has two ends of its arcs.
bool is_closed(const SurfaceIntersection& result, const SpaceCurve& curve) {
  std::vector<int> ends(result.nodes.size(), 0);
  for (const int arc : curve.arcs) {
    ++ends[static_cast<std::size_t>(result.arcs[static_cast<std::size_t>(arc)].from)];
    ++ends[static_cast<std::size_t>(result.arcs[static_cast<std::size_t>(arc)].to)];
  }
  return std::all_of(ends.begin(), ends.end(), [](int count) { return count % 2 == 0; });
}

void set_curves(SurfaceIntersection& result, std::vector<SpaceCurve> curves) {
  result.curves = std::move(curves);
  for (std::size_t i = 0; i < result.curves.size(); ++i) {
    SpaceCurve& named = result.curves[i];
    named.id = static_cast<int>(i);
    for (const int arc : named.arcs) result.arcs[static_cast<std::size_t>(arc)].curve = named.id;
    named.is_closed = is_closed(result, named);
  }
}

/// How narrow the boxes of nodes are in parameters.
Rational drawn_width(double tolerance, double extent) {
  return std::min<Rational>(power_of_two(-80), from_double(tolerance / extent));
}

/// Throws BeyondDoubles unless the extent is a positive number.
double drawable(double extent) {
  if (!(extent > 0 && std::isfinite(extent))) throw BeyondDoubles(kBeyondDoubles);
  return extent;
}

/// Of a curve's arc between two of its nodes.
template <class CurveArc>
void add_arc(SurfaceIntersection& result, const CurveArc& arc, int multiplicity, SpaceCourse course) {
  result.arcs.push_back({static_cast<int>(result.arcs.size()), 0, static_cast<int>(arc.from),
                         static_cast<int>(arc.to), multiplicity, std::move(course.points),
                         course.error_bound});
}

void draw(SurfaceIntersection& result, const LiftedCurve& curve, const PairRegion& region, const Run& run) {
  if (curve.nodes.empty()) return;
  const double extent = drawable(extent_of(curve.chart)), tolerance = run.drawn_tolerance(extent);
  for (std::size_t i = 0; i < curve.nodes.size(); ++i) {
    const LiftedNode& node = curve.nodes[i];
    add_node(result, node_kind(node.degree, node.is_singular, node.goes_on), node.degree,
             place_in_space(curve, i, drawn_width(tolerance, extent)), names_of(region, node.bounds));
  }
  for (std::size_t i = 0; i < curve.arcs.size(); ++i)
    add_arc(result, curve.arcs[i], curve.arcs[i].multiplicity, course_in_space(curve, i, tolerance));
  set_curves(result, named_curves(curve));
}

void draw(SurfaceIntersection& result, const TorusCurve& curve, const PairRegion& region, const Run& run) {
  if (curve.nodes.empty()) return;
  const TorusDrawing drawing(curve, run.drawn_tolerance(drawable(extent_of(curve.frame))));
  for (std::size_t i = 0; i < curve.nodes.size(); ++i)
    add_node(result, node_kind(curve.nodes[i].degree, curve.nodes[i].is_singular), curve.nodes[i].degree,
             drawing.box(i), names_of(region, curve.nodes[i].bounds));
  for (std::size_t i = 0; i < curve.arcs.size(); ++i)
    add_arc(result, curve.arcs[i], curve.factors[curve.arcs[i].factor].multiplicity, drawing.course(i));
  set_curves(result, named_curves(curve));
}

void draw(SurfaceIntersection& result, const RingCurve& curve, const PairRegion& region, const Run& run) {
  if (curve.nodes.empty()) return;
  const double extent = drawable(extent_of(curve)), tolerance = run.drawn_tolerance(extent);
  for (const RingNode& node : curve.nodes) {
    const LiftedCurve& half = curve.halves[node.half];
    const LiftedNode& at = half.nodes[node.below];
    add_node(result, node_kind(node.degree, node.degree == 2 && at.is_singular), node.degree,
             place_in_space(half, node.below, drawn_width(tolerance, extent)), names_of(region, at.bounds));
  }
  for (const RingArc& arc : curve.arcs) {
    const LiftedCurve& half = curve.halves[arc.half];
    add_arc(result, arc, half.arcs[arc.below].multiplicity, course_in_space(half, arc.below, tolerance));
  }
  set_curves(result, named_curves(curve));
}

SpaceBox point_box(const Point& p) {
  return {RationalInterval{p[0], p[0]}, RationalInterval{p[1], p[1]}, RationalInterval{p[2], p[2]}};
}

SurfaceIntersection open(std::string why, Reason reason) {
  SurfaceIntersection result{Status::incomplete};
  result.incomplete.push_back({std::move(why), reason});
  return result;
}

SurfaceIntersection solved_pair(const ImplicitSurface& first, const ImplicitSurface& second,
                                const PairRegion& region, const Run& run);

/// One node of those in one point.
void merge_nodes(SurfaceIntersection& result, const std::vector<std::size_t>& points) {
  std::vector<SpaceNode> nodes;
  std::map<std::size_t, int> place;
  std::vector<int> position;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [at, is_new] = place.emplace(points[i], static_cast<int>(nodes.size()));
    position.push_back(at->second);
    if (is_new) {
      nodes.push_back(std::move(result.nodes[i]));
      nodes.back().id = at->second;
      continue;
    }
    SpaceNode& known = nodes[static_cast<std::size_t>(at->second)];
    const int degree = known.degree + result.nodes[i].degree;
    if (known.degree == 0) known.kind = result.nodes[i].kind;
    if (known.degree > 0 && result.nodes[i].degree > 0) known.kind = node_kind(degree, true);
    known.degree = degree;
  }
  result.nodes = std::move(nodes);
  for (SpaceArc& arc : result.arcs) {
    arc.from = position[static_cast<std::size_t>(arc.from)];
    arc.to = position[static_cast<std::size_t>(arc.to)];
  }
}

SurfaceIntersection on_sphere(const SphereRegion& shared, const PairRegion& region, const Run& run) {
  SurfaceIntersection result{Status::complete, shared.has_inner_points};
  std::vector<std::size_t> points;
  for (const SphereCircle& circle : shared.circles) {
    SurfaceIntersection part{Status::complete};
    draw(part, circle.curve, region, run);
    append(result, std::move(part));
    points.insert(points.end(), circle.points.begin(), circle.points.end());
  }
  merge_nodes(result, points);
  return result;
}

/// Two surfaces with one equation: nappes of one cone that face away from each other share the apex.
SurfaceIntersection same(const ImplicitSurface& first, const ImplicitSurface& second,
                         const PairRegion& region, const Run& run) {
  if (first.bound() && second.bound() && dot(first.data()->axis, second.data()->axis) < 0) {
    SurfaceIntersection result{Status::complete};
    const Point& apex = first.data()->point;
    if (region.all.contains(apex))
      add_node(result, SpaceNodeKind::touch, 0, point_box(apex), names_of(region, bounds_at(region, apex)));
    return result;
  }
  if (are_equal(first.box(), second.box())) return {Status::complete, true};
  SurfaceIntersection result{Status::complete};
  const ImplicitSurface& known = first.data() ? first : second;
  if (!known.data())
    return open("two polynomials with a common factor are in different boxes", Reason::not_decided);
  if (const std::optional<SharedBox> shared = shared_box(first, second)) {
    result.is_same = shared->has_inner_points;
    for (const SharedCut& cut : shared->cuts)
      append(result, solved_pair(known, cut.surface, within(region, cut.region), run));
  } else {
    result = on_sphere(sphere_region(known, region.all), region, run);
  }
  for (SpaceArc& arc : result.arcs) arc.multiplicity = 0, arc.beside.reset();
  for (SpaceCurve& curve : result.curves) curve.multiplicity = 0;
  return result;
}

/// Two planes: a line is shown from one side of the point next to the first one's to the other, or as far as
/// it is in the boxes.
SurfaceIntersection planes(const ImplicitSurface& first, const ImplicitSurface& second,
                           const PairRegion& region, const Run& run) {
  const SurfaceData &one = *first.data(), &other = *second.data();
  const Point along = cross(one.axis, other.axis);
  const Rational off = dot(other.axis, other.point - one.point);
  if (is_zero(along))
    return off == 0 ? same(first, second, region, run) : SurfaceIntersection{Status::complete};
  const Point down = cross(along, one.axis);
  const Point point = one.point + off / dot(other.axis, down) * down;
  SurfaceIntersection result{Status::complete};
  const auto add_end = [&](const Rational& t, SpaceNodeKind kind, int degree) {
    const Point end = point + t * along;
    add_node(result, kind, degree, point_box(end), names_of(region, bounds_at(region, end)));
  };
  const std::optional<RationalInterval> part = part_of_line(region, point, along);
  if (!part) return result;
  if (part->lower == part->upper) {
    add_end(part->lower, SpaceNodeKind::touch, 0);
    return result;
  }
  for (const Rational& t : {part->lower, part->upper})
    add_end(t, region.all.clauses.empty() ? SpaceNodeKind::cut : SpaceNodeKind::end, 1);
  double error = 0;
  for (const SpaceNode& node : result.nodes)
    for (std::size_t k = 0; k < 3; ++k)
      error += to_double(abs(node.box[k].lower - from_double(node.approx[k])));
  error = error * kSlack + kUnderflowLoss;
  result.arcs.push_back(
      {0, 0, 0, 1, 1, {result.nodes[0].approx, result.nodes[1].approx}, error, SideSigns{-1, 1}});  // along
                                                                                                    // n1 x n2
  result.curves.push_back({0, SpaceCurveKind::line, {0}, false, 1, point, along});
  return result;
}

/// By a curve on a chart, or on charts, of the first surface; empty if there are none.
template <class Solve>
std::optional<SurfaceIntersection> solved_by(const ImplicitSurface& first, const ImplicitSurface& second,
                                             const PairRegion& region, const Run& run, Solve curve_on) {
  decltype(curve_on(first, second, region.all)) curve;
  run.timed("curve", [&] { curve = curve_on(first, second, region.all); });
  if (!curve) return std::nullopt;
  if (curve->is_same) return same(first, second, region, run);
  SurfaceIntersection result{Status::complete};
  run.timed("drawing", [&] { draw(result, *curve, region, run); });
  run.timed("sides", [&] { add_sides(result, *curve, first, second); });
  return result;
}

/// A torus with what has no bound but its box, in one of the torus's charts; empty if it has none over Q.
std::optional<SurfaceIntersection> on_torus(const ImplicitSurface& torus, const ImplicitSurface& other,
                                            const PairRegion& region, const Run& run) {
  return solved_by(torus, other, region, run, torus_curve);
}

/// The same in two halves, if the ratio of its radii is rational.
std::optional<SurfaceIntersection> on_ring(const ImplicitSurface& torus, const ImplicitSurface& other,
                                           const PairRegion& region, const Run& run) {
  return solved_by(torus, other, region, run, ring_curve);
}

/// The answer for both surfaces in the other order, from that in this one.
SurfaceIntersection in_other_order(SurfaceIntersection result, const ImplicitSurface& first,
                                   const ImplicitSurface& second) {
  exchange_sides(result, first.equation(), second.equation());
  return result;
}

/// Of two tori the one that is taken in whichever order they come.
bool is_before(const SurfaceData& a, const SurfaceData& b) {
  return std::tie(a.minor_squared, a.squared, a.point) < std::tie(b.minor_squared, b.squared, b.point);
}

std::optional<SurfaceIntersection> tori(const ImplicitSurface& first, const ImplicitSurface& second,
                                        const PairRegion& region, const Run& run) {
  if (is_before(*second.data(), *first.data())) {
    std::optional<SurfaceIntersection> result = tori(second, first, region, run);
    if (result) result = in_other_order(*std::move(result), second, first);
    return result;
  }
  if (const auto coaxial = coaxial_section(*first.data(), *second.data())) {
    if (coaxial->is_same) return same(first, second, region, run);
    if (!coaxial->surface) return SurfaceIntersection{Status::complete};
    SurfaceIntersection result =
        solved_pair(first, *coaxial->surface, within(region, coaxial->surface->region()), run);
    if (coaxial->is_reversed) negate_sides(result);
    return result;
  }
  std::optional<SurfaceIntersection> result;
  for (const auto solve : {on_torus, on_ring}) {
    if (!result) result = solve(first, second, region, run);
    if (!result && (result = solve(second, first, region, run)))
      result = in_other_order(*std::move(result), second, first);
  }
  if (result) {
    name_villarceau_circles(*result, *first.data(), *second.data());
    set_curves(*result, std::move(result->curves));
  }
  return result;
}

std::optional<SurfaceIntersection> lifted(const ImplicitSurface& first, const ImplicitSurface& second,
                                          const PairRegion& region, const Run& run) {
  return solved_by(first, second, region, run, lifted_curve);
}

/// By their equations alone.
SurfaceIntersection crossing(const ImplicitSurface& first, const ImplicitSurface& second,
                             const PairRegion& region, const Run& run) {
  CrossingCurve curve;
  run.timed("curve", [&] {
    curve = crossing_curve(first.equation(), second.equation(), region.all,
                           [&](double extent) { return run.drawn_tolerance(drawable(extent)); });
  });
  if (curve.open) return open(curve.open->why, curve.open->reason);
  if (curve.is_same && !region.all.clauses.empty()) return same(first, second, region, run);
  SurfaceIntersection result{Status::complete, curve.is_same};
  const Point height = curve.projection ? curve.projection->frame.height : Point{};
  for (CrossingNode& node : curve.nodes)
    add_node(result, node_kind(node.degree, node.is_singular, node.goes_on), node.degree, std::move(node.box),
             names_of(region, node.bounds));
  for (CrossingArc& arc : curve.arcs) {
    add_arc(result, arc, arc.multiplicity, {std::move(arc.points), arc.error_bound});
    const auto& [f, g] = curve.forms[arc.factor];
    result.arcs.back().beside = sides_from({f, g, arc.sense, height, cube_of(arc.begin)}, first.equation(),
                                           second.equation(), arc.multiplicity);
  }
  set_curves(result, named_curves(curve));
  return result;
}

SurfaceIntersection solved_pair(const ImplicitSurface& first, const ImplicitSurface& second,
                                const PairRegion& region, const Run& run) {
  if (rank(first) > rank(second))
    return in_other_order(solved_pair(second, first, region, run), second, first);
  if (first.kind() == SurfaceKind::plane && second.kind() == SurfaceKind::plane)
    return planes(first, second, region, run);
  std::optional<SurfaceIntersection> result;
  const auto tolerance = [&](double extent) { return run.drawn_tolerance(drawable(extent)); };
  run.timed("drawing", [&] { result = ellipse_intersection(first, second, region, tolerance); });
  if (result) return *std::move(result);
  if (!run.exact() && are_equal(region.all, pair_region(first, second).all))
    run.timed("filter", [&] { result = round_intersection(first, second, tolerance); });
  if (result) {
    run.count("filtered", 1);
    return *std::move(result);
  }
  if (first.kind() != SurfaceKind::torus)
    result = lifted(first, second, region, run);
  else if (second.kind() == SurfaceKind::torus)
    result = tori(first, second, region, run);
  else {
    for (const auto solve : {on_torus, on_ring})
      if (!result) result = solve(first, second, region, run);
  }
  return result ? *std::move(result) : crossing(first, second, region, run);
}

SurfaceIntersection answered_pair(const ImplicitSurface& first, const ImplicitSurface& second,
                                  const Run& run) {
  const InterruptionScope scope(run.stop());
  try {
    SurfaceIntersection result = solved_pair(first, second, pair_region(first, second), run);
    add_sides_around(result, first.equation(), second.equation());
    if (result.is_same) result.normals = sign_of_quotient(first.equation(), second.equation());
    return result;
  } catch (const Interrupted&) {
    return open("the work cap was reached", Reason::time);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::logic_error& error) {
    return open(std::string("a proof failed: ") + error.what(), Reason::failed_proof);
  }
}

/// The point of a plane, or of the axis of a cylinder, that is next to q; the centre or apex of others.
Point reference_point(const SurfaceData& data, SurfaceKind kind, const Point& q) {
  const Point off = q - data.point;
  if (kind == SurfaceKind::plane) return q - dot(data.axis, off) / dot(data.axis, data.axis) * data.axis;
  if (kind == SurfaceKind::cylinder)
    return data.point + dot(data.axis, off) / dot(data.axis, data.axis) * data.axis;
  return data.point;
}

/// A box about the reference points with the radii. Empty if there is a polynomial.
std::vector<Point> model_points(const ImplicitSurface& first, const ImplicitSurface& second) {
  if (!first.data() || !second.data()) return {};
  const Point other = reference_point(*second.data(), second.kind(), first.data()->point);
  std::vector<Point> points;
  for (const ImplicitSurface* surface : {&first, &second}) {
    const Point at = reference_point(*surface->data(), surface->kind(), other);
    const bool is_cone = surface->kind() == SurfaceKind::cone;  // whose slope is no length
    const Rational reach =
        is_cone ? Rational(0)
                : root_above(surface->data()->squared) + root_above(surface->data()->minor_squared);
    points.push_back(at - reach * Point{1, 1, 1});
    points.push_back(at + reach * Point{1, 1, 1});
  }
  return points;
}

/// Throws BeyondDoubles if a coordinate is not in their range.
void restore(SurfaceIntersection& result, const Placement& place) {
  const auto checked = [&](std::array<double, 3>& point) {
    const double moved = place.restore(point);
    if (!std::isfinite(moved)) throw BeyondDoubles(kBeyondDoubles);
    return moved;
  };
  for (SpaceNode& node : result.nodes) {
    Point lower, upper;
    for (std::size_t k = 0; k < 3; ++k) lower[k] = node.box[k].lower, upper[k] = node.box[k].upper;
    lower = place.restored(lower);
    upper = place.restored(upper);
    for (std::size_t k = 0; k < 3; ++k) node.box[k] = {lower[k], upper[k]};
    checked(node.approx);
  }
  for (SpaceArc& arc : result.arcs) {
    double moved = 0;
    for (std::array<double, 3>& point : arc.polyline) moved = larger_bound(moved, checked(point));
    arc.error_bound = place.restored(arc.error_bound, moved);
  }
  for (SpaceCurve& curve : result.curves) {
    if (curve.point) curve.point = place.restored(*curve.point);
    if (curve.radius_squared) *curve.radius_squared *= place.scale() * place.scale();
  }
}

/// The model is moved and scaled where that helps.
SurfaceIntersection pair_in_place(const ImplicitSurface& first, const ImplicitSurface& second,
                                  const Run& run) {
  const std::vector<Point> points = model_points(first, second);
  const auto place = points.empty() ? std::nullopt : Placement::of(points);
  if (!place) return answered_pair(first, second, run);
  SurfaceIntersection result = answered_pair(place->placed(first), place->placed(second),
                                             run.with_tolerance(place->left_of(run.tolerance(1))));
  restore(result, *place);
  return result;
}

}  // namespace

SurfaceIntersection intersect(const ImplicitSurface& first, const ImplicitSurface& second,
                              const IntersectOptions& options) {
  return in_nearest_rounding([&] {
    const Run run(options);
    SurfaceIntersection result = pair_in_place(first, second, run);
    result.work = run.finished({result.status, {}, {}, {}}).work;
    return result;
  });
}

}  // namespace exsect

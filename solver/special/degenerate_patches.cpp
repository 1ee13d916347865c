#include "special/degenerate_patches.h"

#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/line_query.h>

#include <algorithm>
#include <functional>

#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "answer/parameter_names.h"
#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"
#include "line/exact_line_points.h"
#include "line/line_system.h"
#include "shape/patch_shape.h"
#include "side/line_arcs.h"
#include "trace/landmark_node.h"

namespace exsect {

namespace {

const Rational& box_width() {
  static const Rational width = power_of_two(-50);
  return width;
}

/// An exact parameter value in [0,1] in a box, sides exact.
RationalInterval box_of(const RealAlgebraic& value) {
  for (const int side : {0, 1})
    if (value.compare(side) == 0) return {side, side};
  const RationalInterval i = value.refined_to(box_width()).interval();
  return {std::max<Rational>(i.lower, 0), std::min<Rational>(i.upper, 1)};
}

/// The sides of the squares on which a box with exact sides lies.
std::vector<Side> sides_of(const ParameterBox& box) {
  std::vector<Side> sides;
  for (const Parameter p : all_parameters)
    for (const int value : {0, 1})
      if (box[index(p)].lower == value && box[index(p)].upper == value) sides.push_back({p, value});
  return sides;
}

bool disjoint(const RationalInterval& a, const RationalInterval& b) {
  return a.upper < b.lower || b.upper < a.lower;
}

/// (r,s) boxes of distinct points, pairwise disjoint.
std::vector<std::array<RationalInterval, 2>> separate_boxes(const std::vector<TriangularPoint>& points) {
  const auto boxes_at = [&](const Rational& width) {
    std::vector<std::array<RationalInterval, 2>> boxes;
    for (const TriangularPoint& p : points) {
      const TriangularPoint fine = p.refined_to(width);
      boxes.push_back({fine.r_interval(), fine.s().interval()});
    }
    return boxes;
  };
  const auto separated = [](const auto& boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!disjoint(boxes[i][0], boxes[j][0]) && !disjoint(boxes[i][1], boxes[j][1])) return false;
    return true;
  };
  Rational width = box_width();
  auto boxes = boxes_at(width);
  for (; !separated(boxes); width *= width) boxes = boxes_at(width);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      for (const int side : {0, 1}) {
        const BivariatePolynomial& variable = k == 0 ? BivariatePolynomial::r() : BivariatePolynomial::s();
        RationalInterval& box = boxes[i][k];
        if (sign_at(variable - BivariatePolynomial::constant(side), points[i]) == 0) box = {side, side};
        box = {std::max<Rational>(box.lower, 0), std::min<Rational>(box.upper, 1)};
      }
  return boxes;
}

/// One pair whose first patch is a point or a curve p(u), whose second one is of no lower dimension and, if
/// it is a curve, q(r).
class DegeneratePair {
 public:
  DegeneratePair(const BezierPatch& x, const BezierPatch& y, const Run& run)
      : x_(x), y_(y), run_(run), scale_(model_scale(x, y)) {}

  IntersectResult run() {
    const PatchShape first = shape(x_);
    const PatchShape second = shape(y_);
    if (first == PatchShape::curve || second == PatchShape::curve) {
      incomplete(
          "a patch is a curve whose points have curves of parameters: its two partial derivatives are "
          "parallel everywhere");
    } else if (first == PatchShape::point) {
      second == PatchShape::surface ? point_on_surface() : point_on_curve(second);
    } else {
      second == PatchShape::surface ? curve_on_surface() : curve_on_curve();
    }
    return finished(std::move(graph_), {}, std::move(result_.incomplete));
  }

 private:
  void incomplete(const std::string& why) { result_.incomplete.push_back({whole_domain(), why}); }

  /// x - y along coordinate k, with x the point (0 at x(0,0)), on the square of y.
  std::vector<BivariatePolynomial> equations() const {
    const PolynomialVector result = coordinates_from(y_, x_.net()[0][0]);
    return {result.begin(), result.end()};
  }

  void add_point(ParameterBox box, std::vector<Parameter> free) {
    graph_.add_isolated(add_node(std::move(box), std::move(free)));
  }

  int add_node(ParameterBox box, std::vector<Parameter> free) {
    for (const Parameter p : free) box[index(p)] = {0, 1};
    const PairSystem<DoubleBall> system(x_, y_, scale_.origin, scale_.frame.exponent);
    const BallPoint<DoubleBall> ball = {DoubleBall::enclosing(box[0]), DoubleBall::enclosing(box[1]),
                                        DoubleBall::enclosing(box[2]), DoubleBall::enclosing(box[3])};
    Node node = landmark_node(system, scale_.frame, ball, box, sides_of(box));
    if (node.on.empty()) node.kinds.clear();
    node.free = std::move(free);
    return graph_.add_node(std::move(node));
  }

  void point_on_curve(PatchShape second) {
    using enum Parameter;
    Polynomial common;
    for (const BivariatePolynomial& e : equations()) common = gcd(common, e.at_s(0));
    if (second == PatchShape::point) {
      if (common.is_zero()) add_point({}, {u, v, r, s});
    } else if (common.degree() > 0) {
      for (const RealAlgebraic& root : real_roots(common, 0, 1))
        add_point({RationalInterval{}, {}, box_of(root), {}}, {u, v, s});
    }
  }

  void point_on_surface() {
    using enum Parameter;
    const CommonZeros zeros = common_zeros(equations());
    for (const auto& [in_r, in_s] : separate_boxes(zeros.points))
      add_point({RationalInterval{}, {}, in_r, in_s}, {u, v});
    const ContentAndPart in_s = split_content(zeros.curve);
    const ContentAndPart in_r = split_content(in_s.primitive.exchanged());
    if (in_s.content.degree() > 0)
      for (const RealAlgebraic& root : real_roots(in_s.content, 0, 1))
        add_point({RationalInterval{}, {}, {}, box_of(root)}, {u, v, r});
    if (in_r.content.degree() > 0)
      for (const RealAlgebraic& root : real_roots(in_r.content, 0, 1))
        add_point({RationalInterval{}, {}, box_of(root), {}}, {u, v, s});
    if (!component_points(squarefree(in_r.primitive)).empty())
      incomplete("the second patch maps a curve of its parameters that is no parameter line to this point");
  }

  void curve_on_surface() {
    for (const CertifiedPoint& point : exact_line_points(x_, y_, line()).points)
      add_point(point.box(), {Parameter::v});
    const LineArcs arcs = arcs_on(y_);
    for (const CollapsedLine& collapsed : arcs.collapsed) add_collapsed(collapsed);
    add_arcs(arcs, {Parameter::v}, [](const LineArc&) { return true; });
  }

  /// The second curve q(r) as the side s = 0 of a strip q(r) + s m: what the first one has in common with the
  /// strip elsewhere is left out.
  void curve_on_curve() {
    const std::optional<BezierPatch> strip = separating_strip();
    if (!strip) {
      incomplete("the second curve is folded, or could not be told from the first one's neighbourhood");
      return;
    }
    const Side on_curve = {Parameter::s, 0};
    for (const CertifiedPoint& point : exact_line_points(x_, *strip, line()).points)
      if (point.on(on_curve)) add_point(point.box(), {Parameter::v, Parameter::s});
    add_arcs(arcs_on(*strip), {Parameter::v, Parameter::s},
             [&](const LineArc& arc) { return arc.inside.on(on_curve); });
  }

  /// A regular strip of which the first curve meets no arc off the side s = 0.
  std::optional<BezierPatch> separating_strip() const {
    const ParameterLine q = line_at_second(y_, 0);
    if (shape(q) == LineShape::folded) return std::nullopt;
    const Point n = cross(q.a[1], q.a[2]);
    for (int i = 0; i < 12; ++i) {
      const Point m = {Rational(1 + i * i % 7), Rational(i * i * i % 11 - 3), Rational(5 * i % 13 - 6)};
      const bool regular = is_zero(n) ? !is_zero(cross(q.a[1] + q.a[2], m)) : dot(n, m) != 0;
      if (!regular) continue;
      const Rational length = from_double(scale_.extent > 0 ? scale_.extent : 1);
      const BezierPatch strip = BezierPatch::from_power_basis({{{q.a[0], length * m, Point{0, 0, 0}},
                                                                {q.a[1], Point{0, 0, 0}, Point{0, 0, 0}},
                                                                {q.a[2], Point{0, 0, 0}, Point{0, 0, 0}}}});
      const LineSystem system = line_system(line_and_patch(x_, strip, line()));
      BivariatePolynomial shared = gcd(system.first, system.second);
      if (shared.is_zero()) continue;
      if (shared.at_s(0).is_zero()) shared = exact_quotient(shared, BivariatePolynomial::s());
      if (shared.degree_r() <= 0 && shared.degree_s() <= 0) return strip;
    }
    return std::nullopt;
  }

  static LineQuery line() { return {Parameter::v, 0}; }

  LineArcs arcs_on(const BezierPatch& surface) const {
    return line_arcs(x_, surface, line(), scale_, run_.drawn_tolerance(scale_.extent), stop_);
  }

  void add_collapsed(const CollapsedLine& collapsed) {
    ParameterBox box{};
    box[index(Parameter::u)] = box_of(collapsed.t);
    box[index(collapsed.fixed)] = box_of(collapsed.value);
    add_point(box, {Parameter::v, collapsed.fixed == Parameter::s ? Parameter::r : Parameter::s});
  }

  void add_arcs(const LineArcs& arcs, const std::vector<Parameter>& free,
                const std::function<bool(const LineArc&)>& wanted) {
    std::vector<int> nodes(arcs.ends.size(), -1);
    const auto node = [&](std::size_t end) {
      if (nodes[end] < 0) nodes[end] = add_node(arcs.ends[end].box(), free);
      return nodes[end];
    };
    for (const LineArc& arc : arcs.arcs)
      if (wanted(arc)) add_arc(arc, node(arc.from), node(arc.to), free);
    if (arcs.incomplete) incomplete(*arcs.incomplete);
  }

  void add_arc(const LineArc& line_arc, int from, int to, const std::vector<Parameter>& free) {
    Arc arc{};
    arc.from = from;
    arc.to = to;
    const auto runs_along = [&](const Side& side) {
      return std::find(free.begin(), free.end(), side.parameter) == free.end();
    };
    const std::vector<Side>& sides = line_arc.inside.sides();
    arc.place =
        std::any_of(sides.begin(), sides.end(), runs_along) ? ArcPlace::patch_boundary : ArcPlace::interior;
    arc.contact = Contact::tangential;
    arc.polyline = line_arc.polyline;
    for (PolylineVertex& vertex : arc.polyline)
      for (const Parameter p : free) vertex.parameters[index(p)] = 0.5;
    arc.error_bound = line_arc.error_bound;
    arc.free = free;
    graph_.add_arc(std::move(arc));
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const Run& run_;
  ModelScale scale_;
  StopRequest stop_ = run_.stop();
  GraphBuilder graph_;
  IntersectResult result_{};
};

int dimension(PatchShape s) { return s == PatchShape::point ? 0 : s == PatchShape::surface ? 2 : 1; }

}  // namespace

std::optional<IntersectResult> intersect_degenerate(const BezierPatch& x, const BezierPatch& y,
                                                    const Run& run) {
  using enum Parameter;
  const PatchShape first = shape(x);
  const PatchShape second = shape(y);
  if (first == PatchShape::surface && second == PatchShape::surface) return std::nullopt;
  ParameterNames names = {u, v, r, s};
  BezierPatch a = x;
  BezierPatch b = y;
  if (first == PatchShape::curve_of_second) {
    a = a.exchanged();
    std::swap(names[0], names[1]);
  }
  if (second == PatchShape::curve_of_second) {
    b = b.exchanged();
    std::swap(names[2], names[3]);
  }
  // A folded curve can be the first one, not the second one.
  const bool folded = dimension(second) == 1 && second != PatchShape::curve &&
                      shape(line_at_second(b, 0)) == LineShape::folded;
  if (dimension(first) > dimension(second) || (folded && dimension(first) == 1)) {
    std::swap(a, b);
    names = {names[2], names[3], names[0], names[1]};
  }
  IntersectResult result = DegeneratePair(a, b, run).run();
  rename_parameters(result, names);
  return result;
}

}  // namespace exsect

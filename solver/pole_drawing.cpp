#include "pole_drawing.h"

#include <exsect/algebra/nearest_double.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "answer/chord_count.h"
#include "curve/polynomial_vector.h"
#include "filter/filter.h"
#include "filter/magnified_box.h"
#include "side/collapsed_line.h"
#include "special/pole_directions.h"

namespace exsect {
namespace {

/// Of one neighbourhood to the next smaller one.
const Rational kNextReach(1, 4);
const Rational kLeastReach = power_of_two(-24);
/// Of a point's coordinates: rounded to doubles, and sums of a few.
constexpr double kPointRounding = 0x1p-50;

bool is_drawn_by_chords(const PoleNeighbourhood& all, double tolerance) {
  return std::ranges::all_of(all.arcs,
                             [&](const PoleArc& arc) { return arc.ray || 2 * arc.bend <= tolerance; });
}

double size_of(const std::array<double, 3>& p) {
  return larger_bound(std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]));
}

double distance_bound(const std::array<double, 3>& p, const std::array<double, 3>& q) {
  return kSlack *
         (length_bound(p[0] - q[0], p[1] - q[1], p[2] - q[2]) + kPointRounding * (size_of(p) + size_of(q)));
}

/// The end of the pole's side in the direction of which the arc may begin, or its middle.
double first_t(const PoleArc& arc) {
  const auto holds = [&](int t) { return arc.along.lower <= t && t <= arc.along.upper; };
  return holds(0) ? 0 : holds(1) ? 1 : to_double(arc.along.midpoint());
}

/// One arc from the side u = 0 to the side u = 1, and nothing else.
bool leads_across(const IntersectionGraph& graph) {
  const auto is_end = [](const Node& node) {
    return node.on.size() == 1 && node.on[0].parameter == Parameter::u && node.free.empty();
  };
  return graph.arcs.size() == 1 && graph.nodes.size() == 2 && graph.isolated_points.empty() &&
         graph.overlaps.empty() && std::ranges::all_of(graph.nodes, is_end) &&
         graph.nodes[0].on[0].value != graph.nodes[1].on[0].value;
}

/// Of a parameter of y in the pole.
bool is_free(const RationalInterval& at) { return at.width() == 1; }

/// The box of the arc over from <= a <= to.
ParameterBox box_of(const PoleArc& arc, const Rational& from, const Rational& to) {
  return {RationalInterval{from, to}, arc.along, arc.on_other[0], arc.on_other[1]};
}

/// Of x_aa on the ray: with X - P X_4 = z w, z w' + z' w and so on as in (14.29).
double second_derivative_bound(const PolePair& pair, const PoleRay& ray, double reach) {
  const Rational width = power_of_two(-60);
  const Rectangle on = {{0, from_double(reach)}, {ray.t - width, ray.t + width}};
  const BivariatePolynomial w = pair.x.component(3);
  const DoubleBall inverse = inverse_range(w, on), w_a = range_on(w.derivative_r(), on),
                   w_aa = range_on(w.derivative_r().derivative_r(), on);
  double square = 0;
  for (const BivariatePolynomial& f : coordinates_from(pair.x, pair.pole.point)) {
    const DoubleBall z = range_on(f, on) * inverse,
                     z_a = (range_on(f.derivative_r(), on) - w_a * z) * inverse;
    const double second =
        ((range_on(f.derivative_r().derivative_r(), on) - DoubleBall(2) * w_a * z_a - w_aa * z) * inverse)
            .upper_magnitude();
    square += second * second;
  }
  return kSlack * std::sqrt(square);
}

/// Into the squares, and on the arc's sides.
void settle(const PoleArc& arc, std::vector<PolylineVertex>& polyline) {
  for (PolylineVertex& vertex : polyline) {
    for (double& t : vertex.parameters) t = std::clamp(t, 0.0, 1.0);
    for (const Side& side : arc.on) vertex.parameters[index(side.parameter)] = side.value;
  }
}

}  // namespace

PoleDrawing::PoleDrawing(const PolePair& pair, PoleNeighbourhood all, const Run& run)
    : pair_(pair), run_(run), levels_{std::move(all)} {
  const double tolerance = run.drawn_tolerance(pair.extent);
  while (!is_drawn_by_chords(levels_.back(), tolerance)) {
    const Rational reach = levels_.back().reach * kNextReach;
    if (reach < kLeastReach) return;
    auto arcs = pair.near_pole(reach, {});
    if (!arcs) return;
    levels_.push_back({reach, *std::move(arcs)});
  }
}

PolylineVertex PoleDrawing::pole_vertex() const {
  PolylineVertex vertex{};
  vertex.parameters = {0, 0.5, to_double(pair_.pole.at[0].midpoint()),
                       to_double(pair_.pole.at[1].midpoint())};
  for (std::size_t c = 0; c < 3; ++c) vertex.point[c] = to_double(pair_.pole.point[c]);
  return vertex;
}

Node PoleDrawing::node() const {
  const PolylineVertex vertex = pole_vertex();
  Node node{};
  node.kinds = {NodeKind::boundary};
  node.on = {{Parameter::u, 0}};
  node.free = {Parameter::v};
  for (std::size_t j = 0; j < 2; ++j) {
    const RationalInterval& at = pair_.pole.at[j];
    for (const int value : {0, 1})
      if (at.lower == value && at.upper == value) node.on.push_back({all_parameters[2 + j], value});
    if (is_free(at)) node.free.push_back(all_parameters[2 + j]);
  }
  if (is_corner(node.on)) node.kinds.push_back(NodeKind::corner);
  node.box = {RationalInterval{0, 0}, RationalInterval{0, 1}, pair_.pole.at[0], pair_.pole.at[1]};
  node.approx = vertex.parameters;
  node.point = vertex.point;
  return node;
}

Arc PoleDrawing::arc(std::size_t which, const PolylineVertex& end) const {
  Arc drawn{};
  const PoleArc& first = levels_[0].arcs[which];
  drawn.place = first.on.empty() ? ArcPlace::interior : ArcPlace::patch_boundary;
  drawn.contact = first.contact;
  drawn.polyline = {end};
  if (first.ray) {
    add_ray(*first.ray, drawn);
    std::ranges::reverse(drawn.polyline);
    return drawn;
  }
  const PoleArc* last = &first;
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    const PoleArc* next = continued(*last, levels_[i]);
    if (next == nullptr || !add_piece(*last, levels_[i].reach, levels_[i - 1].reach, drawn)) break;
    last = next;
  }
  add_chord(*last, drawn);
  settle(first, drawn.polyline);
  std::ranges::reverse(drawn.polyline);
  return drawn;
}

/// The arc inside of a smaller neighbourhood, which is the only one of it over a common t.
const PoleArc* PoleDrawing::continued(const PoleArc& arc, const PoleNeighbourhood& inside) const {
  const PoleArc* result = nullptr;
  for (const PoleArc& other : inside.arcs) {
    if (other.along.upper < arc.along.lower || arc.along.upper < other.along.lower) continue;
    if (result != nullptr) return nullptr;
    result = &other;
  }
  return result;
}

/// Adds the part over from <= a <= to, of which the end is drawn; false if it is not found.
bool PoleDrawing::add_piece(const PoleArc& arc, const Rational& from, const Rational& to, Arc& drawn) const {
  auto piece = filter::intersect_over(pair_.x, pair_.y, box_of(arc, from, to), pair_.extent,
                                      run_.with_turning({}), intersect_in_doubles, leads_across);
  if (!piece) return false;
  Arc& part = piece->graph.arcs[0];
  if (part.polyline.front().parameters[0] < part.polyline.back().parameters[0])
    std::ranges::reverse(part.polyline);
  const double moved = distance_bound(part.polyline.front().point, drawn.polyline.back().point);
  drawn.error_bound = larger_bound(drawn.error_bound, kSlack * (part.error_bound + moved));
  drawn.polyline.insert(drawn.polyline.end(), part.polyline.begin() + 1, part.polyline.end());
  return true;
}

/// All of the line x(.,t) to the pole: chords of the length d in a are within |x_aa| d^2 / 8 of it.
void PoleDrawing::add_ray(const PoleRay& ray, Arc& drawn) const {
  const double reach = to_double(levels_[0].reach), bend = second_derivative_bound(pair_, ray, reach);
  const int n = chord_count(reach * std::sqrt(bend / (4 * run_.drawn_tolerance(pair_.extent))), 1);
  for (int i = n; i >= 0; --i) {
    const Rational a = levels_[0].reach * Rational(i, n);
    PolylineVertex vertex = pole_vertex();
    vertex.parameters[0] = to_double(a);
    vertex.parameters[1] = to_double(ray.t);
    for (std::size_t j = 0; j < 2; ++j)
      vertex.parameters[2 + j] =
          to_double((ray.on_other[j][0] + ray.on_other[j][1] * a) / (1 + ray.bend * a));
    const Point at = pair_.x(a, ray.t);
    for (std::size_t c = 0; c < 3; ++c) vertex.point[c] = to_double(at[c]);
    if (i < n) {
      drawn.polyline.push_back(vertex);
      continue;
    }
    const double moved = distance_bound(vertex.point, drawn.polyline.back().point);
    drawn.error_bound =
        kSlack * (bend * (reach / n) * (reach / n) / 8 + moved +
                  2 * kPointRounding * (size_of(vertex.point) + size_of(pole_vertex().point)));
  }
}

/// To the pole.
void PoleDrawing::add_chord(const PoleArc& arc, Arc& drawn) const {
  PolylineVertex pole = pole_vertex();
  pole.parameters[1] = first_t(arc);
  for (std::size_t j = 0; j < 2; ++j)
    if (is_free(pair_.pole.at[j])) pole.parameters[2 + j] = to_double(arc.on_other[j].midpoint());
  std::array<double, 3> end = pole.point;
  for (std::size_t c = 0; c < 3; ++c) end[c] += arc.step[c];
  const double off = distance_bound(drawn.polyline.back().point, end) + kPointRounding * size_of(pole.point);
  drawn.error_bound = larger_bound(drawn.error_bound, kSlack * (arc.bend + off));
  drawn.polyline.push_back(pole);
}

}  // namespace exsect

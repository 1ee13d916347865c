#include "certificate/events.h"

#include <exsect/checker/check_certificate.h>
#include <exsect/checker/star_maps.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "certificate/claims.h"

namespace exsect::cli {
namespace {

/// d, which depends on the parameter p alone, is monotone in it: all steps of its control values have one
/// sign.
bool monotone(const Point& d, const checker::Net<Rational>& control, std::size_t p) {
  int all = 0;
  for (std::size_t k = 0; k < control.degree(p); ++k) {
    const int step = sign(dot(d, control.along(p, k + 1, 0) - control.along(p, k, 0)));
    if (step == 0 || step * all < 0) return false;
    all = step;
  }
  return true;
}

bool has(const Node& node, NodeKind kind) {
  return std::find(node.kinds.begin(), node.kinds.end(), kind) != node.kinds.end();
}

}  // namespace

bool is_star(const IntersectionGraph& graph, const Node& node, bool self) {
  const auto& isolated = graph.isolated_points;
  return std::find(isolated.begin(), isolated.end(), node.id) != isolated.end() ||
         has(node, NodeKind::crossing) || has(node, NodeKind::touch) || (!self && has(node, NodeKind::cusp));
}

void refuse_events(const IntersectResult& result, bool self) {
  if (result.status != Status::complete) throw NoCertificate("the result is incomplete");
  const IntersectionGraph& graph = result.graph;
  for (const Node& node : graph.nodes) {
    if (!node.free.empty()) throw NoCertificate("a node with a free parameter");
    const auto ends_here = [&](const Arc& arc) { return arc.from == node.id || arc.to == node.id; };
    const bool alone = std::none_of(graph.arcs.begin(), graph.arcs.end(), ends_here);
    if (is_star(graph, node, self) || (alone && !graph.overlaps.empty())) continue;
    const bool cusp = self && node.kinds == std::vector{NodeKind::cusp};
    if (has(node, NodeKind::cusp) && !cusp) throw NoCertificate("a cuspidal point on a side");
    if (!cusp && node.on.empty() && node.wrt.empty()) throw NoCertificate("a node inside a curve");
  }
  for (const Arc& arc : graph.arcs) {
    if (!arc.free.empty()) throw NoCertificate("an arc with a free parameter");
  }
}

/// The shortest rationals in the node's box, which are its parameters if these are short.
std::array<Rational, 4> short_place(const Node& node) {
  std::array<Rational, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [lower, upper] = node.box[i];
    result[i] = lower == upper ? lower : simplest_between(lower, upper);
  }
  return result;
}

std::vector<Point> related_directions(const Patches& patches) {
  std::array<checker::Net<Rational>, 2> power;
  std::array<checker::Net<Rational>, 2> control;
  for (std::size_t n = 0; n < 2; ++n) {
    if (!patches[n].is_polynomial()) return {};
    power[n] = power_basis(patches[n]).points;
    control[n] = control_net(patches[n]).points;
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      std::vector<Point> vectors;
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 1; b < 4; ++b) {
          vectors.push_back(power[0].along(i, a, b));
          vectors.push_back(power[1].along(j, a, b));
        }
      }
      Point d = {};
      for (const Point& a : vectors)
        for (const Point& b : vectors)
          if (is_zero(d)) d = cross(a, b);
      const auto in_plane = [&](const Point& a) { return dot(d, a) == 0; };
      if (is_zero(d) || !std::all_of(vectors.begin(), vectors.end(), in_plane)) continue;
      if (!monotone(d, control[0], i) || !monotone(d, control[1], j)) continue;
      result.push_back(d);
    }
  }
  return result;
}

Rational value(const Point& a, const Rational& t) { return a[0] + t * (a[1] + t * a[2]); }

namespace {

/// Of F along a line at most.
int degree_along_line(const ExactMap& equation) {
  int most = 0;
  for (const auto& term : equation.terms())
    most = std::max(most, std::accumulate(term.power.begin(), term.power.end(), 0));
  return 2 * most;
}

/// The two places and the slope at the first one, 0 for a straight line, give a line; nothing if it is no
/// solution.
std::optional<Line> line_through(const ExactMap& equation, std::size_t axis, const std::array<Rational, 4>& a,
                                 const std::array<Rational, 4>& b,
                                 const std::optional<checker::Vector4<Rational>>& slope) {
  Line line = {axis, {}};
  const Rational t = a[axis];
  const Rational step = b[axis] - t;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational mean = (b[i] - a[i]) / step;
    const Rational first = slope ? (*slope)[i] : mean;
    const Rational bend = (mean - first) / step;  // a + first (s - t) + bend (s - t)^2
    line.at[i] = {a[i] - first * t + bend * t * t, first - 2 * bend * t, bend};
  }
  const int degree = degree_along_line(equation);
  for (int k = 0; k <= degree; ++k) {
    const auto at = [&](std::size_t i) { return value(line.at[i], Rational(k)); };
    if (!is_solution(equation, {at(0), at(1), at(2), at(3)})) return std::nullopt;
  }
  return line;
}

}  // namespace

std::optional<Line> line_between(const ExactMap& equation, const Node& from, const Node& to) {
  const std::array<Rational, 4> a = short_place(from);
  const std::array<Rational, 4> b = short_place(to);
  const auto length = [&](std::size_t j) { return Rational(abs(Rational(b[j] - a[j]))); };
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (length(i) > length(axis)) axis = i;
  if (a[axis] == b[axis]) return std::nullopt;
  if (auto line = line_through(equation, axis, a, b, std::nullopt)) return line;
  if (!is_solution(equation, a)) return std::nullopt;
  const auto tangent = checker::tangent(equation.at(a), {});
  for (std::size_t k = 0; k < 4; ++k) {
    if (tangent[k].middle == 0 || a[k] == b[k]) continue;
    checker::Vector4<Rational> slope;
    for (std::size_t i = 0; i < 4; ++i) slope[i] = tangent[i].middle / tangent[k].middle;
    if (auto line = line_through(equation, k, a, b, slope)) return line;
  }
  return std::nullopt;
}

bool touches(const Arc& arc) { return arc.contact == Contact::tangential; }

}  // namespace exsect::cli

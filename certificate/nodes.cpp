#include "certificate/nodes.h"

// The nodes of a certificate that are no stars, with their tubes.
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate/claims.h"
#include "certificate/gates.h"

namespace exsect::cli {
namespace {

/// The place of a node in doubles, or exactly where several sides are to follow from it.
Json place_claim(const Draft& d, const Node& n, const Parameters& w) {
  if (n.on.size() < 2) return exact(w);
  const std::array<Rational, 4> at = short_place(n);
  return is_solution(d.exact, at) ? rationals(at) : exact(w);
}

bool is_cusp(const Node& n) { return n.on.empty() && n.wrt.empty(); }

/// w becomes the node, as near as it gets.
Tube node_tube(const Draft& d, const Node& n, Parameters& w) {
  const bool turning = n.on.empty();
  const Equation equation = d.equation(d.factor_at[static_cast<std::size_t>(n.id)]);
  const Parameters t = tangent(equation.map, w);
  // On a side its parameter is the axis; a turning point's axis is none of those that turn.
  std::vector<bool> allowed(4, turning);
  for (const Parameter p : n.wrt) allowed[index(p)] = false;
  for (const Side& side : n.on) {
    allowed[index(side.parameter)] = true;
    w[index(side.parameter)] = side.value;
  }
  std::size_t axis = 4;
  for (std::size_t i = 0; i < 4; ++i)
    if (allowed[i] && (axis == 4 || std::abs(t[i]) > std::abs(t[axis]))) axis = i;
  if (axis == 4) throw NoCertificate("a node that turns in all parameters");
  w = turning ? turning_point(equation.map, w, axis, index(n.wrt[0])) : on_curve(equation.map, w, axis);
  for (const Side& side : n.on) w[index(side.parameter)] = side.value;
  for (const double a : w)
    if (!(a >= 0 && a <= 1)) throw NoCertificate("a node that Newton's method does not find again");
  return tube_at(equation, w, axis, Turns::once);
}

double node_radius(const Draft& d, const Node& n, const Tube& tube, const Parameters& w) {
  const Map& map = d.equation(tube.factor).map;
  const double near = distance(map, tube, w);
  double radius = std::max(4 * near, 0x1p-44);
  if (n.on.empty()) {
    const std::size_t i = index(n.wrt[0]);
    const auto bounds = bounds_in(map, tube);
    const auto t = tangent_near(map, w, near);
    const double slope = (t[i].magnitude() + 1e-13) / (std::abs(t[tube.axis].middle) - t[tube.axis].radius);
    const double away = slope / (std::abs(bounds.second[i].middle) - bounds.second[i].radius);
    for (const auto& b : bounds.first) radius = std::max(radius, 2 * (near + away * b.magnitude()));
  }
  return std::exp2(std::ceil(std::log2(radius)));
}

/// The boxes of nodes must not meet.
void keep_apart(const Draft& d, const std::vector<double>& radii) {
  for (std::size_t a = 0; a + 1 < radii.size(); ++a) {
    double apart = 0;
    for (std::size_t i = 0; i < 4; ++i)
      apart = std::max(apart, std::abs(d.places[a][i] - d.places.back()[i]));
    if (apart <= radii[a] + radii.back()) throw NoCertificate("nodes nearer to each other than doubles tell");
  }
}

/// `radii`: of the nodes before, and then of this one.
Json node(Draft& d, const Node& n, std::vector<double>& radii) {
  Parameters w = n.approx;
  d.tube_of.push_back(d.tubes.size());
  d.tubes.push_back(is_cusp(n) ? cusp_tube(d.pair, w) : node_tube(d, n, w));
  const Tube& tube = d.tubes[d.tube_of.back()];
  d.places.push_back(w);
  d.place_claims.push_back(place_claim(d, n, w));
  const double radius = is_cusp(n) ? cusp_radius(d.pair, tube, w) : node_radius(d, n, tube, w);
  radii.push_back(radius);
  keep_apart(d, radii);

  Json on = Json::array();
  for (const Side& side : n.on) on.push_back(side_name(side));
  std::vector<std::size_t> turns;
  for (const Parameter p : n.wrt) turns.push_back(index(p));
  std::sort(turns.begin(), turns.end());
  Json wrt = Json::array();
  for (const std::size_t i : turns) wrt.push_back(letter(i));
  return sealed(in_list("nodes", d.places.size() - 1), {{"tube", d.tube_of.back()},
                                                        {"at", d.place_claims.back()},
                                                        {"radius", exact_number(radius)},
                                                        {"on", on},
                                                        {"wrt", wrt}});
}

void add_place(Draft& d, const FoundStar& star) {
  Parameters at;
  for (std::size_t i = 0; i < 4; ++i) at[i] = checker::number<double>(star.claim.at[i]);
  d.places.push_back(at);
  Json place = Json::array();  // near it where it is irrational
  for (std::size_t i = 0; i < 4; ++i)
    place.push_back(star.claim.at[i].is_rational() ? to_string(star.claim.at[i].rational())
                                                   : exact_number(at[i]));
  d.place_claims.push_back(place);
  d.tube_of.push_back(d.tubes.size());
}

}  // namespace

Json node_claims(Draft& d) {
  Json result = Json::array();
  std::vector<double> radii;
  for (const Node& n : d.graph.nodes)
    if (d.on_curve[static_cast<std::size_t>(n.id)] && !d.in_star[static_cast<std::size_t>(n.id)])
      result.push_back(node(d, n, radii));
  for (const FoundStar& star : d.stars) add_place(d, star);
  return result;
}

}  // namespace exsect::cli

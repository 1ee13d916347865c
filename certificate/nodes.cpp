#include "certificate/nodes.h"

// The nodes of a certificate that are no stars, with their tubes.
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "certificate/claims.h"
#include "certificate/gates.h"
#include "certificate/near_nodes.h"

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

/// A node that is claimed, in its tube.
struct Found {
  const Node* node;
  double radius;
};

Found found(Draft& d, const Node& n) {
  Parameters w = n.approx;
  d.tube_of.push_back(d.tubes.size());
  d.tubes.push_back(is_cusp(n) ? cusp_tube(d.pair, w) : node_tube(d, n, w));
  const Tube& tube = d.tubes.back();
  d.places.push_back(w);
  d.long_places.emplace_back();
  d.place_claims.push_back(place_claim(d, n, w));
  return {&n, is_cusp(n) ? cusp_radius(d.pair, tube, w) : node_radius(d, n, tube, w)};
}

/// The boxes of nodes must not meet: longer numbers for those whose boxes do.
void tell_apart(Draft& d, const std::vector<Found>& all) {
  std::set<std::size_t> near;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (apart(d.places[a], d.places[b]) <= all[a].radius + all[b].radius) near.insert({a, b});
  if (near.empty()) return;
  std::vector<const Node*> nodes;
  std::vector<Tube> tubes;
  for (const std::size_t i : near) {
    nodes.push_back(all[i].node);
    tubes.push_back(d.tubes[d.tube_of[i]]);
  }
  const std::vector<LongPlace> places = told_apart(d, nodes, tubes);
  auto place = places.begin();
  for (const std::size_t i : near) {
    d.long_places[i] = *place;
    d.place_claims[i] = rationals(place->at);
    ++place;
  }
}

Json claim(const Draft& d, std::size_t i, const Found& f) {
  Json on = Json::array();
  for (const Side& side : f.node->on) on.push_back(side_name(side));
  std::vector<std::size_t> turns;
  for (const Parameter p : f.node->wrt) turns.push_back(index(p));
  std::sort(turns.begin(), turns.end());
  Json wrt = Json::array();
  for (const std::size_t t : turns) wrt.push_back(letter(t));
  const auto& longer = d.long_places[i];
  return sealed(in_list("nodes", i), {{"tube", d.tube_of[i]},
                                      {"at", d.place_claims[i]},
                                      {"radius", longer ? to_string(longer->radius) : exact_number(f.radius)},
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
  d.long_places.emplace_back();
  d.tube_of.push_back(d.tubes.size());
}

}  // namespace

Json node_claims(Draft& d) {
  std::vector<Found> all;
  for (const Node& n : d.graph.nodes)
    if (d.on_curve[static_cast<std::size_t>(n.id)] && !d.in_star[static_cast<std::size_t>(n.id)])
      all.push_back(found(d, n));
  tell_apart(d, all);
  Json result = Json::array();
  for (std::size_t i = 0; i < all.size(); ++i) result.push_back(claim(d, i, all[i]));
  for (const FoundStar& star : d.stars) add_place(d, star);
  return result;
}

}  // namespace exsect::cli

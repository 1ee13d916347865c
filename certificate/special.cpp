#include "certificate/special.h"

// The special places of a certificate: factors, overlaps and stars.
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate/claims.h"
#include "certificate/overlap.h"
#include "certificate/regular.h"

namespace exsect::cli {
namespace {

/// How many arcs end there.
std::size_t ends_at(const IntersectionGraph& graph, const Node& node) {
  std::size_t result = 0;
  for (const Arc& arc : graph.arcs) result += (arc.from == node.id) + (arc.to == node.id);
  return result;
}

/// The end of one arc along a side of both patches that are on one side of it even where they touch: it is in
/// a tube of the arc's factor.
bool is_behind_walls(const Draft& d, const Node& n) {
  const int number = d.factor_at[static_cast<std::size_t>(n.id)];
  if (number < 0 || n.on.size() < 3 || ends_at(d.graph, n) != 1) return false;
  const NearFactor& factor = d.factors.found()[static_cast<std::size_t>(number)];
  checker::Box<double> box;
  for (std::size_t i = 0; i < 4; ++i) box[i] = {n.approx[i], 0x1p-20};
  return factor.walls && checker::on_one_side<double>(factor.exact, *factor.walls, factor.columns, box);
}

/// All sides follow from one of them, as the map vanishes wherever they hold, or the node is an exact
/// solution; otherwise nothing but a star tells that they hold in one point.
bool sides_follow(const Draft& d, const Node& n) {
  if (n.on.size() < 2 || is_solution(d.exact, short_place(n))) return true;
  const int factor = d.factor_at[static_cast<std::size_t>(n.id)];
  const ExactMap& map = factor < 0 ? d.exact : d.factors.found()[static_cast<std::size_t>(factor)].exact.map;
  std::vector<checker::Side> sides;
  for (const Side& side : n.on) sides.push_back({{index(side.parameter)}, side.value});
  const auto follows = [&](const checker::Side& from, const checker::Side& other) {
    for (std::size_t c = 0; c < 3; ++c)
      if (checker::vanishes(map, c, {from, other})) return true;
    return false;
  };
  return std::any_of(sides.begin(), sides.end(), [&](const checker::Side& from) {
    return std::all_of(sides.begin(), sides.end(), [&](const checker::Side& other) {
      return other.parameter == from.parameter || follows(from, other);
    });
  });
}

/// A point of a star, as is one on sides that do not follow from each other, or where the parameter of one of
/// them turns, or through which a curve along a side goes on while another parameter turns.
bool needs_star(const Draft& d, const SingularSearch& search, const Node& n) {
  if (is_behind_walls(d, n)) return false;
  if (is_star(d.graph, n, d.self)) return true;
  if (n.on.empty() || !d.on_curve[static_cast<std::size_t>(n.id)]) return false;
  if (turns_at_side(d.pair.power, search, n) || ends_at(d.graph, n) > 1 || !sides_follow(d, n)) return true;
  if (!n.wrt.empty()) throw NoCertificate("a turning point on a side");
  return false;
}

void number_nodes(Draft& d, const SingularSearch& search) {
  d.claim_of.assign(d.graph.nodes.size(), 0);
  d.on_curve.assign(d.graph.nodes.size(), false);
  for (const int n : d.graph.isolated_points) d.on_curve[static_cast<std::size_t>(n)] = true;
  for (const Arc& arc : d.graph.arcs)
    for (const int n : {arc.from, arc.to}) d.on_curve[static_cast<std::size_t>(n)] = true;
  for (const Node& n : d.graph.nodes) d.in_star.push_back(needs_star(d, search, n));
  std::size_t next = 0;
  for (const bool star : {false, true}) {
    if (star) d.first_star = next;
    for (const Node& n : d.graph.nodes)
      if (d.on_curve[static_cast<std::size_t>(n.id)] && d.in_star[static_cast<std::size_t>(n.id)] == star)
        d.claim_of[static_cast<std::size_t>(n.id)] = next++;
  }
}

void find_factors(Draft& d) {
  d.factor_at.assign(d.graph.nodes.size(), -1);
  d.factor_along.assign(d.graph.arcs.size(), -1);
  for (const Arc& arc : d.graph.arcs) {
    const auto from = static_cast<std::size_t>(arc.from);
    const auto to = static_cast<std::size_t>(arc.to);
    const int factor = d.factors.along(arc, d.graph.nodes[from], d.graph.nodes[to]);
    d.factor_at[from] = d.factor_at[to] = d.factor_along[static_cast<std::size_t>(arc.id)] = factor;
  }
}

Json overlap_claim(Draft& d, const Overlap& overlap, std::size_t index) {
  if (d.self) throw NoCertificate("an overlap of a patch with itself");
  const FoundOverlap found = overlap_at(d.factors, d.graph, overlap);
  d.planes.push_back(found.factor);
  return sealed(in_list("overlaps", index), {{"factor", found.factor}, {"edges", found.edges}});
}

/// A curve with a constant parameter has half branches in tubes of a factor alone.
void add_factor_at(Draft& d, const SingularSearch& search, const Node& n) {
  const Place place = short_place(n);
  if (!is_solution(search.equation, place)) return;
  d.factors.add_at(place, constant_at(search.equation, points_in_box(search, n)[0]));
}

/// Smaller than the way to any other node.
void add_star(Draft& d, const SingularSearch& search, const Node& n) {
  double size = 0.5;
  for (const Node& other : d.graph.nodes)
    if (other.id != n.id) size = std::min(size, 0.4 * apart(n.approx, other.approx));
  add_factor_at(d, search, n);
  d.stars.push_back(star_at(search, n, {d.stars.size(), d.tubes.size()}, size, d.factors.found()));
  d.tubes.insert(d.tubes.end(), d.stars.back().tubes.begin(), d.stars.back().tubes.end());
}

}  // namespace

void find_special_places(Draft& d, const SingularSearch& search) {
  find_factors(d);
  number_nodes(d, search);
  for (const Overlap& overlap : d.graph.overlaps)
    d.overlaps.push_back(overlap_claim(d, overlap, d.overlaps.size()));
  for (const Node& n : d.graph.nodes)
    if (d.in_star[static_cast<std::size_t>(n.id)]) add_star(d, search, n);
}

}  // namespace exsect::cli

#include "certificate/certificate_text.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "certificate/arcs.h"
#include "certificate/claims.h"
#include "certificate/cover.h"
#include "certificate/draft.h"
#include "certificate/free.h"
#include "certificate/nodes.h"
#include "certificate/special.h"

namespace exsect::cli {
namespace {

Json summary(const Draft& d, const Json& json, std::size_t cells) {
  Json claims = Json::array();
  for (const char* list : {"factors", "stars", "tubes", "nodes", "arcs"}) claims.push_back(json[list].size());
  claims.push_back(cells);
  claims.push_back(json["overlaps"].size());
  std::array<std::size_t, 4> turning{};
  std::size_t boundary = 0;
  for (const Json& node : json["nodes"]) {
    if (!node["on"].empty()) ++boundary;
    for (std::size_t i = 0; i < 4; ++i)
      for (const Json& p : node["wrt"])
        if (p == letter(i)) ++turning[i];
  }
  return sealed("$.summary",
                {{"claims", claims},
                 {"components", d.graph.components.size()},
                 {"closed", d.graph.count(ComponentShape::closed)},
                 {"open", d.graph.count(ComponentShape::open)},
                 {"branched", d.graph.count(ComponentShape::branched)},
                 {"isolated", d.graph.isolated_points.size()},
                 {"boundary", boundary},
                 {"tangential", std::count_if(d.graph.arcs.begin(), d.graph.arcs.end(), touches)},
                 {"turning", turning}});
}

/// In an order in which each arc but the first is next to one before it.
std::vector<int> connected(const IntersectionGraph& graph, std::vector<int> arcs) {
  std::set<int> nodes;
  const auto is_next = [&](int a) {
    const Arc& arc = graph.arcs[static_cast<std::size_t>(a)];
    return nodes.empty() || nodes.count(arc.from) + nodes.count(arc.to) > 0;
  };
  std::vector<int> result;
  for (auto next = arcs.begin(); next != arcs.end(); next = std::find_if(arcs.begin(), arcs.end(), is_next)) {
    const Arc& arc = graph.arcs[static_cast<std::size_t>(*next)];
    nodes.insert({arc.from, arc.to});
    result.push_back(*next);
    arcs.erase(next);
  }
  return result;
}

/// The document with the claims of `surfaces` and those about the curves.
Json document(Draft& d, const Json& surfaces) {
  Json json = {{"exsect", "certificate/1"}, {"command", d.self ? "self" : "intersect"}};
  json.update(surfaces);
  json["factors"] = d.factors.claims();
  json["stars"] = star_claims(d.stars);
  json["tubes"] = Json::array();
  json["nodes"] = node_claims(d);
  json["arcs"] = arc_claims(d);
  json["tubes"] = tube_claims(d.pair, d.tubes);
  json["components"] = Json::array();
  for (const Component& c : d.graph.components)
    json["components"].push_back(sealed(in_list("components", json["components"].size()),
                                        {{"shape", name(c.shape)}, {"arcs", connected(d.graph, c.arcs)}}));
  json["overlaps"] = d.overlaps;
  Places places = {d.tubes, {}, {}, d.self};
  for (const FoundStar& star : d.stars) places.stars.push_back(star.claim);
  for (const int plane : d.planes)
    places.planes.push_back(&d.factors.found()[static_cast<std::size_t>(plane)]);
  const std::vector<std::string> cells = cover(d.pair, places);
  json["cover"] = cover_claims(cells);
  json["summary"] = summary(d, json, cells.size());
  return json;
}

}  // namespace

namespace {

std::string text(const Patches& patches, const PatchNames& names, IntersectResult result, bool self) {
  if (!self) result.graph = with_free_arcs(std::move(result.graph));
  refuse_events(result, self);
  Draft d = {result.graph, equation_of(patches), near_pair(patches, self), self, {patches, self}};
  find_special_places(d, singular_search(patches));
  Json surfaces = {{"first", patch_claim("$.first", names.first, patches[0])}};
  if (!self) surfaces["second"] = patch_claim("$.second", names.second, patches[1]);
  return accepted_text(document(d, surfaces));
}

/// r = s = 1/2.
IntersectionGraph in_the_middle(IntersectionGraph graph) {
  for (Node& node : graph.nodes) {
    for (const std::size_t i : {2, 3}) {
      node.approx[i] = 0.5;
      node.box[i] = {Rational(1, 2), Rational(1, 2)};
    }
  }
  for (Arc& arc : graph.arcs) {
    for (PolylineVertex& vertex : arc.polyline) vertex.parameters[2] = vertex.parameters[3] = 0.5;
    arc.error_bound *= 1.25;  // for vertices left out, and for checkers with other enclosures
  }
  return graph;
}

/// The polyline with its vertices as near to the curve as doubles are, but for those in stars, and without
/// those next to others: as they were found they may run back by their errors.
std::vector<PolylineVertex> settled(const std::vector<PolylineVertex>& polyline, const Map& equation,
                                    const std::vector<FoundStar>& stars) {
  const auto is_far = [](const PolylineVertex& a, const PolylineVertex& b) {
    return larger_bound(std::abs(a.parameters[0] - b.parameters[0]),
                        std::abs(a.parameters[1] - b.parameters[1])) > 0x1p-24;
  };
  const auto in_star = [&](const Parameters& w) {
    return std::any_of(stars.begin(), stars.end(),
                       [&](const FoundStar& star) { return distance_from_point(star.claim, w) < 1; });
  };
  std::vector<PolylineVertex> result = {polyline.front()};
  for (std::size_t i = 1; i + 1 < polyline.size(); ++i) {
    PolylineVertex vertex = polyline[i];
    if (Parameters& w = vertex.parameters; !in_star(w)) w = on_curve(equation, w, best_axis(equation, w));
    if (is_far(vertex, result.back()) && is_far(vertex, polyline.back())) result.push_back(vertex);
  }
  result.push_back(polyline.back());
  return result;
}

/// Throws NoCertificate for what only pairs of patches have claims for.
void refuse_on_equations(const ImplicitSurface& surface, const IntersectionGraph& graph) {
  if (!surface.region().clauses.empty()) throw NoCertificate("a surface with bounds");
  if (!graph.overlaps.empty()) throw NoCertificate("a patch on the surface");
}

}  // namespace

std::string certificate_text(const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                             const IntersectResult& result) {
  return text({certified_form(x), certified_form(y)}, names, result, false);
}

std::string certificate_text(const ImplicitSurface& surface, const RationalPatch& patch,
                             const PatchNames& names, const IntersectResult& result) {
  refuse_events(result, false);
  refuse_on_equations(surface, result.graph);
  const RationalPatch x = certified_form(patch);
  const SpacePolynomial& f = surface.equation();
  IntersectionGraph graph = in_the_middle(result.graph);
  const ExactMap section = equation_of(f, x);
  Draft d = {graph, section, near_section(f, x), false, Factors(section)};
  find_special_places(d, singular_search(section));
  for (Arc& arc : graph.arcs) {
    const Equation equation = d.equation(d.factor_along[static_cast<std::size_t>(arc.id)]);
    arc.polyline = settled(arc.polyline, equation.map, d.stars);
  }
  return accepted_text(document(d, {{"first", patch_claim("$.first", names.first, x)},
                                    {"second", equation_claim("$.second", names.second, f)}}));
}

std::string self_certificate_text(const RationalPatch& patch, const PatchNames& names,
                                  const IntersectResult& result) {
  const RationalPatch x = certified_form(patch);
  return text({x, x}, names, result, true);
}

}  // namespace exsect::cli

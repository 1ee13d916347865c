#include "certificate/certificate_text.h"

#include <algorithm>
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

Json document(const Patches& patches, const PatchNames& names, const IntersectResult& result, bool self) {
  Draft d = {patches, names, result.graph, near_pair(patches), self, Factors(patches, self)};
  find_special_places(d);
  Json json = {{"exsect", "certificate/1"}, {"command", self ? "self" : "intersect"}};
  json["first"] = patch_claim("$.first", names.first, patches[0]);
  if (!self) json["second"] = patch_claim("$.second", names.second, patches[1]);
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
  Places places = {d.tubes, {}, {}, self};
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
  return accepted_text(document(patches, names, result, self));
}

}  // namespace

std::string certificate_text(const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                             const IntersectResult& result) {
  return text({certified_form(x), certified_form(y)}, names, result, false);
}

std::string self_certificate_text(const BezierPatch& x, const PatchNames& names,
                                  const IntersectResult& result) {
  return text({x, x}, names, result, true);
}

}  // namespace exsect::cli

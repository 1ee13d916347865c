#include "certificate_text.h"

#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate_claims.h"

namespace exsect::cli {
namespace {

/// Throws NoCertificate for what a certificate cannot say.
void refuse_events(const IntersectResult& result) {
  if (result.status != Status::complete) throw NoCertificate("the result is incomplete");
  const IntersectionGraph& graph = result.graph;
  if (!graph.overlaps.empty()) throw NoCertificate("an overlap");
  if (!graph.isolated_points.empty()) throw NoCertificate("an isolated point");
  for (const Node& node : graph.nodes) {
    if (!node.free.empty()) throw NoCertificate("a node with a free parameter");
    for (const NodeKind kind : node.kinds)
      if (kind != NodeKind::boundary && kind != NodeKind::turning && kind != NodeKind::corner)
        throw NoCertificate(std::string("a node of kind ") + name(kind));
    if (node.on.empty() == node.wrt.empty())
      throw NoCertificate(node.on.empty() ? "a node inside a curve" : "a turning point on a side");
  }
  for (const Arc& arc : graph.arcs) {
    if (!arc.free.empty()) throw NoCertificate("an arc with a free parameter");
    if (arc.place != ArcPlace::interior) throw NoCertificate("an arc on a side of a patch");
    if (arc.contact != Contact::transversal) throw NoCertificate("an arc along which the patches touch");
  }
}

/// Directions d such that d . (x - y) depends on one parameter of either patch only.
Json relations(const std::array<ControlNet, 2>& power) {
  Json result = Json::array();
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      std::vector<Point> vectors;
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 1; b < 3; ++b) {
          vectors.push_back(i == 0 ? power[0][a][b] : power[0][b][a]);
          vectors.push_back(j == 0 ? power[1][a][b] : power[1][b][a]);
        }
      }
      Point d = {};
      for (const Point& a : vectors)
        for (const Point& b : vectors)
          if (is_zero(d)) d = cross(a, b);
      const auto in_plane = [&](const Point& a) { return dot(d, a) == 0; };
      if (is_zero(d) || !std::all_of(vectors.begin(), vectors.end(), in_plane)) continue;
      const auto slope_sign = [&](const ControlNet& c, std::size_t p) {
        const Rational first = dot(d, p == 0 ? c[1][0] : c[0][1]);
        return sign(first) * sign(Rational(first + 2 * dot(d, p == 0 ? c[2][0] : c[0][2])));
      };
      if (slope_sign(power[0], i) <= 0 || slope_sign(power[1], j) <= 0) continue;
      Json direction = Json::array();
      for (const Rational& q : d) direction.push_back(to_string(q));
      result.push_back(sealed(in_list("relations", result.size()),
                              {{"direction", direction}, {"first", letter(i)}, {"second", letter(2 + j)}}));
    }
  }
  return result;
}

class Writer {
 public:
  Writer(const BezierPatch& x, const BezierPatch& y, const PatchNames& names, const IntersectResult& result)
      : patches_{x, y}, names_(names), graph_(result.graph), pair_(near_pair(x, y)) {}

  Json document() {
    Json json = {{"exsect", "certificate/1"}, {"command", "intersect"}};
    json["first"] = patch_claim("$.first", names_.first, patches_[0]);
    json["second"] = patch_claim("$.second", names_.second, patches_[1]);
    json["relations"] = relations({patches_[0].power_basis(), patches_[1].power_basis()});
    json["tubes"] = Json::array();
    json["nodes"] = Json::array();
    for (const Node& n : graph_.nodes) json["nodes"].push_back(node(n));
    json["arcs"] = Json::array();
    for (const Arc& a : graph_.arcs) json["arcs"].push_back(arc(a));
    json["tubes"] = tube_claims(pair_, tubes_);
    json["components"] = Json::array();
    for (const Component& c : graph_.components)
      json["components"].push_back(sealed(in_list("components", json["components"].size()),
                                          {{"closed", c.shape == ComponentShape::closed}, {"arcs", c.arcs}}));
    json["cover"] = cover_claims(cover(pair_, tubes_));
    json["summary"] = summary(json);
    return json;
  }

 private:
  Json node(const Node& n) {
    const bool turning = n.on.empty();
    Parameters w = n.approx;
    const Parameters t = tangent(pair_, w);
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
    w = turning ? turning_point(pair_, w, axis, index(n.wrt[0])) : on_curve(pair_, w, axis);
    for (const Side& side : n.on) w[index(side.parameter)] = side.value;
    for (const double a : w)
      if (!(a >= 0 && a <= 1)) throw NoCertificate("a node that Newton's method does not find again");
    const Tube tube = tube_at(pair_, w, axis);
    tubes_.push_back(tube);
    places_.push_back(w);
    const double radius = node_radius(n, tube, w);
    radii_.push_back(radius);

    Json on = Json::array();
    for (const Side& side : n.on) on.push_back(side_name(side));
    std::vector<std::size_t> turns;
    for (const Parameter p : n.wrt) turns.push_back(index(p));
    std::sort(turns.begin(), turns.end());
    Json wrt = Json::array();
    for (const std::size_t i : turns) wrt.push_back(letter(i));
    return sealed(in_list("nodes", tubes_.size() - 1), {{"tube", tubes_.size() - 1},
                                                        {"at", exact(w)},
                                                        {"radius", to_string(from_double(radius))},
                                                        {"on", on},
                                                        {"wrt", wrt}});
  }

  double node_radius(const Node& n, const Tube& tube, const Parameters& w) const {
    const double near = distance(pair_, tube, w);
    double radius = std::max(4 * near, 0x1p-44);
    if (n.on.empty()) {
      const std::size_t i = index(n.wrt[0]);
      const auto bounds = bounds_in(pair_, tube);
      const auto t = checker::tangent(pair_.power.at(w), {near, near, near, near});
      const double slope = (t[i].magnitude() + 1e-13) / (std::abs(t[tube.axis].middle) - t[tube.axis].radius);
      const double away = slope / (std::abs(bounds.second[i].middle) - bounds.second[i].radius);
      for (const auto& b : bounds.first) radius = std::max(radius, 2 * (near + away * b.magnitude()));
    }
    return std::exp2(std::ceil(std::log2(radius)));
  }

  Json arc(const Arc& a) {
    std::vector<Parameters> points;
    for (const PolylineVertex& v : a.polyline) points.push_back(v.parameters);
    const auto from = static_cast<std::size_t>(a.from);
    const auto to = static_cast<std::size_t>(a.to);
    points.front() = places_[from];
    points.back() = places_[to];
    const TracedArc traced = chain(pair_, points, from, to, tubes_);
    Json list = Json::array();
    for (const TracedPoint& p : traced.points) {
      Json numbers = exact(p.at);
      if (p.vertex >= 0)
        for (const double c : a.polyline[static_cast<std::size_t>(p.vertex)].point)
          numbers.push_back(to_string(from_double(c)));
      list.push_back(numbers);
    }
    Json pieces = Json::array();
    for (const TracedPiece& p : traced.pieces) pieces.push_back({p.tube, p.last});
    return sealed(in_list("arcs", static_cast<std::size_t>(a.id)),
                  {{"component", a.component},
                   {"from", a.from},
                   {"to", a.to},
                   {"points", list},
                   {"pieces", pieces},
                   {"error_bound", to_string(from_double(a.error_bound))}});
  }

  Json summary(const Json& json) const {
    Json claims = Json::array();
    for (const char* list : {"relations", "tubes", "nodes", "arcs", "cover"})
      claims.push_back(json[list].size());
    Json turning = Json::array();
    for (const Parameter p : all_parameters) turning.push_back(graph_.turning_points(p));
    return sealed("$.summary", {{"claims", claims},
                                {"components", graph_.components.size()},
                                {"closed", graph_.count(ComponentShape::closed)},
                                {"open", graph_.count(ComponentShape::open)},
                                {"boundary", graph_.boundary_points()},
                                {"turning", turning}});
  }

  std::array<BezierPatch, 2> patches_;
  const PatchNames& names_;
  const IntersectionGraph& graph_;
  NearPair pair_;
  std::vector<Tube> tubes_;         // those of the nodes first
  std::vector<Parameters> places_;  // of the nodes
  std::vector<double> radii_;
};

/// An arc whose error bound the check, with enclosures of its own, cannot confirm gets a larger one.
bool enlarge_bound(Json& document, const std::string& where, const std::string& reason) {
  for (std::size_t i = 0; i < document["arcs"].size(); ++i) {
    if (where != in_list("arcs", i) || reason != "the error bound is too small") continue;
    Json arc = document["arcs"][i];
    arc.erase("seal");
    const Rational bound = parse_number(arc["error_bound"].get<std::string>());
    arc["error_bound"] = to_string(bound * Rational(5, 4));
    document["arcs"][i] = sealed(where, arc);
    return true;
  }
  return false;
}

}  // namespace

std::string certificate_text(const BezierPatch& x, const BezierPatch& y, const PatchNames& names,
                             const IntersectResult& result) {
  refuse_events(result);
  Json document = Writer(x, y, names, result).document();
  for (int trials = 0; trials < 60; ++trials) {
    const std::string certificate = claims_text(document);
    try {
      checker::check_in_doubles(certificate);
      return certificate;
    } catch (const checker::Rejected& rejected) {
      if (enlarge_bound(document, rejected.place(), rejected.what())) continue;
    }
    try {
      checker::check_certificate(certificate);
      return certificate;
    } catch (const checker::Rejected& rejected) {
      if (!enlarge_bound(document, rejected.place(), rejected.what())) throw not_accepted(rejected);
    }
  }
  throw NoCertificate("an arc whose polyline's error bound cannot be confirmed");
}

}  // namespace exsect::cli

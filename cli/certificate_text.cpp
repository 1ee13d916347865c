#include "certificate_text.h"

#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate_claims.h"
#include "certificate_events.h"

namespace exsect::cli {
namespace {

/// Throws NoCertificate for what a certificate cannot say.
void refuse_events(const IntersectResult& result, bool self) {
  if (result.status != Status::complete) throw NoCertificate("the result is incomplete");
  const IntersectionGraph& graph = result.graph;
  if (!graph.overlaps.empty()) throw NoCertificate("an overlap");
  const auto isolated = [&](const Node& node) {
    const auto& points = graph.isolated_points;
    return std::find(points.begin(), points.end(), node.id) != points.end();
  };
  for (const Node& node : graph.nodes) {
    if (!node.free.empty()) throw NoCertificate("a node with a free parameter");
    if (isolated(node)) continue;
    for (const NodeKind kind : node.kinds)
      if (kind != NodeKind::boundary && kind != NodeKind::turning && kind != NodeKind::corner &&
          !(self && kind == NodeKind::cusp))
        throw NoCertificate(std::string("a node of kind ") + name(kind));
    const bool cusp = self && node.kinds == std::vector{NodeKind::cusp};
    if (cusp && !node.on.empty()) throw NoCertificate("a cuspidal point on a side");
    if (!cusp && node.on.empty() == node.wrt.empty())
      throw NoCertificate(node.on.empty() ? "a node inside a curve" : "a turning point on a side");
  }
  for (const Arc& arc : graph.arcs) {
    if (!arc.free.empty()) throw NoCertificate("an arc with a free parameter");
    if (arc.contact != Contact::transversal) throw NoCertificate("an arc along which the patches touch");
  }
}

/// `self`: of one patch, which is both patches.
class Writer {
 public:
  Writer(const BezierPatch& x, const BezierPatch& y, const PatchNames& names, const IntersectResult& result,
         bool self)
      : patches_{x, y}, names_(names), graph_(result.graph), pair_(near_pair(x, y)), self_(self) {}

  Json document() {
    find_events();
    Json json = {{"exsect", "certificate/1"}, {"command", self_ ? "self" : "intersect"}};
    json["first"] = patch_claim("$.first", names_.first, patches_[0]);
    if (!self_) json["second"] = patch_claim("$.second", names_.second, patches_[1]);
    json["relations"] = self_ ? Json::array() : relation_claims(patches_);
    json["lines"] = line_claims(lines_);
    json["touches"] = touch_claims(touches_);
    json["tubes"] = Json::array();
    json["nodes"] = Json::array();
    for (const Node& n : graph_.nodes)
      if (const auto i = claim_of_[static_cast<std::size_t>(n.id)]; i >= 0) json["nodes"].push_back(node(n));
    json["arcs"] = Json::array();
    for (const Arc& a : graph_.arcs) json["arcs"].push_back(arc(a));
    json["tubes"] = tube_claims(pair_, tubes_);
    json["components"] = Json::array();
    for (const Component& c : graph_.components)
      json["components"].push_back(sealed(in_list("components", json["components"].size()),
                                          {{"closed", c.shape == ComponentShape::closed}, {"arcs", c.arcs}}));
    const std::vector<std::string> cells = cover(pair_, {tubes_, touches_, self_});
    cells_ = cells.size();
    json["cover"] = cover_claims(cells);
    json["summary"] = summary(json);
    return json;
  }

 private:
  /// Lines that arcs run along, isolated points, and the places of the other nodes in the list of claims.
  void find_events() {
    line_of_.assign(graph_.nodes.size(), {});
    claim_of_.assign(graph_.nodes.size(), 0);
    for (const int id : graph_.isolated_points) {
      const auto i = static_cast<std::size_t>(id);
      touches_.push_back(touch_at(patches_, graph_.nodes[i]));
      claim_of_[i] = -1;
    }
    int next = 0;
    for (int& i : claim_of_)
      if (i == 0) i = next++;
    for (const Arc& arc : graph_.arcs) {
      const auto from = static_cast<std::size_t>(arc.from);
      const auto to = static_cast<std::size_t>(arc.to);
      const auto line = line_between(patches_, graph_.nodes[from], graph_.nodes[to]);
      const bool inside = arc.place == ArcPlace::interior;
      if (!line && !inside)
        throw NoCertificate("an arc on a side that is no line of parameters of both patches");
      if (!line || (inside && self_)) continue;
      OnLine on = {static_cast<int>(lines_.size()), line->axis, {}};
      for (std::size_t i = 0; i < 4; ++i) on.constant[i] = line->at[i][1] == 0;
      if (inside && on.constant == std::array{false, false, false, false}) continue;
      lines_.push_back(*line);
      line_of_[from] = line_of_[to] = on;
    }
  }

  static bool is_cusp(const Node& n) { return n.on.empty() && n.wrt.empty(); }

  Json node(const Node& n) {
    Parameters w = n.approx;
    tubes_.push_back(is_cusp(n) ? cusp_tube(w) : node_tube(n, w));
    places_.push_back(w);
    const double radius = is_cusp(n) ? cusp_radius(tubes_.back(), w) : node_radius(n, tubes_.back(), w);

    Json on = Json::array();
    for (const Side& side : n.on) on.push_back(side_name(side));
    std::vector<std::size_t> turns;
    for (const Parameter p : n.wrt) turns.push_back(index(p));
    std::sort(turns.begin(), turns.end());
    Json wrt = Json::array();
    for (const std::size_t i : turns) wrt.push_back(letter(i));
    return sealed(in_list("nodes", tubes_.size() - 1), {{"tube", tubes_.size() - 1},
                                                        {"at", exact(w)},
                                                        {"radius", exact_number(radius)},
                                                        {"on", on},
                                                        {"wrt", wrt}});
  }

  /// w becomes the node, as near as it gets.
  Tube node_tube(const Node& n, Parameters& w) const {
    const bool turning = n.on.empty();
    const OnLine& line = line_of_[static_cast<std::size_t>(n.id)];
    const Parameters t = tangent(pair_, w);
    // On a side its parameter is the axis; a turning point's axis is none of those that turn.
    std::vector<bool> allowed(4, turning);
    for (const Parameter p : n.wrt) allowed[index(p)] = false;
    for (const Side& side : n.on) {
      allowed[index(side.parameter)] = true;
      w[index(side.parameter)] = side.value;
    }
    std::size_t axis = line.claim >= 0 ? line.axis : 4;
    for (std::size_t i = 0; line.claim < 0 && i < 4; ++i)
      if (allowed[i] && (axis == 4 || std::abs(t[i]) > std::abs(t[axis]))) axis = i;
    if (axis == 4) throw NoCertificate("a node that turns in all parameters");
    if (!allowed[axis]) throw NoCertificate("an arc on a side that begins at no side of its own");
    w = turning ? turning_point(pair_, w, axis, index(n.wrt[0])) : on_curve(pair_.power, w, axis);
    for (const Side& side : n.on) w[index(side.parameter)] = side.value;
    for (const double a : w)
      if (!(a >= 0 && a <= 1)) throw NoCertificate("a node that Newton's method does not find again");
    return tube_at(pair_.power, w, axis, line);
  }

  double node_radius(const Node& n, const Tube& tube, const Parameters& w) const {
    const double near = distance(pair_.power, tube, w);
    double radius = std::max(4 * near, 0x1p-44);
    if (n.on.empty()) {
      const std::size_t i = index(n.wrt[0]);
      const auto bounds = bounds_in(pair_.power, tube);
      const auto t = checker::tangent(pair_.power.at(w), {near, near, near, near});
      const double slope = (t[i].magnitude() + 1e-13) / (std::abs(t[tube.axis].middle) - t[tube.axis].radius);
      const double away = slope / (std::abs(bounds.second[i].middle) - bounds.second[i].radius);
      for (const auto& b : bounds.first) radius = std::max(radius, 2 * (near + away * b.magnitude()));
    }
    return std::exp2(std::ceil(std::log2(radius)));
  }

  const Map& chart_map(Chart chart) const { return pair_.charts[chart == Chart::first ? 0 : 1]; }

  /// A tube along w of the chart in which the curve's direction is at most 1; w becomes the cuspidal point.
  Tube cusp_tube(Parameters& w) const {
    std::array<double, 2> length{};
    const Map local = pair_.power.at(w);
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t j = 0; j < 2; ++j) length[j] += std::pow(local.first(d, j, {}).middle, 2);
    const Chart chart = length[0] < length[1] ? Chart::first : Chart::second;
    const std::size_t p = chart == Chart::first ? 0 : 1;
    double m = 0;  // x_u + m x_v = 0
    for (std::size_t d = 0; d < 3; ++d)
      m -= local.first(d, p, {}).middle * local.first(d, 1 - p, {}).middle / length[1 - p];
    const Parameters z = on_curve(chart_map(chart), {w[p], w[1 - p], m, 0}, 3);
    if (!(std::abs(z[0] - w[p]) < 1e-6)) throw NoCertificate("a cuspidal point that is not found again");
    w[p] = w[p + 2] = z[0];
    w[1 - p] = w[3 - p] = z[1];
    return tube_at(chart_map(chart), z, 3, {}, chart);
  }

  double cusp_radius(const Tube& tube, const Parameters& w) const {
    const std::size_t p = tube.chart == Chart::first ? 0 : 1;
    const Parameters z = {w[p], w[1 - p], tube.centre[2], 0};
    return std::exp2(std::ceil(std::log2(std::max(16 * distance(chart_map(tube.chart), tube, z), 0x1p-40))));
  }

  Json arc(const Arc& a) {
    const auto claim = [&](int node) {
      return static_cast<std::size_t>(claim_of_[static_cast<std::size_t>(node)]);
    };
    const TracedArc traced = trace(a, claim(a.from), claim(a.to));
    Json list = Json::array();
    for (const TracedPoint& p : traced.points) {
      Json numbers = exact(p.at);
      if (p.vertex >= 0)
        for (const double c : a.polyline[static_cast<std::size_t>(p.vertex)].point)
          numbers.push_back(exact_number(c));
      list.push_back(numbers);
    }
    Json pieces = Json::array();
    for (const TracedPiece& p : traced.pieces) pieces.push_back({p.tube, p.last});
    return sealed(in_list("arcs", static_cast<std::size_t>(a.id)),
                  {{"component", a.component},
                   {"from", claim(a.from)},
                   {"to", claim(a.to)},
                   {"points", list},
                   {"pieces", pieces},
                   {"error_bound", exact_number(a.error_bound)}});
  }

  TracedArc trace(const Arc& a, std::size_t from, std::size_t to) {
    std::vector<TracedPoint> points;
    for (std::size_t i = 0; i < a.polyline.size(); ++i)
      points.push_back({a.polyline[i].parameters, static_cast<int>(i)});
    points.front().at = places_[from];
    points.back().at = places_[to];
    const OnLine& line = line_of_[static_cast<std::size_t>(a.from)];
    if (line.claim >= 0) return chain(pair_, points, from, to, line, tubes_);
    const std::vector<TracedPoint> start = leave_diagonal(points, from);
    std::reverse(points.begin(), points.end());
    std::vector<TracedPoint> finish = leave_diagonal(points, to);
    std::reverse(points.begin(), points.end());
    TracedArc result =
        chain(pair_, points, gate_tube(points.front().at, from), gate_tube(points.back().at, to), {}, tubes_);
    if (!start.empty()) {
      result.points.insert(result.points.begin(), start.begin(), start.end());
      for (TracedPiece& piece : result.pieces) piece.last += start.size();
      result.pieces.insert(result.pieces.begin(), {from, start.size()});
    }
    if (!finish.empty()) {
      result.points.insert(result.points.end(), finish.rbegin(), finish.rend());
      result.pieces.push_back({to, result.points.size() - 1});
    }
    return result;
  }

  /// If the arc begins at a cuspidal point, takes the points off that are in its tube and returns them; the
  /// arc then begins where it leaves the tube.
  std::vector<TracedPoint> leave_diagonal(std::vector<TracedPoint>& points, std::size_t node) const {
    const Tube& tube = tubes_[node];
    if (tube.chart == Chart::pair) return {};
    const std::size_t p = tube.chart == Chart::first ? 0 : 1;
    const Map& map = chart_map(tube.chart);
    const auto w_of = [&](const TracedPoint& q) { return in_chart(tube.chart, q.at)[3]; };
    double gate = std::min(0.5 * tube.reach, 0.4 * w_of(points.back()));
    for (const TracedPoint& q : points)  // none too near
      if (std::abs(w_of(q) - gate) < 0.01 * gate) gate *= 0.97;
    const int side = points[1].at[p] > points[1].at[p + 2] ? 1 : -1;
    std::vector<TracedPoint> result = {points[0]};
    std::size_t i = 1;
    for (; i + 1 < points.size() && w_of(points[i]) < gate; ++i)
      result.push_back({pair_of(tube.chart, on_curve(map, in_chart(tube.chart, points[i].at), 3), side),
                        points[i].vertex});
    Parameters z = tube.centre;
    for (std::size_t j = 0; j < 4; ++j) z[j] += gate * tube.slope[j];
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i));
    points.insert(points.begin(), {pair_of(tube.chart, on_curve(map, z, 3), side), -1});
    return result;
  }

  /// The node's tube, or one where the arc leaves it.
  std::size_t gate_tube(const Parameters& w, std::size_t node) {
    if (tubes_[node].chart == Chart::pair) return node;
    tubes_.push_back(tube_at(pair_.power, w, best_axis(pair_, w)));
    return tubes_.size() - 1;
  }

  Json summary(const Json& json) const {
    Json claims = Json::array();
    for (const char* list : {"relations", "lines", "touches", "tubes", "nodes", "arcs"})
      claims.push_back(json[list].size());
    claims.push_back(cells_);
    Json turning = Json::array();
    for (const Parameter p : all_parameters) turning.push_back(graph_.turning_points(p));
    const auto on_sides = [](const Json& node) { return !node["on"].empty(); };
    return sealed("$.summary",
                  {{"claims", claims},
                   {"components", graph_.components.size()},
                   {"closed", graph_.count(ComponentShape::closed)},
                   {"open", graph_.count(ComponentShape::open)},
                   {"boundary", std::count_if(json["nodes"].begin(), json["nodes"].end(), on_sides)},
                   {"turning", turning}});
  }

  Patches patches_;
  const PatchNames& names_;
  const IntersectionGraph& graph_;
  NearPair pair_;
  bool self_;
  std::vector<checker::Line> lines_;
  std::vector<OnLine> line_of_;  // of each node of the graph, if its arc runs along one
  std::vector<checker::Touch> touches_;
  std::vector<int> claim_of_;       // the node's number among the claims; -1 for isolated points
  std::vector<Tube> tubes_;         // those of the nodes first
  std::vector<Parameters> places_;  // of the nodes that are claims
  std::size_t cells_ = 0;
};

/// An arc whose error bound the check, with enclosures of its own, cannot confirm gets a larger one.
bool enlarge_bound(Json& document, const std::string& where, const std::string& reason) {
  for (std::size_t i = 0; i < document["arcs"].size(); ++i) {
    if (where != in_list("arcs", i) || reason != "the error bound is too small") continue;
    Json arc = document["arcs"][i];
    arc.erase("seal");
    const Rational bound = checker::number_of(arc["error_bound"].get<std::string>());
    arc["error_bound"] = to_string(bound * Rational(5, 4));
    document["arcs"][i] = sealed(where, arc);
    return true;
  }
  return false;
}

/// The text, if it is accepted, with greater error bounds perhaps.
std::string accepted_text(Json document) {
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

}  // namespace

std::string certificate_text(const BezierPatch& x, const BezierPatch& y, const PatchNames& names,
                             const IntersectResult& result) {
  refuse_events(result, false);
  return accepted_text(Writer(x, y, names, result, false).document());
}

std::string self_certificate_text(const BezierPatch& x, const PatchNames& names,
                                  const IntersectResult& result) {
  refuse_events(result, true);
  return accepted_text(Writer(x, x, names, result, true).document());
}

}  // namespace exsect::cli

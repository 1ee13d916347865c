#include "certificate_text.h"

#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "certificate_claims.h"
#include "certificate_events.h"
#include "certificate_star.h"

namespace exsect::cli {
namespace {

bool has(const Node& node, NodeKind kind) {
  return std::find(node.kinds.begin(), node.kinds.end(), kind) != node.kinds.end();
}

/// A point that needs a star: isolated, or where branches meet.
bool is_star(const IntersectionGraph& graph, const Node& node, bool self) {
  const auto& isolated = graph.isolated_points;
  return std::find(isolated.begin(), isolated.end(), node.id) != isolated.end() ||
         has(node, NodeKind::crossing) || has(node, NodeKind::touch) || (!self && has(node, NodeKind::cusp));
}

/// Throws NoCertificate for what a certificate cannot say.
void refuse_events(const IntersectResult& result, bool self) {
  if (result.status != Status::complete) throw NoCertificate("the result is incomplete");
  const IntersectionGraph& graph = result.graph;
  if (!graph.overlaps.empty()) throw NoCertificate("an overlap");
  for (const Node& node : graph.nodes) {
    if (!node.free.empty()) throw NoCertificate("a node with a free parameter");
    if (is_star(graph, node, self)) continue;
    const bool cusp = self && node.kinds == std::vector{NodeKind::cusp};
    if (has(node, NodeKind::cusp) && !cusp) throw NoCertificate("a cuspidal point on a side");
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
    json["stars"] = Json::array();
    json["tubes"] = Json::array();
    json["nodes"] = Json::array();
    for (const Node& n : graph_.nodes)
      if (!is_star(graph_, n, self_)) json["nodes"].push_back(node(n));
    for (const Node& n : graph_.nodes)
      if (is_star(graph_, n, self_)) add_star(n);
    json["stars"] = star_claims(stars_);
    json["arcs"] = Json::array();
    for (const Arc& a : graph_.arcs) json["arcs"].push_back(arc(a));
    json["tubes"] = tube_claims(pair_, tubes_);
    json["components"] = Json::array();
    for (const Component& c : graph_.components)
      json["components"].push_back(sealed(in_list("components", json["components"].size()),
                                          {{"shape", name(c.shape)}, {"arcs", c.arcs}}));
    const std::vector<std::string> cells = cover(pair_, {tubes_, star_places(), self_});
    cells_ = cells.size();
    json["cover"] = cover_claims(cells);
    json["summary"] = summary(json);
    return json;
  }

 private:
  /// Lines that arcs run along, isolated points, and the places of the other nodes in the list of claims.
  void find_events() {
    line_of_.assign(graph_.nodes.size(), {});
    line_along_.assign(graph_.arcs.size(), {});
    claim_of_.assign(graph_.nodes.size(), 0);
    std::size_t next = 0;
    for (const bool star : {false, true})
      for (const Node& n : graph_.nodes)
        if (is_star(graph_, n, self_) == star) claim_of_[static_cast<std::size_t>(n.id)] = next++;
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
      line_of_[from] = line_of_[to] = line_along_[static_cast<std::size_t>(arc.id)] = on;
    }
  }

  /// Smaller than the way to any other node.
  void add_star(const Node& n) {
    double size = 0.5;
    for (const Node& other : graph_.nodes) {
      double away = 0;
      for (std::size_t i = 0; i < 4; ++i) away = std::max(away, std::abs(n.approx[i] - other.approx[i]));
      if (other.id != n.id) size = std::min(size, 0.4 * away);
    }
    stars_.push_back(star_at(patches_, n, stars_.size(), tubes_.size(), size, lines_));
    tubes_.insert(tubes_.end(), stars_.back().tubes.begin(), stars_.back().tubes.end());
    Parameters at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = to_double(stars_.back().claim.at[i]);
    places_.push_back(at);
    place_claims_.push_back(rationals(stars_.back().claim.at));
  }

  /// The place of a node in doubles, or exactly where several sides are to follow from it.
  Json place_claim(const Node& n, const Parameters& w) const {
    const std::array<Rational, 4> at = short_place(n);
    const bool solves = n.on.size() > 1 && patches_[0](at[0], at[1]) == patches_[1](at[2], at[3]);
    return solves ? rationals(at) : exact(w);
  }

  std::vector<checker::Star> star_places() const {
    std::vector<checker::Star> result;
    for (const FoundStar& star : stars_) result.push_back(star.claim);
    return result;
  }

  static bool is_cusp(const Node& n) { return n.on.empty() && n.wrt.empty(); }

  Json node(const Node& n) {
    Parameters w = n.approx;
    tubes_.push_back(is_cusp(n) ? cusp_tube(w) : node_tube(n, w));
    places_.push_back(w);
    place_claims_.push_back(place_claim(n, w));
    const double radius = is_cusp(n) ? cusp_radius(tubes_.back(), w) : node_radius(n, tubes_.back(), w);

    Json on = Json::array();
    for (const Side& side : n.on) on.push_back(side_name(side));
    std::vector<std::size_t> turns;
    for (const Parameter p : n.wrt) turns.push_back(index(p));
    std::sort(turns.begin(), turns.end());
    Json wrt = Json::array();
    for (const std::size_t i : turns) wrt.push_back(letter(i));
    return sealed(in_list("nodes", tubes_.size() - 1), {{"tube", tubes_.size() - 1},
                                                        {"at", place_claims_.back()},
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

  /// The star of the node claimed under this number, or nothing.
  const FoundStar* star_of(std::size_t node) const {
    const std::size_t nodes = places_.size() - stars_.size();
    return node < nodes ? nullptr : &stars_[node - nodes];
  }

  Json arc(const Arc& a) {
    const std::size_t from = claim_of_[static_cast<std::size_t>(a.from)];
    const std::size_t to = claim_of_[static_cast<std::size_t>(a.to)];
    const TracedArc traced = trace(a, from, to);
    Json list = Json::array();
    for (std::size_t i = 0; i < traced.points.size(); ++i) {
      const TracedPoint& p = traced.points[i];
      Json numbers = i == 0                          ? place_claims_[from]
                     : i + 1 == traced.points.size() ? place_claims_[to]
                                                     : exact(p.at);
      if (p.vertex >= 0)
        for (const double c : a.polyline[static_cast<std::size_t>(p.vertex)].point)
          numbers.push_back(exact_number(c));
      list.push_back(numbers);
    }
    Json pieces = Json::array();
    for (const TracedPiece& p : traced.pieces) pieces.push_back({p.tube, p.last});
    return sealed(in_list("arcs", static_cast<std::size_t>(a.id)),
                  {{"component", a.component},
                   {"from", from},
                   {"to", to},
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
    const OnLine& line = line_along_[static_cast<std::size_t>(a.id)];
    Gate start = leave(points, from, line);
    std::reverse(points.begin(), points.end());
    const Gate finish = leave(points, to, line);
    std::reverse(points.begin(), points.end());
    TracedArc result = chain(pair_, points, start.beyond, finish.beyond, line, tubes_);
    if (!start.points.empty()) {
      result.points.insert(result.points.begin(), start.points.begin(), start.points.end());
      for (TracedPiece& piece : result.pieces) piece.last += start.points.size();
      result.pieces.insert(result.pieces.begin(), {start.tube, start.points.size()});
    }
    if (!finish.points.empty()) {
      result.points.insert(result.points.end(), finish.points.rbegin(), finish.points.rend());
      result.pieces.push_back({finish.tube, result.points.size() - 1});
    }
    return result;
  }

  /// The points of an arc in the chart of a node where it begins, their tube, and one of the pair where it
  /// leaves the chart; without points both are the node's.
  struct Gate {
    std::vector<TracedPoint> points;
    std::size_t tube;
    std::size_t beyond;
  };

  /// The arc begins where it leaves the chart, if the node has one.
  Gate leave(std::vector<TracedPoint>& points, std::size_t node, const OnLine& line) {
    Gate result = {{}, node, node};
    if (star_of(node)) {
      result.tube = half_branch(points, node);
      result.points = leave_star(points, *star_of(node), tubes_[result.tube]);
    } else if (tubes_[node].chart != Chart::pair) {
      result.points = leave_diagonal(points, tubes_[node]);
    } else {
      return result;
    }
    const Parameters& w = points.front().at;
    tubes_.push_back(tube_at(pair_.power, w, line.claim >= 0 ? line.axis : best_axis(pair_, w), line));
    result.beyond = tubes_.size() - 1;
    return result;
  }

  std::vector<TracedPoint> leave_diagonal(std::vector<TracedPoint>& points, const Tube& tube) const {
    const std::size_t p = tube.chart == Chart::first ? 0 : 1;
    const Map& map = chart_map(tube.chart);
    const int side = points[1].at[p] > points[1].at[p + 2] ? 1 : -1;
    return cut(
        points, 0.5 * tube.reach, [&](const Parameters& w) { return in_chart(tube.chart, w)[3]; },
        [&](const Parameters& w) {
          return pair_of(tube.chart, on_curve(map, in_chart(tube.chart, w), 3), side);
        },
        [&](double gate) {
          Parameters z = tube.centre;
          for (std::size_t j = 0; j < 4; ++j) z[j] += gate * tube.slope[j];
          return pair_of(tube.chart, on_curve(map, z, 3), side);
        });
  }

  /// With more points than vertices: the error is bounded step by step.
  static std::vector<TracedPoint> leave_star(std::vector<TracedPoint>& points, const FoundStar& star,
                                             const Tube& tube) {
    constexpr double step = 1.0 / 32;
    const Map& map = star.maps[tube.direction];
    const auto at = [&](double t) { return parameters_of(star, tube, on_half_branch(star, tube, t)); };
    const auto along = [&](const Parameters& w) {
      const auto z = in_star(star, tube, w);
      return z ? (*z)[tube.axis] : std::nan("");
    };
    const std::vector<TracedPoint> few = cut(
        points, 0.9, along,
        [&](const Parameters& w) {
          return parameters_of(star, tube, on_curve(map, *in_star(star, tube, w), tube.axis));
        },
        at);
    std::vector<TracedPoint> result;
    for (std::size_t i = 0; i < few.size(); ++i) {
      const double begin = i == 0 ? 0 : along(few[i].at);
      const double length = along(i + 1 < few.size() ? few[i + 1].at : points[0].at) - begin;
      result.push_back(few[i]);
      const int steps = static_cast<int>(std::ceil(length / step));
      for (int n = 1; n < steps; ++n) result.push_back({at(begin + n * length / steps), -1});
    }
    return result;
  }

  /// Takes off the points before the gate, `along` a chart's axis, and returns them; the gate becomes the
  /// first one.
  template <class Along, class Projected, class At>
  static std::vector<TracedPoint> cut(std::vector<TracedPoint>& points, double gate, const Along& along,
                                      const Projected& projected, const At& at) {
    gate = std::min(gate, std::isnan(along(points.back().at)) ? gate : 0.4 * along(points.back().at));
    for (const TracedPoint& q : points)  // none too near
      if (std::abs(along(q.at) - gate) < 0.01 * gate) gate *= 0.97;
    std::vector<TracedPoint> result = {points[0]};
    std::size_t i = 1;
    for (; i + 1 < points.size() && along(points[i].at) < gate; ++i)
      result.push_back({projected(points[i].at), points[i].vertex});
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i));
    points.insert(points.begin(), {at(gate), -1});
    return result;
  }

  /// The tube of the star's half branch that is nearest to the points and on which no arc runs yet.
  std::size_t half_branch(const std::vector<TracedPoint>& points, std::size_t node) {
    const FoundStar& star = *star_of(node);
    const std::size_t index = node + stars_.size() - places_.size();
    std::size_t best = tubes_.size();
    double least = 1e300;
    for (std::size_t i = 0; i < tubes_.size(); ++i) {
      const Tube& tube = tubes_[i];
      if (tube.chart != Chart::star || tube.star != index || begun_.count(i) > 0) continue;
      const Parameters w = parameters_of(star, tube, on_half_branch(star, tube, 0.9));
      for (std::size_t j = 0; j + 1 < points.size(); ++j) {
        const double away = distance_to_edge(w, points[j].at, points[j + 1].at);
        if (away < least) best = i;
        least = std::min(least, away);
        const auto z = in_star(star, tube, points[j + 1].at);
        if (!z || (*z)[tube.axis] > 1) break;
      }
    }
    if (best == tubes_.size()) throw NoCertificate("a special point with more arcs than half branches");
    begun_.insert(best);
    return best;
  }

  static double distance_to_edge(const Parameters& w, const Parameters& a, const Parameters& b) {
    double along = 0;
    double length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      along += (w[i] - a[i]) * (b[i] - a[i]);
      length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double t = std::clamp(along / length, 0.0, 1.0);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += std::pow(a[i] + t * (b[i] - a[i]) - w[i], 2);
    return sum;
  }

  Json summary(const Json& json) const {
    Json claims = Json::array();
    for (const char* list : {"relations", "lines", "stars", "tubes", "nodes", "arcs"})
      claims.push_back(json[list].size());
    claims.push_back(cells_);
    std::array<std::size_t, 4> turning{};
    std::size_t boundary = 0;
    for (const Json& node : json["nodes"]) {
      if (!node["on"].empty()) ++boundary;
      for (std::size_t i = 0; i < 4; ++i)
        for (const Json& p : node["wrt"])
          if (p == letter(i)) ++turning[i];
    }
    return sealed("$.summary", {{"claims", claims},
                                {"components", graph_.components.size()},
                                {"closed", graph_.count(ComponentShape::closed)},
                                {"open", graph_.count(ComponentShape::open)},
                                {"branched", graph_.count(ComponentShape::branched)},
                                {"isolated", graph_.isolated_points.size()},
                                {"boundary", boundary},
                                {"turning", turning}});
  }

  Patches patches_;
  const PatchNames& names_;
  const IntersectionGraph& graph_;
  NearPair pair_;
  bool self_;
  std::vector<checker::Line> lines_;
  std::vector<OnLine> line_of_;     // of each node of the graph, if its arc runs along one
  std::vector<OnLine> line_along_;  // of each arc
  std::vector<FoundStar> stars_;
  std::set<std::size_t> begun_;        // half branches on which arcs run
  std::vector<std::size_t> claim_of_;  // the node's number among the claims, those of stars last
  std::vector<Tube> tubes_;            // those of the nodes first
  std::vector<Parameters> places_;     // of the nodes and stars
  std::vector<Json> place_claims_;
  std::size_t cells_ = 0;
};

/// An arc whose error bound the check, with enclosures of its own, cannot confirm gets a larger one.
bool enlarge_bound(Json& document, const Rational& factor, const std::string& where,
                   const std::string& reason) {
  for (std::size_t i = 0; i < document["arcs"].size(); ++i) {
    if (where != in_list("arcs", i) || reason != "the error bound is too small") continue;
    Json arc = document["arcs"][i];
    arc.erase("seal");
    const Rational bound = checker::number_of(arc["error_bound"].get<std::string>());
    arc["error_bound"] = to_string(bound * factor);
    document["arcs"][i] = sealed(where, arc);
    return true;
  }
  return false;
}

/// The text, if it is accepted, with greater error bounds perhaps.
std::string accepted_text(Json document) {
  for (int trials = 0; trials < 60; ++trials) {
    const std::string certificate = claims_text(document);
    const Rational factor = trials < 20 ? Rational(5, 4) : Rational(4);
    try {
      checker::check_in_doubles(certificate);
      return certificate;
    } catch (const checker::Rejected& rejected) {
      if (enlarge_bound(document, factor, rejected.place(), rejected.what())) continue;
    }
    try {
      checker::check_certificate(certificate);
      return certificate;
    } catch (const checker::Rejected& rejected) {
      if (!enlarge_bound(document, factor, rejected.place(), rejected.what())) throw not_accepted(rejected);
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

#include "certificate_text.h"

#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "certificate_claims.h"
#include "certificate_events.h"
#include "certificate_gates.h"
#include "certificate_overlap.h"
#include "certificate_star.h"

namespace exsect::cli {
namespace {

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
    Json overlaps = Json::array();
    for (const Overlap& overlap : graph_.overlaps) overlaps.push_back(add_overlap(overlap, overlaps.size()));
    for (const Node& n : graph_.nodes)
      if (is_star(graph_, n, self_)) add_star(n);
    for (const Arc& a : graph_.arcs)
      if (touches(a)) add_seam(a);
    json["stars"] = star_claims(stars_);
    json["seams"] = seam_claims(seams_);
    json["tubes"] = Json::array();
    json["nodes"] = Json::array();
    for (const Node& n : graph_.nodes)
      if (on_curve_[static_cast<std::size_t>(n.id)] && !is_star(graph_, n, self_))
        json["nodes"].push_back(node(n));
    for (const FoundStar& star : stars_) add_place(star);
    json["arcs"] = Json::array();
    for (const Arc& a : graph_.arcs) json["arcs"].push_back(arc(a));
    json["tubes"] = tube_claims(pair_, tubes_);
    json["components"] = Json::array();
    for (const Component& c : graph_.components)
      json["components"].push_back(sealed(in_list("components", json["components"].size()),
                                          {{"shape", name(c.shape)}, {"arcs", c.arcs}}));
    json["overlaps"] = overlaps;
    std::vector<checker::Star> planes;
    for (std::size_t i = 0; i < overlaps.size(); ++i) planes.push_back(seams_[i].claim);
    const std::vector<std::string> cells = cover(pair_, {tubes_, star_places(), planes, self_});
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
    on_curve_.assign(graph_.nodes.size(), false);
    for (const int n : graph_.isolated_points) on_curve_[static_cast<std::size_t>(n)] = true;
    for (const Arc& arc : graph_.arcs)
      for (const int n : {arc.from, arc.to}) on_curve_[static_cast<std::size_t>(n)] = true;
    std::size_t next = 0;
    for (const bool star : {false, true}) {
      if (star) first_star_ = next;
      for (const Node& n : graph_.nodes)
        if (on_curve_[static_cast<std::size_t>(n.id)] && is_star(graph_, n, self_) == star)
          claim_of_[static_cast<std::size_t>(n.id)] = next++;
    }
    for (const Arc& arc : graph_.arcs) {
      const auto from = static_cast<std::size_t>(arc.from);
      const auto to = static_cast<std::size_t>(arc.to);
      const auto line = line_between(patches_, graph_.nodes[from], graph_.nodes[to]);
      const bool inside = arc.place == ArcPlace::interior;
      if (!line && !inside)
        throw NoCertificate("an arc on a side that is no line of parameters of both patches");
      if (!line && touches(arc))
        throw NoCertificate("an arc along which the patches touch and that is no line of parameters");
      if (!line || (inside && self_ && !touches(arc))) continue;
      OnLine on = {static_cast<int>(add_line(*line, touches(arc))), line->axis, {}};
      for (std::size_t i = 0; i < 4; ++i) on.constant[i] = line->at[i][1] == 0;
      if (inside && !touches(arc) && on.constant == std::array{false, false, false, false}) continue;
      line_of_[from] = line_of_[to] = line_along_[static_cast<std::size_t>(arc.id)] = on;
    }
  }

  Json add_overlap(const Overlap& overlap, std::size_t index) {
    if (self_) throw NoCertificate("an overlap of a patch with itself");
    FoundOverlap found = overlap_at(patches_, graph_, overlap);
    seams_.push_back(found.seam);
    return sealed(in_list("overlaps", index), {{"seam", index}, {"edges", found.edges}});
  }

  static bool touches(const Arc& arc) { return arc.contact == Contact::tangential; }

  /// The line's number among the claims.
  std::size_t add_line(const checker::Line& line, bool touching) {
    const auto known = std::find_if(lines_.begin(), lines_.end(), [&](const checker::Line& other) {
      return line.axis == other.axis && line.at == other.at;
    });
    if (known != lines_.end()) return static_cast<std::size_t>(known - lines_.begin());
    lines_.push_back(line);
    touching_.push_back(touching);
    return lines_.size() - 1;
  }

  /// The seam along the arc, or the part of it that is in no star.
  void add_seam(const Arc& arc) {
    const checker::Line& line =
        lines_[static_cast<std::size_t>(line_along_[static_cast<std::size_t>(arc.id)].claim)];
    std::array<Rational, 2> t;
    for (std::size_t end = 0; end < 2; ++end)
      t[end] = short_place(graph_.nodes[static_cast<std::size_t>(end == 0 ? arc.from : arc.to)])[line.axis];
    const std::array<Rational, 2> all = t;
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t node = claim_of_[static_cast<std::size_t>(end == 0 ? arc.from : arc.to)];
      if (node < first_star_) continue;
      Rational most = 0;  // along the line, in the star's coordinates
      for (const auto& row : stars_[node - first_star_].claim.coordinates) {
        Rational e = 0;
        for (std::size_t i = 0; i < 4; ++i) e += row[i] * line.at[i][1];
        most = std::max<Rational>(most, abs(e));
      }
      t[end] += (all[1 - end] > all[end] ? 1 : -1) * Rational(2, 5) / most;
    }
    try {
      seams_.push_back(seam_along(checker::pair_map(patches_[0].power_basis(), patches_[1].power_basis()), {},
                                  line.at, line.axis, (t[0] + t[1]) / 2, abs(Rational(t[1] - t[0])) / 2,
                                  seams_.size(), line_along_[static_cast<std::size_t>(arc.id)].claim));
    } catch (const NotAlone&) {
      throw NoCertificate("an arc along which the patches touch, next to other solutions");
    }
    seam_tube_[arc.from] = seam_tube_[arc.to] = tubes_.size();
    along_seam_[arc.id] = tubes_.size();
    tubes_.push_back(seams_.back().tube);
  }

  /// Smaller than the way to any other node.
  void add_star(const Node& n) {
    double size = 0.5;
    for (const Node& other : graph_.nodes) {
      double away = 0;
      for (std::size_t i = 0; i < 4; ++i) away = std::max(away, std::abs(n.approx[i] - other.approx[i]));
      if (other.id != n.id) size = std::min(size, 0.4 * away);
    }
    stars_.push_back(
        star_at(patches_, n, {stars_.size(), tubes_.size(), seams_.size()}, size, lines_, touching_));
    tubes_.insert(tubes_.end(), stars_.back().tubes.begin(), stars_.back().tubes.end());
    seams_.insert(seams_.end(), stars_.back().seams.begin(), stars_.back().seams.end());
  }

  void add_place(const FoundStar& star) {
    Parameters at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = to_double(star.claim.at[i]);
    places_.push_back(at);
    place_claims_.push_back(rationals(star.claim.at));
    tube_of_.push_back(tubes_.size());
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
    tube_of_.push_back(tubes_.size());
    const auto seam = seam_tube_.find(n.id);
    if (seam != seam_tube_.end()) {
      tube_of_.back() = seam->second;
      w = on_line(tubes_[seam->second], n);
    } else {
      tubes_.push_back(is_cusp(n) ? cusp_tube(pair_, w) : node_tube(n, w));
    }
    const Tube& tube = tubes_[tube_of_.back()];
    places_.push_back(w);
    place_claims_.push_back(place_claim(n, w));
    const double radius = tube.seam >= 0 ? 0x1p-44
                          : is_cusp(n)   ? cusp_radius(pair_, tube, w)
                                         : node_radius(n, tube, w);

    Json on = Json::array();
    for (const Side& side : n.on) on.push_back(side_name(side));
    std::vector<std::size_t> turns;
    for (const Parameter p : n.wrt) turns.push_back(index(p));
    std::sort(turns.begin(), turns.end());
    Json wrt = Json::array();
    for (const std::size_t i : turns) wrt.push_back(letter(i));
    return sealed(in_list("nodes", places_.size() - 1), {{"tube", tube_of_.back()},
                                                         {"at", place_claims_.back()},
                                                         {"radius", exact_number(radius)},
                                                         {"on", on},
                                                         {"wrt", wrt}});
  }

  /// The point of the tube's line at the value of its axis.
  Parameters on_line(const Tube& tube, double t) const {
    const checker::Line& line = lines_[static_cast<std::size_t>(tube.line)];
    Parameters w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = to_double(checker::value(line.at[i], from_double(t)));
    return w;
  }
  Parameters on_line(const Tube& tube, const Node& n) const {
    Parameters w = on_line(tube, to_double(short_place(n)[tube.axis]));
    for (const Side& side : n.on) w[index(side.parameter)] = side.value;
    return w;
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

  /// The star of the node claimed under this number, or nothing.
  const FoundStar* star_of(std::size_t node) const {
    return node < first_star_ ? nullptr : &stars_[node - first_star_];
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
    const auto seam = along_seam_.find(a.id);
    const std::size_t beyond = seam == along_seam_.end() ? tubes_.size() : seam->second;
    for (std::size_t i = 1; seam != along_seam_.end() && i + 1 < points.size(); ++i)
      points[i].at = on_line(tubes_[beyond], points[i].at[tubes_[beyond].axis]);
    Gate start = leave(points, from, line, seam == along_seam_.end());
    std::reverse(points.begin(), points.end());
    const Gate finish = leave(points, to, line, seam == along_seam_.end());
    std::reverse(points.begin(), points.end());
    TracedArc result = seam == along_seam_.end()
                           ? chain(pair_, points, start.beyond, finish.beyond, line, tubes_)
                           : TracedArc{points, {{beyond, points.size() - 1}}};
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

  /// The arc begins where it leaves the chart, if the node has one. `tube`: one of the pair is wanted.
  Gate leave(std::vector<TracedPoint>& points, std::size_t node, const OnLine& line, bool tube) {
    Gate result = {{}, tube_of_[node], tube_of_[node]};
    if (star_of(node)) {
      result.tube = half_branch(points, node);
      result.points = leave_star(points, *star_of(node), tubes_[result.tube]);
    } else if (tubes_[result.tube].chart != Chart::pair) {
      result.points = leave_diagonal(pair_, points, tubes_[result.tube]);
    } else {
      return result;
    }
    if (!tube) return result;
    const Parameters& w = points.front().at;
    tubes_.push_back(tube_at(pair_.power, w, line.claim >= 0 ? line.axis : best_axis(pair_, w), line));
    result.beyond = tubes_.size() - 1;
    return result;
  }

  /// The tube of the star's half branch that is nearest to the points and on which no arc runs yet.
  std::size_t half_branch(const std::vector<TracedPoint>& points, std::size_t node) {
    const FoundStar& star = *star_of(node);
    const std::size_t index = node - first_star_;
    std::size_t best = tubes_.size();
    double least = 1e300;
    for (std::size_t i = 0; i < tubes_.size(); ++i) {
      const Tube& tube = tubes_[i];
      if (tube.chart != Chart::star || tube.star != index || begun_.count(i) > 0) continue;
      const double away = distance_to_half_branch(star, tube, points);
      if (away < least) best = i;
      least = std::min(least, away);
    }
    if (best == tubes_.size()) throw NoCertificate("a special point with more arcs than half branches");
    begun_.insert(best);
    return best;
  }

  Json summary(const Json& json) const {
    Json claims = Json::array();
    for (const char* list : {"relations", "lines", "stars", "tubes", "nodes", "arcs"})
      claims.push_back(json[list].size());
    claims.push_back(cells_);
    claims.push_back(json["seams"].size());
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
                   {"components", graph_.components.size()},
                   {"closed", graph_.count(ComponentShape::closed)},
                   {"open", graph_.count(ComponentShape::open)},
                   {"branched", graph_.count(ComponentShape::branched)},
                   {"isolated", graph_.isolated_points.size()},
                   {"boundary", boundary},
                   {"tangential", std::count_if(graph_.arcs.begin(), graph_.arcs.end(), touches)},
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
  std::vector<bool> on_curve_;      // nodes that are not only corners of overlaps
  std::size_t first_star_ = 0;      // among the nodes claimed
  std::vector<bool> touching_;      // of each of the lines
  std::vector<FoundStar> stars_;
  std::vector<FoundSeam> seams_;
  std::map<int, std::size_t> along_seam_;  // the tube of each arc along which the patches touch
  std::map<int, std::size_t> seam_tube_;   // of each node where one ends
  std::vector<std::size_t> tube_of_;       // of each node claimed
  std::set<std::size_t> begun_;            // half branches on which arcs run
  std::vector<std::size_t> claim_of_;      // the node's number among the claims, those of stars last
  std::vector<Tube> tubes_;                // those of the nodes first
  std::vector<Parameters> places_;         // of the nodes and stars
  std::vector<Json> place_claims_;
  std::size_t cells_ = 0;
};

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

#include "certificate/arcs.h"

// The arcs of a certificate: chains of tubes from node to node.
#include <exsect/geometry/number.h>

#include <algorithm>
#include <set>

#include "certificate/claims.h"
#include "certificate/gates.h"
#include "certificate/near_nodes.h"

namespace exsect::cli {
namespace {

/// Appends exact(numbers) without brackets.
template <class Numbers>
void append_numbers(std::string& list, const Numbers& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    list += i == 0 ? "\"" : ",\"";
    append_number(list, numbers[i]);
    list += '"';
  }
}

class ArcWriter {
 public:
  explicit ArcWriter(Draft& draft) : d_(draft) {}

  Json claim(const Arc& a) {
    const std::size_t from = d_.claim_of[static_cast<std::size_t>(a.from)];
    const std::size_t to = d_.claim_of[static_cast<std::size_t>(a.to)];
    const TracedArc traced = traced_arc(a, from, to);
    const bool stays = std::all_of(a.polyline.begin(), a.polyline.end(),
                                   [&](const PolylineVertex& v) { return v.point == a.polyline[0].point; });
    std::string list;
    for (std::size_t i = 0; i < traced.points.size(); ++i) {
      const TracedPoint& p = traced.points[i];
      list += i == 0 ? "[" : ",";
      if (i == 0 || i + 1 == traced.points.size()) {
        list += compact_text(d_.place_claims[i == 0 ? from : to]);
      } else if (p.exact) {
        list += compact_text(rationals(*p.exact));
      } else {
        list += '[';
        append_numbers(list, p.at);
        list += ']';
      }
      // Where the point of space stays, a polyline has no edges.
      const std::size_t vertex = stays ? 0 : static_cast<std::size_t>(p.vertex);
      if (!stays && p.vertex < 0) continue;
      list.back() = ',';
      append_numbers(list, a.polyline[vertex].point);
      list += ']';
    }
    Json pieces = Json::array();
    for (const TracedPiece& p : traced.pieces) pieces.push_back({p.tube, p.last});
    return sealed(in_list("arcs", static_cast<std::size_t>(a.id)),
                  {{"component", a.component},
                   {"from", from},
                   {"to", to},
                   {"points", verbatim(list + "]")},
                   {"pieces", pieces},
                   {"error_bound", exact_number(a.error_bound)}});
  }

 private:
  /// Where several half branches begin next to each other, the nearest one that leads to the arc's other end.
  TracedArc traced_arc(const Arc& a, std::size_t from, std::size_t to) {
    std::vector<TracedPoint> points = polyline_points(a, from, to);
    const auto& begins = d_.long_places[from];
    const auto& ends = d_.long_places[to];
    if (points.size() == 2 && begins && ends && apart(points[0].at, points[1].at) < 0x1p-40)
      return short_arc(d_, *begins, *ends, {d_.tube_of[from], d_.tube_of[to]}, a.polyline.size());
    const std::vector<std::size_t> first = first_tubes(points, from);
    std::reverse(points.begin(), points.end());
    const std::vector<std::size_t> last = first_tubes(points, to);
    std::reverse(points.begin(), points.end());
    const std::size_t tubes = d_.tubes.size();
    std::string reason = "a special point with more arcs than half branches";
    for (const std::size_t begin : first) {
      for (const std::size_t end : last) {
        if (begin == end && d_.star_of(from)) continue;
        try {
          const TracedArc result = trace(a, points, begin, end);
          begun_.insert({begin, end});
          return result;
        } catch (const NoCertificate& no) {
          if (begin == first[0] && end == last[0]) reason = no.what();
          d_.tubes.resize(tubes);
        }
      }
    }
    throw NoCertificate(reason);
  }

  /// The vertices, without those that are next to an end that needs numbers longer than doubles.
  std::vector<TracedPoint> polyline_points(const Arc& a, std::size_t from, std::size_t to) const {
    std::vector<TracedPoint> points = {{d_.places[from], 0}};
    for (std::size_t i = 1; i + 1 < a.polyline.size(); ++i) {
      const Parameters& w = a.polyline[i].parameters;
      const auto at_end = [&](std::size_t n) {
        return d_.long_places[n] && apart(w, d_.places[n]) < 0x1p-24;
      };
      if (!at_end(from) && !at_end(to)) points.push_back({w, static_cast<int>(i)});
    }
    points.push_back({d_.places[to], static_cast<int>(a.polyline.size()) - 1});
    return points;
  }
  /// That of the node; of a star, those of its half branches on which no arc runs yet, the nearest first.
  std::vector<std::size_t> first_tubes(const std::vector<TracedPoint>& points, std::size_t node) const {
    const FoundStar* star = d_.star_of(node);
    if (!star) return {d_.tube_of[node]};
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t i = 0; i < d_.tubes.size(); ++i) {
      const Tube& tube = d_.tubes[i];
      if (tube.chart == Chart::star && tube.star == node - d_.first_star && begun_.count(i) == 0)
        found.push_back({distance_to_half_branch(*star, tube, points), i});
    }
    std::sort(found.begin(), found.end());
    std::vector<std::size_t> result;
    for (const auto& entry : found) result.push_back(entry.second);
    return result;
  }

  TracedArc trace(const Arc& a, std::vector<TracedPoint> points, std::size_t first, std::size_t last) {
    const Equation equation = d_.equation(d_.factor_along[static_cast<std::size_t>(a.id)]);
    const Gate start = leave(points, first, equation);
    std::reverse(points.begin(), points.end());
    const Gate finish = leave(points, last, equation);
    std::reverse(points.begin(), points.end());
    TracedArc result = chain(equation, points, start.beyond, finish.beyond, d_.tubes);
    if (!start.points.empty()) {
      result.points.insert(result.points.begin(), start.points.begin(), start.points.end());
      for (TracedPiece& piece : result.pieces) piece.last += start.points.size();
      result.pieces.insert(result.pieces.begin(), {first, start.points.size()});
    }
    if (!finish.points.empty()) {
      result.points.insert(result.points.end(), finish.points.rbegin(), finish.points.rend());
      result.pieces.push_back({last, result.points.size() - 1});
    }
    return result;
  }

  /// The points of an arc in the chart of a node where it begins, and a tube of the pair where it leaves the
  /// chart; without points that of the node.
  struct Gate {
    std::vector<TracedPoint> points;
    std::size_t beyond;
  };

  /// The arc begins where it leaves the chart, if the node's tube is one of a chart.
  Gate leave(std::vector<TracedPoint>& points, std::size_t node_tube, const Equation& equation) {
    Gate result = {{}, node_tube};
    const Tube tube = d_.tubes[node_tube];
    if (tube.chart == Chart::pair) return result;
    result.points = tube.chart == Chart::star ? leave_star(points, d_.stars[tube.star], tube)
                                              : leave_diagonal(d_.pair, points, tube);
    const Parameters& w = points.front().at;
    d_.tubes.push_back(tube_at(equation, w, best_axis(equation.map, w)));
    result.beyond = d_.tubes.size() - 1;
    return result;
  }

  Draft& d_;
  std::set<std::size_t> begun_;  // half branches on which arcs run
};

}  // namespace

Json arc_claims(Draft& draft) {
  ArcWriter writer(draft);
  Json result = Json::array();
  for (const Arc& a : draft.graph.arcs) result.push_back(writer.claim(a));
  return result;
}

}  // namespace exsect::cli

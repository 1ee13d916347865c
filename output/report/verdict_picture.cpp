#include "output/report/verdict_picture.h"

#include <algorithm>
#include <set>

#include "output/drawing/intersection_svg.h"
#include "output/report/report_data.h"
#include "output/text/verdict_json.h"

namespace exsect::cli {
namespace {

/// A candidate curve as drawn in one of its representations: its parameter and what is there.
struct DrawnStrand {
  Representation in;
  std::vector<double> at;
  std::vector<std::array<double, 3>> points;  // of space, or (a, b, 0)
};

/// Vertices of polylines, at most some thousand; 24 chords for each span of another spline.
DrawnStrand drawn(const SplineCurve& curve, Representation in, bool closed) {
  constexpr int chords = 24;
  constexpr std::size_t most_vertices = 4000;
  DrawnStrand strand{in, {}, {}};
  const auto add = [&](double t) {
    strand.at.push_back(t);
    strand.points.push_back(point_of(curve, t));
  };
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t stride = curve.degree == 1 ? 1 + curve.points.size() / most_vertices : 1;
  for (std::size_t k = degree; k < curve.points.size(); k += stride) {
    const double from = curve.knots[k];
    const double to = curve.knots[k + 1];
    for (int i = 0; from < to && i < (curve.degree == 1 ? 1 : chords); ++i)
      add(from + (to - from) * i / chords);
  }
  add(curve.to());
  if (closed) {
    strand.at.push_back(curve.to() + 1);
    strand.points.push_back(strand.points.front());
  }
  return strand;
}

std::vector<DrawnStrand> strands(const CandidateCurve& curve) {
  std::vector<DrawnStrand> result;
  if (curve.space) result.push_back(drawn(*curve.space, Representation::space, curve.closed));
  if (curve.first) result.push_back(drawn(*curve.first, Representation::first, curve.closed));
  if (curve.second) result.push_back(drawn(*curve.second, Representation::second, curve.closed));
  return result;
}

/// The points of a strand between two of its parameters, and those at its ends if none is between.
std::vector<std::array<double, 3>> part_of(const DrawnStrand& strand, double from, double to) {
  std::vector<std::array<double, 3>> points;
  for (std::size_t i = 0; i + 1 < strand.at.size(); ++i) {
    const double a = strand.at[i];
    const double b = strand.at[i + 1];
    if (b <= from || a >= to || a >= b) continue;
    const auto place = [&](double t) {
      const double s = std::clamp((t - a) / (b - a), 0.0, 1.0);
      std::array<double, 3> p{};
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = strand.points[i][k] + s * (strand.points[i + 1][k] - strand.points[i][k]);
      return p;
    };
    if (points.empty()) points.push_back(place(from));
    points.push_back(place(to));
  }
  return points;
}

const Arc& arc_of(const IntersectionGraph& graph, int arc, int overlap) {
  if (overlap < 0) return graph.arcs[static_cast<std::size_t>(arc)];
  for (const auto& chain : graph.overlaps[static_cast<std::size_t>(overlap)].chains)
    for (const Arc& rim : chain)
      if (rim.id == arc) return rim;
  throw std::invalid_argument("an arc of the verdict is not in the graph");
}

std::vector<PolylineVertex> vertices_of(const IntersectionGraph& graph, const ArcGap& gap) {
  const std::vector<PolylineVertex>& line = arc_of(graph, gap.arc, gap.overlap).polyline;
  return {line.begin() + static_cast<std::ptrdiff_t>(gap.vertices[0]),
          line.begin() + static_cast<std::ptrdiff_t>(gap.vertices[1]) + 1};
}

std::vector<ArcGap> all_gaps(const Verdict& verdict) {
  std::vector<ArcGap> gaps;
  for (const ArcFinding& arc : verdict.arcs) gaps.insert(gaps.end(), arc.gaps.begin(), arc.gaps.end());
  return gaps;
}

std::set<std::size_t> wrong_points(const Verdict& verdict) {
  std::set<std::size_t> wrong;
  for (const Difference& difference : verdict.differences)
    if (difference.point) wrong.insert(*difference.point);
  return wrong;
}

PlanePolyline flat(const std::vector<std::array<double, 3>>& points) {
  PlanePolyline line;
  for (const auto& p : points) line.push_back({p[0], p[1]});
  return line;
}

/// Of a polyline in space or in a square; numbers are rounded as they are drawn.
Json points_json(const std::vector<std::array<double, 3>>& points, Representation in) {
  Json list = Json::array();
  for (const auto& p : points) {
    if (in == Representation::space)
      list.push_back(p);
    else
      list.push_back(Json::array({p[0], p[1]}));
  }
  return list;
}

Json candidate_data(const Verification& verification, const Candidate& candidate) {
  Json curves = Json::array();
  for (std::size_t c = 0; c < candidate.curves.size(); ++c) {
    Json curve = Json::array();
    for (const DrawnStrand& strand : strands(candidate.curves[c])) {
      Json spurious = Json::array();
      for (const CandidatePart& part : verification.verdict.curves[c].spurious)
        if (part.representation == strand.in)
          spurious.push_back(points_json(part_of(strand, part.from, part.to), strand.in));
      curve.push_back({{"in", name(strand.in)},
                       {"points", points_json(strand.points, strand.in)},
                       {"spurious", std::move(spurious)}});
    }
    curves.push_back(std::move(curve));
  }
  Json points = Json::array();
  const std::set<std::size_t> wrong = wrong_points(verification.verdict);
  for (std::size_t i = 0; i < candidate.points.size(); ++i) {
    const CandidatePoint& point = candidate.points[i];
    points.push_back({{"space", point.point ? Json(*point.point) : Json()},
                      {"first", point.first ? Json(*point.first) : Json()},
                      {"second", point.second ? Json(*point.second) : Json()},
                      {"wrong", wrong.contains(i)}});
  }
  return {{"curves", std::move(curves)}, {"points", std::move(points)}};
}

}  // namespace

std::string verdict_svg(const Verification& verification, const Candidate& candidate, const PatchNames& names,
                        const std::string& title) {
  const Stroke missing = {"#f0a0a0", 7};
  const Stroke claimed = {"#000000", 1.2, "3 3"};
  const Stroke spurious = {"#d00000", 3};
  SquareAdditions additions;
  const std::vector<ArcGap> gaps = all_gaps(verification.verdict);
  for (const ArcGap& gap : gaps) {
    for (std::size_t square : {0, 1}) {
      PlanePolyline line;
      for (const PolylineVertex& v : vertices_of(verification.exact.graph, gap))
        line.push_back({v.parameters[2 * square], v.parameters[2 * square + 1]});
      additions.below.push_back({square, line, missing});
    }
  }
  bool has_curve = false;
  bool has_spurious = false;
  for (std::size_t c = 0; c < candidate.curves.size(); ++c) {
    for (const DrawnStrand& strand : strands(candidate.curves[c])) {
      if (strand.in == Representation::space) continue;
      const std::size_t square = strand.in == Representation::first ? 0 : 1;
      additions.above.push_back({square, flat(strand.points), claimed});
      has_curve = true;
      for (const CandidatePart& part : verification.verdict.curves[c].spurious) {
        if (part.representation != strand.in) continue;
        additions.above.push_back({square, flat(part_of(strand, part.from, part.to)), spurious});
        has_spurious = true;
      }
    }
  }
  for (const std::size_t i : wrong_points(verification.verdict)) {
    const CandidatePoint& point = candidate.points[i];
    if (point.first) additions.marks.push_back({0, *point.first});
    if (point.second) additions.marks.push_back({1, *point.second});
  }
  if (!gaps.empty()) additions.legend.push_back({missing, "not covered by the candidate"});
  if (has_curve) additions.legend.push_back({claimed, "candidate"});
  if (has_spurious) additions.legend.push_back({spurious, "no intersection"});
  return intersection_svg(verification.exact, names, title, additions);
}

std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                                const ReportOrigin& origin) {
  Json data = report_data("verify", origin, verdict_json(verification, candidate, names));
  data["parameters"] = pair_names;
  data["patches"] = {patch_data(names.first, x), patch_data(names.second, y)};
  data["graph"] = intersection_json(verification.exact, names);
  data["candidate"] = candidate_data(verification, candidate);
  data["gaps"] = Json::array();
  for (const ArcGap& gap : all_gaps(verification.verdict)) {
    Json line = Json::array();
    for (const PolylineVertex& v : vertices_of(verification.exact.graph, gap)) {
      Json row = v.parameters;
      for (const double c : v.point) row.push_back(c);
      line.push_back(std::move(row));
    }
    data["gaps"].push_back(std::move(line));
  }
  return page_of(data, verdict_svg(verification, candidate, names, origin.title));
}

}  // namespace exsect::cli

#include "output/report/candidate_strands.h"

#include <algorithm>
#include <stdexcept>

namespace exsect::cli {
namespace {

/// Vertices of polylines, at most some thousand; 24 chords for each span of another spline.
DrawnStrand drawn_strand(const SplineCurve& curve, Representation in, bool closed) {
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

const Arc& gap_arc(const IntersectionGraph& graph, int arc, int overlap) {
  if (overlap < 0) return graph.arcs[static_cast<std::size_t>(arc)];
  for (const auto& chain : graph.overlaps[static_cast<std::size_t>(overlap)].chains)
    for (const Arc& rim : chain)
      if (rim.id == arc) return rim;
  throw std::invalid_argument("an arc of the verdict is not in the graph");
}

}  // namespace

std::vector<DrawnStrand> strands(const CandidateCurve& curve) {
  std::vector<DrawnStrand> result;
  if (curve.space) result.push_back(drawn_strand(*curve.space, Representation::space, curve.closed));
  if (curve.first) result.push_back(drawn_strand(*curve.first, Representation::first, curve.closed));
  if (curve.second) result.push_back(drawn_strand(*curve.second, Representation::second, curve.closed));
  return result;
}

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

std::vector<PolylineVertex> vertices_of(const IntersectionGraph& graph, const ArcGap& gap) {
  const std::vector<PolylineVertex>& line = gap_arc(graph, gap.arc, gap.overlap).polyline;
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

}  // namespace exsect::cli

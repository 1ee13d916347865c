#include "output/report/verdict_picture.h"

#include <algorithm>
#include <utility>

#include "output/drawing/intersection_svg.h"
#include "output/drawing/surfaces_svg.h"
#include "output/report/candidate_strands.h"

namespace exsect::cli {
namespace {

const Stroke missing_stroke = {"#f0a0a0", 7};
const Stroke claimed_stroke = {"#000000", 1.2, "3 3"};
const Stroke spurious_stroke = {"#d00000", 3};

std::vector<std::pair<Stroke, std::string>> verdict_legend(bool has_gap, bool has_curve, bool has_spurious) {
  std::vector<std::pair<Stroke, std::string>> legend;
  if (has_gap) legend.emplace_back(missing_stroke, "not covered by the candidate");
  if (has_curve) legend.emplace_back(claimed_stroke, "candidate");
  if (has_spurious) legend.emplace_back(spurious_stroke, "no intersection");
  return legend;
}

PlanePolyline flat(const std::vector<std::array<double, 3>>& points) {
  PlanePolyline line;
  for (const auto& p : points) line.push_back({p[0], p[1]});
  return line;
}

}  // namespace

std::string verdict_svg(const Verification& verification, const Candidate& candidate, const PatchNames& names,
                        const std::string& title) {
  const std::size_t squares = named_parameters(names.parameters).size() / 2;
  SquareAdditions additions;
  const std::vector<ArcGap> gaps = all_gaps(verification.verdict);
  for (const ArcGap& gap : gaps) {
    for (std::size_t square = 0; square < squares; ++square) {
      PlanePolyline line;
      for (const PolylineVertex& v : vertices_of(verification.exact.graph, gap))
        line.push_back({v.parameters[2 * square], v.parameters[2 * square + 1]});
      additions.below.push_back({square, line, missing_stroke});
    }
  }
  bool has_curve = false;
  bool has_spurious = false;
  for (std::size_t c = 0; c < candidate.curves.size(); ++c) {
    for (const DrawnStrand& strand : strands(candidate.curves[c])) {
      if (strand.in == Representation::space) continue;
      const std::size_t square = strand.in == Representation::first ? 0 : 1;
      additions.above.push_back({square, flat(strand.points), claimed_stroke});
      has_curve = true;
      for (const CandidatePart& part : verification.verdict.curves[c].spurious) {
        if (part.representation != strand.in) continue;
        additions.above.push_back({square, flat(part_of(strand, part.from, part.to)), spurious_stroke});
        has_spurious = true;
      }
    }
  }
  for (const std::size_t i : wrong_points(verification.verdict)) {
    const CandidatePoint& point = candidate.points[i];
    if (point.first) additions.marks.push_back({0, *point.first});
    if (point.second) additions.marks.push_back({1, *point.second});
  }
  additions.legend = verdict_legend(!gaps.empty(), has_curve, has_spurious);
  return intersection_svg(verification.exact, names, title, additions);
}

std::string verdict_svg(const Verification& verification, const Candidate& candidate,
                        const DrawnSurfaces& drawn, const std::string& title) {
  SpaceAdditions additions;
  for (const ArcGap& gap : all_gaps(verification.verdict)) {
    SpacePoints line;
    for (const PolylineVertex& v : vertices_of(verification.exact.graph, gap)) line.push_back(v.point);
    additions.below.push_back({std::move(line), missing_stroke});
  }
  bool has_spurious = false;
  for (std::size_t c = 0; c < candidate.curves.size(); ++c)
    for (const DrawnStrand& strand : strands(candidate.curves[c])) {
      additions.above.push_back({strand.points, claimed_stroke});
      for (const CandidatePart& part : verification.verdict.curves[c].spurious) {
        additions.above.push_back({part_of(strand, part.from, part.to), spurious_stroke});
        has_spurious = true;
      }
    }
  for (const std::size_t i : wrong_points(verification.verdict))
    additions.marks.push_back(*candidate.points[i].point);
  additions.legend = verdict_legend(!additions.below.empty(), !additions.above.empty(), has_spurious);
  return surfaces_svg(drawn, title, additions);
}

}  // namespace exsect::cli

#include "output/text/verdict_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// What a line speaks of: differences that are one but for the representation of their curve.
struct Finding {
  const Difference* first;
  std::optional<CandidatePart> part;         // the ranges of all representations together
  std::vector<std::string> representations;  // "space", "(u,v)", "(r,s)"
  std::size_t count;                         // of differences with the same words
};

std::string square_name(Representation representation) {
  if (representation == Representation::space) return "space";
  return representation == Representation::first ? "(u,v)" : "(r,s)";
}

bool is_one(const Finding& finding, const Difference& difference) {
  const Difference& first = *finding.first;
  if (first.kind != difference.kind || first.curve != difference.curve ||
      first.components != difference.components)
    return false;
  if (!finding.part || !difference.part)
    return !finding.part && !difference.part && first.text == difference.text;
  return difference.part->from <= finding.part->to && finding.part->from <= difference.part->to;
}

void add_to(Finding& finding, const Difference& difference) {
  ++finding.count;
  if (!difference.part) return;
  finding.part->from = std::min(finding.part->from, difference.part->from);
  finding.part->to = std::max(finding.part->to, difference.part->to);
  const std::string given = square_name(difference.part->representation);
  if (std::ranges::find(finding.representations, given) == finding.representations.end())
    finding.representations.push_back(given);
}

std::vector<Finding> findings(const Verdict& verdict) {
  std::vector<Finding> result;
  for (const Difference& difference : verdict.differences) {
    const auto one = std::ranges::find_if(result, [&](const Finding& f) { return is_one(f, difference); });
    if (one != result.end()) {
      add_to(*one, difference);
      continue;
    }
    result.push_back({&difference, difference.part, {}, 1});
    if (difference.part)
      result.back().representations.push_back(square_name(difference.part->representation));
  }
  return result;
}

using PatchPointers = std::array<const RationalPatch*, 2>;

/// Where things lie, in floating point: for the eye.
class Places {
 public:
  Places(const Verification& verification, const Candidate& candidate, const PatchPointers& patches)
      : graph_(verification.exact.graph), candidate_(candidate), patches_(patches) {}

  std::string of(const Finding& finding) const {
    const Difference& difference = *finding.first;
    if (finding.part) {
      const CandidateCurve& curve = candidate_.curves[finding.part->curve];
      return from_to(at(curve, finding.part->from), at(curve, finding.part->to));
    }
    if (difference.gap) return of(*difference.gap);
    if (difference.node)
      return ", near " + text(graph_.nodes[static_cast<std::size_t>(*difference.node)].point);
    if (difference.point) return ", near " + text(at(candidate_.points[*difference.point]));
    if (difference.kind != DifferenceKind::lost_curve) return "";
    return of(graph_.components[static_cast<std::size_t>(difference.components.front())]);
  }

 private:
  using Place = std::array<double, 3>;

  static std::string text(const Place& p) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", p[0], p[1], p[2]);
  }
  static std::string from_to(const Place& a, const Place& b) {
    return ", from near " + text(a) + " to near " + text(b);
  }
  static Place on(const RationalPatch& patch, double first, double second) {
    const Point p = patch(from_double(first), from_double(second));
    return {to_double(p[0]), to_double(p[1]), to_double(p[2])};
  }

  Place at(const CandidateCurve& curve, double t) const {
    const auto& given = curve.space ? curve.space : curve.first ? curve.first : curve.second;
    const auto inside = [&](double s) { return std::clamp(s, given->from(), given->to()); };
    const Place p = point_of(*given, inside(t));
    return curve.space ? p : on(*patches_[curve.first ? 0 : 1], p[0], p[1]);
  }
  Place at(const CandidatePoint& point) const {
    if (point.point) return *point.point;
    return point.first ? on(*patches_[0], (*point.first)[0], (*point.first)[1])
                       : on(*patches_[1], (*point.second)[0], (*point.second)[1]);
  }

  std::string of(const ArcGap& gap) const {
    if (gap.overlap >= 0) return "";
    const std::vector<PolylineVertex>& line = graph_.arcs[static_cast<std::size_t>(gap.arc)].polyline;
    return from_to(line[gap.vertices[0]].point, line[gap.vertices[1]].point);
  }
  std::string of(const Component& component) const {
    const auto arc = [&](int id) -> const Arc& { return graph_.arcs[static_cast<std::size_t>(id)]; };
    const std::vector<PolylineVertex>& line = arc(component.arcs.front()).polyline;
    return ", through near " + text(line[line.size() / 2].point);
  }

  const IntersectionGraph& graph_;
  const Candidate& candidate_;
  const PatchPointers& patches_;
};

/// What is wrong with a part of a curve, without where.
std::string part_words(const Difference& difference) {
  const std::string curve = fmt::format("curve {}", difference.part->curve);
  if (difference.kind == DifferenceKind::spurious_curve) return curve + " is no intersection";
  if (difference.components.size() == 1)
    return fmt::format("{} joins two places of component {} that are apart", curve, difference.components[0]);
  return fmt::format("{} joins component {} to component {}", curve, difference.components[0],
                     difference.components[1]);
}

std::string difference_text(const Finding& finding, const Candidate& candidate, const Places& places) {
  const Difference& difference = *finding.first;
  std::string text = fmt::format("  {}: ", name(difference.kind));
  if (finding.part) {
    const CandidateCurve& curve = candidate.curves[finding.part->curve];
    const auto& given = curve.space ? curve.space : curve.first ? curve.first : curve.second;
    text += fmt::format("{}, {} {:.6g} to {:.6g} in {}", part_words(difference),
                        given->degree == 1 ? "vertices" : "parameters", finding.part->from, finding.part->to,
                        joined(finding.representations, ", "));
  } else {
    text += difference.text;
    if (difference.gap)
      text += fmt::format(", vertices {} to {} of the arc", difference.gap->vertices[0],
                          difference.gap->vertices[1]);
    if (finding.count > 1) text += fmt::format(", in {} places", finding.count);
  }
  return text + places.of(finding) + "\n";
}

std::string curve_bounds_text(const DistanceEnclosure& bounds) {
  return std::isfinite(bounds.upper)
             ? fmt::format("{:.3g} to {}", std::nextafter(bounds.lower, 0.0), rounded_up(bounds.upper))
             : "-";
}

/// The largest distance of a curve from the truth or of the truth from it, as far as it is bounded.
std::string largest_text(const Verdict& verdict) {
  DistanceEnclosure largest;
  for (const CurveFinding& curve : verdict.curves) {
    for (const DistanceEnclosure& distance : {curve.distance, curve.true_distance}) {
      largest.lower = std::max(largest.lower, distance.lower);
      largest.upper = std::max(largest.upper, distance.upper);
    }
  }
  if (verdict.curves.empty() || !std::isfinite(largest.upper)) return "";
  if (verdict.agreement == Agreement::agrees)
    return fmt::format("  largest distance, proved: at most {}\n", rounded_up(largest.upper));
  return fmt::format("  largest distance of the curves given, proved: {}\n", curve_bounds_text(largest));
}

std::string verdict_text(const Verdict& verdict, const std::string& asked, std::size_t differences,
                         bool has_patch) {
  std::string text = name(verdict.agreement);
  if (differences > 0) text += ": " + counted(differences, "difference");
  return fmt::format("{}\n  tolerance {} of the size of {}: {} in the unit of its {}\n", text,
                     printable(asked), has_patch ? "the model" : "what is common",
                     rounded_up(verdict.tolerance), has_patch ? "control points" : "coordinates") +
         largest_text(verdict);
}

std::string component_table(const Verification& verification) {
  std::vector<std::vector<std::string>> rows;
  for (const ComponentFinding& component : verification.verdict.components) {
    std::vector<std::string> curves;
    for (const std::size_t c : component.curves) curves.push_back(std::to_string(c));
    rows.push_back(
        {std::to_string(component.component),
         name(verification.exact.graph.components[static_cast<std::size_t>(component.component)].shape),
         name(component.coverage), joined(curves, ", ")});
  }
  return table({"component", "shape", "", "curves"}, rows);
}

std::string curve_table(const Verdict& verdict) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t c = 0; c < verdict.curves.size(); ++c)
    rows.push_back({std::to_string(c), curve_bounds_text(verdict.curves[c].distance),
                    curve_bounds_text(verdict.curves[c].true_distance)});
  return table({"curve", "largest distance from the true curve", "of the true curve from it"}, rows);
}

}  // namespace

std::string verdict_summary(const Verification& verification, const Candidate& candidate,
                            const std::string& asked, const PatchPointers& patches) {
  const Verdict& verdict = verification.verdict;
  const std::vector<Finding> found = findings(verdict);
  const Places places(verification, candidate, patches);
  std::string text = candidate.source.empty() ? "" : "candidate of " + printable(candidate.source) + "\n";
  const bool has_patch = patches[0] != nullptr || patches[1] != nullptr;
  text += verdict_text(verdict, asked, found.size(), has_patch);
  for (const Finding& finding : found) text += difference_text(finding, candidate, places);
  for (const std::string& open : verdict.undecided) text += "  not decided: " + open + "\n";
  return text + component_table(verification) + curve_table(verdict);
}

}  // namespace exsect::cli

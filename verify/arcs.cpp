// What of the true arcs and components the candidate covers.
#include <algorithm>
#include <cmath>

#include "chain_distances.h"
#include "infinite.h"
#include "verifier.h"

namespace exsect {
namespace {

std::string where(const ArcGap& gap) {
  if (!gap.parameter) return "";
  return std::string(" where ") + name(*gap.parameter) + " is between " + decimal(to_double(gap.from)) +
         " and " + decimal(to_double(gap.to));
}

}  // namespace

std::string Verifier::arc_name(std::size_t arc) const {
  const TrueArc& named = truth_.arcs()[arc];
  return std::to_string(named.arc->id) +
         (named.overlap < 0 ? "" : " of the rim of overlap " + std::to_string(named.overlap));
}

std::vector<int> Verifier::components_of(std::size_t arc) const {
  const int component = truth_.arcs()[arc].arc->component;
  return component < 0 ? std::vector<int>{} : std::vector<int>{component};
}

void Verifier::judge_arcs() {
  for (std::size_t a = 0; a < truth_.arcs().size(); ++a) {
    const TrueArc& arc = truth_.arcs()[a];
    const Chain& chain = truth_.chains()[a];
    ArcFinding finding{arc.arc->id, arc.overlap, arc.arc->component, Coverage::undecided, {}, {}};
    const auto length = static_cast<double>(chain.pieces());
    const std::vector<Interval> open = remaining(covered_[a].intervals(), length);
    std::vector<Interval> far;
    for (const Interval& interval : open) {
      for (auto i = static_cast<std::size_t>(interval.first); static_cast<double>(i) < interval.second; ++i) {
        require_time(stop_);
        FarParts parts(*claimed_, tolerance_, tolerance_ / 8);
        const auto at = static_cast<double>(i);
        // Twice the bound more: the vertices' parameters then bracket what is meant.
        parts.find(chain.points[i], chain.points[i + 1], at, at + 1, 3 * chain.bound[i] + rounding_);
        for (const Interval& part : parts.parts()) far.push_back(part);
      }
    }
    for (const Interval& part : united(far)) finding.gaps.push_back(gap(a, part));
    const bool touched = !kernel_[a].empty();
    finding.coverage = open.empty()           ? Coverage::covered
                       : finding.gaps.empty() ? Coverage::undecided
                       : touched              ? Coverage::partly
                                              : Coverage::missed;
    finding.distance = largest_distance(chain, *claimed_, tolerance_ / 8, stop_);
    verdict_.arcs.push_back(std::move(finding));
  }
}

DistanceEnclosure Verifier::distance_of(const std::vector<int>& components) const {
  DistanceEnclosure result;
  for (const ArcFinding& arc : verdict_.arcs) {
    if (std::find(components.begin(), components.end(), arc.component) == components.end()) continue;
    result.lower = std::max(result.lower, arc.distance.lower);
    result.upper = std::max(result.upper, arc.distance.upper);
  }
  return result;
}

ArcGap Verifier::gap(std::size_t arc, const Interval& part) const {
  const std::vector<PolylineVertex>& line = truth_.arcs()[arc].arc->polyline;
  const auto before = static_cast<std::size_t>(std::floor(part.first));
  const auto after = std::min(static_cast<std::size_t>(std::ceil(part.second)), line.size() - 1);
  const TrueArc& owner = truth_.arcs()[arc];
  if (sides_[0].patch() == nullptr && sides_[1].patch() == nullptr)
    return {owner.arc->id, owner.overlap, {}, 0, 0, {before, after}};
  std::size_t widest = 0;
  const auto change = [&](std::size_t k) {
    return std::fabs(line[after].parameters[k] - line[before].parameters[k]);
  };
  for (std::size_t k = 1; k < 4; ++k)
    if (change(k) > change(widest)) widest = k;
  const auto value = [&](double position) {
    const auto i = std::min(static_cast<std::size_t>(position), line.size() - 2);
    const double t = position - static_cast<double>(i);
    return from_double((1 - t) * line[i].parameters[widest] + t * line[i + 1].parameters[widest]);
  };
  return {owner.arc->id,     owner.overlap,      all_parameters[widest],
          value(part.first), value(part.second), {before, after}};
}

void Verifier::judge_components() {
  for (const Component& component : graph_.components) {
    ComponentFinding finding{component.id, Coverage::covered, {}};
    bool touched = false;
    bool has_gap = false;
    std::set<std::size_t> curves;
    for (std::size_t a = 0; a < verdict_.arcs.size(); ++a) {
      const ArcFinding& arc = verdict_.arcs[a];
      if (arc.component != component.id) continue;
      for (const auto& [c, interval] : kernel_[a]) curves.insert(c);
      touched = touched || !kernel_[a].empty();
      has_gap = has_gap || !arc.gaps.empty();
      if (arc.coverage != Coverage::covered) finding.coverage = Coverage::undecided;
    }
    if (has_gap) finding.coverage = touched ? Coverage::partly : Coverage::missed;
    finding.curves.assign(curves.begin(), curves.end());
    report_component(component, finding);
    verdict_.components.push_back(std::move(finding));
  }
  for (const ArcFinding& arc : verdict_.arcs)
    if (arc.component < 0) report_gaps(arc, {});
}

void Verifier::report_component(const Component& component, const ComponentFinding& finding) {
  const std::string what = "component " + std::to_string(component.id);
  if (finding.coverage == Coverage::undecided)
    verdict_.undecided.push_back("whether " + what + " is covered");
  if (finding.coverage == Coverage::missed) {
    differ(DifferenceKind::lost_curve, what + " (" + name(component.shape) + ") is missing").components = {
        component.id};
    report_points_instead(component, what);
  }
  if (finding.coverage == Coverage::partly)
    for (const ArcFinding& arc : verdict_.arcs)
      if (arc.component == component.id) report_gaps(arc, {component.id});
}

void Verifier::report_gaps(const ArcFinding& arc, const std::vector<int>& components) {
  for (const ArcGap& gap : arc.gaps) {
    Difference& difference =
        differ(DifferenceKind::gap,
               (gap.parameter ? "arc " : "a part of arc ") + std::to_string(arc.arc) +
                   (arc.overlap < 0 ? "" : " of the rim of overlap " + std::to_string(arc.overlap)) +
                   " is not covered" + where(gap));
    difference.components = components;
    difference.gap = gap;
  }
}

void Verifier::report_points_instead(const Component& component, const std::string& what) {
  std::vector<Chain> own;
  std::vector<Chain> others;
  SpacePoint lower = {infinite, infinite, infinite};
  SpacePoint upper = {-infinite, -infinite, -infinite};
  for (std::size_t a = 0; a < truth_.arcs().size(); ++a) {
    const bool belongs = truth_.arcs()[a].arc->component == component.id;
    (belongs ? own : others).push_back(truth_.chains()[a]);
    if (!belongs) continue;
    for (const SpacePoint& p : own.back().points) {
      for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = std::min(lower[k], p[k]);
        upper[k] = std::max(upper[k], p[k]);
      }
    }
  }
  const double extent = std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2], tolerance_});
  const PieceTree tree(own);
  const PieceTree rest(others);
  std::vector<std::size_t> instead;
  for (std::size_t i = 0; i < candidate_.points.size(); ++i) {
    const SpacePoint p = places(candidate_.points[i]).front();
    const double near = tree.distance_from_above(p) + rounding_;
    if (near <= extent && near <= rest.distance_from_above(p)) instead.push_back(i);
  }
  if (instead.empty()) return;
  const std::string number_of =
      instead.size() == 1 ? "is 1 point" : "are " + std::to_string(instead.size()) + " points";
  Difference& difference =
      differ(DifferenceKind::curve_as_points, "instead of " + what + " there " + number_of);
  difference.components = {component.id};
  difference.point = instead.front();
}

}  // namespace exsect

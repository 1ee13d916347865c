#include "verify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "candidate_chain.h"
#include "intersect.h"
#include "model_scale.h"
#include "verify_walks.h"

namespace exsect {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Interval = std::pair<double, double>;

/// Sorted, overlapping and adjacent ones united.
std::vector<Interval> united(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end());
  std::vector<Interval> result;
  for (const Interval& next : intervals) {
    if (!result.empty() && next.first <= result.back().second)
      result.back().second = std::max(result.back().second, next.second);
    else
      result.push_back(next);
  }
  return result;
}

/// Of two united lists.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> result;
  for (const Interval& i : a)
    for (const Interval& j : b)
      if (std::max(i.first, j.first) <= std::min(i.second, j.second))
        result.push_back({std::max(i.first, j.first), std::min(i.second, j.second)});
  return result;
}

/// How far parameters leave [0,1]: a little, or up to 1.
Rational margin(const Candidate& candidate) {
  for (const CandidateCurve& curve : candidate.curves)
    for (const auto* spline : {&curve.first, &curve.second})
      if (*spline)
        for (const auto& p : (*spline)->points)
          if (std::min(p[0], p[1]) < -0.01 || std::max(p[0], p[1]) > 1.01) return 1;
  return Rational(1, 64);
}

/// What of [0, length] is left by a united list.
std::vector<Interval> remaining(const std::vector<Interval>& covered, double length) {
  std::vector<Interval> result;
  double at = 0;
  for (const Interval& i : covered) {
    if (i.first > at) result.push_back({at, i.first});
    at = std::max(at, i.second);
  }
  if (at < length) result.push_back({at, length});
  return result;
}

/// One representation of a candidate curve.
struct Strand {
  Representation representation;
  Chain chain;
  std::vector<Walk> walks;
};

struct CurveData {
  std::vector<Strand> strands;
};

/// The part of a piece, in [0,1], whose points are all farther than a distance from a set of curves.
class FarParts {
 public:
  FarParts(const PieceTree& others, double least, double smallest)
      : others_(others), least_(least), smallest_(smallest) {}

  /// In the parameter from..to of the segment from a to b; `slack` is added to the distance asked for.
  void find(const SpacePoint& a, const SpacePoint& b, double from, double to, double slack) {
    if (others_.distance_from_below(a, b) > least_ + slack) {
      parts_.push_back({from, to});
      return;
    }
    if (distance(a, b) < smallest_ || others_.distance_from_above(a, b) < least_ - slack) return;
    const SpacePoint m = between(a, b, 0.5);
    find(a, m, from, (from + to) / 2, slack);
    find(m, b, (from + to) / 2, to, slack);
  }
  std::vector<Interval> parts() const { return united(parts_); }

 private:
  const PieceTree& others_;
  double least_;
  double smallest_;
  std::vector<Interval> parts_;
};

/// Bounds of the largest distance of a point of the chain from the nearest of the others.
DistanceEnclosure largest_distance(const Chain& chain, const PieceTree& others, double fine) {
  DistanceEnclosure result;
  if (others.empty()) return {infinite, infinite};
  for (std::size_t i = 0; i < chain.pieces(); ++i)
    for (const SpacePoint& p : {chain.points[i], chain.points[i + 1]})
      result.lower = std::max(result.lower, others.distance_from_below(p) - chain.bound[i]);
  struct Part {
    SpacePoint a;
    SpacePoint b;
    int depth;
  };
  for (std::size_t i = 0; i < chain.pieces(); ++i) {
    std::vector<Part> parts = {{chain.points[i], chain.points[i + 1], 0}};
    while (!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      const double above = others.distance_from_above(part.a, part.b) + chain.bound[i];
      const SpacePoint m = between(part.a, part.b, 0.5);
      if (above <= std::max(1.05 * result.lower, fine) || above <= result.upper || part.depth == 12) {
        result.upper = std::max(result.upper, above);
        continue;
      }
      result.lower = std::max(result.lower, others.distance_from_below(m) - chain.bound[i]);
      parts.push_back({part.a, m, part.depth + 1});
      parts.push_back({m, part.b, part.depth + 1});
    }
  }
  return result;
}

std::string number(double x) {
  std::string text = std::to_string(x);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

class Verifier {
 public:
  Verifier(const Candidate& candidate, const BezierPatch& x, const BezierPatch& y,
           const IntersectResult& exact, double tolerance)
      : candidate_(candidate),
        graph_(exact.graph),
        tolerance_(tolerance),
        x_(x, margin(candidate)),
        y_(y, margin(candidate)),
        truth_(exact.graph) {
    verdict_.agreement = Agreement::undecided;
    verdict_.exact_is_complete = exact.status == Status::complete;
    verdict_.tolerance = tolerance;
    rounding_ = 4 * (x_.rounding() + y_.rounding());
    add_points();
  }

  Verdict operator()() {
    read_curves();
    for (std::size_t c = 0; c < curves_.size(); ++c) judge_curve(c);
    judge_points();
    if (verdict_.exact_is_complete) {
      judge_arcs();
      for (CurveFinding& curve : verdict_.curves) curve.true_distance = distance_of(curve.components);
      judge_components();
      judge_connections();
      judge_contacts();
    }
    conclude();
    return std::move(verdict_);
  }

 private:
  // The true points: the curve and the isolated points.

  /// Isolated points as chains of one piece of length 0.
  void add_points() {
    everything_ = truth_.chains();
    for (const int id : graph_.isolated_points) {
      const Node& node = graph_.nodes[static_cast<std::size_t>(id)];
      const auto width = [&](Parameter p) { return to_double(node.box[index(p)].width()); };
      const double in_x = x_.speed(0) * width(Parameter::u) + x_.speed(1) * width(Parameter::v);
      const double in_y = y_.speed(0) * width(Parameter::r) + y_.speed(1) * width(Parameter::s);
      const auto middle = [&](Parameter p) { return to_double(node.box[index(p)].midpoint()); };
      Chain chain;
      const SpacePoint at = in_x <= in_y ? x_(middle(Parameter::u), middle(Parameter::v))
                                         : y_(middle(Parameter::r), middle(Parameter::s));
      chain.points = {at, at};
      chain.at = {0, 0};
      chain.bound = {std::min(in_x, in_y) * (1 + 0x1p-40) + rounding_};
      everything_.push_back(chain);
    }
    near_.emplace(everything_);
  }

  // The candidate's curves.

  void read_curves() {
    for (const CandidateCurve& curve : candidate_.curves) {
      CurveData data;
      const double flat = tolerance_ / 8;
      if (curve.space)
        data.strands.push_back({Representation::space, chain_in_space(*curve.space, curve.closed, flat), {}});
      if (curve.first)
        data.strands.push_back(
            {Representation::first, chain_on_patch(*curve.first, curve.closed, x_, flat), {}});
      if (curve.second)
        data.strands.push_back(
            {Representation::second, chain_on_patch(*curve.second, curve.closed, y_, flat), {}});
      if (data.strands.empty()) throw std::invalid_argument("a candidate curve is given in no space");
      for (const Strand& strand : data.strands) strands_.push_back(strand.chain);
      curves_.push_back(std::move(data));
    }
    claimed_.emplace(strands_);
    covered_.resize(truth_.arcs().size());
    kernel_.resize(truth_.arcs().size());
  }

  void judge_curve(std::size_t c) {
    CurveFinding& finding = verdict_.curves.emplace_back();
    for (Strand& strand : curves_[c].strands) {
      WalkSearch search{tolerance_, rounding_, {}};
      search.rank = [&](std::size_t arc, double position, std::size_t vertex) {
        constexpr double if_covered = 1e-9;
        return parameters_apart(candidate_.curves[c], strand.chain.at[vertex], arc, position) +
               (is_covered(arc, position) ? if_covered : 0.0);
      };
      strand.walks = find_walks(truth_, strand.chain, search);
      const DistanceEnclosure distance = largest_distance(strand.chain, *near_, tolerance_ / 8);
      finding.distance.lower = std::max(finding.distance.lower, distance.lower);
      finding.distance.upper = std::max(finding.distance.upper, distance.upper);
      find_spurious(c, strand, finding);
      if (strand.walks.size() != 1 || strand.walks[0].first != 0 ||
          strand.walks[0].last != strand.chain.pieces())
        not_followed_.insert(c);
    }
    note_coverage(c, finding);
  }

  bool is_covered(std::size_t arc, double position) const {
    return std::any_of(covered_[arc].begin(), covered_[arc].end(),
                       [&](const Interval& i) { return i.first < position && position < i.second; });
  }

  /// How far the stated parameters at t are from those of a place of the truth, in floating point; 0 where
  /// none are stated.
  double parameters_apart(const CandidateCurve& curve, double t, std::size_t arc, double position) const {
    const std::vector<PolylineVertex>& line = truth_.arcs()[arc].arc->polyline;
    const auto i = std::min(static_cast<std::size_t>(position), line.size() - 2);
    const double part = position - static_cast<double>(i);
    double result = 0;
    for (std::size_t square = 0; square < 2; ++square) {
      const auto& stated = square == 0 ? curve.first : curve.second;
      if (!stated || t < stated->from() || t > stated->to()) continue;
      const auto p = point_of(*stated, t);
      for (std::size_t k = 0; k < 2; ++k) {
        const double from = line[i].parameters[2 * square + k];
        const double to = line[i + 1].parameters[2 * square + k];
        result = std::max(result, std::fabs(p[k] - from - part * (to - from)));
      }
    }
    return result;
  }

  void find_spurious(std::size_t c, const Strand& strand, CurveFinding& finding) {
    std::vector<Interval> followed;
    for (const Walk& walk : strand.walks)
      followed.push_back({static_cast<double>(walk.first), static_cast<double>(walk.last)});
    const Chain& chain = strand.chain;
    std::vector<Interval> parts;
    for (const Interval& open : remaining(united(followed), static_cast<double>(chain.pieces()))) {
      for (auto i = static_cast<std::size_t>(open.first); i < static_cast<std::size_t>(open.second); ++i) {
        FarParts far(*near_, tolerance_, tolerance_ / 8);
        far.find(chain.points[i], chain.points[i + 1], chain.at[i], chain.at[i + 1],
                 chain.bound[i] + rounding_);
        for (const Interval& part : far.parts()) parts.push_back(part);
      }
    }
    for (const Interval& part : united(parts)) {
      if (!is_off(chain, part)) continue;
      finding.spurious.push_back({c, strand.representation, part.first, part.second});
      Difference& difference =
          differ(DifferenceKind::spurious_curve, "curve " + std::to_string(c) + " is no intersection from " +
                                                     number(part.first) + " to " + number(part.second) +
                                                     " (" + name(strand.representation) + ")");
      difference.curve = c;
      difference.part = finding.spurious.back();
    }
  }

  /// Far from the curves and isolated points; where that is not the whole truth, far from one of the patches.
  bool is_off(const Chain& chain, const Interval& part) const {
    if (verdict_.exact_is_complete && graph_.overlaps.empty()) return true;
    for (std::size_t i = 0; i < chain.points.size(); ++i)
      if (part.first <= chain.at[i] && chain.at[i] <= part.second &&
          is_off_a_patch(chain.points[i], chain.bound[std::min(i, chain.pieces() - 1)]))
        return true;
    return false;
  }

  bool is_off_a_patch(const SpacePoint& p, double bound) const {
    const double radius = (tolerance_ + bound + rounding_) * (1 + 0x1p-40);
    return x_.certainly_farther(p, radius) || y_.certainly_farther(p, radius);
  }

  /// An arc is covered by a curve where all of the curve's representations cover it.
  void note_coverage(std::size_t c, CurveFinding& finding) {
    for (std::size_t arc = 0; arc < covered_.size(); ++arc) {
      std::vector<Interval> reached;
      std::vector<Interval> kernel;
      for (std::size_t s = 0; s < curves_[c].strands.size(); ++s) {
        std::vector<Interval> of_strand;
        std::vector<Interval> inner;
        for (const Walk& walk : curves_[c].strands[s].walks) {
          for (const Leg& leg : walk.reach)
            if (leg.arc == arc) of_strand.push_back(std::minmax(leg.from, leg.to));
          for (const Leg& leg : walk.legs)
            if (leg.arc == arc && leg.from != leg.to) inner.push_back(std::minmax(leg.from, leg.to));
        }
        if (s == 0) {
          for (std::size_t i = 0; i < inner.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) note_repetition(arc, inner[i], inner[j], c, c);
        }
        reached = s == 0 ? united(of_strand) : common(reached, united(of_strand));
        kernel = s == 0 ? united(inner) : common(kernel, united(inner));
      }
      for (const auto& [other, interval] : kernel_[arc])
        for (const Interval& own : kernel) note_repetition(arc, own, interval, other, c);
      for (const Interval& i : kernel) kernel_[arc].push_back({c, i});
      covered_[arc].insert(covered_[arc].end(), reached.begin(), reached.end());
    }
    for (const Strand& strand : curves_[c].strands)
      for (const Walk& walk : strand.walks)
        for (const Leg& leg : walk.legs) {
          const int component = truth_.arcs()[leg.arc].arc->component;
          if (component >= 0 && (finding.components.empty() || finding.components.back() != component))
            finding.components.push_back(component);
        }
  }

  /// More than a joint of two walks, and no other part of the truth near that one of them could belong to.
  void note_repetition(std::size_t arc, const Interval& a, const Interval& b, std::size_t other,
                       std::size_t c) {
    const double from = std::max(a.first, b.first);
    const double to = std::min(a.second, b.second);
    if (from >= to) return;
    const Chain& chain = truth_.chains()[arc];
    double length = 0;
    for (auto i = static_cast<std::size_t>(std::floor(from));
         static_cast<double>(i) < to && i < chain.pieces(); ++i)
      length += distance(chain.points[i], chain.points[i + 1]) *
                (std::min(to, static_cast<double>(i + 1)) - std::max(from, static_cast<double>(i)));
    if (length <= 8 * tolerance_) return;
    const std::string text = "curves " + std::to_string(other) + " and " + std::to_string(c) +
                             " both run along arc " + arc_name(arc);
    const auto middle = static_cast<std::size_t>((from + to) / 2);
    std::set<std::size_t> arcs;
    truth_.tree().within(chain.points[middle], 4 * tolerance_,
                         [&](const ChainPlace& place) { arcs.insert(place.chain); });
    if (arcs.size() > 1) {
      verdict_.undecided.push_back(text + ", or one of them along another arc as near");
      return;
    }
    Difference& difference = differ(
        DifferenceKind::repeated,
        other == c ? "curve " + std::to_string(c) + " runs more than once along arc " + arc_name(arc) : text);
    difference.curve = c;
    difference.components = components_of(arc);
  }

  // Points.

  std::vector<SpacePoint> places(const CandidatePoint& point) const {
    std::vector<SpacePoint> result;
    if (point.point) result.push_back(*point.point);
    if (point.first) result.push_back(x_((*point.first)[0], (*point.first)[1]));
    if (point.second) result.push_back(y_((*point.second)[0], (*point.second)[1]));
    return result;
  }

  void judge_points() {
    std::vector<int> claims(graph_.isolated_points.size(), 0);
    for (std::size_t i = 0; i < candidate_.points.size(); ++i) judge_point(i, claims);
    if (!verdict_.exact_is_complete) return;
    for (std::size_t k = 0; k < claims.size(); ++k) {
      const int id = graph_.isolated_points[k];
      if (claims[k] == 1) continue;
      if (claims[k] > 1) {
        differ(DifferenceKind::repeated_point,
               "isolated point " + std::to_string(id) + " is claimed " + std::to_string(claims[k]) + " times")
            .node = id;
        continue;
      }
      const Chain& truth = everything_[truth_.arcs().size() + k];
      bool apart = true;
      for (const CandidatePoint& point : candidate_.points) {
        bool some = false;
        for (const SpacePoint& p : places(point))
          some = some || distance(p, truth.points[0]) - truth.bound[0] - rounding_ > tolerance_;
        apart = apart && some;
      }
      if (apart)
        differ(DifferenceKind::lost_point, "isolated point " + std::to_string(id) + " is not claimed").node =
            id;
      else
        verdict_.undecided.push_back("whether isolated point " + std::to_string(id) + " is claimed");
    }
  }

  void judge_point(std::size_t i, std::vector<int>& claims) {
    const std::vector<SpacePoint> all = places(candidate_.points[i]);
    if (all.empty()) throw std::invalid_argument("a candidate point is given in no space");
    const auto arcs = static_cast<std::ptrdiff_t>(truth_.arcs().size());
    bool off = false;
    for (const SpacePoint& p : all) {
      const bool far = near_->distance_from_below(p) - rounding_ > tolerance_;
      const bool whole = verdict_.exact_is_complete && graph_.overlaps.empty();
      off = off || (far && (whole || is_off_a_patch(p, rounding_)));
    }
    if (off) {
      differ(DifferenceKind::false_point, "point " + std::to_string(i) + " is no intersection").point = i;
      return;
    }
    const auto near_all = [&](const Chain& chain) {
      return std::all_of(all.begin(), all.end(), [&](const SpacePoint& p) {
        return distance(p, chain.points[0]) + chain.bound[0] + rounding_ <= tolerance_;
      });
    };
    for (std::size_t k = 0; k < claims.size(); ++k) {
      if (!near_all(everything_[static_cast<std::size_t>(arcs) + k])) continue;
      ++claims[k];
      return;
    }
    if (!verdict_.exact_is_complete) return;
    std::set<int> on;
    for (const SpacePoint& p : all)
      truth_.tree().within(p, tolerance_, [&](const ChainPlace& place) {
        if (place.distance + place.bound + rounding_ <= tolerance_)
          on.insert(truth_.arcs()[place.chain].arc->component);
      });
    if (on.empty()) {
      verdict_.undecided.push_back("whether point " + std::to_string(i) + " is an isolated intersection");
      return;
    }
    Difference& difference =
        differ(DifferenceKind::point_on_curve,
               "point " + std::to_string(i) + " is claimed as isolated and lies on a curve");
    difference.point = i;
    for (const int component : on)
      if (component >= 0) difference.components.push_back(component);
  }

  // The true arcs and components.

  std::string arc_name(std::size_t arc) const {
    const TrueArc& named = truth_.arcs()[arc];
    return std::to_string(named.arc->id) +
           (named.overlap < 0 ? "" : " of the rim of overlap " + std::to_string(named.overlap));
  }

  std::vector<int> components_of(std::size_t arc) const {
    const int component = truth_.arcs()[arc].arc->component;
    return component < 0 ? std::vector<int>{} : std::vector<int>{component};
  }

  void judge_arcs() {
    for (std::size_t a = 0; a < truth_.arcs().size(); ++a) {
      const TrueArc& arc = truth_.arcs()[a];
      const Chain& chain = truth_.chains()[a];
      ArcFinding finding{arc.arc->id, arc.overlap, arc.arc->component, Coverage::undecided, {}, {}};
      const auto length = static_cast<double>(chain.pieces());
      const std::vector<Interval> open = remaining(united(covered_[a]), length);
      std::vector<Interval> far;
      for (const Interval& interval : open) {
        for (auto i = static_cast<std::size_t>(interval.first); static_cast<double>(i) < interval.second;
             ++i) {
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
      finding.distance = largest_distance(chain, *claimed_, tolerance_ / 8);
      verdict_.arcs.push_back(std::move(finding));
    }
  }

  /// Of all arcs of the components from the candidate.
  DistanceEnclosure distance_of(const std::vector<int>& components) const {
    DistanceEnclosure result;
    for (const ArcFinding& arc : verdict_.arcs) {
      if (std::find(components.begin(), components.end(), arc.component) == components.end()) continue;
      result.lower = std::max(result.lower, arc.distance.lower);
      result.upper = std::max(result.upper, arc.distance.upper);
    }
    return result;
  }

  /// The parameter that changes most over the part tells where it is.
  ArcGap gap(std::size_t arc, const Interval& part) const {
    const std::vector<PolylineVertex>& line = truth_.arcs()[arc].arc->polyline;
    const auto before = static_cast<std::size_t>(std::floor(part.first));
    const auto after = std::min(static_cast<std::size_t>(std::ceil(part.second)), line.size() - 1);
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
    const TrueArc& owner = truth_.arcs()[arc];
    return {owner.arc->id,     owner.overlap,      all_parameters[widest],
            value(part.first), value(part.second), {before, after}};
  }

  void judge_components() {
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

  void report_component(const Component& component, const ComponentFinding& finding) {
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

  void report_gaps(const ArcFinding& arc, const std::vector<int>& components) {
    for (const ArcGap& gap : arc.gaps) {
      Difference& difference =
          differ(DifferenceKind::gap,
                 "arc " + std::to_string(arc.arc) +
                     (arc.overlap < 0 ? "" : " of the rim of overlap " + std::to_string(arc.overlap)) +
                     " is not covered where " + exsect::name(gap.parameter) + " is between " +
                     number(to_double(gap.from)) + " and " + number(to_double(gap.to)));
      difference.components = components;
      difference.gap = gap;
    }
  }

  /// Claimed points that are as near to a missing component as to any other one, and nearer than its extent.
  void report_points_instead(const Component& component, const std::string& what) {
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
    const double extent =
        std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2], tolerance_});
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

  // Connections.

  void judge_connections() {
    for (std::size_t c = 0; c < curves_.size(); ++c)
      for (const Strand& strand : curves_[c].strands)
        for (std::size_t w = 0; w + 1 < strand.walks.size(); ++w)
          judge_join(c, strand, strand.walks[w], strand.walks[w + 1]);
    for (const ComponentFinding& component : verdict_.components)
      if (component.coverage == Coverage::partly) judge_split(component);
  }

  /// The component of a walk if that is certain: at one of its vertices no other one is within the tolerance.
  std::optional<int> certain_component(const Strand& strand, const Walk& walk) const {
    const std::size_t steps = std::min<std::size_t>(walk.last - walk.first, 16);
    for (std::size_t k = 0; k <= steps; ++k) {
      const std::size_t vertex = walk.first + k * (walk.last - walk.first) / std::max<std::size_t>(steps, 1);
      std::set<int> components;
      const double radius =
          tolerance_ + strand.chain.bound[std::min(vertex, strand.chain.pieces() - 1)] + rounding_;
      truth_.tree().within(strand.chain.points[vertex], 2 * radius, [&](const ChainPlace& place) {
        components.insert(truth_.arcs()[place.chain].arc->component);
      });
      if (components.size() == 1) return *components.begin();
    }
    return std::nullopt;
  }

  void judge_join(std::size_t c, const Strand& strand, const Walk& before, const Walk& after) {
    const auto from = certain_component(strand, before);
    const auto to = certain_component(strand, after);
    if (!from || !to || *from < 0 || *to < 0) return;
    if (*from == *to && !is_shortcut(strand.chain, before, after)) return;
    const CandidatePart part = {c, strand.representation, strand.chain.at[before.last],
                                strand.chain.at[after.first]};
    Difference& difference = differ(
        DifferenceKind::wrong_connection,
        "curve " + std::to_string(c) + " joins " +
            (*from == *to ? "two places of component " + std::to_string(*from) + " that are apart"
                          : "component " + std::to_string(*from) + " to component " + std::to_string(*to)) +
            " between " + number(part.from) + " and " + number(part.to));
    difference.curve = c;
    difference.part = part;
    difference.components = *from == *to ? std::vector<int>{*from} : std::vector<int>{*from, *to};
  }

  /// Along the true curve both ways from the first to the second walk, where there are any, lead farther away
  /// from the bridge between them than it is long.
  bool is_shortcut(const Chain& chain, const Walk& before, const Walk& after) const {
    Chain bridge;
    double length = 0;
    for (std::size_t i = before.last; i <= after.first; ++i) {
      bridge.points.push_back(chain.points[i]);
      if (i == before.last) continue;
      bridge.bound.push_back(chain.bound[i - 1]);
      length += distance(chain.points[i - 1], chain.points[i]);
    }
    if (bridge.bound.empty()) return false;
    const std::vector<Chain> alone = {bridge};
    const PieceTree tree(alone);
    const Leg& from = before.legs.back();
    const Leg& to = after.legs.front();
    std::size_t found = 0;
    for (const int direction : {1, -1}) {
      const auto farthest = farthest_between(tree, from, to, direction);
      if (!farthest) continue;
      if (*farthest <= length) return false;
      ++found;
    }
    return found > 0;
  }

  /// The largest distance of a vertex on the way from the end of one leg to the start of another; empty where
  /// the way in this direction ends or branches before.
  std::optional<double> farthest_between(const PieceTree& tree, const Leg& from, const Leg& to,
                                         int direction) const {
    double result = 0;
    std::size_t arc = from.arc;
    double position = from.to;
    for (std::size_t legs = 0; legs <= truth_.arcs().size(); ++legs) {
      const Chain& chain = truth_.chains()[arc];
      const double end = direction > 0 ? static_cast<double>(chain.pieces()) : 0;
      const bool here = arc == to.arc && (direction > 0 ? to.from >= position : to.from <= position);
      const auto [lower, upper] = std::minmax(position, here ? to.from : end);
      for (auto i = static_cast<std::size_t>(std::ceil(lower)); static_cast<double>(i) <= upper; ++i)
        result = std::max(result, tree.distance_from_below(chain.points[i]));
      if (here) return result;
      const auto ways = truth_.after(arc, direction);
      if (ways.size() != 1) return std::nullopt;
      arc = ways[0].first;
      direction = ways[0].second;
      position = direction > 0 ? 0 : static_cast<double>(truth_.chains()[arc].pieces());
    }
    return std::nullopt;
  }

  /// A gap with covered places on both sides of it along the component.
  void judge_split(const ComponentFinding& finding) {
    const Component& component = graph_.components[static_cast<std::size_t>(finding.component)];
    // the covered and the missing parts, in order along the component
    std::vector<bool> missing;
    for (const int id : component.arcs) {
      const auto a = static_cast<std::size_t>(id);
      std::vector<std::pair<double, bool>> parts;
      for (const ArcGap& gap : verdict_.arcs[a].gaps)
        parts.push_back({static_cast<double>(gap.vertices[0] + gap.vertices[1]) / 2, true});
      for (const auto& [c, interval] : kernel_[a])
        parts.push_back({(interval.first + interval.second) / 2, false});
      std::sort(parts.begin(), parts.end());
      if (component.shape != ComponentShape::branched && is_reversed(component, id))
        std::reverse(parts.begin(), parts.end());
      for (const auto& [position, is_gap] : parts)
        if (missing.empty() || missing.back() != is_gap) missing.push_back(is_gap);
    }
    std::size_t covered = static_cast<std::size_t>(std::count(missing.begin(), missing.end(), false));
    const bool closed = component.shape == ComponentShape::closed;
    if (closed && missing.size() > 1 && !missing.front() && !missing.back()) --covered;
    if (component.shape == ComponentShape::branched || covered + (closed ? 1 : 0) < 2) return;
    Difference& difference = differ(
        DifferenceKind::split,
        "component " + std::to_string(component.id) + " (" + name(component.shape) + ") comes " +
            (covered == 1 ? "as an open curve" : "in " + std::to_string(covered) + " parts that are apart"));
    difference.components = {component.id};
  }

  /// Whether a simple component runs through the arc from its end `to`.
  bool is_reversed(const Component& component, int id) const {
    const auto& arcs = component.arcs;
    const auto at = static_cast<std::size_t>(std::find(arcs.begin(), arcs.end(), id) - arcs.begin());
    if (arcs.size() < 2) return false;
    const Arc& arc = graph_.arcs[static_cast<std::size_t>(id)];
    const Arc& other = graph_.arcs[static_cast<std::size_t>(arcs[at + 1 < arcs.size() ? at + 1 : at - 1])];
    const bool to_is_shared = arc.to == other.from || arc.to == other.to;
    const bool from_is_shared = arc.from == other.from || arc.from == other.to;
    if (to_is_shared && from_is_shared)
      return at == 0 ? false : arc.to == graph_.arcs[static_cast<std::size_t>(arcs[at - 1])].to;
    return at + 1 < arcs.size() ? !to_is_shared : to_is_shared;
  }

  void judge_contacts() {
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const auto& stated = candidate_.curves[c].tangential;
      if (!stated) continue;
      for (const Strand& strand : curves_[c].strands) {
        for (const Walk& walk : strand.walks) {
          if (!certain_component(strand, walk)) continue;
          for (const Leg& leg : walk.legs) {
            const Arc& arc = *truth_.arcs()[leg.arc].arc;
            if (leg.from == leg.to || (arc.contact == Contact::tangential) == *stated) continue;
            Difference& difference = differ(DifferenceKind::wrong_contact,
                                            "curve " + std::to_string(c) + " is claimed to be " +
                                                (*stated ? "tangential" : "transversal") + " and is " +
                                                name(arc.contact) + " along arc " + arc_name(leg.arc));
            difference.curve = c;
            difference.components = components_of(leg.arc);
            return;
          }
        }
      }
    }
  }

  /// A curve that is on one arc and has the parameters of another one within the tolerance: agreement is then
  /// not claimed.
  void doubt_parameters() {
    constexpr double clearly = 1e-6;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      if (!candidate_.curves[c].first && !candidate_.curves[c].second) continue;
      const Strand& strand = curves_[c].strands.front();
      for (const Walk& walk : strand.walks) {
        const std::size_t vertex = (walk.first + walk.last) / 2;
        double own = infinite;
        double other = infinite;
        truth_.tree().within(strand.chain.points[vertex], tolerance_, [&](const ChainPlace& place) {
          const bool followed = std::any_of(walk.legs.begin(), walk.legs.end(),
                                            [&](const Leg& leg) { return leg.arc == place.chain; });
          double& nearest = followed ? own : other;
          nearest = std::min(nearest, parameters_apart(candidate_.curves[c], strand.chain.at[vertex],
                                                       place.chain, place.position));
        });
        if (2 * other + clearly < own)
          verdict_.undecided.push_back("whether curve " + std::to_string(c) +
                                       " belongs to the arc that its parameters are nearest to");
      }
    }
  }

  // The verdict.

  void conclude() {
    if (!verdict_.exact_is_complete) {
      verdict_.undecided.push_back("the exact intersection is incomplete");
    } else {
      if (verdict_.differences.empty() && candidate_.curves.size() < graph_.components.size())
        differ(DifferenceKind::lost_curve, std::to_string(graph_.components.size()) +
                                               " components and only " +
                                               std::to_string(candidate_.curves.size()) + " curves");
      doubt_parameters();
      for (const std::size_t c : not_followed_)
        verdict_.undecided.push_back("whether curve " + std::to_string(c) +
                                     " runs along the true curve from end to end");
      for (const ArcFinding& arc : verdict_.arcs)
        if (arc.component < 0 && arc.coverage == Coverage::undecided)
          verdict_.undecided.push_back("whether the rim of overlap " + std::to_string(arc.overlap) +
                                       " is covered");
    }
    if (!verdict_.differences.empty()) {
      verdict_.agreement = Agreement::disagrees;
      verdict_.undecided.clear();
    } else if (verdict_.undecided.empty()) {
      verdict_.agreement = Agreement::agrees;
    }
  }

  Difference& differ(DifferenceKind kind, std::string text) {
    verdict_.differences.push_back({kind, std::move(text), {}, {}, {}, {}, {}, {}});
    return verdict_.differences.back();
  }

  const Candidate& candidate_;
  const IntersectionGraph& graph_;
  double tolerance_;
  PatchInDoubles x_;
  PatchInDoubles y_;
  TrueCurve truth_;
  double rounding_;
  std::vector<Chain> everything_;  // the arcs, then the isolated points
  std::optional<PieceTree> near_;
  std::vector<CurveData> curves_;
  std::vector<Chain> strands_;
  std::optional<PieceTree> claimed_;
  std::vector<std::vector<Interval>> covered_;                         // by arc
  std::vector<std::vector<std::pair<std::size_t, Interval>>> kernel_;  // by arc, with the curve
  std::set<std::size_t> not_followed_;
  Verdict verdict_;
};

}  // namespace

Verdict verify(const Candidate& candidate, const BezierPatch& x, const BezierPatch& y,
               const IntersectResult& exact, double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw std::invalid_argument("the tolerance must be positive and finite");
  return Verifier(candidate, x, y, exact, tolerance)();
}

Verification verify(const Candidate& candidate, const BezierPatch& x, const BezierPatch& y,
                    const VerifyOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
    throw std::invalid_argument("the tolerance must be positive and finite");
  const double extent = model_scale(x, y).extent;
  const double tolerance = options.tolerance * (extent > 0 ? extent : 1);
  IntersectOptions fine;
  fine.max_seconds = options.max_seconds;
  fine.progress = options.progress;
  constexpr int most_rounds = 3;
  for (int round = 1;; ++round) {
    fine.tolerance = std::ldexp(options.tolerance, -1 - 3 * round);
    IntersectResult exact = intersect(x, y, fine);
    Verdict verdict = verify(candidate, x, y, exact, tolerance);
    if (verdict.agreement != Agreement::undecided || !verdict.exact_is_complete || round == most_rounds)
      return {std::move(verdict), std::move(exact)};
  }
}

const char* name(Agreement agreement) {
  constexpr std::array<const char*, 3> names = {"agrees", "disagrees", "undecided"};
  return names[static_cast<std::size_t>(agreement)];
}

const char* name(DifferenceKind kind) {
  constexpr std::array<const char*, 12> names = {
      "lost-curve",     "gap",        "spurious-curve",  "wrong-connection",
      "split",          "repeated",   "curve-as-points", "false-point",
      "point-on-curve", "lost-point", "repeated-point",  "wrong-contact"};
  return names[static_cast<std::size_t>(kind)];
}

const char* name(Representation representation) {
  constexpr std::array<const char*, 3> names = {"space", "first", "second"};
  return names[static_cast<std::size_t>(representation)];
}

const char* name(Coverage coverage) {
  constexpr std::array<const char*, 4> names = {"covered", "partly", "missed", "undecided"};
  return names[static_cast<std::size_t>(coverage)];
}

}  // namespace exsect

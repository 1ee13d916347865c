// The candidate's curves: what of the truth they follow, and what of them is no intersection.
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "chain_distances.h"
#include "verifier.h"

namespace exsect {

namespace {

/// A hundred at most: a part of an arc that a curve repeats is not reported for each of a thousand others.
std::vector<std::size_t> first_of(std::vector<std::size_t> numbers) {
  constexpr std::size_t most = 100;
  if (numbers.size() > most) numbers.resize(most);
  return numbers;
}

}  // namespace

void Verifier::read_curves() {
  for (const CandidateCurve& curve : candidate_.curves) {
    require_time(stop_);
    CurveData data;
    const double flat = tolerance_ / 8;
    if (curve.space)
      data.strands.push_back({Representation::space, chain_in_space(*curve.space, curve.closed, flat), {}});
    if (curve.first)
      data.strands.push_back(
          {Representation::first, chain_on_patch(*curve.first, curve.closed, patch(0), flat), {}});
    if (curve.second)
      data.strands.push_back(
          {Representation::second, chain_on_patch(*curve.second, curve.closed, patch(1), flat), {}});
    if (data.strands.empty()) throw std::invalid_argument("a candidate curve is given in no space");
    for (const Strand& strand : data.strands) strands_.push_back(strand.chain);
    curves_.push_back(std::move(data));
  }
  claimed_.emplace(strands_);
  covered_.resize(truth_.arcs().size());
  kernel_.resize(truth_.arcs().size());
  kernel_index_.resize(truth_.arcs().size());
}

void Verifier::judge_curve(std::size_t c) {
  CurveFinding& finding = verdict_.curves.emplace_back();
  for (Strand& strand : curves_[c].strands) {
    WalkSearch search{tolerance_, rounding_, {}, {}, stop_};
    search.rank = [&](std::size_t arc, double position, std::size_t vertex) {
      return parameters_apart(candidate_.curves[c], strand.chain.at[vertex], arc, position);
    };
    search.rank_of_walk = [&](const Walk& walk) {
      constexpr double if_covered = 1e-4;  // which arcs over one curve in space differ by more in a parameter
      return if_covered * covered_share(walk);
    };
    strand.walks = find_walks(truth_, strand.chain, search);
    const DistanceEnclosure distance = largest_distance(strand.chain, *near_, tolerance_ / 8, stop_);
    finding.distance.lower = std::max(finding.distance.lower, distance.lower);
    finding.distance.upper = std::max(finding.distance.upper, distance.upper);
    find_spurious(c, strand, finding);
    if (strand.walks.size() != 1 || strand.walks[0].first != 0 ||
        strand.walks[0].last != strand.chain.pieces())
      not_followed_.insert(c);
  }
  note_coverage(c, finding);
}

double Verifier::covered_share(const Walk& walk) const {
  double length = 0;
  double covered = 0;
  bool stands_on_covered = true;
  for (const Leg& leg : walk.legs) {
    const auto [from, to] = std::minmax(leg.from, leg.to);
    length += to - from;
    covered += covered_[leg.arc].length(from, to);
    stands_on_covered = stands_on_covered && covered_[leg.arc].contains(from);
  }
  if (length > 0) return covered / length;
  return stands_on_covered ? 1 : 0;
}

double Verifier::parameters_apart(const CandidateCurve& curve, double t, std::size_t arc,
                                  double position) const {
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
      const double apart = std::fabs(p[k] - from - part * (to - from));
      if (!(apart <= result)) result = std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
    }
  }
  return result;
}

void Verifier::find_spurious(std::size_t c, const Strand& strand, CurveFinding& finding) {
  std::vector<Interval> followed;
  for (const Walk& walk : strand.walks)
    followed.push_back({static_cast<double>(walk.first), static_cast<double>(walk.last)});
  const Chain& chain = strand.chain;
  std::vector<Interval> parts;
  for (const Interval& open : remaining(united(followed), static_cast<double>(chain.pieces()))) {
    for (auto i = static_cast<std::size_t>(open.first); i < static_cast<std::size_t>(open.second); ++i) {
      require_time(stop_);
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
                                                   decimal(part.first) + " to " + decimal(part.second) +
                                                   " (" + name(strand.representation) + ")");
    difference.curve = c;
    difference.part = finding.spurious.back();
  }
}

bool Verifier::is_off(const Chain& chain, const Interval& part) const {
  if (verdict_.exact_is_complete && graph_.overlaps.empty()) return true;
  const auto first = std::lower_bound(chain.at.begin(), chain.at.end(), part.first);
  for (auto i = static_cast<std::size_t>(first - chain.at.begin());
       i < chain.points.size() && chain.at[i] <= part.second; ++i)
    if (is_off_a_surface(chain.points[i], chain.bound[std::min(i, chain.pieces() - 1)])) return true;
  return false;
}

bool Verifier::is_off_a_surface(const SpacePoint& p, double bound) const {
  const double radius = (tolerance_ + bound + rounding_) * kSlack;
  return std::ranges::any_of(sides_,
                             [&](const ComparedSide& side) { return side.certainly_farther(p, radius); });
}

void Verifier::note_coverage(std::size_t c, CurveFinding& finding) {
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
        IntervalIndex before;
        for (const Interval& own : inner) {
          for (const std::size_t j : first_of(before.crossing(own)))
            note_repetition(arc, own, inner[j], c, c);
          before.add(own);
        }
      }
      reached = s == 0 ? united(of_strand) : common(reached, united(of_strand));
      kernel = s == 0 ? united(inner) : common(kernel, united(inner));
    }
    std::vector<std::pair<std::size_t, std::size_t>> crossings;
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (const std::size_t j : first_of(kernel_index_[arc].crossing(kernel[k])))
        crossings.push_back({j, k});
    std::sort(crossings.begin(), crossings.end());
    for (const auto& [j, k] : crossings)
      note_repetition(arc, kernel[k], kernel_[arc][j].second, kernel_[arc][j].first, c);
    for (const Interval& i : kernel) {
      kernel_[arc].push_back({c, i});
      kernel_index_[arc].add(i);
    }
    for (const Interval& i : reached) covered_[arc].add(i);
  }
  for (const Strand& strand : curves_[c].strands)
    for (const Walk& walk : strand.walks)
      for (const Leg& leg : walk.legs) {
        const int component = truth_.arcs()[leg.arc].arc->component;
        if (component >= 0 && (finding.components.empty() || finding.components.back() != component))
          finding.components.push_back(component);
      }
}

void Verifier::note_repetition(std::size_t arc, const Interval& a, const Interval& b, std::size_t other,
                               std::size_t c) {
  const double from = std::max(a.first, b.first);
  const double to = std::min(a.second, b.second);
  if (from >= to) return;
  const Chain& chain = truth_.chains()[arc];
  double length = 0;
  for (auto i = static_cast<std::size_t>(std::floor(from)); static_cast<double>(i) < to && i < chain.pieces();
       ++i)
    length += distance(chain.points[i], chain.points[i + 1]) *
              (std::min(to, static_cast<double>(i + 1)) - std::max(from, static_cast<double>(i)));
  if (!(length > 8 * tolerance_)) return;
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

}  // namespace exsect

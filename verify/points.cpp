// The candidate's points, each claimed to be an isolated one.
#include <algorithm>
#include <stdexcept>

#include "verifier.h"

namespace exsect {

std::vector<SpacePoint> Verifier::places(const CandidatePoint& point) const {
  std::vector<SpacePoint> result;
  if (point.point) result.push_back(*point.point);
  if (point.first) result.push_back(patch(0)((*point.first)[0], (*point.first)[1]));
  if (point.second) result.push_back(patch(1)((*point.second)[0], (*point.second)[1]));
  return result;
}

void Verifier::judge_points() {
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

void Verifier::judge_point(std::size_t i, std::vector<int>& claims) {
  const std::vector<SpacePoint> all = places(candidate_.points[i]);
  if (all.empty()) throw std::invalid_argument("a candidate point is given in no space");
  const auto arcs = static_cast<std::ptrdiff_t>(truth_.arcs().size());
  bool off = false;
  for (const SpacePoint& p : all) {
    const bool far = near_->distance_from_below(p) - rounding_ > tolerance_;
    const bool whole = verdict_.exact_is_complete && graph_.overlaps.empty();
    off = off || (far && (whole || is_off_a_surface(p, rounding_)));
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

}  // namespace exsect

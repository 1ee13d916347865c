#include "verifier.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "infinite.h"
#include "scale.h"

namespace exsect {
namespace {

bool is_outside(double a, double b) { return !(std::min(a, b) >= -0.01 && std::max(a, b) <= 1.01); }

/// How far parameters leave [0,1]: a little, or up to 1.
Rational margin(const Candidate& candidate) {
  for (const CandidateCurve& curve : candidate.curves)
    for (const auto* spline : {&curve.first, &curve.second})
      if (*spline)
        for (const auto& p : (*spline)->points)
          if (is_outside(p[0], p[1])) return 1;
  for (const CandidatePoint& point : candidate.points)
    for (const auto* square : {&point.first, &point.second})
      if (*square && is_outside((**square)[0], (**square)[1])) return 1;
  return Rational(1, 64);
}

}  // namespace

Verifier::Verifier(const ComparedPair& pair)
    : candidate_(pair.candidate),
      graph_(pair.exact.graph),
      tolerance_(pair.tolerance),
      stop_(pair.stop),
      sides_{ComparedSide(pair.surfaces[0], margin(pair.candidate)),
             ComparedSide(pair.surfaces[1], margin(pair.candidate))},
      point_bounds_(pair.point_bounds),
      truth_(pair.exact.graph),
      rounding_(rounding_of_places()) {
  verdict_.agreement = Agreement::undecided;
  verdict_.exact_is_complete = pair.exact.status == Status::complete;
  verdict_.tolerance = tolerance_;
  if (std::isfinite(rounding_)) add_points();
}

Verdict Verifier::operator()() {
  const InterruptionScope scope(stop_);
  try {
    if (std::isfinite(rounding_))
      judge();
    else
      without_bounds();
    conclude();
  } catch (const Interrupted&) {
    verdict_.undecided = {"what the time was not enough for"};
    verdict_.curves.resize(candidate_.curves.size());
    if (!verdict_.differences.empty()) verdict_.agreement = Agreement::disagrees;
  }
  return std::move(verdict_);
}

double Verifier::rounding_of_places() const {
  std::vector<double> of_patches;
  for (const ComparedSide& side : sides_)
    if (side.patch() != nullptr) of_patches.push_back(side.patch()->rounding());
  if (!of_patches.empty()) return 4 * (of_patches.front() + of_patches.back());
  return 128 * kUnitRoundoff * std::max(largest_coordinate(graph_), largest_coordinate(candidate_));
}

/// A denominator may vanish next to the square, where the candidate may be.
void Verifier::without_bounds() {
  verdict_.curves.resize(candidate_.curves.size());
  verdict_.undecided.push_back(
      "the denominator of a patch is not proved positive where the candidate may be");
}

void Verifier::judge() {
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
}

void Verifier::add_points() {
  everything_ = truth_.chains();
  for (std::size_t k = 0; k < graph_.isolated_points.size(); ++k) everything_.push_back(isolated_point(k));
  near_.emplace(everything_);
}

/// From the patch on which its parameters tell more; without patches where the result says.
Chain Verifier::isolated_point(std::size_t k) const {
  const Node& node = graph_.nodes[static_cast<std::size_t>(graph_.isolated_points[k])];
  SpacePoint at = node.point;
  double bound = k < point_bounds_.size() ? point_bounds_[k] : infinite;
  for (std::size_t side = 0; side < 2; ++side) {
    const PatchInDoubles* patch = sides_[side].patch();
    if (patch == nullptr) continue;
    const RationalInterval &a = node.box[2 * side], &b = node.box[2 * side + 1];
    const double off = patch->speed(0) * to_double(a.width()) + patch->speed(1) * to_double(b.width());
    if (!(off < bound)) continue;
    bound = off;
    at = (*patch)(to_double(a.midpoint()), to_double(b.midpoint()));
  }
  Chain chain;
  chain.points = {at, at};
  chain.at = {0, 0};
  chain.bound = {bound * kSlack + rounding_};
  return chain;
}

void Verifier::conclude() {
  if (!verdict_.exact_is_complete) {
    verdict_.undecided.push_back("the exact intersection is incomplete");
  } else {
    if (verdict_.differences.empty() && candidate_.curves.size() < graph_.components.size())
      differ(DifferenceKind::lost_curve, std::to_string(graph_.components.size()) + " components and only " +
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

Difference& Verifier::differ(DifferenceKind kind, std::string text) {
  verdict_.differences.push_back({kind, std::move(text), {}, {}, {}, {}, {}, {}});
  return verdict_.differences.back();
}

std::string decimal(double x) {
  std::string text = std::to_string(x);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

}  // namespace exsect

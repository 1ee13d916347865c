#include "verifier.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

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

Verifier::Verifier(const Candidate& candidate, const RationalPatch& x, const RationalPatch& y,
                   const IntersectResult& exact, double tolerance, StopRequest stop)
    : candidate_(candidate),
      graph_(exact.graph),
      tolerance_(tolerance),
      stop_(std::move(stop)),
      x_(x, margin(candidate)),
      y_(y, margin(candidate)),
      truth_(exact.graph) {
  verdict_.agreement = Agreement::undecided;
  verdict_.exact_is_complete = exact.status == Status::complete;
  verdict_.tolerance = tolerance;
  rounding_ = 4 * (x_.rounding() + y_.rounding());
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
    chain.bound = {std::min(in_x, in_y) * kSlack + rounding_};
    everything_.push_back(chain);
  }
  near_.emplace(everything_);
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

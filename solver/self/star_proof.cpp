#include "self/star_proof.h"

#include <exsect/algebra/algebraic_value.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "answer/parameter_box.h"
#include "curve/short_rational.h"
#include "self/chart.h"
#include "self/pairs.h"
#include "shape/injective_rectangle.h"
#include "shape/special_cusps.h"

namespace exsect {
namespace {

constexpr int kMostSlabs = 10;
constexpr int kMostWideSlabs = 3;
constexpr double kLeastSurroundings = 0x1p-8;

}  // namespace

SelfStarProof::SelfStarProof(const SelfStarProblem& problem, const SelfCentre& centre, std::size_t sweep)
    : problem_(problem),
      known_(problem.values),
      centre_(centre),
      sweep_(sweep),
      at_(centre.value[sweep].refined_to(power_of_two(-100))) {
  for (const std::size_t fixed : {0, 1})
    for (const int value : {0, 1})
      if (is_cuspidal_side(problem.x, fixed, value)) cuspidal_sides_.emplace_back(fixed, value);
}

std::optional<SelfStar> SelfStarProof::run(double halfwidth) {
  if (!known_.turning[sweep_] || !bound_slab()) return std::nullopt;
  double slab = largest_slab(halfwidth);
  for (int i = 0; i < kMostSlabs && !is_stopped(problem_.stop); ++i, slab *= 0.25) {
    set_box(halfwidth, slab);
    if (!centre_.cuspidal && !arcs_are_monotone()) return std::nullopt;
    if (!is_alone() || !lateral_faces_are_free()) continue;
    return with_ports();
  }
  return std::nullopt;
}

ParameterBox SelfStarProof::surroundings(const ParameterBox& inner) {
  for (double halfwidth = 0.25; halfwidth >= kLeastSurroundings; halfwidth *= 0.5) {
    double slab = largest_slab(halfwidth);
    for (int i = 0; i < kMostWideSlabs && !is_stopped(problem_.stop); ++i, slab *= 0.25) {
      set_box(halfwidth, slab);
      if (lies_in(inner, box_) && is_alone() && lateral_faces_are_free()) return box_;
    }
  }
  return inner;
}

double SelfStarProof::largest_slab(double halfwidth) const {
  double slab = 0.5 * halfwidth;
  while (from_double(slab) > slab_room_) slab *= 0.5;
  return slab;
}

bool SelfStarProof::add_layers(SelfStar& star, int count) const {
  const RationalInterval& slab = star.star.box[sweep_];
  const Rational centre = at_.is_rational() ? at_.rational() : at_.interval().midpoint();
  for (const int side : {-1, 1}) {
    const auto ports = static_cast<std::size_t>(
        std::ranges::count_if(star.star.ports, [&](const Port& port) { return port.side == side; }));
    const Rational end = side < 0 ? slab.lower : slab.upper;
    const Rational step = (centre - end) / (count + 1);
    for (int i = 1; i <= count && ports > 0; ++i) {
      if (is_stopped(problem_.stop)) return false;
      const Rational about = end + step * i;
      const Rational value = simplest_between(about - abs(step) / 4, about + abs(step) / 4);
      auto points = oriented(pairs_in(problem_.x, {sweep(), value}, star.star.box));
      if (!points || points->size() != ports) return false;
      star.star.layers[side < 0 ? 0 : 1].push_back(*std::move(points));
    }
  }
  return true;
}

/// Twice the slab holds no other turning value, and at a cuspidal centre no other cuspidal one.
bool SelfStarProof::bound_slab() {
  slab_room_ = 1;
  keep_away(*known_.turning[sweep_]);
  if (!centre_.cuspidal) return true;
  if (!known_.cuspidal[sweep_]) return false;
  keep_away(*known_.cuspidal[sweep_]);
  return true;
}

void SelfStarProof::keep_away(const std::vector<RealAlgebraic>& values) {
  for (const RealAlgebraic& value : values) {
    if (value == at_) continue;
    for (Rational width = power_of_two(-60);; width *= width) {
      const RationalInterval a = value.refined_to(width).interval();
      const RationalInterval b = at_.refined_to(width).interval();
      if (a.lower <= b.upper && b.lower <= a.upper) continue;
      slab_room_ = std::min<Rational>(slab_room_, std::max(a.lower - b.upper, b.lower - a.upper) / 2);
      break;
    }
  }
}

/// At a cuspidal centre on the side that is its value of the sweep parameter the two points of every pair
/// differ in that parameter, if possible: then only the pairs whose second point is nearer to the side
/// count, none of which lies on it, and the slab holds both points.
void SelfStarProof::set_box(double halfwidth, double slab) {
  // The fibres over the faces are computed exactly: their numbers are short, and h is h (1 + 1/16) at most.
  const auto range = [&](std::size_t j, double h) {
    const double middle = to_double(near(j).midpoint());
    const int bits = 5 - std::ilogb(h);
    return RationalInterval{std::max<Rational>(0, rounded_down(from_double(middle - h), bits)),
                            std::min<Rational>(1, rounded_up(from_double(middle + h), bits))};
  };
  for (std::size_t j = 0; j < 4; ++j) box_[j] = range(j, j == sweep_ ? slab : halfwidth);
  const bool on_side = at_.compare(0) == 0 || at_.compare(1) == 0;
  from_side_ = centre_.cuspidal && on_side &&
               !has_folded_line(problem_.x, sweep_, box_[sweep_], hull(box_[1 - sweep_], box_[3 - sweep_]));
  if (from_side_) box_[sweep_ + 2] = box_[sweep_];
}

/// The centre is the only pair of the box over its value of the sweep parameter and the only isolated one
/// on a side; a cuspidal one is the only cuspidal point, any other box holds none.
bool SelfStarProof::is_alone() const {
  if (!lies_in(centre_.point.box(), box_) || meets_cuspidal_side()) return false;
  for (std::size_t i = 0; i < problem_.boundary.size(); ++i)
    if (i != centre_.landmark && meet(problem_.boundary[i].box(), box_)) return false;
  if (centre_.cuspidal) {
    if (cuspidal_points_on_line() != 1) return false;
    if (from_side_) return true;
    const auto pairs = pairs_in(problem_.x, {sweep(), at_.rational()}, box_);
    return pairs && pairs->empty() && orientation().has_value();
  }
  if (meet(box_, exchanged_pair(box_))) return false;
  if (!at_.is_rational()) return is_only_root(centre_, box_);
  const auto pairs = pairs_in(problem_.x, {sweep(), at_.rational()}, box_);
  return pairs && pairs->size() == 1;
}

/// Where cuspidal points are not isolated.
bool SelfStarProof::meets_cuspidal_side() const {
  return std::ranges::any_of(cuspidal_sides_,
                             [&](const auto& side) { return meets_side(box_, side.first, side.second); });
}

/// Of the box, over the centre's value.
std::optional<std::size_t> SelfStarProof::cuspidal_points_on_line() const {
  const RationalInterval& a = box_[1 - sweep_];
  const RationalInterval& b = box_[3 - sweep_];
  return cuspidal_points_on(sweep_ == 0 ? problem_.x : problem_.x.exchanged(), at_.rational(),
                            {std::min(a.lower, b.lower), std::max(a.upper, b.upper)});
}

/// A parameter in which the two points of every pair in the box differ: u or v.
std::optional<std::size_t> SelfStarProof::orientation() const {
  if (from_side_) return sweep_;
  for (const std::size_t k : {0, 1}) {
    if (!has_folded_line(problem_.x, k, hull(box_[k], box_[k + 2]), hull(box_[1 - k], box_[3 - k]))) return k;
  }
  return std::nullopt;
}

bool SelfStarProof::lateral_faces_are_free() const {
  for (const Parameter p : all_parameters) {
    if (index(p) == sweep_ || (from_side_ && index(p) == sweep_ + 2)) continue;
    for (const Rational& face : {box_[index(p)].lower, box_[index(p)].upper}) {
      if (face == 0 || face == 1) continue;
      const auto pairs = pairs_in(problem_.x, {p, face}, box_);
      if (!pairs || !pairs->empty()) return false;
    }
  }
  return true;
}

/// At a cuspidal centre those of one order only: at the side 1 the first point is the lower one.
std::optional<std::vector<CertifiedPoint>> SelfStarProof::oriented(
    std::optional<std::vector<CertifiedPoint>> points) const {
  if (!points || !centre_.cuspidal) return points;
  const std::size_t k = *orientation();
  std::vector<CertifiedPoint> kept;
  for (CertifiedPoint point : *points) {
    for (Rational width = power_of_two(-60);
         point.box()[k].lower <= point.box()[k + 2].upper && point.box()[k + 2].lower <= point.box()[k].upper;
         width *= width)
      point = point.refined_to(width);
    const bool descending = point.box()[k].lower > point.box()[k + 2].upper;
    if (descending != (from_side_ && at_.compare(1) == 0)) kept.push_back(point);
  }
  return kept;
}

std::optional<SelfStar> SelfStarProof::with_ports() const {
  SelfStar result{{centre_.point, sweep(), box_, {}, {}}, box_, {}, centre_.cuspidal, centre_.landmark};
  for (const int side : {-1, 1}) {
    const Rational value = side < 0 ? box_[sweep_].lower : box_[sweep_].upper;
    if (at_.compare(value) == 0) {
      if (value != 0 && value != 1) return std::nullopt;
      continue;
    }
    const auto points = oriented(pairs_in(problem_.x, {sweep(), value}, box_));
    if (!points) return std::nullopt;
    for (const CertifiedPoint& point : *points) {
      result.star.ports.push_back({point, sweep(), side});
      result.folded.push_back(folded_arc(point, value));
    }
  }
  if (centre_.cuspidal && !result.star.ports.empty() && !arcs_are_monotone()) return std::nullopt;
  return result;
}

/// The folded line on which the point over this value of the sweep parameter lies.
std::optional<SelfStar::FoldedArc> SelfStarProof::folded_arc(const CertifiedPoint& point,
                                                             const Rational& value) const {
  const std::size_t fixed = 1 - sweep_;
  for (const FoldedLine& line : folded_lines(fixed == 1 ? problem_.x : problem_.x.exchanged())) {
    const RealAlgebraic turn = value_at(BivariatePolynomial::r(), line.turn);
    const RealAlgebraic& constant = line.turn.s();
    const Rational width = power_of_two(-300);
    const RationalInterval at = constant.refined_to(width).interval();
    const RationalInterval middle = turn.refined_to(width).interval();
    ParameterBox pair;  // of a point of the fibre, like `point`; boxes of different points are disjoint
    pair[fixed] = pair[fixed + 2] = at;
    pair[sweep_] = {value, value};
    pair[sweep_ + 2] = {2 * middle.lower - value, 2 * middle.upper - value};
    if (lies_in(pair, point.box())) return SelfStar::FoldedArc{fixed, constant, line.side[1]};
  }
  return std::nullopt;
}

/// Or constant: the box holds no turning value of the other parameters but the centre's.
bool SelfStarProof::arcs_are_monotone() const {
  for (const Parameter p : all_parameters) {
    if (index(p) == sweep_) continue;
    const auto& values = known_.turning[index(p) % 2];
    if (!values) return false;
    for (const RealAlgebraic& value : *values) {
      const RationalInterval& range = box_[index(p)];
      if (value.compare(range.lower) < 0 || value.compare(range.upper) > 0) continue;
      // An arc that turned over the centre's value would turn over another one on its way to the centre.
      if (value == centre_.value[index(p)]) continue;
      return false;
    }
  }
  return true;
}

}  // namespace exsect

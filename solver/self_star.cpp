#include "self_star.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <list>
#include <utility>

#include "graph_builder.h"
#include "model_scale.h"
#include "parameter_box.h"
#include "self_pairs.h"
#include "self_star_centres.h"
#include "self_turning.h"
#include "special_cusps.h"

namespace exsect {
namespace {

constexpr int kMostSlabs = 10;
constexpr double kMostLayers = 1024;
constexpr double kLayersPerTolerance = 8;

ParameterBox exchanged(const ParameterBox& box) { return {box[2], box[3], box[0], box[1]}; }

class SelfStarProof {
 public:
  SelfStarProof(const SelfStarProblem& problem, const SelfCentre& centre, std::size_t sweep)
      : problem_(problem),
        known_(problem.values),
        centre_(centre),
        sweep_(sweep),
        at_(centre.value[sweep].refined_to(power_of_two(-100))) {}

  /// The star in a box of at most this half width.
  std::optional<SelfStar> run(double halfwidth) {
    if (!known_.turning[sweep_] || !bound_slab()) return std::nullopt;
    double slab = 0.5 * halfwidth;
    while (from_double(slab) > slab_room_) slab *= 0.5;
    for (int i = 0; i < kMostSlabs && !is_stopped(problem_.stop); ++i, slab *= 0.25) {
      set_box(halfwidth, slab);
      if (!centre_.cuspidal && !arcs_are_monotone()) return std::nullopt;
      if (!is_alone() || !lateral_faces_are_free()) continue;
      return with_ports();
    }
    return std::nullopt;
  }

  /// Fills in `count` layers on each side that has ports.
  bool add_layers(SelfStar& star, int count) const {
    const RationalInterval& slab = star.star.box[sweep_];
    const Rational centre = at_.is_rational() ? at_.rational() : at_.interval().midpoint();
    for (const int side : {-1, 1}) {
      const auto ports = static_cast<std::size_t>(
          std::ranges::count_if(star.star.ports, [&](const Port& port) { return port.side == side; }));
      const Rational end = side < 0 ? slab.lower : slab.upper;
      for (int i = 1; i <= count && ports > 0; ++i) {
        if (is_stopped(problem_.stop)) return false;
        auto points = oriented(
            pairs_in(problem_.x, {sweep(), end + (centre - end) * Rational(i, count + 1)}, star.star.box));
        if (!points || points->size() != ports) return false;
        star.star.layers[side < 0 ? 0 : 1].push_back(*std::move(points));
      }
    }
    return true;
  }

 private:
  Parameter sweep() const { return static_cast<Parameter>(sweep_); }
  const RationalInterval& near(std::size_t j) const { return centre_.point.box()[j]; }

  /// Twice the slab holds no other turning value, and at a cuspidal centre no other cuspidal one.
  bool bound_slab() {
    slab_room_ = 1;
    keep_away(*known_.turning[sweep_]);
    if (!centre_.cuspidal) return true;
    if (!known_.cuspidal[sweep_]) return false;
    keep_away(*known_.cuspidal[sweep_]);
    return true;
  }

  void keep_away(const std::vector<RealAlgebraic>& values) {
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
  void set_box(double halfwidth, double slab) {
    const auto range = [&](std::size_t j, double h) {
      const double middle = to_double(near(j).midpoint());
      return RationalInterval{from_double(std::max(0.0, middle - h)), from_double(std::min(1.0, middle + h))};
    };
    for (std::size_t j = 0; j < 4; ++j) box_[j] = range(j, j == sweep_ ? slab : halfwidth);
    const bool on_side = at_.compare(0) == 0 || at_.compare(1) == 0;
    from_side_ = centre_.cuspidal && on_side && !has_folded_line(problem_.x, sweep_, box_[sweep_]);
    if (from_side_) box_[sweep_ + 2] = box_[sweep_];
  }

  /// The centre is the only pair of the box over its value of the sweep parameter and the only isolated one
  /// on a side; a cuspidal one is the only cuspidal point, any other box holds none.
  bool is_alone() const {
    if (!lies_in(centre_.point.box(), box_)) return false;
    for (std::size_t i = 0; i < problem_.boundary.size(); ++i)
      if (i != centre_.landmark && meet(problem_.boundary[i].box(), box_)) return false;
    if (centre_.cuspidal) {
      if (cuspidal_points_on_line() != 1) return false;
      if (from_side_) return true;
      const auto pairs = pairs_in(problem_.x, {sweep(), at_.rational()}, box_);
      return pairs && pairs->empty() && orientation().has_value();
    }
    if (meet(box_, exsect::exchanged(box_))) return false;
    if (!at_.is_rational()) return is_only_root(centre_, box_);
    const auto pairs = pairs_in(problem_.x, {sweep(), at_.rational()}, box_);
    return pairs && pairs->size() == 1;
  }

  /// Of the box, over the centre's value.
  std::optional<std::size_t> cuspidal_points_on_line() const {
    const RationalInterval& a = box_[1 - sweep_];
    const RationalInterval& b = box_[3 - sweep_];
    return cuspidal_points_on(sweep_ == 0 ? problem_.x : problem_.x.exchanged(), at_.rational(),
                              {std::min(a.lower, b.lower), std::max(a.upper, b.upper)});
  }

  /// A parameter in which the two points of every pair in the box differ: u or v.
  std::optional<std::size_t> orientation() const {
    if (from_side_) return sweep_;
    for (const std::size_t k : {0, 1}) {
      const RationalInterval range = {std::min(box_[k].lower, box_[k + 2].lower),
                                      std::max(box_[k].upper, box_[k + 2].upper)};
      if (!has_folded_line(problem_.x, k, range)) return k;
    }
    return std::nullopt;
  }

  bool lateral_faces_are_free() const {
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
  std::optional<std::vector<CertifiedPoint>> oriented(
      std::optional<std::vector<CertifiedPoint>> points) const {
    if (!points || !centre_.cuspidal) return points;
    const std::size_t k = *orientation();
    std::vector<CertifiedPoint> kept;
    for (CertifiedPoint point : *points) {
      for (Rational width = power_of_two(-60); point.box()[k].lower <= point.box()[k + 2].upper &&
                                               point.box()[k + 2].lower <= point.box()[k].upper;
           width *= width)
        point = point.refined_to(width);
      const bool descending = point.box()[k].lower > point.box()[k + 2].upper;
      if (descending != (from_side_ && at_.compare(1) == 0)) kept.push_back(point);
    }
    return kept;
  }

  std::optional<SelfStar> with_ports() const {
    SelfStar result{{centre_.point, sweep(), box_, {}, {}}, {}, centre_.cuspidal, centre_.landmark};
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

  /// The folded line on which the point over this value of the sweep parameter lies, if that line and its
  /// turn are rational.
  std::optional<SelfStar::FoldedArc> folded_arc(const CertifiedPoint& point, const Rational& value) const {
    const std::size_t fixed = 1 - sweep_;
    for (const FoldedLine& line : folded_lines(fixed == 1 ? problem_.x : problem_.x.exchanged())) {
      const auto turn = rational_turn(line);
      if (!turn) continue;
      const auto& [middle, at] = *turn;
      ParameterBox pair;  // a point of the fibre, like `point`; boxes of different points are disjoint
      pair[fixed] = pair[fixed + 2] = {at, at};
      pair[sweep_] = {value, value};
      pair[sweep_ + 2] = {2 * middle - value, 2 * middle - value};
      if (lies_in(pair, point.box())) return SelfStar::FoldedArc{fixed, at, line.side[1]};
    }
    return std::nullopt;
  }

  /// Or constant: the box holds no turning value of the other parameters but the centre's.
  bool arcs_are_monotone() const {
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

  const SelfStarProblem& problem_;
  const SelfValues& known_;
  const SelfCentre& centre_;
  std::size_t sweep_;
  RealAlgebraic at_;
  Rational slab_room_;
  ParameterBox box_;
  bool from_side_ = false;
};

class SelfStarSearch {
 public:
  explicit SelfStarSearch(const SelfStarProblem& problem)
      : problem_(problem),
        scale_(model_scale(problem.x, problem.x)),
        system_(problem.x, problem.x, scale_.origin, scale_.frame.exponent) {}

  std::vector<SelfStar> run() {
    const double first = std::clamp(8 * problem_.tolerance, 0x1p-36, 0x1p-5);
    const std::vector<SelfCentre> centres =
        self_star_centres(problem_.x, problem_.boundary, problem_.where, problem_.values);
    for (const double halfwidth : {first, 0x1p-4 * first, 0x1p-9 * first, 0x1p-14 * first, 0x1p-20 * first})
      for (const SelfCentre& centre : centres)
        if (!is_known(centre)) add(centre, halfwidth);
    return std::move(stars_);
  }

 private:
  bool is_known(const SelfCentre& centre) const {
    return std::ranges::any_of(stars_, [&](const SelfStar& star) {
      return meet(star.star.box, centre.point.box()) ||
             meet(star.star.box, exsect::exchanged(centre.point.box()));
    });
  }

  /// The sweep with the widest slab first, whatever the parameters are called: the searches around the star
  /// have an easy task if its box is not flat.
  void add(const SelfCentre& centre, double halfwidth) {
    std::list<SelfStarProof> proofs;
    std::vector<std::pair<SelfStarProof*, SelfStar>> stars;
    for (const std::size_t sweep : centre.sweeps) {
      proofs.emplace_back(problem_, centre, sweep);
      auto star = proofs.back().run(halfwidth);
      if (star && is_disjoint(*star)) stars.emplace_back(&proofs.back(), *std::move(star));
    }
    std::ranges::stable_sort(stars, std::greater<>(), [](const auto& star) { return slab(star.second); });
    for (auto& [proof, star] : stars) {
      if (!divide_into_layers(*proof, star)) continue;
      stars_.push_back(std::move(star));
      return;
    }
  }

  /// As many as the tolerance asks for: tried with more if the hulls between them are wide.
  bool divide_into_layers(const SelfStarProof& proof, SelfStar& star) const {
    double layers = std::clamp(kLayersPerTolerance * slab(star) / problem_.tolerance, 1.0, kMostLayers);
    for (int attempt = 0; attempt < 2; ++attempt, layers = std::min(4 * layers, kMostLayers)) {
      star.star.layers = {};
      if (!proof.add_layers(star, static_cast<int>(layers))) return false;
      if (arcs_keep_tolerance(star.star)) return true;
    }
    return false;
  }

  static double slab(const SelfStar& star) {
    return to_double(star.star.box[index(star.star.sweep)].width());
  }

  bool is_disjoint(const SelfStar& star) const {
    return std::ranges::none_of(stars_, [&](const SelfStar& other) {
      return meet(star.star.box, other.star.box) || meet(star.star.box, exsect::exchanged(other.star.box));
    });
  }

  /// In either order of the pairs: the curve's order is that in which it is traced.
  bool arcs_keep_tolerance(const StarNeighbourhood& star) const {
    const ModelFrame unit = {{0, 0, 0}, 0};
    const auto keeps = [&](const ParameterBox& hull) {
      return chord_bound(system_, unit, hull) <= 0.9 * problem_.tolerance;
    };
    return std::ranges::all_of(star.ports, [&](const Port& port) {
      const StarArc arc = star_arc(star, port);
      return std::ranges::all_of(
          arc.hulls, [&](const ParameterBox& hull) { return keeps(hull) && keeps(exsect::exchanged(hull)); });
    });
  }

  const SelfStarProblem& problem_;
  ModelScale scale_;
  PairSystem<DoubleBall> system_;
  std::vector<SelfStar> stars_;
};

}  // namespace

std::vector<SelfStar> self_stars(const SelfStarProblem& problem) { return SelfStarSearch(problem).run(); }

}  // namespace exsect

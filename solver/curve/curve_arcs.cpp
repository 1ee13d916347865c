#include "curve/curve_arcs.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/no_zero.h"
#include "curve/plane_curve.h"
#include "curve/turning_resultant.h"

namespace exsect {
namespace {

/// An event before its meetings are known.
struct Place {
  RealAlgebraic u;  // meaningless for an extra event
  std::optional<RationalInterval> extra;
  int multiplicity;
  int turning_values;  // in the interval

  RationalInterval interval() const { return extra ? *extra : u.interval(); }
  bool is_rational() const { return !extra && u.is_rational(); }
};

bool overlap(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

/// Refines until the closed intervals are pairwise disjoint; equal numbers become one.
void separate(std::vector<Place>& places) {
  const auto by_lower = [](const Place& a, const Place& b) {
    return a.interval().lower < b.interval().lower;
  };
  for (Rational width = power_of_two(-40);; width *= width) {
    std::sort(places.begin(), places.end(), by_lower);
    bool disjoint = true;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      Place& a = places[i];
      Place& b = places[i + 1];
      if (!overlap(a.interval(), b.interval())) continue;
      disjoint = false;
      if (a.extra || b.extra) {
        // What was asked for is known to this width only: one event for both.
        a.extra = RationalInterval{std::min(a.interval().lower, b.interval().lower),
                                   std::max(a.interval().upper, b.interval().upper)};
        a.multiplicity = std::max(a.multiplicity, b.multiplicity);
        a.turning_values += b.turning_values;
      } else if (a.u == b.u) {
        if (b.u.is_rational()) a.u = b.u;
        a.multiplicity = std::max(a.multiplicity, b.multiplicity);
        a.turning_values = std::max(a.turning_values, b.turning_values);
      } else {
        a.u = a.u.refined_to(width);
        b.u = b.u.refined_to(width);
        continue;
      }
      places.erase(places.begin() + static_cast<std::ptrdiff_t>(i + 1));
      --i;
    }
    if (disjoint) return;
  }
}

std::vector<Place> places(const BivariatePolynomial& f, const std::vector<RationalInterval>& extra) {
  std::vector<Place> result = {{0, std::nullopt, 0, 0}, {1, std::nullopt, 0, 0}};
  const auto add = [&](const Polynomial& polynomial, int multiplicity) {
    for (const RealAlgebraic& u : real_roots(polynomial, 0, 1))
      result.push_back(
          {u.refined_to(power_of_two(-40)), std::nullopt, multiplicity, multiplicity > 0 ? 1 : 0});
  };
  const Polynomial turning = turning_resultant(f);
  if (turning.is_zero()) throw std::domain_error("curve_arcs: the polynomial has a multiple factor");
  for (const PolynomialPower& power : squarefree_factors(turning)) add(power.factor, power.multiplicity);
  for (const int side : {0, 1}) {
    const Polynomial on_side = f.at_s(side);
    if (on_side.is_zero()) throw std::domain_error("curve_arcs: a side of the square belongs to the curve");
    if (on_side.degree() > 0) add(on_side, 0);
  }
  for (const RationalInterval& interval : extra) result.push_back({0, interval, 0, 0});
  separate(result);
  return result;
}

std::vector<RealAlgebraic> roots_at(const BivariatePolynomial& f, const Rational& u) {
  const Polynomial in_v = f.at_r(u);
  return in_v.degree() <= 0 ? std::vector<RealAlgebraic>{} : real_roots(in_v, 0, 1);
}

/// A rational number strictly between two different neighbouring roots.
Rational between(RealAlgebraic a, RealAlgebraic b) {
  for (Rational width = power_of_two(-10); a.interval().upper >= b.interval().lower; width *= width) {
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
  return simplest_between(a.interval().upper, b.interval().lower);
}

void add_cuts(std::vector<Rational>& cuts, const std::vector<RealAlgebraic>& roots) {
  for (std::size_t i = 0; i + 1 < roots.size(); ++i) cuts.push_back(between(roots[i], roots[i + 1]));
}

/// Roots at both ends of a window around an event, and numbers c such that f(u,c) has no zero in the window.
struct Window {
  std::vector<RealAlgebraic> left;
  std::vector<RealAlgebraic> right;
  std::vector<Rational> cuts;  // ascending
};

std::size_t count_below(const std::vector<RealAlgebraic>& roots, const Rational& c) {
  return static_cast<std::size_t>(
      std::count_if(roots.begin(), roots.end(), [&](const RealAlgebraic& v) { return v.compare(c) < 0; }));
}

/// left_end and right_end: whether the curve is looked at on that side of the event.
Window window(const BivariatePolynomial& f, const RationalInterval& on, bool left_end, bool right_end,
              const std::vector<RealAlgebraic>& at_event) {
  Window result;
  if (left_end) result.left = roots_at(f, on.lower);
  if (right_end) result.right = roots_at(f, on.upper);
  std::vector<Rational> candidates;
  add_cuts(candidates, result.left);
  add_cuts(candidates, result.right);
  add_cuts(candidates, at_event);
  std::sort(candidates.begin(), candidates.end());
  for (const Rational& c : candidates)
    if ((result.cuts.empty() || result.cuts.back() != c) && has_no_zero(f.at_s(c), on))
      result.cuts.push_back(c);
  return result;
}

/// The parts of the arcs [from, from + count) and of the roots at the event that lie between two cuts.
struct Strip {
  RationalInterval v;
  std::size_t left_from, left_to, right_from, right_to;
  std::size_t at_event;

  std::size_t arcs() const { return left_to - left_from + right_to - right_from; }
};

std::vector<Strip> strips(const Window& window, const std::vector<RealAlgebraic>& at_event) {
  std::vector<Strip> result;
  Strip strip{{0, 0}, 0, 0, 0, 0, 0};
  std::size_t event_from = 0;
  for (std::size_t i = 0; i <= window.cuts.size(); ++i) {
    const bool last = i == window.cuts.size();
    strip.v.upper = last ? Rational(1) : window.cuts[i];
    strip.left_to = last ? window.left.size() : count_below(window.left, strip.v.upper);
    strip.right_to = last ? window.right.size() : count_below(window.right, strip.v.upper);
    const std::size_t event_to = last ? at_event.size() : count_below(at_event, strip.v.upper);
    strip.at_event = event_to - event_from;
    result.push_back(strip);
    event_from = event_to;
    strip.v.lower = strip.v.upper;
    strip.left_from = strip.left_to;
    strip.right_from = strip.right_to;
  }
  return result;
}

std::vector<std::size_t> part(const std::vector<std::size_t>& arcs, std::size_t from, std::size_t to) {
  return {arcs.begin() + static_cast<std::ptrdiff_t>(from), arcs.begin() + static_cast<std::ptrdiff_t>(to)};
}

class ArcJoiner {
 public:
  ArcJoiner(const BivariatePolynomial& f, const std::vector<RationalInterval>& extra)
      : f_(f), places_(places(f, extra)) {}

  CurveArcs run() {
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) add_gap(i);
    for (std::size_t i = 0; i < places_.size(); ++i) add_event(i);
    return std::move(result_);
  }

 private:
  void add_gap(std::size_t i) {
    CurveGap gap;
    gap.sample = simplest_between(places_[i].interval().upper, places_[i + 1].interval().lower);
    for (const RealAlgebraic& v : roots_at(f_, gap.sample)) {
      gap.arcs.push_back(result_.arcs.size());
      result_.arcs.push_back({i, v.interval()});
    }
    result_.gaps.push_back(std::move(gap));
  }

  /// Around the event and apart from all others, of a width that falls with the round.
  RationalInterval interval_around(std::size_t i, int round) const {
    const Place& place = places_[i];
    if (place.extra) return *place.extra;
    const RationalInterval fine = place.u.refined_to(power_of_two(-(40 << round))).interval();
    if (fine.lower < fine.upper) return fine;
    const Rational& u = fine.lower;
    const Rational reach = power_of_two(-(10 << round));
    RationalInterval on = {u, u};
    if (i > 0) on.lower = std::max(Rational(u - reach), Rational((u + places_[i - 1].interval().upper) / 2));
    if (i + 1 < places_.size())
      on.upper = std::min(Rational(u + reach), Rational((u + places_[i + 1].interval().lower) / 2));
    return on;
  }

  void add_event(std::size_t i) {
    const Place& place = places_[i];
    const std::vector<RealAlgebraic> at_event =
        place.is_rational() ? roots_at(f_, place.u.rational()) : std::vector<RealAlgebraic>{};
    const bool has_left = i > 0, has_right = i + 1 < places_.size();
    std::vector<Strip> found;
    for (int round = 0; round < rounds; ++round) {
      const Window at = window(f_, interval_around(i, round), has_left, has_right, at_event);
      found = strips(at, at_event);
      const bool settled = std::all_of(found.begin(), found.end(), [&](const Strip& strip) {
        return place.is_rational() ? strip.at_event <= 1 : strip.arcs() <= 2;
      });
      if (settled) break;
    }
    const std::vector<std::size_t> none;
    const auto& left = has_left ? result_.gaps[i - 1].arcs : none;
    const auto& right = has_right ? result_.gaps[i].arcs : none;
    if (found.back().left_to != left.size() || found.back().right_to != right.size())
      throw ProofFailure(whole_domain(), "curve_arcs: the number of points changes between two events");
    const RationalInterval on = interval_around(i, 0);
    const bool between_sides = has_no_zero(f_.at_s(0), on) || has_no_zero(f_.at_s(1), on);
    CurveEvent event{place.interval(), place.multiplicity, place.turning_values > 1, {}};
    for (const Strip& strip : found)
      if (strip.arcs() > 0)
        event.meetings.push_back({kind(strip, place.is_rational(), between_sides || found.size() > 1),
                                  strip.v, part(left, strip.left_from, strip.left_to),
                                  part(right, strip.right_from, strip.right_to)});
    result_.events.push_back(std::move(event));
  }

  /// The curve enters and leaves a strip over a window by its arcs and by the sides v = 0, v = 1, and an even
  /// number of half branches comes to each of its points: so one arc ends on a side, and two are joined, if
  /// the strip does not reach points of both sides. Over a rational event the strip has one point of the
  /// curve if the roots there are separated.
  static MeetingKind kind(const Strip& strip, bool rational, bool reaches_one_side) {
    if (rational && strip.at_event != 1) return MeetingKind::unresolved;
    if (strip.arcs() == 1) return MeetingKind::ends;
    if (strip.arcs() > 2) return rational ? MeetingKind::crosses : MeetingKind::unresolved;
    if (!rational && !reaches_one_side) return MeetingKind::unresolved;
    return strip.left_to - strip.left_from == 1 ? MeetingKind::passes : MeetingKind::folds;
  }

  static constexpr int rounds = 4;

  const BivariatePolynomial& f_;
  std::vector<Place> places_;
  CurveArcs result_;
};

}  // namespace

CurveArcs curve_arcs(const BivariatePolynomial& f, const std::vector<RationalInterval>& extra) {
  return in_nearest_rounding([&] {
    // The content in u of the polynomial with exchanged variables.
    const ContentAndPart parts = split_content(f.exchanged());
    CurveArcs result = ArcJoiner(parts.primitive.exchanged(), extra).run();
    if (parts.content.degree() > 0) result.vertical = real_roots(parts.content, 0, 1);
    return result;
  });
}

std::vector<CurveComponent> components(const CurveArcs& curve, const std::vector<bool>& kept) {
  std::vector<std::size_t> parent(curve.arcs.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t arc) {
    while (parent[arc] != arc) arc = parent[arc] = parent[parent[arc]];
    return arc;
  };
  std::vector<int> joined_ends(curve.arcs.size(), 0);
  std::vector<bool> branched(curve.arcs.size(), false);
  for (const CurveEvent& event : curve.events)
    for (const CurveMeeting& meeting : event.meetings) {
      std::vector<std::size_t> arcs;
      for (const auto* side : {&meeting.left, &meeting.right})
        std::copy_if(side->begin(), side->end(), std::back_inserter(arcs),
                     [&](std::size_t arc) { return kept[arc]; });
      for (const std::size_t arc : arcs) {
        parent[root(arc)] = root(arcs.front());
        if (arcs.size() == 2) ++joined_ends[arc];
        if (arcs.size() > 2) branched[arc] = true;
      }
    }
  std::vector<CurveComponent> result;
  std::vector<std::size_t> position(curve.arcs.size(), curve.arcs.size());
  for (std::size_t arc = 0; arc < curve.arcs.size(); ++arc) {
    if (!kept[arc]) continue;
    std::size_t& at = position[root(arc)];
    if (at == curve.arcs.size()) {
      at = result.size();
      result.push_back({{}, true, false});
    }
    result[at].arcs.push_back(arc);
    if (joined_ends[arc] != 2) result[at].closed = false;
    if (branched[arc]) result[at].branched = true;
  }
  return result;
}

}  // namespace exsect

#include "sweep/traced_curves.h"

#include <algorithm>
#include <cmath>

#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "line/known_tangent.h"
#include "line/line_place.h"
#include "line/line_points_in.h"
#include "sweep/constant_parameter.h"
#include "sweep/entering_directions.h"
#include "sweep/fibre_crossings.h"
#include "sweep/multiple_turning_values.h"
#include "sweep/search_window.h"
#include "sweep/traced_contacts.h"
#include "trace/enclose.h"
#include "trace/fixed_arc.h"
#include "trace/landmark_tangent.h"
#include "trace/search_direction.h"
#include "trace/search_regions.h"
#include "trace/subdivision.h"

namespace exsect {

namespace {

constexpr int kQuickSearch = 16;  // times 64 boxes

template <class Ball>
class CurveTracing {
 public:
  CurveTracing(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const SweepData& sweep,
               const Rational& width, const StopRequest& stop)
      : system_(system),
        landmarks_(landmarks),
        sweep_(sweep),
        pair_(sweep.pair),
        width_(width),
        stop_(stop) {}

  TracedCurves<Ball> run() {
    if (sweep_.turning && sweep_.exact) {
      trace_contacts(system_, landmarks_, sweep_, width_, stop_, result_);
    }
    trace_open_curves();
    if (result_.problems.empty()) {
      sweep_.turning || !sweep_.exact ? trace_closed_curves() : search_everywhere();
    }
    if (result_.problems.empty() && sweep_.turning && sweep_.exact) {
      match_fibres();
      check_multiple_turning_values();
    }
    return std::move(result_);
  }

 private:
  void problem(const ParameterBox& where, const std::string& why, Reason reason = Reason::not_decided) {
    result_.problems.push_back({where, why, reason});
  }

  void trace_open_curves() {
    used_.assign(landmarks_.size(), {});
    for (const AnalysedContact<Ball>& contact : result_.contacts) {
      for (const int landmark : {contact.trace.start, contact.trace.end}) {
        if (landmark >= 0) {
          used_[static_cast<std::size_t>(landmark)] = {1, -1};
        }
      }
    }
    for (const bool last_pass : {false, true}) {
      for (std::size_t i = 0; i < landmarks_.size(); ++i) {
        const bool centre = sweep_.landmarks[i].star && sweep_.landmarks[i].side == 0;
        if (!centre && !sweep_.landmarks[i].on_side_arc && used_[i].size() < 2) {
          trace_from(i, last_pass);
        }
      }
    }
  }

  /// Traces the curves that leave a landmark in directions not used yet. Points where these are not known
  /// wait for the last pass: a regular point at which two curves arrived is done.
  void trace_from(std::size_t landmark, bool last_pass) {
    const auto directions = entering_directions(system_, landmarks_, sweep_, landmark);
    if (!directions) {
      if (last_pass) {
        problem(sweep_.landmarks[landmark].point.box(),
                "the intersection is tangent to a side of a patch, or singular, at this boundary point",
                Reason::tangency);
      }
      return;
    }
    if (directions->empty() && last_pass) {
      result_.isolated.push_back(static_cast<int>(landmark));
    }
    for (const int sign : *directions) {
      if (std::count(used_[landmark].begin(), used_[landmark].end(), sign) > 0) {
        continue;
      }
      used_[landmark].push_back(sign);
      auto outcome = trace_arc(system_, landmarks_, static_cast<int>(landmark), sign, stop_);
      if (const auto* trace = std::get_if<Trace<Ball>>(&outcome)) {
        used_[static_cast<std::size_t>(trace->end)].push_back(arriving_direction(*trace));
      }
      add(std::move(outcome));
    }
  }

  /// Fibre points that are on no curve traced so far start closed curves.
  void trace_closed_curves() {
    for (const std::vector<CertifiedPoint>& fibre : sweep_.fibres) {
      for (const CertifiedPoint& point : fibre) {
        if (!point.sides().empty()) {
          continue;  // on an arc that lies on a side
        }
        const BallPoint<Ball> box = enclose<Ball>(point, width_);
        if (curves_through(result_, box) + contacts_through(result_, box) == 0) {
          add(trace_loop(system_, landmarks_, box, stop_));
        }
        if (!result_.problems.empty()) {
          return;
        }
      }
    }
  }

  void add(std::variant<Trace<Ball>, TraceFailure> outcome) {
    if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
      problem(around(failure->where), failure->why);
      return;
    }
    AnalysedTrace<Ball> curve{std::get<Trace<Ball>>(std::move(outcome)), {}};
    KnownTangent known;
    for (const Parameter p : all_parameters) {
      known.constant[index(p)] =
          may_be_constant(curve.trace, index(p)) && is_constant(system_, sweep_, curve.trace, p, width_);
    }
    mark_coincident(known.constant, pair_.coincident());
    known.plane = pair_.plane();
    known.common_zero = [this](const ParameterBox& where, std::size_t i, std::size_t j) {
      return common_tangent_zero(pair_.x(), pair_.y(), where, i, j);
    };
    known.at_start = tangent_signs_at(system_, landmarks_, sweep_, curve.trace.start);
    known.at_end = tangent_signs_at(system_, landmarks_, sweep_, curve.trace.end);
    auto turning = find_turning_points(system_, curve.trace, pair_.coincident(), known);
    if (std::holds_alternative<TraceFailure>(turning) && is_fixed(curve.trace)) {
      turning = find_turning_points(system_, curve.trace, pair_.symmetry()->partner, known);
    }
    if (const auto* failure = std::get_if<TraceFailure>(&turning)) {
      problem(around(failure->where), failure->why);
      return;
    }
    curve.turning = std::get<TurningPoints<Ball>>(std::move(turning));
    result_.curves.push_back(std::move(curve));
  }

  /// By a symmetry that exchanges the patches: then parameters turn together with their partners.
  bool is_fixed(const Trace<Ball>& trace) const {
    return pair_.symmetry() && exsect::is_fixed(*pair_.symmetry(), trace);
  }

  /// (u',v') on the pieces of the curves traced so far.
  std::vector<std::array<double, 2>> tangents() const {
    std::vector<std::array<double, 2>> result;
    for (const AnalysedTrace<Ball>& curve : result_.curves)
      for (const Piece<Ball>& piece : curve.trace.pieces)
        result.push_back({piece.tube.slope[0], piece.tube.slope[1]});
    return result;
  }

  void search_everywhere() {
    search({Parameter::u, {0, 1}},
           "a closed curve or singular point of the intersection is not excluded here");
  }

  void search(const SearchWindow& window, const char* why) {
    const SeedHandler<Ball> known = [&](const BallPoint<Ball>& seed) {
      const BallPoint<Ball> point = window.point(seed);
      return is_outside(point) || known_or_traced(point);
    };
    const SettledRegion settled = [&](const SearchRegion& seen) {
      const ParameterBox box = window.box(seen);
      return (sweep_.settled && sweep_.settled(rounded_outwards(box))) || is_in_star(box) ||
             is_on_contact(box);
    };
    const bool whole = window.range.width() == 1;
    const PairSystem<Ball> seen = whole ? system_ : system_.restricted(index(window.across), window.range);
    const StopRequest soon = [this, asked = 0]() mutable {
      return is_stopped(stop_) || (sweep_.quick && ++asked > kQuickSearch);
    };
    const SearchOutcome outcome =
        search_closed_curves(seen, {{0, 0, 0, 0}, {1, 1, 1, 1}},
                             window.direction(search_direction(tangents())), known, settled, soon);
    result_.cut_short = result_.cut_short || (sweep_.quick && !outcome.undecided.empty());
    result_.searched_boxes += outcome.boxes;
    for (const SearchRegion& box : merged(outcome.undecided)) {
      result_.problems.push_back(left_open(window.box(box), why, stop_));
    }
  }

  static bool is_outside(const BallPoint<Ball>& point) {
    return std::ranges::any_of(point,
                               [](const Ball& c) { return c.is_negative() || (c - Ball(1)).is_positive(); });
  }

  bool is_in_star(const ParameterBox& box) const {
    return std::any_of(sweep_.stars.begin(), sweep_.stars.end(), [&](const StarNeighbourhood& star) {
      return lies_in(box, star.outer.value_or(star.box));
    });
  }

  bool is_on_contact(const ParameterBox& box) const {
    return !result_.contacts.empty() &&
           contacts_through(result_, BallPoint<Ball>{Ball::enclosing(box[0]), Ball::enclosing(box[1]),
                                                     Ball::enclosing(box[2]), Ball::enclosing(box[3])}) > 0;
  }

  bool known_or_traced(const BallPoint<Ball>& seed) {
    if (curves_through(result_, seed) > 0) {
      return true;
    }
    auto outcome = trace_loop(system_, landmarks_, seed, stop_);
    if (std::holds_alternative<TraceFailure>(outcome)) {
      return false;
    }
    const std::size_t before = result_.problems.size();
    add(std::move(outcome));
    return result_.problems.size() == before;
  }

  /// The bijection: every fibre point lies on one curve, and the curves meet the sample as often as the fibre
  /// has points.
  void match_fibres() {
    for (std::size_t k = 0; k < sweep_.fibres.size(); ++k) {
      std::size_t expected = 0;
      for (const AnalysedTrace<Ball>& curve : result_.curves) {
        const auto met = crossings(sweep_, curve, sweep_.samples[k]);
        if (!met) {
          problem(whole_domain(), "a turning point cannot be separated from a sample of the sweep");
          return;
        }
        expected += *met;
      }
      std::size_t met = 0;
      for (const CertifiedPoint& point : sweep_.fibres[k]) {
        if (!point.sides().empty()) {
          continue;  // not over a boundary point: on an arc that lies on a side
        }
        const BallPoint<Ball> box = enclose<Ball>(point, width_);
        if (contacts_through(result_, box) == 1) {
          continue;
        }
        if (curves_through(result_, box) != 1) {
          problem(point.box(), "it is not decided which curve this point of a fibre lies on");
          return;
        }
        ++met;
      }
      if (expected != met) {
        ParameterBox where = whole_domain();
        where[index(sweep_.turning->sweep)] = {sweep_.samples[k], sweep_.samples[k]};
        problem(where, "the traced curves and the exact fibre do not agree here");
        return;
      }
    }
  }

  /// Searches slabs around roots of E over which a further singular point is not excluded.
  void check_multiple_turning_values() {
    for (const TurningValue* turning : undecided_turning_values(sweep_, result_, width_)) {
      search(window_around(sweep_, turning->value),
             "a multiple root of the turning eliminant: a singular or isolated point of the intersection is "
             "not excluded here");
    }
  }

  const PairSystem<Ball>& system_;
  const Landmarks<Ball>& landmarks_;
  const SweepData& sweep_;
  ExactPair& pair_;
  const Rational& width_;
  const StopRequest& stop_;
  std::vector<std::vector<int>> used_;  // directions of T in which a curve leaves each landmark
  TracedCurves<Ball> result_;
};

}  // namespace

template <class Ball>
TracedCurves<Ball> trace_curves(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                                const SweepData& sweep, const Rational& width, const StopRequest& stop) {
  return CurveTracing<Ball>(system, landmarks, sweep, width, stop).run();
}

#define EXSECT_INSTANTIATE_CURVES(Ball)                                                     \
  template TracedCurves<Ball> trace_curves(const PairSystem<Ball>&, const Landmarks<Ball>&, \
                                           const SweepData&, const Rational&, const StopRequest&);

EXSECT_INSTANTIATE_CURVES(DoubleBall)
EXSECT_INSTANTIATE_CURVES(DoubleDoubleBall)
EXSECT_INSTANTIATE_CURVES(ArbBall<256>)
EXSECT_INSTANTIATE_CURVES(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_CURVES

}  // namespace exsect

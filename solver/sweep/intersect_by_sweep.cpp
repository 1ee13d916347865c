#include "sweep/intersect_by_sweep.h"

#include <exsect/solver/line_query.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "answer/left_open.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "answer/proof.h"
#include "filter/contact_regions.h"
#include "line/line_points_in.h"
#include "side/boundary_lines.h"
#include "side/common_pole.h"
#include "star/pinch_points.h"
#include "star/singular_points.h"
#include "sweep/traced_curves.h"
#include "sweep/traced_pair.h"
#include "trace/enclose.h"

namespace exsect {

namespace {

/// Of boxes of landmarks: polylines in doubles do not get better beyond.
Rational vertex_width() { return power_of_two(-200); }
/// Of the box of a place where tracing ended.
const Rational kNextToPole = power_of_two(-16);

class Intersection {
 public:
  Intersection(const BezierPatch& x, const BezierPatch& y, const Run& run, ExactPair& pair)
      : x_(x), y_(y), run_(run), pair_(pair), scaling_(model_scale(x, y)), sweep_{pair} {
    sweep_.settled = [this](const SearchRegion& region) {
      if (!contacts_) contacts_.emplace(x_, y_);
      return contacts_->settles(region);
    };
  }

  IntersectResult run() {
    timed("boundary points", [this] { find_boundary_points(); });
    timed("turning eliminant", [this] { find_turning_values(); });
    timed("fibres", [this] { compute_fibres(); });
    sweep_.quick = true;
    if (!trace_and_build<DoubleBall>(power_of_two(-50), false)) {
      timed("singular points", [this] { find_stars(); });
      const bool again = !sweep_.stars.empty() || cut_short_;
      sweep_.quick = false;
      if ((!again || !trace_and_build<DoubleBall>(power_of_two(-50), false)) &&
          !trace_and_build<DoubleDoubleBall>(power_of_two(-100), false) &&
          !trace_and_build<ArbBall<256>>(vertex_width(), false)) {
        trace_and_build<ArbBall<1024>>(power_of_two(-700), true);
      }
    }
    return *std::move(result_);
  }

 private:
  template <class Step>
  void timed(const char* step, Step&& body) {
    run_.timed(step, std::forward<Step>(body));
  }

  void incomplete(const ParameterBox& where, const std::string& why) { incomplete_.push_back({where, why}); }

  void find_boundary_points() {
    sides_ = boundary_lines(x_, y_, scaling_, side_tolerance(run_.drawn_tolerance(scaling_.extent)), stop_);
    incomplete_ = sides_.incomplete;
    on_side_arc_.assign(sides_.points.size(), false);
    for (const SideArc& arc : sides_.arcs) {
      on_side_arc_[arc.from] = on_side_arc_[arc.to] = true;
    }
    for (const CommonPole& pole : sides_.poles) {
      for (std::size_t i = 0; i < sides_.points.size(); ++i) {
        on_side_arc_[i] = on_side_arc_[i] || is_on(sides_.points[i], pole);
      }
    }
    for (std::size_t i = 0; i < sides_.points.size(); ++i) {
      sweep_.landmarks.push_back({sides_.points[i], std::nullopt, 0, Parameter::u, on_side_arc_[i]});
    }
  }

  void find_turning_values() {
    if (run_.out_of_time()) {
      incomplete_.push_back(
          out_of_time(whole_domain(), "the work cap was reached before closed curves were excluded"));
      return;
    }
    sweep_.turning = pair_.choice().turning;  // without one, closed curves are found by subdivision
  }

  /// Exact fibres at samples between all critical values, where no parameter is
  /// that of a pinch point.
  void compute_fibres() {
    if (!sweep_.turning) {
      return;
    }
    std::vector<CertifiedPoint> avoided = sides_.points;
    avoided.insert(avoided.end(), pinches_.begin(), pinches_.end());
    std::vector<Rational> samples = sweep_samples(*sweep_.turning, avoided);
    if (samples == sweep_.samples) {
      return;
    }
    sweep_.samples = std::move(samples);
    sweep_.fibres.clear();
    for (const Rational& sample : sweep_.samples) {
      if (run_.out_of_time()) {
        incomplete_.push_back(
            out_of_time(whole_domain(), "the work cap was reached while fibres were computed"));
        return;
      }
      const LinePoints& fibre = pair_.fibre({sweep_.turning->sweep, sample});
      ParameterBox where = whole_domain();
      where[index(sweep_.turning->sweep)] = {sample, sample};
      if (fibre.incomplete || !fibre.on_patch.empty()) {
        incomplete(where, fibre.incomplete ? *fibre.incomplete : "a parameter line lies on the other patch");
      }
      sweep_.fibres.push_back(fibre.points);
    }
    run_.count("fibres", static_cast<double>(sweep_.fibres.size()));
  }

  /// Proves neighbourhoods of the singular points; their ports become
  /// landmarks.
  void find_stars() {
    pinches_ = pinch_points(x_, y_);
    if (!pinches_.empty()) {
      compute_fibres();
    }
    const SingularPointQuery query = {
        pair_,
        {sides_.points, sweep_.turning ? sweep_.turning->sweep : Parameter::u, sweep_.samples},
        on_side_arc_,
        pinches_,
        std::ldexp(run_.drawn_tolerance(scaling_.extent), static_cast<int>(-scaling_.frame.exponent))};
    const PairSystem<ArbBall<256>> system(x_, y_, scaling_.origin, scaling_.frame.exponent);
    sweep_.stars = singular_stars(query, system);
    for (std::size_t k = 0; k < sweep_.stars.size(); ++k) {
      const StarNeighbourhood& star = sweep_.stars[k];
      for (LandmarkPoint& landmark : sweep_.landmarks) {
        if (landmark.side == 0 && surely_lies_in(landmark.point, star.box)) {
          landmark.star = k;
        }
      }
      for (const Port& port : star.ports) {
        if (port.point.sides().empty()) {  // else the arc lies on a side
          sweep_.landmarks.push_back({port.point, k, port.side, port.across, false});
        }
      }
    }
  }

  /// All of them end at a common pole, where the tangent of a curve vanishes, in any arithmetic.
  bool are_in_poles(const std::vector<Incomplete>& problems) const {
    const auto is_next_to = [](const ParameterBox& box, const Side& side) {
      const RationalInterval& at = box[index(side.parameter)];
      return at.width() < kNextToPole && (side.value == 0 ? at.lower <= 0 : at.upper >= 1);
    };
    return std::ranges::all_of(problems, [&](const Incomplete& problem) {
      return std::ranges::any_of(sides_.poles, [&](const CommonPole& pole) {
        return is_next_to(problem.where, pole.of_x) && is_next_to(problem.where, pole.of_y);
      });
    });
  }

  /// One attempt in one arithmetic; false if something is undecided that more
  /// precision may decide and `last` is not set.
  template <class Ball>
  bool trace_and_build(const Rational& width, bool last) {
    const PairSystem<Ball> system(x_, y_, scaling_.origin, scaling_.frame.exponent);
    Landmarks<Ball> landmarks;
    for (const LandmarkPoint& landmark : sweep_.landmarks) {
      landmarks.push_back(enclose<Ball>(landmark.point, width));
    }
    TracedCurves<Ball> traced;
    sweep_.exact = incomplete_.empty();
    timed("tracing", [&] { traced = trace_curves(system, landmarks, sweep_, width, stop_); });
    cut_short_ = traced.cut_short;
    // What a search has left open in balls of many bits stays open with more.
    const bool searched_in_vain = traced.searched_boxes > 0 && width <= vertex_width();
    const bool ends_in_poles = width <= vertex_width() && are_in_poles(traced.problems);
    if (!traced.problems.empty() && sweep_.exact && !last && !searched_in_vain && !ends_in_poles) {
      return false;
    }
    const long searched_boxes = traced.searched_boxes;
    const auto known = std::make_shared<const TracedPair<Ball>>(
        TracedPair<Ball>{x_, y_, scaling_, run_.drawn_tolerance(scaling_.extent), sides_, sweep_.landmarks,
                         sweep_.stars, incomplete_, system, std::move(landmarks), std::move(traced)});
    timed("graph",
          [&] { result_ = first_drawn([known](const Run& run) { return drawn(*known, run); }, run_); });
    if (!result_) return false;
    run_.count("searched boxes", static_cast<double>(searched_boxes));
    return true;
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const Run& run_;
  ExactPair& pair_;
  ModelScale scaling_;
  StopRequest stop_ = run_.stop();
  SweepData sweep_;
  BoundaryLines sides_;
  std::optional<ContactRegions> contacts_;  // once asked for
  std::vector<bool> on_side_arc_;           // per point
  std::vector<CertifiedPoint> pinches_;
  std::vector<Incomplete> incomplete_;
  std::optional<IntersectResult> result_;
  bool cut_short_ = false;  // the last attempt's searches were, and something is left
};

}  // namespace

IntersectResult intersect_by_sweep(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                   ExactPair& pair) {
  return Intersection(x, y, run, pair).run();
}

}  // namespace exsect

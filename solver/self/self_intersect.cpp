#include "self/self_intersect.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "answer/finished_result.h"
#include "answer/left_open.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "answer/placed_result.h"
#include "answer/proof.h"
#include "self/curves.h"
#include "self/cut_self_intersection.h"
#include "self/degenerate.h"
#include "self/folds.h"
#include "self/self_intersect_within.h"
#include "self/traced_self.h"
#include "self/turning_pairs.h"
#include "shape/coincident_parameters.h"
#include "trace/turning_points.h"

namespace exsect {

namespace {

class SelfIntersection {
 public:
  SelfIntersection(const BezierPatch& x, const Run& run, const std::vector<PairCut>& cuts)
      : x_(x),
        run_(run),
        cuts_(cuts),
        scaling_(model_scale(x, x)),
        in_doubles_(x, scaling_.origin, scaling_.frame.exponent),
        pairs_(x) {}

  IntersectResult run() {
    find();
    return kept(std::move(known_), run_);
  }

  std::optional<CutSelfIntersection> run_with_cuts() {
    find();
    if (!known_.incomplete.empty() || !known_.collapsed_sides.empty() || places_.size() != cuts_.size())
      return std::nullopt;
    CutSelfIntersection result{drawn_pairs(known_, run_), {}};
    for (const std::vector<CutPlace>& cut : places_) {
      result.cuts.emplace_back();
      for (const CutPlace& place : cut) {
        const int node = node_at(result.graph, place);
        result.cuts.back().push_back({node, place.exchanged});
        if (place.turning.empty()) continue;
        result.graph.add_kind(node, NodeKind::turning);
        result.graph.set_turning(node, place.turning);
      }
    }
    return result;
  }

 private:
  void find() {
    bool injective = false;
    timed("injectivity", [&] { injective = is_quickly_injective(in_doubles_, stop_); });
    if (!injective) {
      find_curves();
    }
    known_.mates = exact_.boundary.mate;
    known_.has_stars = !exact_.stars.empty();
    for (const std::array<int, 2>& side : exact_.injective.along_sides)
      if (is_collapsed_side(x_, static_cast<std::size_t>(side[0]), side[1]))
        known_.collapsed_sides.push_back(side);
  }

  template <class Step>
  void timed(const char* step, Step&& body) {
    run_.timed(step, std::forward<Step>(body));
  }

  void find_curves() {
    if (run_.out_of_time()) {
      known_.incomplete.push_back(out_of_time(whole_domain()));
      return;
    }
    timed("exact places", [this] { find_exact_places(); });
    if (run_.out_of_time()) {
      known_.incomplete.push_back(out_of_time(whole_domain()));
      return;
    }
    if (!exact_.boundary.problems.empty()) {
      known_.incomplete = exact_.boundary.problems;
      return;
    }
    const SelfSystem<ArbBall<256>> in_balls(x_, scaling_.origin, scaling_.frame.exponent);
    for (const SearchEffort effort : {SearchEffort::brief, SearchEffort::whole}) {
      if (trace_and_build(in_doubles_, power_of_two(-50), effort, false)) return;
      if (trace_and_build(in_balls, power_of_two(-200), effort, true)) return;
    }
  }

  /// All of them, or some if the time is over.
  void find_exact_places() {
    exact_.injective = injective_rectangles(x_);
    if (run_.out_of_time()) return;
    exact_.boundary = self_boundary(x_, exact_.injective);
    if (run_.out_of_time()) return;
    exact_.cusps = special_cusps(x_);
    if (run_.out_of_time()) return;
    exact_.folds = multiple_folds(x_, exact_.cusps, exact_.boundary.points);
    exact_.coincident = coincident_parameters(x_, x_);
    exact_.zero_tangent = [this](const CertifiedPoint& point) { return pairs_.zero_at(point); };
    exact_.common_zero = [this](const ParameterBox& where, std::size_t i, std::size_t j) {
      return pairs_.common_zero(where, i, j);
    };
  }

  /// Near what the attempts so far left undecided; false if there are no more than before: those stay, to
  /// whose ports the curves lead.
  bool find_stars() {
    std::vector<SelfStar> stars;
    timed("stars", [&] {
      std::vector<SelfCentre> centres =
          self_star_centres(x_, exact_.boundary.points, undecided_, pairs_.values());
      if (centres_ && have_same_values(*centres_, centres)) return;
      centres_ = std::move(centres);
      const double scaled =
          std::ldexp(run_.drawn_tolerance(scaling_.extent), -static_cast<int>(scaling_.frame.exponent));
      stars = self_stars({x_, exact_.boundary.points, *centres_, pairs_.values(), scaled, stop_});
    });
    if (stars.size() <= exact_.stars.size()) return false;
    exact_.stars = std::move(stars);
    return true;
  }

  static bool have_same_values(const std::vector<SelfCentre>& a, const std::vector<SelfCentre>& b) {
    return std::ranges::equal(a, b, {}, &SelfCentre::value, &SelfCentre::value);
  }

  /// With more stars, or with the effort that is allowed where a brief search left something undecided.
  template <class Ball>
  bool can_try_again(const SelfCurves<Ball>& found, SearchEffort allowed, SearchEffort& effort) {
    const bool stars = find_stars();
    effort = stars ? SearchEffort::brief : allowed;
    return stars || (found.is_cut_short && allowed == SearchEffort::whole);
  }

  /// In one arithmetic, again as long as more stars are found near what is undecided; false if something is
  /// left that more effort may decide, or more precision unless these are the longest numbers.
  template <class Ball>
  bool trace_and_build(const SelfSystem<Ball>& system, const Rational& width, SearchEffort allowed,
                       bool longest) {
    SelfCurves<Ball> found;
    SearchEffort effort = allowed;
    do {
      timed("tracing",
            [&] { found = trace_self_curves(system, in_doubles_.charts, exact_, width, effort, stop_); });
      for (const Incomplete& problem : found.problems) undecided_.push_back(problem.where);
    } while (!found.problems.empty() && !run_.out_of_time() && can_try_again(found, allowed, effort));
    cut_short_ = cut_short_ || found.is_cut_short;
    const bool last = longest && (allowed == SearchEffort::whole || !cut_short_);
    if (found.problems.empty()) {
      if (auto cut = cut_curves(found, exact_, cuts_, width)) {
        places_ = *std::move(cut);
      } else {
        found.problems.push_back({whole_domain(), "a pair where the curves are to be cut is not found"});
      }
    }
    const bool stopped = run_.out_of_time();
    if (!found.problems.empty() && !last && !stopped) return false;
    if (stopped)
      for (Incomplete& problem : found.problems) problem = out_of_time(problem.where);
    known_.incomplete.insert(known_.incomplete.end(), found.problems.begin(), found.problems.end());
    run_.count("searched boxes", static_cast<double>(found.searched_boxes));
    TracedSelf<Ball> traced{x_, scaling_, system, exact_, std::move(found)};
    traced.exact.zero_tangent = {};  // they ask this object
    traced.exact.common_zero = {};
    known_.curves = [all = std::make_shared<const TracedSelf<Ball>>(std::move(traced))](const Run& run) {
      GraphBuilder graph;
      run.timed("graph", [&] { graph = drawn_curves(*all, run); });
      return graph;
    };
    return true;
  }

  /// Landmarks are the first nodes; a star has one for each order of its centre.
  int node_at(const GraphBuilder& graph, const CutPlace& place) const {
    if (!place.star) return static_cast<int>(place.landmark);
    const SelfStar& star = exact_.stars[*place.star];
    if (star.landmark) {
      const std::size_t at = *star.landmark;
      return static_cast<int>(place.landmark == 0 ? at : exact_.boundary.mate[at]);
    }
    const ParameterBox centre = star.star.centre.box();
    const ParameterBox box = place.landmark == 0 ? centre : exchanged_pair(centre);
    return std::ranges::find_if(
               graph.nodes(),
               [&](const Node& node) { return lies_in(node.box, box) && lies_in(box, node.box); })
        ->id;
  }

  const BezierPatch& x_;
  const Run& run_;
  const std::vector<PairCut>& cuts_;
  ModelScale scaling_;
  StopRequest stop_ = run_.stop();
  SelfSystem<DoubleBall> in_doubles_;
  ExactPlaces exact_{};
  std::vector<ParameterBox> undecided_;             // by all attempts
  std::optional<std::vector<SelfCentre>> centres_;  // near these, tried as stars
  TurningPairs pairs_;
  bool cut_short_ = false;                     // a brief search of an attempt
  std::vector<std::vector<CutPlace>> places_;  // of the cuts
  KnownSelf known_{x_, {}, {}, {}, false, {}};
};

}  // namespace

IntersectResult self_intersect(const BezierPatch& x, const IntersectOptions& options) {
  return in_nearest_rounding([&]() -> IntersectResult {
    const Run run(options);
    IntersectResult result = run.finished(answered(run, [&] {
      const auto place = Placement::of(x, x);
      return solved_in_place(place, to_double(model_extent(x, x)), run, [&](const Run& in_place) {
        return self_intersect_within(in_place, place ? place->placed(x) : x);
      });
    }));
    return answer_to(options, std::move(result),
                     [x](const IntersectOptions& other) { return self_intersect(x, other); });
  });
}

IntersectResult self_intersect_within(const Run& run, const BezierPatch& x) {
  auto result = self_intersect_degenerate(x, run);
  return result ? std::move(*result) : SelfIntersection(x, run, {}).run();
}

std::optional<CutSelfIntersection> cut_self_intersection(const BezierPatch& x, const Run& run,
                                                         const std::vector<PairCut>& cuts) {
  if (self_intersect_degenerate(x, run)) return std::nullopt;
  const Run all = run.with_turning({all_parameters.begin(), all_parameters.end()});
  return SelfIntersection(x, all, cuts).run_with_cuts();
}

}  // namespace exsect

#include "overlap/two_piece_curves.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "answer/graph_builder.h"
#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "overlap/pair_map.h"
#include "overlap/two_piece_landmarks.h"
#include "self/near_cusps.h"
#include "self/search.h"
#include "shape/coincident_parameters.h"
#include "trace/landmark_tangent.h"
#include "trace/loop_seeds.h"

namespace exsect {

namespace {

BezierPatch restricted(const BezierPatch& x, const std::array<AffineMap, 2>& to) {
  return x.restricted_to(to[0](0), to[0](1), to[1](0), to[1](1));
}

template <class Ball>
bool certainly_outside(const Ball& c) {
  return c.is_negative() || (c - Ball(1)).is_positive();
}

template <class Ball>
class TwoPieceTracing {
 public:
  TwoPieceTracing(const TwoPieces& pieces, const SelfSystem<Ball>& shared, const PairSystem<Ball>& system,
                  const std::vector<CertifiedPoint>& boundary, const std::vector<CertifiedPoint>& side_ends,
                  const Point& origin, long exponent, const Rational& width, const StopRequest& stop)
      : pieces_(pieces),
        system_(system),
        hull_(restricted(pieces.x, pieces.hull), origin, exponent),
        from_hull_(pieces.copy, pieces.hull),
        coincident_(coincident_parameters(pieces.x, pieces.y)),
        stop_(stop),
        ends_(pieces, shared, system, boundary, side_ends, width, stop, result_) {}

  TwoPieceCurves<Ball> run() {
    ends_.run();
    if (result_.problems.empty()) {
      trace_open_curves();
    }
    if (result_.problems.empty()) {
      search_closed_curves();
    }
    return std::move(result_);
  }

 private:
  void problem(const ParameterBox& where, const std::string& why) {
    result_.problems.push_back(left_open(where, why, stop_));
  }

  void trace_open_curves() {
    std::vector<bool> used(result_.landmarks.size(), false);
    for (std::size_t i = used.size(); i-- > 0;) {  // from gates first
      if (used[i] || ends_.is_side_end(i)) {
        continue;
      }
      const std::optional<int> direction = ends_.direction_at(i);
      if (!direction) {
        problem(around(approximation(result_.landmarks[i])),
                "the curve is tangent to a side of a patch, or singular, at this end point");
      } else if (*direction == 0) {
        result_.isolated.push_back(static_cast<int>(i));
      } else {
        auto outcome = trace_arc(system_, result_.landmarks, static_cast<int>(i), *direction, stop_);
        if (const auto* trace = std::get_if<Trace<Ball>>(&outcome)) {
          used[static_cast<std::size_t>(trace->end)] = true;
        }
        add(std::move(outcome));
      }
    }
  }

  static std::array<double, 4> approximation(const BallPoint<Ball>& p) {
    return {p[0].approximation(), p[1].approximation(), p[2].approximation(), p[3].approximation()};
  }

  TangentSigns signs_at(int landmark) const {
    return landmark < 0 ? TangentSigns{}
                        : tangent_signs(system_, result_.landmarks[static_cast<std::size_t>(landmark)]);
  }

  void add(std::variant<Trace<Ball>, TraceFailure>&& outcome) {
    if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
      problem(around(failure->where), failure->why);
      return;
    }
    AnalysedTrace<Ball> curve{std::get<Trace<Ball>>(std::move(outcome)), {}};
    KnownTangent known = {{}, signs_at(curve.trace.start), signs_at(curve.trace.end), {}};
    const auto line = ends_.along_line(curve.trace);
    if (line) {
      known.constant[line->fixed] = known.constant[line->fixed + 2] = true;
    }
    auto turning = find_turning_points(system_, curve.trace, coincident_, known);
    if (const auto* failure = std::get_if<TraceFailure>(&turning)) {
      problem(around(failure->where), failure->why);
      return;
    }
    curve.turning = std::get<TurningPoints<Ball>>(std::move(turning));
    result_.curves.push_back(std::move(curve));
    result_.along_side.push_back(line && line->on_side);
  }

  void search_closed_curves() {
    for (const ChartSystem<Ball>& chart : hull_.charts) {
      const Chart which = chart.chart();
      const ChartSeedHandler<Ball> known = [this, which](const BallPoint<Ball>& p) {
        return is_known(which, p);
      };
      const ChartSearchOutcome outcome = search_chart<Ball>(chart, KnownPlaces({}), {whole_chart}, {1, 0.375},
                                                            known, kMostChartBoxes<Ball>, stop_);
      result_.searched_boxes += outcome.boxes;
      if (!outcome.undecided.empty()) {
        problem(whole_domain(),
                "a closed curve or a singular point, apart from the common region, is not excluded");
      }
    }
  }

  bool is_known(Chart chart, const BallPoint<Ball>& p) {
    if (p[3].is_negative() || passes_near_cusp(result_.near, chart, in_common(pieces_, chart, p))) {
      return true;
    }
    if (!p[3].is_positive()) {
      return is_near_diagonal_outside(chart, p);
    }
    const BallPoint<Ball> pair = pair_of(chart, p);
    return is_settled(from_hull_(pair)) && is_settled(from_hull_(exchanged_pair(pair)));
  }

  /// No two points U ± t, V ± m t are one in the first piece and one in the second, w = t² >= 0.
  bool is_near_diagonal_outside(Chart chart, const BallPoint<Ball>& p) const {
    const double t = std::sqrt(p[3].upper_magnitude()) * kSlack;
    Ball a = p[0].widened(t);
    Ball b = p[1].widened(t * p[2].upper_magnitude() * kSlack);
    if (chart == Chart::second) {
      std::swap(a, b);
    }
    const BallPoint<Ball> both = from_hull_(BallPoint<Ball>{a, b, a, b});
    return std::any_of(both.begin(), both.end(), [](const Ball& c) { return certainly_outside(c); });
  }

  bool is_settled(const BallPoint<Ball>& pair) {
    return std::any_of(pair.begin(), pair.end(), [](const Ball& c) { return certainly_outside(c); }) ||
           std::any_of(result_.curves.begin(), result_.curves.end(),
                       [&](const AnalysedTrace<Ball>& curve) { return passes_through(curve.trace, pair); }) ||
           seeds_.trace(system_, result_.landmarks, pair, stop_, [this](auto outcome) {
             const std::size_t before = result_.problems.size();
             add(std::move(outcome));
             return result_.problems.size() == before;
           });
  }

  const TwoPieces& pieces_;
  const PairSystem<Ball>& system_;
  SelfSystem<Ball> hull_;
  PairMap from_hull_;
  std::array<std::size_t, 4> coincident_;
  const StopRequest& stop_;
  LoopSeeds<Ball> seeds_;
  TwoPieceCurves<Ball> result_;
  TwoPieceLandmarks<Ball> ends_;  // of the curves
};

}  // namespace

BezierPatch TwoPieces::shared() const { return restricted(x, common); }

std::optional<TwoPieces> two_pieces(const BezierPatch& x, const BezierPatch& y) {
  const auto copy = shifted_copy(x, y);
  if (!copy) {
    return std::nullopt;
  }
  TwoPieces result{x, y, *copy, {}, {}, true};
  for (std::size_t j = 0; j < 2; ++j) {
    const Rational a = std::min<Rational>(copy->maps[j](0), copy->maps[j](1));
    const Rational b = std::max<Rational>(copy->maps[j](0), copy->maps[j](1));
    const Rational lower = std::max<Rational>(a, 0);
    const Rational upper = std::min<Rational>(b, 1);
    result.overlapping = result.overlapping && lower < upper;
    result.common[j] = {lower, upper - lower};
    result.hull[j] = {std::min<Rational>(a, 0), std::max<Rational>(b, 1) - std::min<Rational>(a, 0)};
  }
  return result;
}

template <class Ball>
BallPoint<Ball> in_common(const TwoPieces& pieces, Chart chart, const BallPoint<Ball>& p) {
  const std::size_t own = chart == Chart::first ? 0 : 1;
  const AffineMap a = quotient(pieces.common[own], pieces.hull[own]);
  const AffineMap b = quotient(pieces.common[1 - own], pieces.hull[1 - own]);
  return {Ball::enclosing(a.offset) + Ball::enclosing(a.factor) * p[0],
          Ball::enclosing(b.offset) + Ball::enclosing(b.factor) * p[1],
          Ball::enclosing(b.factor / a.factor) * p[2], Ball::enclosing(a.factor * a.factor) * p[3]};
}

template <class Ball>
TwoPieceCurves<Ball> trace_two_pieces(const TwoPieces& pieces, const SelfSystem<Ball>& shared,
                                      const PairSystem<Ball>& system,
                                      const std::vector<CertifiedPoint>& boundary,
                                      const std::vector<CertifiedPoint>& side_ends, const Point& origin,
                                      long exponent, const Rational& width, const StopRequest& stop) {
  return TwoPieceTracing<Ball>(pieces, shared, system, boundary, side_ends, origin, exponent, width, stop)
      .run();
}

#define EXSECT_INSTANTIATE_TWO_PIECES(Ball)                                                       \
  template BallPoint<Ball> in_common(const TwoPieces&, Chart, const BallPoint<Ball>&);            \
  template TwoPieceCurves<Ball> trace_two_pieces(                                                 \
      const TwoPieces&, const SelfSystem<Ball>&, const PairSystem<Ball>&,                         \
      const std::vector<CertifiedPoint>&, const std::vector<CertifiedPoint>&, const Point&, long, \
      const Rational&, const StopRequest&);

EXSECT_INSTANTIATE_TWO_PIECES(DoubleBall)
EXSECT_INSTANTIATE_TWO_PIECES(ArbBall<256>)
#undef EXSECT_INSTANTIATE_TWO_PIECES

}  // namespace exsect

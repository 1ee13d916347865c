#include "two_piece_curves.h"

#include <algorithm>
#include <cmath>

#include "landmark_tangent.h"
#include "loop_seeds.h"
#include "pair_map.h"
#include "self_search.h"
#include "traced_curves.h"

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
                  const std::vector<CertifiedPoint>& boundary, const Point& origin, long exponent,
                  const Rational& width, const StopRequest& stop)
      : pieces_(pieces),
        shared_(shared),
        system_(system),
        boundary_(boundary),
        hull_(restricted(pieces.x, pieces.hull), origin, exponent),
        from_common_(pieces.copy, pieces.common),
        from_hull_(pieces.copy, pieces.hull),
        coincident_(coincident_parameters(pieces.x, pieces.y)),
        width_(width),
        stop_(stop) {}

  TwoPieceCurves<Ball> run() {
    find_cusps();
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
    result_.problems.push_back({where, is_stopped(stop_) ? "the work cap was reached" : why});
  }

  void find_cusps() {
    const BezierPatch patch = pieces_.shared();
    ExactPlaces exact{};
    exact.cusps = special_cusps(patch);
    exact.coincident = coincident_parameters(patch, patch);
    result_.near = trace_near_cusps(shared_, exact, width_, stop_);
    for (const Incomplete& near : result_.near.problems) {
      ParameterBox where;
      for (std::size_t j = 0; j < 4; ++j) {
        where[j] = from_common_(near.where[j], j);
      }
      problem(where, near.why);
    }
    for (const CuspArc<Ball>& cusp : result_.near.leaving) {
      if (enters(cusp, 1) || enters(cusp, -1)) {
        std::array<double, 4> at = {cusp.cusp[0].approximation(), cusp.cusp[1].approximation(), 0, 0};
        if (cusp.chart == Chart::second) {
          std::swap(at[0], at[1]);
        }
        problem(around(from_common_({at[0], at[1], at[0], at[1]})), "a cuspidal point on a side");
      }
    }
    for (const CertifiedPoint& point : boundary_) {
      result_.landmarks.push_back(enclose<Ball>(point, width_));
    }
    for (const BallPoint<Ball>& gate : result_.near.landmarks) {
      result_.landmarks.push_back(from_common_(gate));
    }
  }

  /// The curve from a cuspidal point on a side of the common rectangle may enter the domain with order * (t,
  /// m t) added in the first piece and taken away in the second one.
  bool enters(const CuspArc<Ball>& cusp, int order) const {
    for (std::size_t j = 0; j < 2; ++j) {
      const std::size_t k = cusp.chart == Chart::first ? j : 1 - j;  // u or v
      if (cusp.across[j] == 0) {
        continue;
      }
      const int side = *cusp.place.side[j];
      const int outward = side == 0 ? -1 : 1;
      const Rational value = pieces_.common[k](side);
      const Rational in_second = quotient(pieces_.copy.maps[k], {value, 1}).offset;
      const bool of_first = value == 0 || value == 1;
      const bool of_second = in_second == 0 || in_second == 1;
      if ((of_first && order * cusp.across[j] == outward) ||
          (of_second && -order * cusp.across[j] == outward)) {
        return false;
      }
    }
    return true;
  }

  /// The direction of the tangent field that enters the domain at a boundary point, or leads away from the
  /// cuspidal point at a gate; 0: none; empty: unknown.
  std::optional<int> direction_at(std::size_t landmark) const {
    const BallPoint<Ball> tangent = Expansion<Ball>(system_, result_.landmarks[landmark]).tangent();
    if (landmark >= boundary_.size()) {
      const auto gate = result_.near.gate(static_cast<int>(landmark - boundary_.size()));
      const ChartTrace<Ball>& trace = result_.near.chart_traces[gate->trace];
      for (std::size_t j = 0; j < 2; ++j) {  // u and v grow with the parameters of the charts
        const int along = trace.direction[gate->exchanged ? j + 2 : j];
        if (along != 0 && tangent[j].certain_sign() != 0) {
          return along * tangent[j].certain_sign();
        }
      }
      return std::nullopt;
    }
    int direction = 0;
    bool entering = true;
    for (const Side& side : boundary_[landmark].sides()) {
      const int sign = tangent[index(side.parameter)].certain_sign();
      if (sign == 0) {
        return std::nullopt;
      }
      const int inward = side.value == 0 ? sign : -sign;
      entering = entering && (direction == 0 || direction == inward);
      direction = inward;
    }
    return entering ? direction : 0;
  }

  void trace_open_curves() {
    std::vector<bool> used(result_.landmarks.size(), false);
    for (std::size_t i = used.size(); i-- > 0;) {  // from gates first
      if (used[i]) {
        continue;
      }
      const std::optional<int> direction = direction_at(i);
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

  void add(std::variant<Trace<Ball>, TraceFailure> outcome) {
    if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
      problem(around(failure->where), failure->why);
      return;
    }
    AnalysedTrace<Ball> curve{std::get<Trace<Ball>>(std::move(outcome)), {}};
    const KnownTangent known = {{}, signs_at(curve.trace.start), signs_at(curve.trace.end), {}};
    auto turning = find_turning_points(system_, curve.trace, coincident_, known);
    if (const auto* failure = std::get_if<TraceFailure>(&turning)) {
      problem(around(failure->where), failure->why);
      return;
    }
    curve.turning = std::get<std::vector<TurningPoint<Ball>>>(std::move(turning));
    result_.curves.push_back(std::move(curve));
  }

  void search_closed_curves() {
    for (const ChartSystem<Ball>& chart : hull_.charts) {
      const Chart which = chart.chart();
      const ChartSeedHandler<Ball> known = [this, which](const BallPoint<Ball>& p) {
        return is_known(which, p);
      };
      const ChartSearchOutcome outcome =
          search_chart<Ball>(chart, KnownPlaces({}), {1, 0.375}, known, kMostChartBoxes<Ball>, stop_);
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
    const double t = std::sqrt(p[3].upper_magnitude()) * (1 + 0x1p-40);
    Ball a = p[0].widened(t);
    Ball b = p[1].widened(t * p[2].upper_magnitude() * (1 + 0x1p-40));
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
  const SelfSystem<Ball>& shared_;
  const PairSystem<Ball>& system_;
  const std::vector<CertifiedPoint>& boundary_;
  SelfSystem<Ball> hull_;
  PairMap from_common_;
  PairMap from_hull_;
  std::array<std::size_t, 4> coincident_;
  const Rational& width_;
  const StopRequest& stop_;
  LoopSeeds<Ball> seeds_;
  TwoPieceCurves<Ball> result_;
};

}  // namespace

BezierPatch TwoPieces::shared() const { return restricted(x, common); }

std::optional<TwoPieces> two_pieces(const BezierPatch& x, const BezierPatch& y) {
  const auto copy = shifted_copy(x, y);
  if (!copy) {
    return std::nullopt;
  }
  TwoPieces result{x, y, *copy, {}, {}};
  for (std::size_t j = 0; j < 2; ++j) {
    const Rational a = std::min<Rational>(copy->maps[j](0), copy->maps[j](1));
    const Rational b = std::max<Rational>(copy->maps[j](0), copy->maps[j](1));
    const Rational lower = std::max<Rational>(a, 0);
    const Rational upper = std::min<Rational>(b, 1);
    if (lower >= upper) {
      return std::nullopt;
    }
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
                                      const std::vector<CertifiedPoint>& boundary, const Point& origin,
                                      long exponent, const Rational& width, const StopRequest& stop) {
  return TwoPieceTracing<Ball>(pieces, shared, system, boundary, origin, exponent, width, stop).run();
}

#define EXSECT_INSTANTIATE_TWO_PIECES(Ball)                                            \
  template BallPoint<Ball> in_common(const TwoPieces&, Chart, const BallPoint<Ball>&); \
  template TwoPieceCurves<Ball> trace_two_pieces(                                      \
      const TwoPieces&, const SelfSystem<Ball>&, const PairSystem<Ball>&,              \
      const std::vector<CertifiedPoint>&, const Point&, long, const Rational&, const StopRequest&);

EXSECT_INSTANTIATE_TWO_PIECES(DoubleBall)
EXSECT_INSTANTIATE_TWO_PIECES(ArbBall<256>)
#undef EXSECT_INSTANTIATE_TWO_PIECES

}  // namespace exsect

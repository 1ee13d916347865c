#include "self/cuts.h"

#include <algorithm>
#include <utility>

#include "answer/parameter_box.h"
#include "trace/enclose.h"
#include "trace/tube_points.h"

namespace exsect {
namespace {

Rational finest() { return power_of_two(-400); }

template <class Ball>
bool meet(const BallPoint<Ball>& a, const BallPoint<Ball>& b) {
  for (std::size_t j = 0; j < 4; ++j)
    if ((a[j] - b[j]).certain_sign() != 0) return false;
  return true;
}

/// The point, known to be on the curve, if it is on the trace.
template <class Pieces, class PointOn>
std::optional<TraceCut> place_on(const Pieces& pieces, int landmark, const PointOn& point_on) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& piece = pieces[i];
    const auto point = point_on(piece);
    if (!point || !contains(piece.tube, *point)) continue;
    const auto tau = offset(piece.tube, *point);
    using Ball = std::decay_t<decltype(tau)>;
    if ((tau - Ball(piece.range.least())).is_negative() || (Ball(piece.range.greatest()) - tau).is_negative())
      continue;
    const double middle = piece.range.clamped(tau.approximation());
    return TraceCut{landmark, i, middle, (tau - Ball(middle)).upper_magnitude()};
  }
  return std::nullopt;
}

/// In the chart, whichever order; empty if it may be on the diagonal.
template <class Ball>
std::optional<BallPoint<Ball>> in_chart(Chart chart, const BallPoint<Ball>& pair) {
  const std::size_t own = chart == Chart::first ? 0 : 1;
  const Ball t = Ball(0.5) * (pair[own] - pair[own + 2]);
  if (t.certain_sign() == 0) return std::nullopt;
  const Ball half = Ball(0.5) * (pair[1 - own] - pair[3 - own]);
  return BallPoint<Ball>{Ball(0.5) * (pair[own] + pair[own + 2]), Ball(0.5) * (pair[1 - own] + pair[3 - own]),
                         half * reciprocal(t), t * t};
}

template <class Ball>
class Cutting {
 public:
  Cutting(SelfCurves<Ball>& found, const ExactPlaces& exact, const std::vector<PairCut>& cuts,
          const Rational& width)
      : found_(found), exact_(exact), cuts_(cuts), width_(width), first_(found.landmarks.size()) {}

  std::optional<std::vector<std::vector<CutPlace>>> run() {
    for (std::size_t k = 0; k < cuts_.size(); ++k) {
      const std::vector<CutPlace> places = places_of(k);
      if (places.empty()) return std::nullopt;
      result_.push_back(places);
    }
    return std::move(result_);
  }

 private:
  std::vector<CutPlace> places_of(std::size_t k) {
    if (!cuts_[k].at.sides().empty()) {
      const auto places = at_boundary_point(cuts_[k].at);
      if (!places || !places->empty()) return places.value_or(std::vector<CutPlace>{});
    }
    if (const auto star = star_around(cuts_[k].at)) {
      const auto order = is_centre(exact_.stars[*star].star, cuts_[k].at);
      if (!order) return {};
      return {{star, 0, *order, {}}, {star, 1, !*order, {}}};
    }
    const auto& twin = cuts_[k].exchanged;
    if (twin && *twin < k) {
      std::vector<CutPlace> places = result_[*twin];
      for (CutPlace& place : places) place.exchanged = !place.exchanged;
      return places;
    }
    for (const bool exchanged : {false, true}) {
      const BallPoint<Ball> at = enclose<Ball>(cuts_[k].at, width_);
      if (const auto place = on_traces(k, exchanged ? exchanged_pair(at) : at, exchanged)) return {*place};
    }
    return {};
  }

  /// None if it is no boundary point, but on a line along a side; empty if it may be on a glued arc.
  std::optional<std::vector<CutPlace>> at_boundary_point(const CertifiedPoint& cut) const {
    for (const GluedArc& arc : exact_.boundary.arcs)
      if (lies_on_all(cut, arc.on, 0) || lies_on_all(cut, arc.on, 2)) return std::nullopt;
    for (Rational width = width_; width >= finest(); width *= width) {
      std::vector<std::size_t> near;
      for (std::size_t i = 0; i < exact_.boundary.points.size(); ++i)
        if (exsect::meet(exact_.boundary.points[i].refined_to(width).box(), cut.refined_to(width).box()))
          near.push_back(i);
      if (near.empty()) return std::vector<CutPlace>{};
      if (near.size() == 1)
        return std::vector<CutPlace>{{{}, near.front(), false, {}},
                                     {{}, exact_.boundary.mate[near.front()], true, {}}};
    }
    return std::nullopt;
  }

  static bool lies_on_all(const CertifiedPoint& point, const std::vector<Side>& sides, std::size_t shift) {
    return std::ranges::all_of(sides, [&](const Side& side) {
      return point.on({static_cast<Parameter>((index(side.parameter) + shift) % 4), side.value});
    });
  }

  std::optional<std::size_t> star_around(const CertifiedPoint& cut) const {
    const ParameterBox box = cut.refined_to(width_).box();
    for (std::size_t k = 0; k < exact_.stars.size(); ++k)
      if (exsect::meet(box, exact_.stars[k].star.box) ||
          exsect::meet(exchanged_pair(box), exact_.stars[k].star.box))
        return k;
    return std::nullopt;
  }

  /// Whether the cut, or the cut exchanged (true), is the centre of the star: it has the centre's value of
  /// the sweep parameter, or of one that no port has, so that it is constant on no arc. Empty if that is not
  /// known.
  std::optional<bool> is_centre(const StarNeighbourhood& star, const CertifiedPoint& cut) const {
    const CertifiedPoint fine = cut.refined_to(finest());
    const ParameterBox centre = star.centre.refined_to(finest()).box();
    for (const bool exchanged : {false, true}) {
      const ParameterBox at = exchanged ? exchanged_pair(fine.box()) : fine.box();
      if (!lies_in(at, star.box)) continue;
      for (const Parameter p : all_parameters) {
        const RationalInterval& value = centre[index(p)];
        const bool same =
            value.width() == 0 && at[index(p)].width() == 0 && value.lower == at[index(p)].lower;
        const bool on_arc = std::ranges::any_of(star.ports, [&](const Port& port) {
          const RationalInterval range = port.point.refined_to(finest()).box()[index(p)];
          return range.lower <= value.lower && value.lower <= range.upper;
        });
        if (same && (p == star.sweep || !on_arc)) return exchanged;
      }
    }
    return std::nullopt;
  }

  std::optional<CutPlace> on_traces(std::size_t k, const BallPoint<Ball>& at, bool exchanged) {
    const int landmark = static_cast<int>(found_.landmarks.size());
    for (SelfCurve<Ball>& curve : found_.curves) {
      const auto cut = place_on(curve.analysed.trace.pieces, landmark,
                                [&](const Piece<Ball>&) { return std::optional(at); });
      if (!cut) continue;
      const auto meets = [&](const TurningPoint<Ball>& turning) { return meet(turning.box, at); };
      const auto turning = drop_turning_at(k, exchanged, false, curve.analysed.turning, meets);
      return turning ? add_to(*cut, curve.analysed.cuts, at, exchanged, *turning) : std::nullopt;
    }
    for (std::size_t i = 0; i < found_.chart_traces.size(); ++i) {
      ChartTrace<Ball>& trace = found_.chart_traces[i];
      const auto cut = place_on(trace.pieces, landmark,
                                [&](const ChartPiece<Ball>& piece) { return in_chart(piece.chart, at); });
      if (!cut || !has_order(trace.pieces[cut->piece], is_exchanged(i) ? exchanged_pair(at) : at)) continue;
      const auto meets = [&](const TurningPoint<Ball>& turning) {
        const auto here = in_chart(trace.pieces[turning.piece].chart, at);
        return !here || meet(turning.box, *here);
      };
      const auto turning = drop_turning_at(k, exchanged, is_exchanged(i), trace.turning, meets);
      return turning ? add_to(*cut, trace.cuts, at, exchanged, *turning) : std::nullopt;
    }
    return std::nullopt;
  }

  /// Outside of the turning points' brackets T_i does not vanish: a zero of T_i near one bracket is in it.
  /// Returns the parameters that turn in the cut; empty if the cut may be another point than a turning point
  /// near it. `exchanged`: the pair with respect to the cut; `reversed`: the trace with respect to the pair.
  template <class Meets>
  std::optional<std::vector<Parameter>> drop_turning_at(std::size_t k, bool exchanged, bool reversed,
                                                        TurningPoints<Ball>& turning, const Meets& meets) {
    std::vector<Parameter> turns;
    if (std::ranges::none_of(turning, meets)) return turns;
    const std::array<bool, 4> zero = cuts_[k].zero_tangent();
    for (const TurningPoint<Ball>& point : turning) {
      if (!meets(point)) continue;
      for (const std::size_t j : point.parameters) {
        const std::size_t p = reversed ? (j + 2) % 4 : j;
        const bool seen = std::ranges::count(turns, static_cast<Parameter>(p)) > 0;
        if (seen || !zero[exchanged ? (p + 2) % 4 : p]) return std::nullopt;
        turns.push_back(static_cast<Parameter>(p));
      }
    }
    std::erase_if(turning, meets);
    std::ranges::sort(turns);
    return turns;
  }

  std::optional<CutPlace> add_to(const TraceCut& cut, std::vector<TraceCut>& cuts, const BallPoint<Ball>& at,
                                 bool exchanged, const std::vector<Parameter>& turning) {
    for (std::size_t i = first_; i < found_.landmarks.size(); ++i)
      if (meet(found_.landmarks[i], at)) return std::nullopt;
    cuts.push_back(cut);
    found_.landmarks.push_back(at);
    return CutPlace{{}, static_cast<std::size_t>(cut.landmark), exchanged, turning};
  }

  /// In the arcs of the graph, the trace in the charts has the other order than its pieces.
  bool is_exchanged(std::size_t trace) const {
    return std::ranges::any_of(found_.curves, [&](const SelfCurve<Ball>& curve) {
      return std::ranges::any_of(std::array{curve.analysed.trace.start, curve.analysed.trace.end},
                                 [&](int end) {
                                   const auto gate = found_.gate(end);
                                   return gate && gate->trace == trace && gate->exchanged;
                                 });
    });
  }

  static bool has_order(const ChartPiece<Ball>& piece, const BallPoint<Ball>& pair) {
    const std::size_t own = piece.chart == Chart::first ? 0 : 1;
    return (pair[own] - pair[own + 2]).is_positive() != piece.exchanged;
  }

  SelfCurves<Ball>& found_;
  const ExactPlaces& exact_;
  const std::vector<PairCut>& cuts_;
  const Rational& width_;
  std::size_t first_;  // of the landmarks of cuts
  std::vector<std::vector<CutPlace>> result_;
};

}  // namespace

template <class Ball>
std::optional<std::vector<std::vector<CutPlace>>> cut_curves(SelfCurves<Ball>& found,
                                                             const ExactPlaces& exact,
                                                             const std::vector<PairCut>& cuts,
                                                             const Rational& width) {
  return Cutting<Ball>(found, exact, cuts, width).run();
}

#define EXSECT_INSTANTIATE_SELF_CUTS(Ball)                               \
  template std::optional<std::vector<std::vector<CutPlace>>> cut_curves( \
      SelfCurves<Ball>&, const ExactPlaces&, const std::vector<PairCut>&, const Rational&);

EXSECT_INSTANTIATE_SELF_CUTS(DoubleBall)
EXSECT_INSTANTIATE_SELF_CUTS(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SELF_CUTS

}  // namespace exsect

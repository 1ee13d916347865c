#include "sweep/multiple_turning_values.h"

#include <algorithm>

#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "eliminant/algebraic_fibre.h"
#include "line/known_tangent.h"
#include "line/line_place.h"
#include "side/line_arcs.h"
#include "sweep/constant_parameter.h"
#include "trace/enclose.h"

namespace exsect {

namespace {

/// Of polylines that nobody sees, relative to the model.
constexpr double kCoarse = 0x1p-7;

template <class Ball>
class MultipleTurningValues {
 public:
  MultipleTurningValues(const SweepData& sweep, const TracedCurves<Ball>& traced, const Rational& width)
      : sweep_(sweep), traced_(traced), width_(width) {}

  std::vector<const TurningValue*> undecided() const {
    std::vector<const TurningValue*> result;
    for (const TurningValue& turning : sweep_.turning->values) {
      if (turning.multiplicity != 1 && !is_used_up(turning) && !multiple_points_are_known(turning)) {
        result.push_back(&turning);
      }
    }
    return result;
  }

 private:
  /// The known points over the value take up all of its multiplicity. A point of a line that lies on the
  /// other patch may take up less than is counted here, so that the fibre has to be finite.
  bool is_used_up(const TurningValue& turning) const {
    const int m = turning.multiplicity;
    return m > 1 && regular_turning_points(turning) + 2 * singular_stars(turning) >= m &&
           !may_have_infinite_fibre(sweep_.pair.x(), sweep_.pair.y(), sweep_.turning->sweep, turning.value);
  }

  /// All points of the fibre over a rational value are on traced curves or in stars.
  bool multiple_points_are_known(const TurningValue& turning) const {
    if (!turning.value.is_rational()) {
      return false;
    }
    const LineQuery query = {sweep_.turning->sweep, turning.value.rational()};
    const LinePoints& fibre = sweep_.pair.fibre(query);
    return !fibre.incomplete &&
           std::all_of(fibre.on_patch.begin(), fibre.on_patch.end(),
                       [&](const AlgebraicInterval& part) { return is_traced(query, part); }) &&
           std::all_of(fibre.points.begin(), fibre.points.end(), [this](const CertifiedPoint& point) {
             const BallPoint<Ball> box = enclose<Ball>(point, width_);
             return point.multiplicity() == 1 || in_star(sweep_, point) || curves_through(traced_, box) > 0 ||
                    contacts_through(traced_, box) > 0;
           });
  }

  /// All of an interval in which the line lies on the other patch is on traced curves and in stars: its
  /// points are, between any two neighbouring places where a curve may end.
  bool is_traced(const LineQuery& query, const AlgebraicInterval& part) const {
    if (query.value == 0 || query.value == 1) {
      return true;  // known as arcs on a side
    }
    const Parameter along = line_place(query).roles.line;
    if (part.from == part.to) {
      return collapsed_lines_are_sides(query, part.from);
    }
    std::vector<RationalInterval> ends = {part.from.refined_to(power_of_two(-60)).interval(),
                                          part.to.refined_to(power_of_two(-60)).interval()};
    const auto add = [&](const ParameterBox& box) {
      const RationalInterval& at = box[index(query.fixed)];
      if (at.lower <= query.value && query.value <= at.upper) {
        ends.push_back(box[index(along)]);
      }
    };
    for (const LandmarkPoint& landmark : sweep_.landmarks) {
      add(landmark.point.box());
    }
    for (const StarNeighbourhood& star : sweep_.stars) {
      add(star.box);
    }
    std::sort(ends.begin(), ends.end(),
              [](const RationalInterval& a, const RationalInterval& b) { return a.lower < b.lower; });
    Rational covered = ends.front().upper;
    for (const RationalInterval& end : ends) {
      if (covered < end.lower && part.from.compare(covered) < 0 && part.to.compare(end.lower) > 0 &&
          !are_on_curves({along, (covered + end.lower) / 2}, query)) {
        return false;
      }
      covered = std::max(covered, end.upper);
    }
    return true;
  }

  /// All lines of the other patch that are one point of this line, at this value along it, are sides of the
  /// square; false: or not known.
  bool collapsed_lines_are_sides(const LineQuery& query, const RealAlgebraic& at) const {
    const BezierPatch& x = sweep_.pair.x();
    const BezierPatch& y = sweep_.pair.y();
    const ModelScale scale = model_scale(x, y);
    const LineArcs arcs = line_arcs(x, y, query, scale, kCoarse * scale.extent, sweep_.pair.stop(), false);
    return !arcs.incomplete && std::ranges::all_of(arcs.collapsed, [&](const CollapsedLine& other) {
      return !(other.t == at) || other.value.compare(0) == 0 || other.value.compare(1) == 0;
    });
  }

  /// The points of `line` across the line `across`, of which there is one, are on traced curves: all of them,
  /// as the other patch may cover the line more than once.
  bool are_on_curves(const LineQuery& across, const LineQuery& line) const {
    const auto points = points_with_value(sweep_, across, line.fixed, line.value);
    return points && !points->empty() && std::ranges::all_of(*points, [&](const CertifiedPoint* point) {
             const BallPoint<Ball> box = enclose<Ball>(*point, width_);
             return curves_through(traced_, box) > 0 || contacts_through(traced_, box) > 0;
           });
  }

  int regular_turning_points(const TurningValue& turning) const {
    const std::size_t sweep = index(sweep_.turning->sweep);
    int count = 0;
    for (const AnalysedTrace<Ball>& curve : traced_.curves) {
      for (const TurningPoint<Ball>& point : curve.turning) {
        count += turns_in(point, sweep) && lies_over_only(turning, point.box[sweep].interval()) ? 1 : 0;
      }
    }
    return count;
  }

  /// Stars around singular points over the value. One from which a curve leaves along which the patches do
  /// not touch: the others have no part in the multiplicity.
  int singular_stars(const TurningValue& turning) const {
    return static_cast<int>(
        std::count_if(sweep_.stars.begin(), sweep_.stars.end(), [&](const StarNeighbourhood& star) {
          return lies_over_only(turning, star.centre) && is_singular_star(star) &&
                 (!sweep_.turning->touching ||
                  std::any_of(star.ports.begin(), star.ports.end(),
                              [](const Port& port) { return port.point.multiplicity() == 1; }));
        }));
  }

  bool is_singular_star(const StarNeighbourhood& star) const {
    const std::array<bool, 4> zero = is_singular(star)
                                         ? std::array<bool, 4>{}
                                         : known_zero_tangent(sweep_.pair.x(), sweep_.pair.y(), star.centre);
    return is_singular(star) || std::count(zero.begin(), zero.end(), true) == 4;
  }

  /// True if the point, over some turning value, can lie over no other one than this.
  bool lies_over_only(const TurningValue& turning, const CertifiedPoint& point) const {
    const std::size_t sweep = index(sweep_.turning->sweep);
    for (Rational width = power_of_two(-100); width > power_of_two(-2000); width *= width) {
      const RationalInterval at = point.refined_to(width).box()[sweep];
      if (lies_over_only(turning, at)) {
        return true;
      }
      if (turning.value.compare(at.lower) < 0 || turning.value.compare(at.upper) > 0) {
        return false;
      }
    }
    return false;
  }

  /// True if `at`, which holds some turning value, can hold no other one than this.
  bool lies_over_only(const TurningValue& turning, const RationalInterval& at) const {
    const auto& all = sweep_.turning->values;
    return std::all_of(all.begin(), all.end(), [&](const TurningValue& other) {
      const bool meets = other.value.compare(at.lower) >= 0 && other.value.compare(at.upper) <= 0;
      return meets == (&other == &turning);
    });
  }

  const SweepData& sweep_;
  const TracedCurves<Ball>& traced_;
  const Rational& width_;
};

}  // namespace

template <class Ball>
std::vector<const TurningValue*> undecided_turning_values(const SweepData& sweep,
                                                          const TracedCurves<Ball>& traced,
                                                          const Rational& width) {
  return MultipleTurningValues<Ball>(sweep, traced, width).undecided();
}

#define EXSECT_INSTANTIATE_VALUES(Ball)                               \
  template std::vector<const TurningValue*> undecided_turning_values( \
      const SweepData&, const TracedCurves<Ball>&, const Rational&);

EXSECT_INSTANTIATE_VALUES(DoubleBall)
EXSECT_INSTANTIATE_VALUES(DoubleDoubleBall)
EXSECT_INSTANTIATE_VALUES(ArbBall<256>)
EXSECT_INSTANTIATE_VALUES(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_VALUES

}  // namespace exsect

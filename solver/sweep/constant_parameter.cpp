#include "sweep/constant_parameter.h"

#include <algorithm>

#include "answer/exact_source.h"
#include "line/line_place.h"
#include "trace/enclose.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

/// More than a fibre has isolated points.
constexpr int kMostIsolated = 16;
/// Rational values with denominators of up to about half as many bits are recognised.
constexpr int kRationalBits = 300;

template <class Ball>
BallPoint<Ball> point_of(const PairSystem<Ball>& system, const TangentialPiece<Ball>& piece, double tau) {
  return point_at(system, piece.tube, tau);
}
template <class Ball>
BallPoint<Ball> point_of(const PairSystem<Ball>&, const Piece<Ball>& piece, double tau) {
  return point_at(piece.tube, tau);
}
template <class Ball, class AnyPiece>
BallPoint<Ball> middle_of(const PairSystem<Ball>& system, const AnyPiece& piece) {
  return point_of(system, piece, piece.range.at(0.5));
}

template <class Ball, class Curve>
class ConstantParameter {
 public:
  ConstantParameter(const PairSystem<Ball>& system, const SweepData& sweep, const Curve& curve, Parameter p,
                    const Rational& width)
      : system_(system),
        sweep_(sweep),
        curve_(curve),
        p_(p),
        along_(static_cast<Parameter>(index(p) ^ 1U)),
        width_(width),
        near_(middle_of(system, curve.pieces[curve.pieces.size() / 2])[index(p)].interval()) {}

  bool run() const {
    const bool known = near_.lower == near_.upper;
    return has_rational_value(known ? near_.lower : simplest_between(near_.lower, near_.upper)) ||
           has_turning_value();
  }

 private:
  /// It has a point on an arc in which a line p = c lies on the other patch. Both are analytic, and the curve
  /// is regular there, so they coincide.
  bool has_rational_value(const Rational& value) const {
    if (value < 0 || value > 1) {
      return false;
    }
    const LinePoints& line = sweep_.pair.fibre({p_, value});
    const auto lies_on_line = [&](const Rational& at) {
      return std::any_of(line.on_patch.begin(), line.on_patch.end(),
                         [&](const AlgebraicInterval& part) {
                           return part.from.compare(at) < 0 && part.to.compare(at) > 0;
                         }) &&
             meets_line<Ball>(sweep_, curve_, {along_, at}, p_, value, width_);
    };
    return std::any_of(curve_.pieces.begin(), curve_.pieces.end(), [&](const auto& piece) {
      return lies_on_line(middle_of(system_, piece)[index(along_)].midpoint().interval().lower);
    });
  }

  /// It has a multiple root of E, rational or not, as its value.
  bool has_turning_value() const {
    const auto& turning = sweep_.pair.turning(p_);
    return turning && std::any_of(turning->values.begin(), turning->values.end(), [&](const TurningValue& v) {
             const RationalInterval at = v.value.interval();
             if (v.multiplicity == 1 || at.upper < near_.lower || near_.upper < at.lower) {
               return false;
             }
             const std::optional<Rational> rational = as_rational(v.value);
             return rational ? has_rational_value(*rational) : has_value(v.value);
           });
  }

  /// A rational number with too long a denominator is treated like an irrational one.
  static std::optional<Rational> as_rational(const RealAlgebraic& value) {
    const RationalInterval at = value.refined_to(power_of_two(-kRationalBits)).interval();
    if (at.lower == at.upper) {
      return at.lower;
    }
    const Rational simplest = simplest_between(at.lower, at.upper);
    return value.compare(simplest) == 0 ? std::optional(simplest) : std::nullopt;
  }

  /// It takes the value α in more points than a fibre has isolated ones: in one of them it is the only curve,
  /// and the fibre over α contains one there.
  bool has_value(const RealAlgebraic& value) const {
    RationalInterval widest{0, 0};
    for (const auto& piece : curve_.pieces) {
      const RationalInterval range = between_ends(piece);
      if (range.lower < range.upper && range.width() > widest.width()) {
        widest = range;
      }
    }
    if (widest.width() == 0) {
      return false;
    }
    for (int i = 1; i <= kMostIsolated + 1; ++i) {
      const Rational at = widest.lower + Rational(i, kMostIsolated + 2) * widest.width();
      const Rational apart = widest.width() / (4 * kMostIsolated + 8);
      if (!has_value_at(value, simplest_between(at - apart, at + apart))) {
        return false;
      }
    }
    return true;
  }

  /// Values of the parameter along the line that the piece takes; lower >= upper if none are known.
  RationalInterval between_ends(const auto& piece) const {
    const RationalInterval a = point_of(system_, piece, piece.range.from())[index(along_)].interval();
    const RationalInterval b = point_of(system_, piece, piece.range.to())[index(along_)].interval();
    return a.upper < b.lower ? RationalInterval{a.upper, b.lower} : RationalInterval{b.upper, a.lower};
  }

  /// The curve has a point with along = at, p = value.
  bool has_value_at(const RealAlgebraic& value, const Rational& at) const {
    if (at <= 0 || at >= 1) {
      return false;
    }
    const LinePoints& line = sweep_.pair.fibre({along_, at});
    return !line.incomplete && line.on_patch.empty() &&
           std::any_of(line.points.begin(), line.points.end(), [&](const CertifiedPoint& point) {
             const RationalInterval around = value.interval();
             const RationalInterval near = point.box()[index(p_)];
             if (near.upper < around.lower || around.upper < near.lower ||
                 !passes_through(curve_, enclose<Ball>(point, width_))) {
               return false;
             }
             const auto exact = point.exact();
             return exact && takes_value(*exact, index(p_), value);
           });
  }

  const PairSystem<Ball>& system_;
  const SweepData& sweep_;
  const Curve& curve_;
  Parameter p_;
  Parameter along_;
  const Rational& width_;
  RationalInterval near_;
};

}  // namespace

template <class Ball, class Curve>
bool is_constant(const PairSystem<Ball>& system, const SweepData& sweep, const Curve& curve, Parameter p,
                 const Rational& width) {
  return ConstantParameter<Ball, Curve>(system, sweep, curve, p, width).run();
}

std::optional<std::vector<const CertifiedPoint*>> points_with_value(const SweepData& sweep,
                                                                    const LineQuery& across, Parameter p,
                                                                    const Rational& value) {
  const LinePoints& line = sweep.pair.fibre(across);
  if (line.incomplete || !line.on_patch.empty()) return std::nullopt;
  std::vector<const CertifiedPoint*> found;
  for (const CertifiedPoint& point : line.points) {
    const RationalInterval at = point.refined_to(power_of_two(-100)).box()[index(p)];
    if (at.lower <= value && value <= at.upper) found.push_back(&point);
  }
  return found;
}

template <class Ball, class Curve>
bool meets_line(const SweepData& sweep, const Curve& curve, const LineQuery& across, Parameter p,
                const Rational& value, const Rational& width) {
  const auto found = points_with_value(sweep, across, p, value);
  if (!found) return false;
  return std::any_of(found->begin(), found->end(), [&](const CertifiedPoint* point) {
    return (found->size() == 1 || sweep.pair.surely_takes(*point, p, value)) &&
           passes_through(curve, enclose<Ball>(*point, width));
  });
}

#define EXSECT_INSTANTIATE_CONSTANT(Ball, Curve)                                                      \
  template bool is_constant(const PairSystem<Ball>&, const SweepData&, const Curve<Ball>&, Parameter, \
                            const Rational&);                                                         \
  template bool meets_line<Ball>(const SweepData&, const Curve<Ball>&, const LineQuery&, Parameter,   \
                                 const Rational&, const Rational&);

EXSECT_INSTANTIATE_CONSTANT(DoubleBall, Trace)
EXSECT_INSTANTIATE_CONSTANT(DoubleDoubleBall, Trace)
EXSECT_INSTANTIATE_CONSTANT(ArbBall<256>, Trace)
EXSECT_INSTANTIATE_CONSTANT(ArbBall<1024>, Trace)
EXSECT_INSTANTIATE_CONSTANT(DoubleBall, TangentialArc)
EXSECT_INSTANTIATE_CONSTANT(DoubleDoubleBall, TangentialArc)
EXSECT_INSTANTIATE_CONSTANT(ArbBall<256>, TangentialArc)
EXSECT_INSTANTIATE_CONSTANT(ArbBall<1024>, TangentialArc)
#undef EXSECT_INSTANTIATE_CONSTANT

void mark_coincident(std::array<bool, 4>& constant, const std::array<std::size_t, 4>& coincident) {
  for (std::size_t j = 0; j < 4; ++j) constant[j] = constant[j] || constant[coincident[j]];
}

}  // namespace exsect

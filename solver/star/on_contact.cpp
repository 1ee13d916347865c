#include "star/on_contact.h"

#include <exsect/solver/line_query.h>

#include <algorithm>

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "star/fine_width.h"
#include "trace/enclose.h"
#include "trace/tangential_enclosure.h"
#include "trace/tangential_tube.h"

namespace exsect {

namespace {

/// Whether the arc of Phi = 0 in a tube around the point is a curve of contact: F is analytic along it, so
/// that it vanishes on all of it if it does on a part. A multiple point of a fibre over no turning value is
/// on such a curve, and if the tube holds it, on this one.
template <class Ball>
class ContactAt {
 public:
  ContactAt(const SingularPointQuery& query, const PairSystem<Ball>& system, const CertifiedPoint& point,
            const TurningValues& turning)
      : query_(query),
        system_(system),
        point_(point),
        turning_(turning),
        sweep_(index(turning.sweep)),
        box_(enclose<Ball>(point, fine_width())) {}

  bool is_proved() const {
    for (double reach = 0x1p-6; reach >= 0x1p-22; reach *= 0x1p-4) {
      const auto tube = certify_tangential_tube(system_, box_, reach, sweep_);
      if (tube && contains(*tube, box_)) {
        return crosses_sides(*tube) && (has_contact_within(*tube) || has_contact_between_ends(*tube));
      }
    }
    return false;
  }

 private:
  bool crosses_sides(const TangentialTube<Ball>& tube) const {
    const double tau = offset(tube, box_).approximation();
    const ArcEnclosure<Ball> here = enclosure_between(system_, tube, tau - 0x1p-60, tau + 0x1p-60);
    return std::all_of(point_.sides().begin(), point_.sides().end(), [&](const Side& side) {
      return here.slope[index(side.parameter)].certain_sign() != 0;
    });
  }

  /// On one side of the point or the other, unless the curve ends on the tube in both directions.
  bool has_contact_within(const TangentialTube<Ball>& tube) const {
    const double centre = tube.centre[tube.axis].approximation();
    return has_contact_over(tube, from_double(centre - 0.5 * tube.reach)) ||
           has_contact_over(tube, from_double(centre + 0.5 * tube.reach));
  }

  /// Across a corner the curve may be as short as it likes.
  bool has_contact_between_ends(const TangentialTube<Ball>& tube) const {
    return std::any_of(
        query_.places.boundary.begin(), query_.places.boundary.end(), [&](const CertifiedPoint& other) {
          if (!contains(tube, enclose<Ball>(other, fine_width()))) {
            return false;
          }
          const std::optional<RationalInterval> range = between(other);
          if (!range) {
            return false;
          }
          const Rational quarter = range->width() / 4;
          return has_contact_over(tube, simplest_between(range->lower, range->upper)) ||
                 has_contact_over(tube, simplest_between(range->lower, range->lower + quarter));
        });
  }

  /// The values of the swept parameter between those of the two points; empty if these cannot be told apart.
  std::optional<RationalInterval> between(const CertifiedPoint& other) const {
    for (Rational width = power_of_two(-100); width > power_of_two(-2000); width *= width) {
      const RationalInterval a = point_.refined_to(width).box()[sweep_];
      const RationalInterval b = other.refined_to(width).box()[sweep_];
      if (gap(a, b) > 0) {
        return a.upper < b.lower ? RationalInterval{a.upper, b.lower} : RationalInterval{b.upper, a.lower};
      }
      if (a.width() == 0 && b.width() == 0) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  bool has_contact_over(const TangentialTube<Ball>& tube, const Rational& at) const {
    const bool regular =
        at > 0 && at < 1 &&
        std::none_of(turning_.values.begin(), turning_.values.end(),
                     [&](const TurningValue& value) { return value.value.compare(at) == 0; });
    if (!regular) {
      return false;
    }
    const LinePoints& fibre = query_.pair.fibre({turning_.sweep, at});
    return std::any_of(fibre.points.begin(), fibre.points.end(), [&](const CertifiedPoint& point) {
      return point.multiplicity() >= 2 && contains(tube, enclose<Ball>(point, fine_width()));
    });
  }

  const SingularPointQuery& query_;
  const PairSystem<Ball>& system_;
  const CertifiedPoint& point_;
  const TurningValues& turning_;
  std::size_t sweep_;
  BallPoint<Ball> box_;
};

}  // namespace

template <class Ball>
bool is_on_contact(const SingularPointQuery& query, const PairSystem<Ball>& system,
                   const CertifiedPoint& point) {
  return std::any_of(all_parameters.begin(), all_parameters.end(), [&](Parameter axis) {
    const auto& turning = query.pair.turning(axis);
    return turning && turning->touching && ContactAt<Ball>(query, system, point, *turning).is_proved();
  });
}

#define EXSECT_INSTANTIATE_ON_CONTACT(Ball) \
  template bool is_on_contact(const SingularPointQuery&, const PairSystem<Ball>&, const CertifiedPoint&);

EXSECT_INSTANTIATE_ON_CONTACT(DoubleBall)
EXSECT_INSTANTIATE_ON_CONTACT(ArbBall<256>)
#undef EXSECT_INSTANTIATE_ON_CONTACT

}  // namespace exsect

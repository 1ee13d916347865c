#include "sweep/traced_contacts.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "line/line_place.h"
#include "sweep/constant_parameter.h"
#include "trace/enclose.h"

namespace exsect {

namespace {

template <class Ball>
class ContactTracing {
 public:
  ContactTracing(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const SweepData& sweep,
                 const Rational& width, const StopRequest& stop, TracedCurves<Ball>& traced)
      : system_(system),
        landmarks_(landmarks),
        sweep_(sweep),
        pair_(sweep.pair),
        width_(width),
        stop_(stop),
        result_(traced) {}

  /// Curves along which the patches touch: through the multiple points of the fibres, and the parameter lines
  /// that do so all along.
  void run() {
    if (sweep_.turning->touching) {
      for (const std::vector<CertifiedPoint>& fibre : sweep_.fibres) {
        for (const CertifiedPoint& point : fibre) {
          trace_contact_through(point);
        }
      }
    }
    for (const TurningValue& turning : sweep_.turning->values) {
      if (turning.multiplicity != 1 && turning.value.is_rational()) {
        trace_contact_lines({sweep_.turning->sweep, turning.value.rational()});
      }
    }
  }

 private:
  void problem(const ParameterBox& where, const std::string& why, Reason reason = Reason::not_decided) {
    result_.problems.push_back({where, why, reason});
  }

  /// The parts of a line on which the patches touch, if the line lies on the other patch.
  void trace_contact_lines(const LineQuery& query) {
    if (query.value == 0 || query.value == 1) {
      return;
    }
    const LinePoints& line = pair_.fibre(query);
    const Parameter along = line_place(query).roles.line;
    const auto& turning = pair_.turning(along);
    if (line.incomplete || line.on_patch.empty() || !turning || !turning->touching) {
      return;
    }
    std::vector<CertifiedPoint> boundary;
    for (const LandmarkPoint& landmark : sweep_.landmarks) {
      boundary.push_back(landmark.point);
    }
    TurningValues across = *turning;
    for (const Rational& sample : sweep_samples(across, boundary)) {
      const bool on_line =
          std::any_of(line.on_patch.begin(), line.on_patch.end(), [&](const AlgebraicInterval& part) {
            return part.from.compare(sample) < 0 && part.to.compare(sample) > 0;
          });
      if (!on_line) continue;
      for (const CertifiedPoint& point : pair_.fibre({along, sample}).points) {
        const RationalInterval& at = point.box()[index(query.fixed)];
        if (at.lower <= query.value && query.value <= at.upper) {
          trace_contact_through(point);
        }
      }
    }
  }

  /// `point` is isolated over a value of a sweep that is no turning value.
  void trace_contact_through(const CertifiedPoint& point) {
    const BallPoint<Ball> box = enclose<Ball>(point, width_);
    if (point.multiplicity() < 2 || !point.sides().empty() || contacts_through(result_, box) > 0 ||
        in_star(sweep_, point)) {
      return;
    }
    auto outcome = trace_contact(system_, landmarks_, box, stop_);
    if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
      problem(around(failure->where), failure->why);
      return;
    }
    AnalysedContact<Ball> contact{std::get<TangentialArc<Ball>>(std::move(outcome)), {}};
    std::array<bool, 4> constant{};
    for (const Parameter p : all_parameters) {
      constant[index(p)] = may_be_constant(system_, contact.trace, index(p)) &&
                           is_constant(system_, sweep_, contact.trace, p, width_);
    }
    mark_coincident(constant, pair_.coincident());
    auto turns = find_contact_turns(system_, contact.trace, pair_, constant);
    if (const auto* failure = std::get_if<TraceFailure>(&turns)) {
      problem(around(failure->where), failure->why);
      return;
    }
    contact.turning = std::get<TurningPoints<Ball>>(std::move(turns));
    check_that_it_leaves(contact.trace);
    result_.contacts.push_back(std::move(contact));
  }

  /// At its ends on sides the curve crosses these.
  void check_that_it_leaves(const TangentialArc<Ball>& curve) {
    for (const int which : {0, 1}) {
      const int landmark = which == 0 ? curve.start : curve.end;
      if (landmark < 0 || sweep_.landmarks[static_cast<std::size_t>(landmark)].side != 0) {
        continue;
      }
      const CertifiedPoint& point = sweep_.landmarks[static_cast<std::size_t>(landmark)].point;
      for (const Side& side : point.sides()) {
        const int outward = (which == 0 ? -1 : 1) * (side.value == 0 ? -1 : 1);
        if (certain_direction(system_, curve, which, index(side.parameter)) != outward) {
          problem(point.box(), "a curve along which the patches touch does not cross the side here",
                  Reason::tangency);
        }
      }
    }
  }

  const PairSystem<Ball>& system_;
  const Landmarks<Ball>& landmarks_;
  const SweepData& sweep_;
  ExactPair& pair_;
  const Rational& width_;
  const StopRequest& stop_;
  TracedCurves<Ball>& result_;
};

}  // namespace

template <class Ball>
void trace_contacts(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const SweepData& sweep,
                    const Rational& width, const StopRequest& stop, TracedCurves<Ball>& traced) {
  ContactTracing<Ball>(system, landmarks, sweep, width, stop, traced).run();
}

#define EXSECT_INSTANTIATE_CONTACTS(Ball)                                                         \
  template void trace_contacts(const PairSystem<Ball>&, const Landmarks<Ball>&, const SweepData&, \
                               const Rational&, const StopRequest&, TracedCurves<Ball>&);

EXSECT_INSTANTIATE_CONTACTS(DoubleBall)
EXSECT_INSTANTIATE_CONTACTS(DoubleDoubleBall)
EXSECT_INSTANTIATE_CONTACTS(ArbBall<256>)
EXSECT_INSTANTIATE_CONTACTS(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_CONTACTS

}  // namespace exsect

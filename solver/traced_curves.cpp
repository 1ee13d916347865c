#include "traced_curves.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "constant_parameter.h"
#include "landmark_tangent.h"
#include "line_place.h"
#include "parameter_box.h"
#include "subdivision.h"

namespace exsect {

namespace {

constexpr int kQuickSearch = 16;  // times 64 boxes

int side_of(const RationalInterval& interval, const Rational& sample) {
  return interval.upper < sample ? -1 : interval.lower > sample ? 1 : 0;
}

template <class Ball>
bool turns_in(const TurningPoint<Ball>& point, std::size_t parameter) {
  return std::count(point.parameters.begin(), point.parameters.end(), parameter) > 0;
}

template <class Ball>
class CurveTracing {
 public:
  CurveTracing(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks, const SweepData& sweep,
               const Rational& width, const StopRequest& stop)
      : system_(system), landmarks_(landmarks), sweep_(sweep), width_(width), stop_(stop) {}

  TracedCurves<Ball> run() {
    if (sweep_.turning && sweep_.exact) {
      trace_contacts();
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
  void problem(const ParameterBox& where, const std::string& why) {
    result_.problems.push_back({where, why});
  }

  /// T at a landmark; nothing for -1.
  TangentSigns signs_at(int landmark) const {
    if (landmark < 0) {
      return {};
    }
    const auto i = static_cast<std::size_t>(landmark);
    return tangent_signs(system_, landmarks_[i], [&] {
      return sweep_.zero_tangent ? sweep_.zero_tangent(sweep_.landmarks[i].point) : std::array<bool, 4>{};
    });
  }

  /// +1, -1: the directions of the tangent field that enter the domain at this boundary point or port; empty:
  /// unknown.
  std::optional<std::vector<int>> entering_directions(std::size_t landmark) const {
    const LandmarkPoint& at = sweep_.landmarks[landmark];
    const BallPoint<Ball> tangent = Expansion<Ball>(system_, landmarks_[landmark]).tangent();
    if (at.side != 0) {
      const int sign = tangent[index(at.across)].certain_sign();
      return sign == 0 ? std::nullopt : std::optional(std::vector{at.side * sign});
    }
    std::vector<int> directions = {1, -1};
    std::vector<Side> tangential;
    for (const Side& side : at.point.sides()) {
      const int sign = tangent[index(side.parameter)].certain_sign();
      if (sign == 0) {
        tangential.push_back(side);
      } else {
        std::erase(directions, side.value == 0 ? -sign : sign);
      }
    }
    for (const Side& side : tangential) {
      const std::optional<bool> inside = directions.empty() ? false : bends_inwards(landmark, side);
      if (!inside) {
        return std::nullopt;
      }
      if (!*inside) {
        directions.clear();
      }
    }
    return directions;
  }

  /// Where the curve is tangent to the side, exactly, its second derivative says whether it lies inside.
  std::optional<bool> bends_inwards(std::size_t landmark, const Side& side) const {
    const std::size_t j = index(side.parameter);
    const int bend = bend_sign(system_, landmarks_[landmark], j);
    if (bend == 0 || signs_at(static_cast<int>(landmark))[j] != 0) {
      return std::nullopt;
    }
    return (bend > 0) == (side.value == 0);
  }

  /// Curves along which the patches touch: through the multiple points of the fibres, and the parameter lines
  /// that do so all along.
  void trace_contacts() {
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

  /// The parts of a line on which the patches touch, if the line lies on the other patch.
  void trace_contact_lines(const LineQuery& query) {
    if (query.value == 0 || query.value == 1) {
      return;
    }
    const LinePoints line = sweep_.line(query);
    const Parameter along = line_place(query).roles.line;
    if (line.incomplete || line.on_patch.empty() || !sweep_.turning_of(along) ||
        !sweep_.turning_of(along)->touching) {
      return;
    }
    std::vector<CertifiedPoint> boundary;
    for (const LandmarkPoint& landmark : sweep_.landmarks) {
      boundary.push_back(landmark.point);
    }
    TurningValues across = *sweep_.turning_of(along);
    for (const Rational& sample : sweep_samples(across, boundary)) {
      const bool on_line =
          std::any_of(line.on_patch.begin(), line.on_patch.end(), [&](const AlgebraicInterval& part) {
            return part.from.compare(sample) < 0 && part.to.compare(sample) > 0;
          });
      const LinePoints fibre = on_line ? sweep_.line({along, sample}) : LinePoints();
      for (const CertifiedPoint& point : fibre.points) {
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
    if (point.multiplicity() < 2 || !point.sides().empty() || contacts_through(box) > 0 || in_star(point)) {
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
      constant[index(p)] = may_be_constant(system_, contact.curve, index(p)) &&
                           is_constant(system_, sweep_, contact.curve, p, width_);
    }
    mark_coincident(constant);
    auto turns = find_contact_turns(system_, contact.curve, sweep_.turning_of, constant);
    if (const auto* failure = std::get_if<TraceFailure>(&turns)) {
      problem(around(failure->where), failure->why);
      return;
    }
    contact.turns = std::get<std::vector<ContactTurn<Ball>>>(std::move(turns));
    check_that_it_leaves(contact.curve);
    result_.contacts.push_back(std::move(contact));
  }

  /// A parameter that is a function of a constant one is constant.
  void mark_coincident(std::array<bool, 4>& constant) const {
    for (std::size_t j = 0; j < 4; ++j) {
      constant[j] = constant[j] || constant[sweep_.coincident[j]];
    }
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
          problem(point.box(), "a curve along which the patches touch does not cross the side here");
        }
      }
    }
  }

  int contacts_through(const BallPoint<Ball>& box) const {
    return static_cast<int>(std::count_if(
        result_.contacts.begin(), result_.contacts.end(),
        [&](const AnalysedContact<Ball>& contact) { return passes_through(contact.curve, box); }));
  }

  void trace_open_curves() {
    used_.assign(landmarks_.size(), {});
    for (const AnalysedContact<Ball>& contact : result_.contacts) {
      for (const int landmark : {contact.curve.start, contact.curve.end}) {
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
    const auto directions = entering_directions(landmark);
    if (!directions) {
      if (last_pass) {
        problem(sweep_.landmarks[landmark].point.box(),
                "the intersection is tangent to a side of a patch, or singular, at this boundary point");
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
        if (curves_through(box) + contacts_through(box) == 0) {
          add(trace_loop(system_, landmarks_, box, stop_));
        }
        if (!result_.problems.empty()) {
          return;
        }
      }
    }
  }

  int curves_through(const BallPoint<Ball>& box) const {
    return static_cast<int>(
        std::count_if(result_.curves.begin(), result_.curves.end(),
                      [&](const AnalysedTrace<Ball>& curve) { return passes_through(curve.trace, box); }));
  }

  void add(std::variant<Trace<Ball>, TraceFailure> outcome) {
    if (const auto* failure = std::get_if<TraceFailure>(&outcome)) {
      problem(around(failure->where), failure->why);
      return;
    }
    AnalysedTrace<Ball> curve{std::get<Trace<Ball>>(std::move(outcome)), {}};
    KnownTangent known;
    for (const Parameter p : all_parameters) {
      known.constant[index(p)] = sweep_.line && may_be_constant(curve.trace, index(p)) &&
                                 is_constant(system_, sweep_, curve.trace, p, width_);
    }
    mark_coincident(known.constant);
    known.plane = sweep_.plane;
    known.at_start = signs_at(curve.trace.start);
    known.at_end = signs_at(curve.trace.end);
    auto turning = find_turning_points(system_, curve.trace, sweep_.coincident, known);
    if (const auto* failure = std::get_if<TraceFailure>(&turning)) {
      problem(around(failure->where), failure->why);
      return;
    }
    curve.turning = std::get<std::vector<TurningPoint<Ball>>>(std::move(turning));
    result_.curves.push_back(std::move(curve));
  }

  /// The direction c for which c.T keeps clearest away from zero on the curves traced so far: any c is legal,
  /// a good one leaves fewer boxes.
  std::array<double, 2> search_direction() const {
    std::array<double, 2> best = {1, 0.375};
    double best_value = -1;
    for (int i = 0; i < 16; ++i) {
      const std::array<double, 2> c = {std::cos(0.19 * i), std::sin(0.19 * i)};
      double least = 1;
      for (const AnalysedTrace<Ball>& curve : result_.curves) {
        for (const Piece<Ball>& piece : curve.trace.pieces) {
          const double du = piece.tube.slope[0];
          const double dv = piece.tube.slope[1];
          least = std::min(least, std::fabs(c[0] * du + c[1] * dv) / std::max(1e-300, std::hypot(du, dv)));
        }
      }
      if (least > best_value) {
        best_value = least;
        best = c;
      }
    }
    return best;
  }

  void search_everywhere() {
    search({{0, 0, 0, 0}, {1, 1, 1, 1}},
           "a closed curve or singular point of the intersection is not excluded here");
  }

  void search(const SearchRegion& region, const char* why) {
    const SeedHandler<Ball> known = [this](const BallPoint<Ball>& seed) { return known_or_traced(seed); };
    const SettledRegion settled = [this](const SearchRegion& box) {
      return (sweep_.settled && sweep_.settled(box)) || is_in_star(box) || is_on_contact(box);
    };
    const StopRequest soon = [this, asked = 0]() mutable {
      return is_stopped(stop_) || (sweep_.quick && ++asked > kQuickSearch);
    };
    const SearchOutcome outcome =
        search_closed_curves(system_, region, search_direction(), known, settled, soon);
    result_.cut_short = result_.cut_short || (sweep_.quick && !outcome.undecided.empty());
    result_.searched_boxes += outcome.boxes;
    for (const SearchRegion& box : merged(outcome.undecided)) {
      ParameterBox where;
      for (std::size_t j = 0; j < 4; ++j) {
        where[j] = {from_double(box.lower[j]), from_double(box.upper[j])};
      }
      problem(where, stop_ && stop_() ? "the work cap was reached" : why);
    }
  }

  bool is_in_star(const SearchRegion& region) const {
    ParameterBox box;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = {from_double(region.lower[j]), from_double(region.upper[j])};
    }
    return std::any_of(sweep_.stars.begin(), sweep_.stars.end(),
                       [&](const StarNeighbourhood& star) { return lies_in(box, star.box); });
  }

  bool is_on_contact(const SearchRegion& region) const {
    BallPoint<Ball> box;
    for (std::size_t j = 0; j < 4; ++j) {
      const double middle = 0.5 * (region.lower[j] + region.upper[j]);
      box[j] =
          Ball(middle).widened(std::max(region.upper[j] - middle, middle - region.lower[j]) * (1 + 0x1p-50));
    }
    return contacts_through(box) > 0;
  }

  bool known_or_traced(const BallPoint<Ball>& seed) {
    if (curves_through(seed) > 0) {
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

  /// The values of the sweep parameter at the ends and turning points of a curve, in order; a closed curve's
  /// first turning point is repeated at the end.
  std::vector<RationalInterval> monotone_stations(const AnalysedTrace<Ball>& curve) const {
    const std::size_t sweep = index(sweep_.turning->sweep);
    const auto at_landmark = [&](int i) {
      return sweep_.landmarks[static_cast<std::size_t>(i)].point.box()[sweep];
    };
    std::vector<RationalInterval> stations;
    const bool open = curve.trace.start >= 0;
    if (open) {
      stations.push_back(at_landmark(curve.trace.start));
    }
    for (const TurningPoint<Ball>& point : curve.turning) {
      if (turns_in(point, sweep)) {
        stations.push_back(point.box[sweep].interval());
      }
    }
    if (open) {
      stations.push_back(at_landmark(curve.trace.end));
    } else if (!stations.empty()) {
      stations.push_back(stations.front());
    }
    return stations;
  }

  /// How often the curve meets the sample; empty if a station cannot be told from it. Between stations the
  /// curve is monotone in the sweep parameter.
  std::optional<std::size_t> crossings(const AnalysedTrace<Ball>& curve, const Rational& sample) const {
    const auto stations = monotone_stations(curve);
    std::size_t count = 0;
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      const int a = side_of(stations[i], sample);
      const int b = side_of(stations[i + 1], sample);
      if (a == 0 || b == 0) {
        return std::nullopt;
      }
      count += a != b ? 1 : 0;
    }
    return count;
  }

  /// The bijection: every fibre point lies on one curve, and the curves meet the sample as often as the fibre
  /// has points.
  void match_fibres() {
    for (std::size_t k = 0; k < sweep_.fibres.size(); ++k) {
      std::size_t expected = 0;
      for (const AnalysedTrace<Ball>& curve : result_.curves) {
        const auto met = crossings(curve, sweep_.samples[k]);
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
        if (contacts_through(box) == 1) {
          continue;
        }
        if (curves_through(box) != 1) {
          throw std::logic_error("internal error: a fibre point lies on no traced curve or on two");
        }
        ++met;
      }
      if (expected != met) {
        throw std::logic_error("internal error: traced curves and exact fibre disagree at " +
                               std::string(name(sweep_.turning->sweep)) + " = " + sweep_.samples[k].str());
      }
    }
  }

  /// Over a root of E of multiplicity m there is no further singular point if the regular turning points over
  /// it, and twice the singular ones that are known, make up m: so much of m is taken up by each. (A simple
  /// root lies under no singular point: docs/method.md, section 4.) Otherwise the slab around the root is
  /// searched.
  void check_multiple_turning_values() {
    for (const TurningValue& turning : sweep_.turning->values) {
      if (turning.multiplicity == 1 ||
          (turning.multiplicity > 1 &&
           regular_turning_points(turning) + 2 * singular_stars(turning) >= turning.multiplicity) ||
          multiple_points_are_known(turning)) {
        continue;
      }
      SearchRegion slab = {{0, 0, 0, 0}, {1, 1, 1, 1}};
      const std::size_t sweep = index(sweep_.turning->sweep);
      const RationalInterval at = turning.value.refined_to(power_of_two(-40)).interval();
      const double grid = 0x1p-24;  // dyadic ends, so that the slab can be halved often
      slab.lower[sweep] = std::max(0.0, grid * std::floor(to_double(at.lower) / grid - 0x1p-30));
      slab.upper[sweep] = std::min(1.0, grid * std::ceil(to_double(at.upper) / grid + 0x1p-30));
      search(
          slab,
          "a multiple root of the turning eliminant: a singular or isolated point of the intersection is not "
          "excluded here");
    }
  }

  /// All points of the fibre over a rational value are on traced curves or in stars.
  bool multiple_points_are_known(const TurningValue& turning) const {
    if (!turning.value.is_rational()) {
      return false;
    }
    const LineQuery query = {sweep_.turning->sweep, turning.value.rational()};
    const LinePoints fibre = sweep_.line(query);
    return !fibre.incomplete &&
           std::all_of(fibre.on_patch.begin(), fibre.on_patch.end(),
                       [&](const AlgebraicInterval& part) { return is_traced(query, part); }) &&
           std::all_of(fibre.points.begin(), fibre.points.end(), [this](const CertifiedPoint& point) {
             const BallPoint<Ball> box = enclose<Ball>(point, width_);
             return point.multiplicity() == 1 || in_star(point) || curves_through(box) > 0 ||
                    contacts_through(box) > 0;
           });
  }

  /// All of an interval in which the line lies on the other patch is on traced curves and in stars: a point
  /// is, between any two neighbouring places where a curve may end.
  bool is_traced(const LineQuery& query, const AlgebraicInterval& part) const {
    if (query.value == 0 || query.value == 1) {
      return true;  // known as arcs on a side
    }
    const Parameter along = line_place(query).roles.line;
    if (part.from == part.to) {
      return sweep_.is_on_sides && sweep_.is_on_sides(query, part.from);
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
          !is_on_curve({along, (covered + end.lower) / 2}, query)) {
        return false;
      }
      covered = std::max(covered, end.upper);
    }
    return true;
  }

  /// A point of `line` across the line `across` is on a traced curve.
  bool is_on_curve(const LineQuery& across, const LineQuery& line) const {
    return std::any_of(result_.curves.begin(), result_.curves.end(),
                       [&](const AnalysedTrace<Ball>& curve) {
                         return meets_line<Ball>(sweep_, curve.trace, across, line.fixed, line.value, width_);
                       }) ||
           std::any_of(
               result_.contacts.begin(), result_.contacts.end(), [&](const AnalysedContact<Ball>& contact) {
                 return meets_line<Ball>(sweep_, contact.curve, across, line.fixed, line.value, width_);
               });
  }

  bool in_star(const CertifiedPoint& point) const {
    return std::any_of(sweep_.stars.begin(), sweep_.stars.end(), [&](const StarNeighbourhood& star) {
      return lies_in(point.refined_to(power_of_two(-100)).box(), star.box);
    });
  }

  int regular_turning_points(const TurningValue& turning) const {
    const std::size_t sweep = index(sweep_.turning->sweep);
    int count = 0;
    for (const AnalysedTrace<Ball>& curve : result_.curves) {
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
          const ParameterBox centre = star.centre.refined_to(power_of_two(-100)).box();
          return lies_over_only(turning, centre[index(sweep_.turning->sweep)]) && is_singular_star(star) &&
                 (!sweep_.turning->touching ||
                  std::any_of(star.ports.begin(), star.ports.end(),
                              [](const Port& port) { return port.point.multiplicity() == 1; }));
        }));
  }

  bool is_singular_star(const StarNeighbourhood& star) const {
    const std::array<bool, 4> zero =
        !is_singular(star) && sweep_.zero_tangent ? sweep_.zero_tangent(star.centre) : std::array<bool, 4>{};
    return is_singular(star) || std::count(zero.begin(), zero.end(), true) == 4;
  }

  /// True if `at`, which holds some turning value, can hold no other one than this.
  bool lies_over_only(const TurningValue& turning, const RationalInterval& at) const {
    const auto& all = sweep_.turning->values;
    return std::all_of(all.begin(), all.end(), [&](const TurningValue& other) {
      const RationalInterval interval = other.value.interval();
      const bool meets = at.lower <= interval.upper && at.upper >= interval.lower;
      return meets == (&other == &turning);
    });
  }

  const PairSystem<Ball>& system_;
  const Landmarks<Ball>& landmarks_;
  const SweepData& sweep_;
  const Rational& width_;
  const StopRequest& stop_;
  std::vector<std::vector<int>> used_;  // directions of T in which a curve leaves each landmark
  TracedCurves<Ball> result_;
};

}  // namespace

ParameterBox around(const std::array<double, 4>& where) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational centre = from_double(std::isfinite(where[j]) ? std::clamp(where[j], 0.0, 1.0) : 0.5);
    box[j] = {std::max<Rational>(centre - power_of_two(-20), 0),
              std::min<Rational>(centre + power_of_two(-20), 1)};
  }
  return box;
}

template <class Ball>
TracedCurves<Ball> trace_curves(const PairSystem<Ball>& system, const Landmarks<Ball>& landmarks,
                                const SweepData& sweep, const Rational& width, const StopRequest& stop) {
  return CurveTracing<Ball>(system, landmarks, sweep, width, stop).run();
}

template <class Ball>
BallPoint<Ball> enclose(const CertifiedPoint& point, const Rational& width) {
  const ParameterBox box = point.refined_to(width).box();
  return {Ball::enclosing(box[0]), Ball::enclosing(box[1]), Ball::enclosing(box[2]), Ball::enclosing(box[3])};
}

#define EXSECT_INSTANTIATE_CURVES(Ball)                                                            \
  template TracedCurves<Ball> trace_curves(const PairSystem<Ball>&, const Landmarks<Ball>&,        \
                                           const SweepData&, const Rational&, const StopRequest&); \
  template BallPoint<Ball> enclose(const CertifiedPoint&, const Rational&);

EXSECT_INSTANTIATE_CURVES(DoubleBall)
EXSECT_INSTANTIATE_CURVES(DoubleDoubleBall)
EXSECT_INSTANTIATE_CURVES(ArbBall<256>)
#undef EXSECT_INSTANTIATE_CURVES

}  // namespace exsect

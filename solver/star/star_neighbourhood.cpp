#include "star/star_neighbourhood.h"

#include <exsect/solver/line_query.h>

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "line/half_rational_point.h"
#include "line/known_tangent.h"
#include "line/line_place.h"
#include "line/line_points_in.h"
#include "star/other_turning.h"
#include "star/short_numbers.h"

namespace exsect {

namespace {

constexpr std::size_t kMostFibrePorts = 64;  // a fibre has at most 16 points
constexpr int kMostSlabs = 24;
constexpr double kNarrowLine = 0x1p-4;

class StarProof {
 public:
  StarProof(const StarQuery& query, const CertifiedPoint& centre, const RealAlgebraic& at)
      : query_(query),
        others_(other_turning(query.pair, query.turning.sweep)),
        centre_(centre.refined_to(power_of_two(-100))),
        at_(at.refined_to(power_of_two(-100))),
        sweep_(query.turning.sweep) {}

  std::optional<StarNeighbourhood> run() {
    if (!bound_halfwidth() || !bound_slab() || !keep_samples_away() || !keep_turning_values_away() ||
        room_ <= power_of_two(-900)) {
      return std::nullopt;
    }
    // The room left by other points may be smaller than 2^-40: the sizes tried start from there.
    const double room = power_of_two_below(room_);
    for (double halfwidth = room; halfwidth >= std::min(0x1p-40, 0x1p-24 * room); halfwidth *= 0x1p-6) {
      double slab = std::min(halfwidth, power_of_two_below(slab_room_));
      const double least_slab = std::min(0x1p-48, 0x1p-24 * slab);
      for (int i = 0; i < kMostSlabs && slab >= least_slab; ++i, slab *= 0.25) {
        if (is_stopped(query_.pair.stop())) {
          return std::nullopt;
        }
        set_region(halfwidth, slab);
        if (!centre_is_alone() || !lateral_faces_are_free()) {
          continue;
        }
        auto star = with_ports();
        if (!star || lies_on_sides(*star) || arcs_are_monotone(star->ports.size())) {
          return star;
        }
        break;  // with a smaller box
      }
    }
    return std::nullopt;
  }

 private:
  /// Keeps every other point of the fibre and every other boundary point away from the box.
  bool bound_halfwidth() {
    room_ = from_double(query_.largest_halfwidth);
    if (!at_.is_rational()) {
      return query_.singular && keep_away(query_.places.boundary, 0) == 0;
    }
    const LinePoints& fibre = query_.pair.fibre({sweep_, at_.rational()});
    if (fibre.incomplete) {
      return false;
    }
    // The centre is in the first list, and in the second one only if it lies on a side.
    const int expected = centre_.sides().empty() ? 0 : 1;
    const int on_side = keep_away(query_.places.boundary, expected);
    for (const AlgebraicInterval& part : fibre.on_patch) {
      if (!keep_away_or_enter(part)) {
        return false;
      }
    }
    return keep_away(fibre.points, line_ ? 0 : 1) == (line_ ? 0 : 1) && on_side <= expected;
  }

  /// Of the fibre over an irrational value; for a rational one bound_halfwidth sees to it.
  bool centre_is_alone() const { return at_.is_rational() || query_.singular->is_alone_in(region_); }

  /// A part of the line over the centre's value that lies on the other patch: away from the box, or it runs
  /// right through it.
  bool keep_away_or_enter(const AlgebraicInterval& part) {
    const Parameter along = line_place({sweep_, at_.rational()}).roles.line;
    const RationalInterval from = part.from.refined_to(centre_width_).interval();
    const RationalInterval to = part.to.refined_to(centre_width_).interval();
    const RationalInterval& centre = centre_.box()[index(along)];
    const Rational d = gap({from.lower, to.upper}, centre);
    if (d > 0) {
      room_ = std::min<Rational>(room_, d / 2);
      return true;
    }
    const bool starts_before = from.upper < centre.lower;
    const bool ends_behind = to.lower > centre.upper;
    const bool starts_here = part.from.compare(0) == 0 && centre.upper == 0;
    const bool ends_here = part.to.compare(1) == 0 && centre.lower == 1;
    if (line_ || !(starts_before || starts_here) || !(ends_behind || ends_here)) {
      return false;
    }
    line_ = along;
    if (starts_before) {
      room_ = std::min<Rational>(room_, (centre.lower - from.upper) / 2);
    }
    if (ends_behind) {
      room_ = std::min<Rational>(room_, (to.lower - centre.upper) / 2);
    }
    return true;
  }

  /// The number of points that cannot be told from the centre, at a width at which it is `expected`, if there
  /// is one.
  int keep_away(const std::vector<CertifiedPoint>& points, int expected) {
    int near = 0;
    Rational room;
    for (Rational width = power_of_two(-100); width > power_of_two(-2000); width *= width) {
      refine_centre(width);
      near = 0;
      room = room_;
      for (const CertifiedPoint& point : points) {
        const Rational d = distance(point.refined_to(width).box(), centre_.box());
        if (d > 0) {
          room = std::min<Rational>(room, d / 2);
        } else {
          ++near;
        }
      }
      if (near <= expected) {
        break;
      }
    }
    room_ = room;
    return near;
  }

  void refine_centre(const Rational& width) {
    if (width < centre_width_) {
      centre_width_ = width;
      centre_ = centre_.refined_to(width);
    }
  }

  /// Keeps every other turning value away from the slab.
  bool bound_slab() {
    slab_room_ = 1;
    for (const TurningValue& value : query_.turning.values) {
      if (value.value == at_) {
        continue;
      }
      RealAlgebraic other = value.value;
      RealAlgebraic at = at_;
      Rational d = gap(other.interval(), at.interval());
      for (Rational width = power_of_two(-60); d == 0; width *= width) {
        other = other.refined_to(width);
        at = at.refined_to(width);
        d = gap(other.interval(), at.interval());
      }
      slab_room_ = std::min<Rational>(slab_room_, d / 2);
    }
    return slab_room_ > power_of_two(-900);
  }

  bool keep_samples_away() {
    Rational& room = query_.places.sampled == sweep_ ? slab_room_ : room_;
    for (const Rational& sample : query_.places.samples) {
      const Rational d = gap_to_centre({sample, sample}, query_.places.sampled);
      if (d == 0) {
        return false;
      }
      room = std::min<Rational>(room, d / 2);
    }
    return true;
  }

  /// From the centre's value of the parameter; 0 if that cannot be told from those in the interval.
  Rational gap_to_centre(const RationalInterval& at, Parameter p) {
    for (Rational width = power_of_two(-200); width > power_of_two(-2000); width *= width) {
      const Rational d = gap(at, centre_.box()[index(p)]);
      if (d > 0) {
        return d;
      }
      refine_centre(width);
    }
    return gap(at, centre_.box()[index(p)]);
  }

  /// A width at which one of the values at most cannot be told from the centre's, if there is one; the
  /// centre is known as well.
  Rational separating_width(const TurningValues& other) {
    Rational width = power_of_two(-100);
    for (; width > power_of_two(-2000); width *= width) {
      refine_centre(width);
      const auto near =
          std::count_if(other.values.begin(), other.values.end(), [&](const TurningValue& value) {
            return gap(value.value.refined_to(width).interval(), centre_.box()[index(other.sweep)]) == 0;
          });
      if (near <= 1) {
        break;
      }
    }
    return width;
  }

  /// Turning values of the other parameters: away from the box, or rational and that of the centre.
  bool keep_turning_values_away() {
    for (const TurningValues* other : others_.values) {
      const Rational width = separating_width(*other);
      for (const TurningValue& value : other->values) {
        const Rational d = gap(value.value.refined_to(width).interval(), centre_.box()[index(other->sweep)]);
        if (d > 0) {
          room_ = std::min<Rational>(room_, d / 2);
        } else if (value.value.is_rational()) {
          through_centre_.push_back({other->sweep, value.value.rational()});
        } else {
          ++irrational_near_[index(other->sweep)];
        }
        if (d == 0 && other->sweep == line_ && !(query_.along && value.value == *query_.along)) {
          return false;
        }
      }
    }
    // Of the turning values along the line, the box now holds the centre's at most. So all arcs in the box
    // that are not the line meet it in the centre only: through a point of the fibre over another value one
    // arc passes, and that is the line.
    return !line_ || std::any_of(others_.values.begin(), others_.values.end(),
                                 [&](const TurningValues* other) { return other->sweep == *line_; });
  }

  /// In every other parameter: the only point of the box over a turning value is the centre, apart from
  /// curves on which that parameter is constant. Where a component of the tangent field is zero in the
  /// centre, as all are if it is singular, its parameter is a turning value: where the box holds one value of
  /// a parameter only, it is the centre's, and an arc that turned there would turn over another one on its
  /// way to the centre.
  bool arcs_are_monotone(std::size_t ports) const {
    const bool singular = ports >= 3 || query_.singular;
    const bool all_rational =
        std::all_of(irrational_near_.begin(), irrational_near_.end(), [](int near) { return near == 0; });
    const std::array<bool, 4> zero = singular || all_rational
                                         ? std::array<bool, 4>{}
                                         : known_zero_tangent(query_.pair.x(), query_.pair.y(), centre_);
    const auto is_known = [&](Parameter p) {
      const auto rational = std::count_if(through_centre_.begin(), through_centre_.end(),
                                          [&](const LineQuery& query) { return query.fixed == p; });
      return irrational_near_[index(p)] == 0 ||
             ((singular || zero[index(p)]) && irrational_near_[index(p)] == 1 && rational == 0);
    };
    return others_.complete && std::all_of(all_parameters.begin(), all_parameters.end(), is_known) &&
           std::all_of(through_centre_.begin(), through_centre_.end(), [this](const LineQuery& query) {
             const LinePoints& line = query_.pair.fibre(query);
             return !line.incomplete &&
                    std::none_of(line.points.begin(), line.points.end(), [this](const CertifiedPoint& point) {
                      const ParameterBox at = point.refined_to(centre_width_).box();
                      return meet(at, region_) && distance(at, centre_.box()) > 0;
                    });
           });
  }

  /// No arc, or only such as lie on sides.
  static bool lies_on_sides(const StarNeighbourhood& star) {
    return std::all_of(star.ports.begin(), star.ports.end(),
                       [](const Port& port) { return !port.point.sides().empty(); });
  }

  void set_region(double halfwidth, double slab) {
    refine_centre(from_double(0x1p-30 * std::min(kNarrowLine * halfwidth, slab)));
    for (std::size_t j = 0; j < 4; ++j) {
      const bool along = line_ && j == index(*line_);  // so that the line leaves across this parameter
      const double h = j == index(sweep_) ? slab : along ? halfwidth * kNarrowLine : halfwidth;
      const Rational half = from_double(h);
      const Rational middle = short_near(centre_.box()[j].midpoint(), half);
      region_[j] = {std::max<Rational>(0, middle - half), std::min<Rational>(1, middle + half)};
    }
  }

  /// The faces of the box across the other three parameters hold no point of the intersection, apart from the
  /// line; those on sides of the squares need not be asked, no arc leaves the domain without a boundary
  /// point.
  bool lateral_faces_are_free() const {
    for (const Parameter p : all_parameters) {
      if (p == sweep_) {
        continue;
      }
      const std::size_t expected = p == line_ ? 1 : 0;  // the line itself
      for (const Rational& face : {region_[index(p)].lower, region_[index(p)].upper}) {
        if (face == 0 || face == 1) {
          continue;
        }
        const auto points = points_in_box({p, face}, expected);
        if (!points || points->size() != expected) {
          return false;
        }
      }
    }
    return true;
  }

  std::optional<StarNeighbourhood> with_ports() const {
    StarNeighbourhood star{centre_, sweep_, region_, {}, {}};
    const RationalInterval slab = star.box[index(sweep_)];
    const auto is_centre = [&](const Rational& end) { return at_.compare(end) == 0; };
    if (!lies_in(centre_.box(), star.box) || (is_centre(slab.lower) && slab.lower != 0) ||
        (is_centre(slab.upper) && slab.upper != 1)) {
      return std::nullopt;
    }
    for (const int side : {-1, 1}) {
      const Rational value = side < 0 ? slab.lower : slab.upper;
      if (is_centre(value)) {
        continue;
      }
      const auto points = points_in_box({sweep_, value}, kMostFibrePorts);
      if (!points) {
        return std::nullopt;
      }
      for (const CertifiedPoint& point : *points) {
        star.ports.push_back({point, sweep_, side});
      }
    }
    if (line_ && !add_line_ports(star)) {
      return std::nullopt;
    }
    return star;
  }

  bool add_line_ports(StarNeighbourhood& star) const {
    for (const int side : {-1, 1}) {
      const RationalInterval& ends = region_[index(*line_)];
      const Rational& face = side < 0 ? ends.lower : ends.upper;
      if (face == 0 || face == 1) {
        continue;  // the line begins in the centre
      }
      const auto points = points_in_box({*line_, face}, 1);
      if (!points || points->size() != 1 || !has_point_on_line(face)) {
        return false;
      }
      star.ports.push_back({points->front(), *line_, side});
    }
    return is_the_only_one_of_space();
  }

  /// Where the centre is given by a rational value along the line: that no other point of the box has its two
  /// parameters, so that the centre is the line's (docs/method.md, Lemma 6.2a).
  bool is_the_only_one_of_space() const {
    if (!query_.along || !query_.along->is_rational()) return true;
    const auto points = points_over(query_.along->rational());
    return std::count_if(points.begin(), points.end(), [&](const HalfRationalPoint& p) {
             return meet(p.point.refined_to(centre_width_).box(), region_);
           }) <= 1;
  }

  /// Solutions with the centre's value of the sweep parameter and this one of the parameter along the line.
  std::vector<HalfRationalPoint> points_over(const Rational& along) const {
    std::array<Rational, 2> at;
    at[index(sweep_) % 2] = at_.rational();
    at[index(*line_) % 2] = along;
    return half_rational_points(query_.pair.x(), query_.pair.y(), index(sweep_) < 2, at);
  }

  bool has_point_on_line(const Rational& along) const {
    const auto points = points_over(along);
    return std::any_of(points.begin(), points.end(),
                       [&](const HalfRationalPoint& p) { return surely_lies_in(p.point, region_); });
  }

  /// The points of a parameter line that lie in the box; empty if there are more than `most`, infinitely
  /// many, or if that cannot be decided.
  std::optional<std::vector<CertifiedPoint>> points_in_box(const LineQuery& query, std::size_t most) const {
    auto inside = line_points_in(query_.pair.x(), query_.pair.y(), query, region_);
    return inside && inside->size() <= most ? inside : std::nullopt;
  }

  const StarQuery& query_;
  OtherTurning others_;
  CertifiedPoint centre_;
  RealAlgebraic at_;
  Parameter sweep_;
  Rational room_;
  Rational slab_room_;
  std::optional<Parameter> line_;  // that runs along the line over `at`, if this lies on the other patch
  std::vector<LineQuery> through_centre_;       // turning values of other parameters that the centre has
  std::array<int, 4> irrational_near_{};        // turning values that cannot be told from the centre's
  Rational centre_width_ = power_of_two(-100);  // of the centre's box
  ParameterBox region_;
};

}  // namespace

std::optional<StarNeighbourhood> star_neighbourhood(const StarQuery& query, const CertifiedPoint& centre,
                                                    const RealAlgebraic& at) {
  return StarProof(query, centre, at).run();
}

}  // namespace exsect

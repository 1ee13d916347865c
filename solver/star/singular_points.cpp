#include "star/singular_points.h"

#include <exsect/solver/line_query.h>

#include <algorithm>
#include <cmath>

#include "answer/graph_builder.h"
#include "answer/parameter_box.h"
#include "eliminant/algebraic_fibre.h"
#include "line/exact_line_points.h"
#include "line/line_place.h"
#include "line/line_points_in.h"
#include "star/fine_width.h"
#include "star/line_crossing.h"
#include "star/on_contact.h"
#include "star/point_on_line.h"
#include "star/star_arc.h"
#include "star/symmetric_crossing.h"
#include "trace/bounded_vertex.h"
#include "trace/enclose.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

constexpr double kCloseArcs = 0x1p-6;
constexpr double kWideHalfwidth = 0x1p-13;
constexpr double kMostLayers = 1024;
constexpr double kLayersPerTolerance = 8;
/// Of algebraic values over which singular points are looked for. Those without a multiplicity are many.
constexpr int kHighestDegree = 8;
constexpr int kHighestDegreeUnweighted = 3;

template <class Ball>
class StarSearch {
 public:
  StarSearch(const SingularPointQuery& query, const PairSystem<Ball>& system)
      : query_(query), pair_(query.pair), system_(system) {}

  std::vector<StarNeighbourhood> run() {
    for (std::size_t i = 0; i < query_.places.boundary.size(); ++i) {
      const CertifiedPoint& point = query_.places.boundary[i];
      if (!stopped() && (query_.on_side_arc[i] ? may_be_singular(point) : needs_star(point))) {
        try_all_sweeps(point);
      }
    }
    for (const CertifiedPoint& point : query_.pinches) {
      if (!stopped() && !is_covered(point)) {
        try_rational_sweeps(point);
      }
    }
    if (no_point_is_singular()) {
      return std::move(stars_);
    }
    for (const Parameter sweep : all_parameters) {
      if (const auto& turning = pair_.turning(sweep)) {
        try_multiple_values(*turning);
      }
    }
    for (const Parameter sweep : all_parameters) {
      if (const auto& turning = pair_.turning(sweep)) {
        try_algebraic_values(*turning);
      }
    }
    for (const Parameter sweep : {Parameter::u, Parameter::v}) {
      const auto& turning = pair_.turning(sweep);
      if (turning && !turning->touching) {
        try_fixed_points(*turning);
      }
    }
    for (const Parameter sweep : all_parameters) {  // last: these stars are narrow
      if (const auto& turning = pair_.turning(sweep)) {
        try_points_on_lines(*turning);
        try_crossings_of_lines(*turning);
      }
    }
    return std::move(stars_);
  }

 private:
  bool stopped() const { return is_stopped(pair_.stop()); }

  /// A simple root of E lies under no singular point (method.md, Theorem 4.4).
  bool no_point_is_singular() const {
    const auto& turning = pair_.turning(query_.places.sampled);
    return turning && !turning->touching &&
           std::all_of(turning->values.begin(), turning->values.end(),
                       [](const TurningValue& value) { return value.multiplicity == 1; });
  }

  BallPoint<Ball> tangent_at(const CertifiedPoint& point) const {
    return Expansion<Ball>(system_, enclose<Ball>(point, fine_width())).tangent();
  }

  /// The tangent may vanish. At the end of an arc that lies on a side nothing else needs a star: the only
  /// curve through a regular point is analytic, and the arc's line contains it.
  bool may_be_singular(const CertifiedPoint& point) const {
    const BallPoint<Ball> tangent = tangent_at(point);
    return std::all_of(tangent.begin(), tangent.end(), [](const Ball& t) { return t.certain_sign() == 0; }) &&
           !is_on_contact(point);
  }

  /// An interior point where the tangent may vanish; a boundary point where it may lie in a side.
  bool needs_star(const CertifiedPoint& point) const {
    const BallPoint<Ball> tangent = tangent_at(point);
    if (point.sides().empty()) {
      return may_be_singular(point);
    }
    return std::any_of(
               point.sides().begin(), point.sides().end(),
               [&](const Side& side) { return tangent[index(side.parameter)].certain_sign() == 0; }) &&
           !is_on_contact(point);
  }

  bool is_on_contact(const CertifiedPoint& point) const {
    return exsect::is_on_contact(query_, system_, point);
  }

  bool is_covered(const CertifiedPoint& point) const {
    return std::any_of(stars_.begin(), stars_.end(),
                       [&](const StarNeighbourhood& star) { return surely_lies_in(point, star.box); });
  }
  bool is_covered(const ParameterBox& box) const {
    return std::any_of(stars_.begin(), stars_.end(),
                       [&](const StarNeighbourhood& star) { return lies_in(box, star.box); });
  }

  /// The parameter lines over rational turning values under which a singular point may lie.
  static std::vector<LineQuery> rational_multiple_lines(const TurningValues& turning) {
    std::vector<LineQuery> lines;
    for (const TurningValue& value : turning.values) {
      if (value.multiplicity != 1 && value.value.is_rational()) {
        lines.push_back({turning.sweep, value.value.rational()});
      }
    }
    return lines;
  }

  void try_multiple_values(const TurningValues& turning) {
    for (const LineQuery& query : rational_multiple_lines(turning)) {
      if (stopped()) {
        return;
      }
      const LinePoints& fibre = pair_.fibre(query);
      for (const CertifiedPoint& point : fibre.points) {
        if (!stopped() && point.multiplicity() != 1 && !is_covered(point) && needs_star(point) &&
            !try_sweep(point, turning, query.value)) {
          try_all_sweeps(point);
        }
      }
    }
  }

  /// Singular points of which no parameter need be rational.
  void try_algebraic_values(const TurningValues& turning) {
    for (const TurningValue& value : turning.values) {
      const int highest = value.multiplicity > 1 ? kHighestDegree : kHighestDegreeUnweighted;
      if (value.multiplicity == 1 || value.value.is_rational() ||
          value.value.polynomial().degree() > highest || stopped()) {
        continue;
      }
      for (const SingularFibrePoint& point :
           singular_points_over(pair_.x(), pair_.y(), turning.sweep, value.value)) {
        if (!stopped() && !is_covered(point.at)) {
          try_sweep(point.at, turning, value.value, {}, &point);
        }
      }
    }
  }

  /// The points of lines that lie on the other patch, over turning values of the parameter along them.
  void try_points_on_lines(const TurningValues& turning) {
    for (const LineQuery& line : rational_multiple_lines(turning)) {
      if (stopped()) {
        return;
      }
      const LinePoints& fibre = pair_.fibre(line);
      const auto& along = pair_.turning(line_place(line).roles.line);
      if (fibre.on_patch.empty() || !along) {
        continue;
      }
      for (const TurningValue& event : along->values) {
        const bool on_line =
            std::any_of(fibre.on_patch.begin(), fibre.on_patch.end(), [&](const AlgebraicInterval& part) {
              return !(event.value < part.from) && !(part.to < event.value);
            });
        if (on_line && event.multiplicity != 1 && !stopped()) {
          try_point_on_line(turning, line, event.value);
        }
      }
    }
  }

  void try_point_on_line(const TurningValues& turning, const LineQuery& line, const RealAlgebraic& along) {
    for (const CertifiedPoint& point : points_on_line(pair_.x(), pair_.y(), line, along)) {
      if (!stopped() && !is_covered(point) && may_be_singular(point)) {  // else the line is all there is
        try_sweep(point, turning, line.value, along);
      }
    }
  }

  /// Points of lines over irrational turning values, irrational along the line as well.
  void try_crossings_of_lines(const TurningValues& turning) {
    const auto& along = pair_.turning(static_cast<Parameter>(index(turning.sweep) ^ 1U));
    for (const TurningValue& value : turning.values) {
      if (value.multiplicity == 1 || value.value.polynomial().degree() > kHighestDegree || !along ||
          stopped())
        continue;
      for (const LineCrossing& crossing :
           line_crossings(pair_.x(), pair_.y(), turning.sweep, value.value, *along)) {
        StarQuery query = star_query(turning);
        if (!stopped() && !is_covered(crossing.near))
          try_star(query, value.value, [&] { return line_crossing_star(query, crossing); });
      }
    }
  }

  /// Crossings with the curve that a symmetry fixes, of any degree.
  void try_fixed_points(const TurningValues& turning) {
    for (const TurningValue& value : turning.values) {
      // Lemma 6.4 asks for a finite fibre.
      if (value.multiplicity != 2 || value.value.is_rational() || stopped() || !pair_.symmetry() ||
          may_have_infinite_fibre(pair_.x(), pair_.y(), turning.sweep, value.value)) {
        continue;
      }
      const ExchangingSymmetry& symmetry = *pair_.symmetry();
      for (const CertifiedPoint& centre : fixed_points_over(symmetry, turning.sweep, value.value)) {
        StarQuery query = star_query(turning);
        if (!stopped() && !is_covered(centre) && may_be_singular(centre)) {
          try_star(query, value.value, [&] { return symmetric_crossing_star(query, symmetry, centre); });
        }
      }
    }
  }

  /// Over sides first, then over rational turning values.
  void try_all_sweeps(const CertifiedPoint& point) {
    for (const Side& side : point.sides()) {
      const auto& turning = pair_.turning(side.parameter);
      if (turning && try_sweep(point, *turning, side.value)) {
        return;
      }
    }
    const ParameterBox box = point.refined_to(fine_width()).box();
    for (const Parameter sweep : all_parameters) {
      const auto& turning = pair_.turning(sweep);
      if (!turning) {
        continue;
      }
      for (const TurningValue& value : turning->values) {
        if (value.value.is_rational() && value.value.rational() >= box[index(sweep)].lower &&
            value.value.rational() <= box[index(sweep)].upper &&
            try_sweep(point, *turning, value.value.rational())) {
          return;
        }
      }
    }
  }

  /// Over the values of its parameters that are known to be rational.
  void try_rational_sweeps(const CertifiedPoint& point) {
    for (const Parameter sweep : all_parameters) {
      const RationalInterval& at = point.box()[index(sweep)];
      const auto& turning = pair_.turning(sweep);
      if (at.width() == 0 && turning && try_sweep(point, *turning, at.lower)) {
        return;
      }
    }
  }

  bool try_sweep(const CertifiedPoint& point, const TurningValues& turning, const RealAlgebraic& at,
                 const std::optional<RealAlgebraic>& along = {},
                 const SingularFibrePoint* singular = nullptr) {
    StarQuery query = star_query(turning);
    query.along = along;
    query.singular = singular;
    return try_star(query, at, [&] { return star_neighbourhood(query, point, at); });
  }

  StarQuery star_query(const TurningValues& turning) const { return {pair_, query_.places, turning}; }

  /// Keeps a star over the value `at` that `proved`, which looks at query.largest_halfwidth, returns.
  bool try_star(StarQuery& query, const RealAlgebraic& at,
                const std::function<std::optional<StarNeighbourhood>()>& proved) {
    // As large as layers of exact fibres can bound the arcs: tracing from close to the centre is slow.
    const double first = std::clamp(8 * query_.tolerance, 0x1p-36, 0x1p-5);
    std::optional<StarNeighbourhood> star;
    std::optional<ParameterBox> outer;
    for (const double halfwidth : {std::max(first, kWideHalfwidth), first, first / 16, first / 512}) {
      query.largest_halfwidth = halfwidth;
      star = proved();
      if (!star) {
        return false;
      }
      if (!outer) outer = star->box;
      if ((halfwidth > first && !has_close_ports(*star)) || !is_disjoint(*star)) {
        continue;
      }
      const double slab = to_double(star->box[index(star->sweep)].width() / 2);
      const double layers = std::clamp(kLayersPerTolerance * slab / query_.tolerance, 1.0, kMostLayers);
      if (!add_layers(*star, pair_.x(), pair_.y(), at, static_cast<int>(layers), pair_.stop())) {
        return false;
      }
      if (arcs_keep_tolerance(*star)) {
        break;
      }
    }
    if (!is_disjoint(*star)) {
      return false;
    }
    star->outer = outer;
    stars_.push_back(*std::move(star));
    return true;
  }

  bool arcs_keep_tolerance(const StarNeighbourhood& star) const {
    const ModelFrame unit = {{0, 0, 0}, 0};
    return std::all_of(star.ports.begin(), star.ports.end(), [&](const Port& port) {
      const StarArc arc = star_arc(star, port);
      return std::all_of(arc.hulls.begin(), arc.hulls.end(), [&](const ParameterBox& hull) {
        return chord_bound(system_, unit, hull) <= 0.9 * query_.tolerance;
      });
    });
  }

  bool is_disjoint(const StarNeighbourhood& star) const {
    return std::none_of(stars_.begin(), stars_.end(),
                        [&](const StarNeighbourhood& other) { return meet(star.box, other.box); });
  }

  /// Two arcs leave so close to each other that tracing them from here takes many steps.
  static bool has_close_ports(const StarNeighbourhood& star) {
    const double slab = to_double(star.box[index(star.sweep)].width());
    for (std::size_t i = 0; i < star.ports.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        double apart = 0;
        for (std::size_t j = 0; j < 4; ++j) {
          apart = std::max(apart, std::fabs(to_double(star.ports[i].point.box()[j].midpoint() -
                                                      star.ports[k].point.box()[j].midpoint())));
        }
        if (apart < kCloseArcs * slab) {
          return true;
        }
      }
    }
    return false;
  }

  const SingularPointQuery& query_;
  ExactPair& pair_;
  const PairSystem<Ball>& system_;
  std::vector<StarNeighbourhood> stars_;
};

}  // namespace

template <class Ball>
std::vector<StarNeighbourhood> singular_stars(const SingularPointQuery& query,
                                              const PairSystem<Ball>& system) {
  return StarSearch<Ball>(query, system).run();
}

#define EXSECT_INSTANTIATE_SINGULAR(Ball) \
  template std::vector<StarNeighbourhood> singular_stars(const SingularPointQuery&, const PairSystem<Ball>&);

EXSECT_INSTANTIATE_SINGULAR(DoubleBall)
EXSECT_INSTANTIATE_SINGULAR(ArbBall<256>)
#undef EXSECT_INSTANTIATE_SINGULAR

}  // namespace exsect

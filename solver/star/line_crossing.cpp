#include "star/line_crossing.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "answer/exact_source.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "eliminant/algebraic_fibre.h"
#include "line/exact_line_points.h"
#include "line/line_points_in.h"
#include "star/fine_width.h"
#include "star/other_turning.h"
#include "trace/sheet_graph.h"

namespace exsect {

namespace {

constexpr int kSlabs = 12;
constexpr int kPointsOnLine = 17;  // more than a fibre has isolated points
constexpr std::size_t kMostPorts = 64;

constexpr int kNewtonSteps = 64;

/// The point of a graph over two algebraic numbers.
class GraphPointSource : public CertifiedPoint::Source {
 public:
  using Ball = ArbBall<256>;

  /// `first`: the parameter of the first number, 0 or 2; `system`: of its patch and the other one.
  GraphPointSource(std::array<RealAlgebraic, 2> over, std::size_t first, PairSystem<Ball> system,
                   SheetGraph graph)
      : over_(std::move(over)), first_(first), system_(std::move(system)), graph_(std::move(graph)) {}

  ParameterBox box(const Rational& width) const override {
    for (Rational fine = width / 16; fine > power_of_two(-240); fine /= 65536) {
      const std::array<RationalInterval, 2> over = {over_[0].refined_to(fine).interval(),
                                                    over_[1].refined_to(fine).interval()};
      const auto on_graph = point_over(over);
      ParameterBox result;
      bool fits = true;
      for (std::size_t k = 0; k < 2; ++k) {
        result[first_ + k] = over[k];
        result[2 - first_ + k] = on_graph[k];
        fits = fits && on_graph[k].width() <= width;
      }
      if (fits) return result;
    }
    ParameterBox where = whole_domain();
    for (std::size_t k = 0; k < 2; ++k) where[first_ + k] = over_[k].interval();
    throw ProofFailure(where, "a point on a graph cannot be enclosed so closely");
  }

 private:
  /// All points of the graph over the intervals: with the map g and its contraction c, |w - b| <= |g(b) - b|
  /// / (1 - c) for any b in the range.
  std::array<RationalInterval, 2> point_over(const std::array<RationalInterval, 2>& over) const {
    BallPoint<Ball> at{};
    for (std::size_t k = 0; k < 2; ++k) {
      at[k] = Ball::enclosing(over[k]);
      at[2 + k] = Ball::enclosing(graph_.range[k].midpoint());
    }
    std::array<Ball, 2> step = newton_step(at);
    for (int i = 0; i < kNewtonSteps; ++i) {
      BallPoint<Ball> next = at;
      for (std::size_t k = 0; k < 2; ++k) next[2 + k] = (at[2 + k] + step[k]).midpoint();
      if (!is_in_range(next)) break;
      const std::array<Ball, 2> smaller = newton_step(next);
      if (!(norm(smaller) < norm(step))) break;
      at = next;
      step = smaller;
    }
    const double distance = kSlack * norm(step) / (1 - graph_.contraction);
    std::array<RationalInterval, 2> result;
    for (std::size_t k = 0; k < 2; ++k)
      result[k] = at[2 + k].widened(kSlack * distance * graph_.width[k]).interval();
    return result;
  }

  std::array<Ball, 2> newton_step(const BallPoint<Ball>& at) const {
    const BallVector<Ball> f = Expansion<Ball>(system_, at).value();
    std::array<Ball, 2> step;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& c = graph_.combination[k];
      step[k] = Ball(c[0]) * f[0] + Ball(c[1]) * f[1] + Ball(c[2]) * f[2];
    }
    return step;
  }

  bool is_in_range(const BallPoint<Ball>& at) const {
    for (std::size_t k = 0; k < 2; ++k) {
      const RationalInterval i = at[2 + k].interval();
      if (i.lower < graph_.range[k].lower || i.upper > graph_.range[k].upper) return false;
    }
    return true;
  }

  double norm(const std::array<Ball, 2>& step) const {
    return kSlack * larger_bound(step[0].upper_magnitude() / graph_.width[0],
                                 step[1].upper_magnitude() / graph_.width[1]);
  }

  std::array<RealAlgebraic, 2> over_;
  std::size_t first_;
  PairSystem<Ball> system_;
  SheetGraph graph_;
};

/// The conditions of Lemma 6.3.
class LineCrossingProof {
 public:
  LineCrossingProof(const StarQuery& query, const LineCrossing& crossing)
      : query_(query),
        others_(other_turning(query.pair, query.turning.sweep)),
        crossing_(crossing),
        sweep_(query.turning.sweep),
        along_(static_cast<Parameter>(index(sweep_) ^ 1U)),
        first_other_(index(sweep_) < 2 ? 2 : 0),
        scale_(model_scale(query.pair.x(), query.pair.y())) {}

  std::optional<StarNeighbourhood> run() {
    if (!others_.complete) return std::nullopt;
    for (double half = query_.largest_halfwidth; half >= 0x1p-40; half *= 0x1p-6) {
      double slab = half;
      for (int i = 0; i < kSlabs; ++i, slab *= 0.25) {
        if (is_stopped(query_.pair.stop())) return std::nullopt;
        if (!set_box(slab, half)) break;
        if (!has_one_event()) break;
        StarNeighbourhood star{centre(), sweep_, box_, {}, {}};
        if (!add_ports_on_line(star)) continue;
        if (!add_ports(star) || star.ports.size() < 3 || !lies_on_other_patch()) return std::nullopt;
        return star;
      }
    }
    return std::nullopt;
  }

 private:
  const BezierPatch& own() const { return first_other_ == 2 ? query_.pair.x() : query_.pair.y(); }
  const BezierPatch& other() const { return first_other_ == 2 ? query_.pair.y() : query_.pair.x(); }

  /// A box in which all solutions are on a graph over the sweep parameter and the one along the line.
  bool set_box(double slab, double half) {
    SearchRegion region{};
    const auto middle = [&](Parameter p) { return to_double(crossing_.near[index(p)].midpoint()); };
    const auto set = [&](Parameter p, double reach) {
      region.lower[index(p) % 2] = middle(p) - reach;
      region.upper[index(p) % 2] = middle(p) + reach;
      box_[index(p)] = {from_double(middle(p) - reach), from_double(middle(p) + reach)};
    };
    set(sweep_, slab);
    set(along_, half);
    for (std::size_t k = 0; k < 2; ++k)
      region.lower[2 + k] = region.upper[2 + k] = to_double(crossing_.near[first_other_ + k].midpoint());
    graph_ = graph_over(PairSystem<DoubleBall>(own(), other(), scale_.origin, scale_.frame.exponent), region);
    if (!graph_) return false;
    for (std::size_t k = 0; k < 2; ++k) box_[first_other_ + k] = graph_->range[k];
    const bool inside = std::all_of(box_.begin(), box_.end(),
                                    [](const RationalInterval& i) { return i.lower > 0 && i.upper < 1; });
    return inside && is_in(crossing_.value, box_[index(sweep_)]) &&
           is_in(crossing_.along, box_[index(along_)]);
  }

  /// The box holds no point of a side or over a sample, and of the turning values of each parameter one at
  /// most, of α's and β's parameters these.
  bool has_one_event() const {
    const auto meets_box = [&](const CertifiedPoint& p) {
      return meet(p.refined_to(fine_width()).box(), box_);
    };
    const auto is_sampled = [&](const Rational& sample) {
      return is_in(sample, box_[index(query_.places.sampled)]);
    };
    const auto has_one_value = [&](const TurningValues* turning) {
      return std::count_if(turning->values.begin(), turning->values.end(), [&](const TurningValue& value) {
               return is_in(value.value, box_[index(turning->sweep)]);
             }) <= 1;
    };
    return std::none_of(query_.places.boundary.begin(), query_.places.boundary.end(), meets_box) &&
           std::none_of(query_.places.samples.begin(), query_.places.samples.end(), is_sampled) &&
           has_one_value(&query_.turning) &&
           std::all_of(others_.values.begin(), others_.values.end(), has_one_value);
  }

  CertifiedPoint centre() const {
    const bool swapped = index(sweep_) % 2 == 1;
    const std::array<RealAlgebraic, 2> over = {swapped ? crossing_.along : crossing_.value,
                                               swapped ? crossing_.value : crossing_.along};
    const PairSystem<ArbBall<256>> system(own(), other(), scale_.origin, scale_.frame.exponent);
    return {std::make_shared<GraphPointSource>(over, 2 - first_other_, system, *graph_),
            power_of_two(-100),
            {},
            0,
            0};
  }

  bool is_on_line(const CertifiedPoint& point) const {
    const auto exact = point.exact();
    return exact && takes_value(*exact, index(sweep_), crossing_.value);
  }

  /// The line leaves across the parameter along it, and nothing else does.
  bool add_ports_on_line(StarNeighbourhood& star) const {
    for (const int side : {-1, 1}) {
      const RationalInterval& range = box_[index(along_)];
      const auto points = line_points_in(query_.pair.x(), query_.pair.y(),
                                         {along_, side < 0 ? range.lower : range.upper}, box_);
      if (!points || points->size() != 1 || !is_on_line(points->front())) return false;
      star.ports.push_back({points->front(), along_, side});
    }
    return true;
  }

  bool add_ports(StarNeighbourhood& star) const {
    for (const int side : {-1, 1}) {
      const RationalInterval& range = box_[index(sweep_)];
      const auto points = line_points_in(query_.pair.x(), query_.pair.y(),
                                         {sweep_, side < 0 ? range.lower : range.upper}, box_);
      if (!points || points->size() > kMostPorts) return false;
      for (const CertifiedPoint& point : *points) star.ports.push_back({point, sweep_, side});
    }
    return true;
  }

  /// The fibre over α has more points than isolated ones: it contains a curve, which is the line, all along
  /// the box.
  bool lies_on_other_patch() const {
    const RationalInterval& range = box_[index(along_)];
    const Rational step = range.width() / (kPointsOnLine + 1);
    for (int i = 1; i <= kPointsOnLine; ++i) {
      const Rational at = range.lower + i * step;
      const auto points = line_points_in(query_.pair.x(), query_.pair.y(),
                                         {along_, simplest_between(at - step / 4, at + step / 4)}, box_);
      if (!points || std::none_of(points->begin(), points->end(),
                                  [&](const CertifiedPoint& p) { return is_on_line(p); }))
        return false;
    }
    return true;
  }

  const StarQuery& query_;
  OtherTurning others_;
  const LineCrossing& crossing_;
  Parameter sweep_;
  Parameter along_;
  std::size_t first_other_;  // parameter of the other patch
  ModelScale scale_;
  ParameterBox box_;
  std::optional<SheetGraph> graph_;  // over the parameters of the patch with the line
};

}  // namespace

std::vector<LineCrossing> line_crossings(const BezierPatch& x, const BezierPatch& y, Parameter sweep,
                                         const RealAlgebraic& value, const TurningValues& along) {
  std::vector<LineCrossing> result;
  if (value.is_rational() || !may_have_infinite_fibre(x, y, sweep, value)) return result;
  const RationalInterval fine = value.refined_to(fine_width()).interval();
  for (const TurningValue& other : along.values) {
    if (other.multiplicity == 1 || other.value.is_rational()) continue;
    const RationalInterval at = other.value.refined_to(power_of_two(-60)).interval();
    for (const CertifiedPoint& point : exact_line_points(x, y, {along.sweep, at.lower}).points) {
      ParameterBox near = point.refined_to(fine_width()).box();
      if (gap(near[index(sweep)], fine) > 0) continue;
      const auto exact = point.exact();
      if (!exact || !takes_value(*exact, index(sweep), value)) continue;
      near[index(along.sweep)] = at;
      result.push_back({value, other.value, std::move(near)});
    }
  }
  return result;
}

std::optional<StarNeighbourhood> line_crossing_star(const StarQuery& query, const LineCrossing& crossing) {
  return LineCrossingProof(query, crossing).run();
}

}  // namespace exsect

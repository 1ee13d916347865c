#include "side/line_arcs.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <memory>

#include "curve/plane_curve.h"
#include "line/line_curve.h"
#include "line/line_point.h"
#include "line/line_system.h"
#include "line/system_point.h"
#include "side/collapsed_line.h"
#include "side/ribbon_trace.h"
#include "side/shared_line_arcs.h"

namespace exsect {

namespace {

constexpr int kMostRuns = 64;
constexpr const char* kWorkCap = "the work cap was reached";
constexpr int kMostHalvings = 6;

class LineArcSearch {
 public:
  LineArcSearch(const BezierPatch& x, const BezierPatch& y, const LineQuery& query, const ModelScale& scale,
                double tolerance, const StopRequest& stop, bool thorough)
      : place_(line_place(query)),
        problem_(line_and_patch(x, y, query)),
        owner_(index(query.fixed) < 2 ? x : y),
        scale_(scale),
        tolerance_(tolerance),
        stop_(stop),
        thorough_(thorough) {}

  LineArcs run() {
    system_ = std::make_shared<const LineSystem>(line_system(problem_));
    const BivariatePolynomial shared = gcd(system_->first, system_->second);
    if (shared.is_zero()) return failed("the whole other patch lies on the line");
    if (shared.degree_r() <= 0 && shared.degree_s() <= 0) return {};
    const BivariatePolynomial curve = squarefree(shared);
    const BivariatePolynomial constant = gcd(curve, jacobian(curve, system_->lambda));
    find_collapsed(constant);
    moving_ = exact_quotient(curve, constant);
    if (moving_.degree_r() <= 0 && moving_.degree_s() <= 0) return std::move(result_);
    if (!find_events()) return failed(kWorkCap);
    trace_lines();
    for (std::size_t i = 0; i + 1 < values_.size() && !result_.incomplete; ++i) trace_over_gap(i);
    return std::move(result_);
  }

 private:
  LineArcs failed(const char* why) {
    result_.incomplete = why;
    return std::move(result_);
  }

  /// What needs no tracing; moving_ is the rest.
  void trace_lines() {
    const LinesOfCurve lines = rational_lines(moving_);
    result_.arcs = arcs_on_lines(place_, problem_.patch, system_, lines, events_, result_.ends, tolerance_);
    moving_ = lines.rest;
    if (moving_.degree_r() <= 0 && moving_.degree_s() <= 0) values_.clear();
  }

  static BivariatePolynomial shifted(const BivariatePolynomial& f, const Rational& c) {
    return f - BivariatePolynomial::constant(c);
  }

  bool in_range(const TriangularPoint& p) const {
    const RationalInterval range = lambda_range(*system_);
    return sign_at(shifted(system_->lambda, range.lower), p) >= 0 &&
           sign_at(shifted(system_->lambda, range.upper), p) <= 0;
  }

  /// The lines s = const and r = const of the curve on which lambda is constant.
  void find_collapsed(const BivariatePolynomial& constant) {
    const ContentAndPart in_s = split_content(constant);
    const ContentAndPart in_r = split_content(in_s.primitive.exchanged());
    if (!component_points(squarefree(in_r.primitive)).empty())
      result_.incomplete = "a curve of the other patch's parameters that is no parameter line is one point";
    if (in_s.content.degree() > 0)
      for (const RealAlgebraic& s : real_roots(in_s.content, 0, 1))
        add_collapsed(place_.roles.second, s,
                      TriangularPoint(s, BivariatePolynomial::r(), RationalInterval{0, 0}));
    if (in_r.content.degree() > 0)
      for (const RealAlgebraic& r : real_roots(in_r.content, 0, 1)) {
        const std::vector<TriangularPoint> at =
            roots_at(BivariatePolynomial({in_r.content}).exchanged(), RealAlgebraic(0), 0, 1);
        for (const TriangularPoint& p : at)
          if (value_at(BivariatePolynomial::r(), p) == r) add_collapsed(place_.roles.first, r, p);
      }
  }

  void add_collapsed(Parameter fixed, const RealAlgebraic& value, const TriangularPoint& at) {
    if (!in_range(at)) return;
    const RealAlgebraic lambda = value_at(system_->lambda, at);
    for (const MonotonePiece& piece : system_->pieces)
      if (lambda.compare(piece.lambda.lower) >= 0 && lambda.compare(piece.lambda.upper) <= 0)
        result_.collapsed.push_back({preimage(system_->phi, piece, lambda), fixed, value});
  }

  /// Events: where an arc may begin or end, or is not regular; on a piece of the line, also where the piece
  /// ends. False if the work must stop.
  bool find_events() {
    std::vector<TriangularPoint> points;
    const auto append = [&](const std::vector<TriangularPoint>& more) {
      for (const TriangularPoint& p : more) {
        const auto same = [&](const TriangularPoint& q) { return same_point(p, q); };
        if (!is_stopped(stop_) && in_range(p) && std::none_of(points.begin(), points.end(), same))
          points.push_back(p);
      }
    };
    append(side_points(moving_));
    append(common_points(moving_, jacobian(moving_, system_->lambda)));
    const std::size_t on_all_pieces = points.size();
    for (const Rational& end : piece_ends()) append(common_points(moving_, shifted(system_->lambda, end)));
    const RationalInterval range = lambda_range(*system_);
    values_ = {RealAlgebraic(range.lower), RealAlgebraic(range.upper)};
    std::vector<RealAlgebraic> value_of_end;
    for (std::size_t i = 0; i < points.size() && !is_stopped(stop_); ++i) {
      values_.push_back(value_at(system_->lambda, points[i]));
      add_event(points[i], i < on_all_pieces);
      value_of_end.resize(result_.ends.size(), values_.back());
    }
    separate(result_.ends);
    std::sort(values_.begin(), values_.end());
    values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
    for (const RealAlgebraic& value : value_of_end) {
      const auto place = std::lower_bound(values_.begin(), values_.end(), value);
      value_of_end_.push_back(static_cast<std::size_t>(place - values_.begin()));
    }
    return !is_stopped(stop_);
  }

  /// lambda at the ends of the monotone pieces.
  std::vector<Rational> piece_ends() const {
    std::vector<Rational> ends;
    for (const MonotonePiece& piece : system_->pieces) {
      ends.push_back(piece.lambda.lower);
      ends.push_back(piece.lambda.upper);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  void add_event(const TriangularPoint& p, bool on_all_pieces) {
    const std::vector<std::size_t> pieces = pieces_at(*system_, p);
    std::vector<CertifiedPoint> points = certified(p);
    const auto has_lambda = [&](const Rational& value) {
      return sign_at(shifted(system_->lambda, value), p) == 0;
    };
    const bool at_turn = system_->pieces.size() > 1 && has_lambda(system_->phi(system_->pieces[0].t.upper));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const RationalInterval& ends = system_->pieces[pieces[i]].lambda;
      if (!on_all_pieces && !has_lambda(ends.lower) && !has_lambda(ends.upper)) continue;
      events_.push_back({p, result_.ends.size(), pieces[i], at_turn});
      result_.ends.push_back(std::move(points[i]));
    }
  }

  std::vector<CertifiedPoint> certified(const TriangularPoint& p) const {
    return system_points(place_, system_, p, Polynomial(), initial_width());
  }

  /// Between neighbouring values the curve is a covering: every arc over the gap has a point over the sample.
  void trace_over_gap(std::size_t i) {
    const Rational sample = rational_between(values_[i], values_[i + 1]);
    for (const CertifiedPoint& inside : points_over(sample)) {
      if (result_.incomplete) return;
      trace_through(inside, i);
    }
  }

  std::vector<CertifiedPoint> points_over(const Rational& lambda) const {
    std::vector<CertifiedPoint> points;
    for (const TriangularPoint& p : common_points(moving_, shifted(system_->lambda, lambda)))
      for (CertifiedPoint& point : certified(p)) points.push_back(std::move(point));
    return points;
  }

  /// Whether the event is over an end of this gap.
  bool is_beside(std::size_t event, std::size_t gap) const {
    const std::size_t value = value_of_end_[event];
    return value == gap || value == gap + 1;
  }

  /// The arc through a point over a gap, if it begins there: lambda is strictly monotone along an arc, which
  /// has one point over each gap that it crosses. (Several arcs can begin in one event, at a fold.)
  void trace_through(const CertifiedPoint& inside, std::size_t gap) {
    auto back = run_from(inside, -1);
    if (back && !is_beside(back->end, gap)) return;
    const auto ahead = back ? run_from(inside, 1) : std::nullopt;
    if (!ahead) {
      result_.incomplete = "a part of the line on the patch could not be traced: " + why_;
      return;
    }
    std::vector<PolylineVertex> polyline(back->polyline.rbegin(), back->polyline.rend());
    polyline.insert(polyline.end(), ahead->polyline.begin() + 1, ahead->polyline.end());
    for (PolylineVertex& vertex : polyline) {
      const std::array<double, 4> p = vertex.parameters;
      vertex.parameters[index(place_.roles.fixed)] = to_double(place_.value);
      vertex.parameters[index(place_.roles.line)] = p[0];
      vertex.parameters[index(place_.roles.first)] = p[2];
      vertex.parameters[index(place_.roles.second)] = p[3];
    }
    back->hulls.insert(back->hulls.end(), ahead->hulls.begin(), ahead->hulls.end());
    result_.arcs.push_back({back->end, ahead->end, inside, std::move(polyline),
                            larger_bound(back->error_bound, ahead->error_bound), std::move(back->hulls)});
  }

  /// From a point to the next event, t falling or rising: in one run, or in shorter ones on ribbons of their
  /// own.
  std::optional<RibbonRun> run_from(CertifiedPoint at, int direction) {
    RibbonRun all{0, {}, 0, {}};
    for (int runs = 0; runs < kMostRuns; ++runs) {
      std::vector<CertifiedPoint> targets;
      const auto run = next_run(at, direction, targets);
      if (!run) return std::nullopt;
      all.polyline.insert(all.polyline.end(), run->polyline.begin() + (runs == 0 ? 0 : 1),
                          run->polyline.end());
      all.error_bound = larger_bound(all.error_bound, run->error_bound);
      all.hulls.insert(all.hulls.end(), run->hulls.begin(), run->hulls.end());
      all.end = run->end;
      if (run->end < result_.ends.size()) return all;
      at = targets[run->end - result_.ends.size()];
    }
    return std::nullopt;
  }

  std::optional<RibbonRun> next_run(const CertifiedPoint& at, int direction,
                                    std::vector<CertifiedPoint>& targets) {
    const Rational here = at.box()[index(place_.roles.line)].midpoint();
    const Rational limit = direction > 0 ? 1 : 0;
    if (here == limit) return std::nullopt;
    const RibbonTracer tracer(place_, problem_, owner_, scale_, tolerance_, stop_);
    for (int halvings = 0; halvings < kMostHalvings; ++halvings) {
      if (is_stopped(stop_)) {
        why_ = kWorkCap;
        return std::nullopt;
      }
      const Rational step = (limit - here) * power_of_two(-halvings);
      const Rational there =
          halvings == 0 ? limit : simplest_between(here + step - abs(step) / 8, here + step + abs(step) / 8);
      targets.clear();
      if (halvings > 0) targets = points_over(system_->phi(there));
      for (const RibbonNormal& normal : tracer.normals(at, here, there))
        if (auto run =
                kept(tracer.run<DoubleBall>(at, direction, result_.ends, targets, normal, power_of_two(-50))))
          return run;
    }
    if (!thorough_) return std::nullopt;
    targets.clear();
    return kept(tracer.run<ArbBall<256>>(at, direction, result_.ends, targets,
                                         tracer.normals(at, here, limit).front(), power_of_two(-200)));
  }

  /// The run, or none and its reason kept.
  std::optional<RibbonRun> kept(std::variant<RibbonRun, std::string> outcome) {
    if (auto* why = std::get_if<std::string>(&outcome)) {
      why_ = std::move(*why);
      return std::nullopt;
    }
    return std::get<RibbonRun>(std::move(outcome));
  }

  LinePlace place_;
  LineAndPatch problem_;
  const BezierPatch& owner_;
  const ModelScale& scale_;
  double tolerance_;
  const StopRequest& stop_;
  bool thorough_;
  std::shared_ptr<const LineSystem> system_;
  BivariatePolynomial moving_;  // the curve without the parts where lambda is constant
  std::vector<LineEvent> events_;
  std::vector<RealAlgebraic> values_;      // lambda at the events and at both ends
  std::vector<std::size_t> value_of_end_;  // for each of result_.ends
  std::string why_;
  LineArcs result_;
};

}  // namespace

LineArcs line_arcs(const BezierPatch& x, const BezierPatch& y, const LineQuery& query,
                   const ModelScale& scale, double tolerance, const StopRequest& stop, bool thorough) {
  if (shape(line_and_patch(x, y, query).line) == LineShape::point) return arcs_of_collapsed_line(x, y, query);
  return LineArcSearch(x, y, query, scale, tolerance, stop, thorough).run();
}

}  // namespace exsect

#include "lift/space_trace.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "lift/local_polynomial.h"
#include "lift/space_tube.h"

namespace exsect {
namespace {

std::array<double, 3> rounded(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

class SpaceTracer {
 public:
  SpaceTracer(const TraceProblem& problem, std::size_t start, int sense)
      : problem_(problem),
        start_(start),
        sense_(sense),
        link_radius_(std::ldexp(1.0, std::ilogb(problem.extent) - 90)),
        step_(problem.extent / 32),
        at_(problem.landmarks[start]) {
    add_vertex(at_);
  }

  SpaceTrace run() {
    constexpr std::size_t most_vertices = 100000;
    while (trace_.points.size() < most_vertices && step_ > problem_.extent * 0x1p-60) {
      interruption_point();
      if (!advance()) {
        step_ /= 2;
        continue;
      }
      if (is_over_) return std::move(trace_);
    }
    throw ProofFailure(whole_domain(), "an arc in space is not enclosed");
  }

 private:
  /// Another tube; false if the step is too long.
  bool advance() {
    const std::optional<SpaceZero> next = next_link();
    if (!next) return false;
    const std::optional<SpaceTube> tube = SpaceTube::around(problem_.f, problem_.g, at_.centre, next->centre);
    if (!tube || tube->place_of(at_) != SpaceTube::Place::inside ||
        tube->place_of(*next) != SpaceTube::Place::inside || tube->order(*next, at_, sense_) != 1)
      return false;
    std::optional<std::size_t> landmark;
    if (!find_landmark(*tube, landmark)) return false;
    const SpaceZero& end = landmark ? problem_.landmarks[*landmark] : *next;
    const double error = tube->distance_to_chord(at_.centre, end.centre) + 4 * (at_.radius + end.radius);
    if (!(error <= problem_.tolerance)) return false;
    trace_.error_bound = larger_bound(trace_.error_bound, (error + rounding_) * kSlack);
    at_ = end;
    add_vertex(at_);
    if (landmark) trace_.end = *landmark;
    is_over_ = landmark.has_value();
    step_ *= std::clamp(0.8 * std::sqrt(problem_.tolerance / error), 0.5, 2.0);
    step_ = std::min(step_, problem_.extent / 8);
    return true;
  }

  /// The point of the curve in the plane orthogonal to an axis about a step ahead.
  std::optional<SpaceZero> next_link() const {
    const SpaceBalls f = LocalPolynomial(problem_.f, at_.centre).gradient();
    const SpaceBalls g = LocalPolynomial(problem_.g, at_.centre).gradient();
    std::array<double, 3> tangent;
    std::size_t axis = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      tangent[k] = (f[i] * g[j] - f[j] * g[i]).approximation() * sense_;
      if (std::fabs(tangent[k]) > std::fabs(tangent[axis])) axis = k;
    }
    const double length = std::hypot(tangent[0], tangent[1], tangent[2]);
    Point guess = at_.centre;
    for (std::size_t k = 0; k < 3; ++k) {
      const double move = step_ * tangent[k] / length;
      if (!std::isfinite(move)) return std::nullopt;
      guess[k] += from_double(move);
    }
    const SpacePolynomial plane = SpacePolynomial::variable(axis) - SpacePolynomial::constant(guess[axis]);
    return space_zero({problem_.f, problem_.g, plane}, guess, link_radius_);
  }

  /// The first landmark in the tube ahead; false if that is not known.
  bool find_landmark(const SpaceTube& tube, std::optional<std::size_t>& first) const {
    for (std::size_t i = 0; i < problem_.landmarks.size(); ++i) {
      if (i == start_) continue;
      const SpaceZero& landmark = problem_.landmarks[i];
      const SpaceTube::Place place = tube.place_of(landmark);
      if (place == SpaceTube::Place::unknown) return false;
      if (place == SpaceTube::Place::outside) continue;
      if (tube.order(landmark, at_, sense_) != 1) return false;
      const int before = first ? tube.order(problem_.landmarks[*first], landmark, sense_) : 1;
      if (before == 0) return false;
      if (before > 0) first = i;
    }
    return true;
  }

  void add_vertex(const SpaceZero& zero) {
    trace_.points.push_back(rounded(zero.centre));
    for (const double coordinate : trace_.points.back())
      rounding_ = larger_bound(rounding_, std::fabs(coordinate) * 0x1p-50);
  }

  const TraceProblem& problem_;
  std::size_t start_;
  int sense_;
  double link_radius_;
  double step_;
  SpaceZero at_;
  SpaceTrace trace_{0, {}, 0};
  double rounding_ = 0;
  bool is_over_ = false;
};

}  // namespace

SpaceTrace space_trace(const TraceProblem& problem, std::size_t start, int sense) {
  return SpaceTracer(problem, start, sense).run();
}

}  // namespace exsect

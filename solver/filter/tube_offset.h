// Places along a tube of doubles. Internal to solver/; docs/method-doubles.md, section 14.3.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <cmath>

#include "filter/boundary.h"
#include "filter/error_bounds.h"
#include "filter/tube.h"
#include "trace/tube_trace.h"

namespace exsect::filter {

/// A number within `doubt` of `value`: an offset, or the difference of two, as the tracer compares them.
class TubeOffset {
 public:
  explicit TubeOffset(double value, double doubt = 0) : value_(value), doubt_(doubt) {}

  double approximation() const { return value_; }
  /// 1 or -1 if the number certainly has this sign, else 0.
  int certain_sign() const {
    if (!(std::fabs(value_) > kSlack * doubt_)) return 0;
    return value_ > 0 ? 1 : -1;
  }
  double upper_magnitude() const { return kSlack * (std::fabs(value_) + doubt_); }

  /// The rounding is within the doubts of measured offsets; the sign of a difference of doubles is exact.
  friend TubeOffset operator-(const TubeOffset& a, const TubeOffset& b) {
    return TubeOffset(a.value_ - b.value_, a.doubt_ + b.doubt_);
  }

 private:
  double value_;
  double doubt_;
};

/// Of all points of the curve in the ball.
template <class K>
TubeOffset offset(const TubeOf<K>& tube, const BallOf<K>& ball) {
  return TubeOffset(ball.middle[tube.axis] - tube.centre[tube.axis], ball.radius + kPlacing);
}

// What the tracer asks of a ball (trace/tube_tracer.h).
template <class K>
const BallOf<K>& landmark_box(const BoundaryPointOf<K>& point) {
  return point.ball;
}
/// Boundary points are all landmarks: the curve does not leave the domain but through one.
template <class K>
bool may_be_in_domain(const BallOf<K>&) {
  return true;
}
template <class K>
TraceFailure trace_failure(const BallOf<K>& at, const char* why) {
  return {parameters_of(at), why};
}

}  // namespace exsect::filter

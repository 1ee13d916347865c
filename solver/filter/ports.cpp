#include "filter/ports.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

constexpr double kLeastPort = 0x1p-20;
constexpr int kMostChords = 64;
/// Of the radius of a boundary point's ball: tubes that start there, or come close, have some room.
constexpr double kRadiusShare = 0.75;
/// Control points of size 1 in each coordinate: |x_u|, |x_v| <= 4 sqrt 3 in the square.
constexpr double kFastest = 14;

/// One of the four arcs of a crossing.
class Branch {
 public:
  /// That on which coordinate `along` of t has the sign.
  Branch(const Pair& pair, const DoublePoint& point, std::size_t along, int sign)
      : pair_(pair), point_(point), along_(along), sign_(sign) {
    const LocalForms& f = point.forms;
    direction_ = {f.bs[0][along], f.bs[1][along], f.s[0][along], f.s[1][along]};
    across_ = {f.bs[0][1 - along], f.bs[1][1 - along], f.s[0][1 - along], f.s[1][1 - along]};
  }

  /// As far from the centre as a few chords allow: tracing from close to it is slow.
  std::optional<Port> port(double tolerance) const {
    for (double reach = 0.5 * point_.reach; reach >= kLeastPort; reach *= 0.5) {
      const auto slope = slope_bound(reach);
      if (!slope || !is_monotone(*slope)) {
        continue;
      }
      auto port = port_at(reach, turn_bound(reach, slope->across) / reach, tolerance);
      if (port) {
        return port;
      }
    }
    return std::nullopt;
  }

 private:
  /// Of the derivatives by t_along.
  struct Slope {
    double across;               // of the other coordinate of t
    std::array<double, 2> turn;  // how far c_t is from B S
  };

  // (14.22).
  std::optional<Slope> slope_bound(double reach) const {
    const auto bounds = local_bounds(point_.forms, reach);
    if (!bounds) {
      return std::nullopt;
    }
    const double rest = point_.forms.rest;
    const double least = 1 - kSlack * (bounds->slope * reach + 2 * rest);
    const double across = kSlack * ((bounds->value + bounds->slope) * reach + 3 * rest) / least;
    if (!(least > 0.25 && across < 0.5)) {
      return std::nullopt;
    }
    const auto turn = [&](std::size_t i) {
      return kSlack * (bounds->turn[i] * reach + 2 * point_.forms.bs_error[i]) * (1 + across);
    };
    return Slope{across, {turn(0), turn(1)}};
  }

  bool is_monotone(const Slope& slope) const {
    for (std::size_t j = 0; j < 4; ++j) {
      const double turn = j < 2 ? slope.turn[j] : 0;
      if (!(std::fabs(direction_[j]) > kSlack * (std::fabs(across_[j]) * slope.across + turn))) {
        return false;
      }
    }
    return true;
  }

  /// A bound of |Y' - Y'(0)| for the point of space on the arc. The derivative of r^i s^j is at most (i + j)
  /// |S|^(i+j) reach^(i+j-1).
  double turn_bound(double reach, double across) const {
    const Coefficients c = expand(pair_.y, point_.centre[2], point_.centre[3]);
    const double s0 = std::fabs(direction_[2]) + std::fabs(across_[2]);
    const double s1 = std::fabs(direction_[3]) + std::fabs(across_[3]);
    Vec3 change{};
    for (std::size_t i = 1; i < 9; ++i) {
      const auto order = static_cast<double>(i / 3 + i % 3);
      const double weight = order * std::pow(s0, i / 3) * std::pow(s1, i % 3) * std::pow(reach, order - 1);
      const double first = i == 3 ? across_[2] : across_[3];
      for (std::size_t k = 0; k < 3; ++k) {
        change[k] += std::fabs(c[i][k]) * (order > 1 ? weight : std::fabs(first) * across);
      }
    }
    return kSlack * (std::sqrt(dot(change, change)) + 16 * pair_.total_error);
  }

  /// A proved point of the curve on this arc.
  struct ArcPoint {
    Ball ball;
    double t;  // t_along, times the sign
    double error;
  };

  std::optional<ArcPoint> point_at(double t, double reach) const {
    const std::size_t axis = steepest(direction_);
    Vec4 guess = point_.centre;
    for (std::size_t j = 0; j < 4; ++j) {
      guess[j] += sign_ * t * direction_[j];
    }
    Tube tube;
    if (!improve(pair_, guess, axis, 6) || !prepare(pair_, guess, axis, tube)) {
      return std::nullopt;
    }
    const Vec3 residual = residual_bound(pair_, tube, 0);
    const double width = 8 * largest(residual) + 0x1p-36;
    if (!certify(pair_, tube, 0, 0, {width, width, width, width}, residual)) {
      return std::nullopt;
    }
    const Ball ball = filter::point_at(tube, 0);
    if (!holds(tube, ball)) {
      return std::nullopt;
    }
    const LocalPlace at =
        local_place(point_, ball.middle, {ball.radius, ball.radius, ball.radius, ball.radius});
    const ArcPoint result = {ball, sign_ * at.t[along_], at.error[along_]};
    return is_on(result, at, reach) ? std::optional(result) : std::nullopt;
  }

  /// The only solution on tau = 0 in the tube's region is the only one in the ball.
  static bool holds(const Tube& tube, const Ball& ball) {
    return std::all_of(tube.others.begin(), tube.others.end(), [&](std::size_t j) {
      return kSlack * (std::fabs(ball.middle[j] - tube.centre[j]) + ball.radius) <= tube.halfwidth[j];
    });
  }

  /// (14.23).
  std::optional<Port> port_at(double reach, double rate, double tolerance) const {
    Port port{{}, steepest(direction_), 0, {}, 0, 0};
    port.side = sign_ * direction_[port.parameter] > 0 ? -0.5 : 0.5;
    const double end = 0.95 * reach;
    if (!(rate * end * end < 2 * kMostChords * tolerance)) {
      return std::nullopt;
    }
    double last = 0;
    for (double t = 0; t < end;) {
      // rate t (t - last)/2 is a little less than the tolerance.
      t = std::min(end, 0.5 * (t + std::sqrt(t * t + 6.4 * tolerance / rate)));
      const auto point = point_at(t, reach);
      const auto slope = point ? slope_bound(point->t + point->error) : std::nullopt;
      if (!slope || !(point->t - point->error > last)) {
        return std::nullopt;
      }
      const double farthest = point->t + point->error;
      const double chord = kSlack * turn_bound(farthest, slope->across) * (farthest - last) / 2;
      if (!(chord <= tolerance)) {
        return std::nullopt;
      }
      port.chord = larger_bound(port.chord, chord);
      port.vertex_error = larger_bound(port.vertex_error, kSlack * kFastest * point->ball.radius);
      port.approach.push_back(point->ball.middle);
      port.ball = point->ball;
      last = point->t - point->error;
    }
    port.approach.pop_back();
    return port.ball.radius < kRadiusShare * 0.25 * kEndMargin<0> ? std::optional(std::move(port))
                                                                  : std::nullopt;
  }

  /// All of the ball, and of its hull with the centre, is inside the domain and in this arc's part of the
  /// region.
  bool is_on(const ArcPoint& p, const LocalPlace& at, double reach) const {
    const Ball& ball = p.ball;
    const bool inside = std::all_of(ball.middle.begin(), ball.middle.end(),
                                    [&](double w) { return std::fabs(w) + ball.radius < 0.5; });
    return inside && at.has_width && p.t - p.error > 0 && p.t + p.error <= reach &&
           std::fabs(at.t[1 - along_]) + at.error[1 - along_] < 0.5 * (p.t - p.error);
  }

  const Pair& pair_;
  const DoublePoint& point_;
  std::size_t along_;
  int sign_;
  Vec4 direction_;  // of the arc in the centre, and the other one, by t
  Vec4 across_;
};

}  // namespace

bool add_ports(const Pair& pair, DoublePoint& point, double tolerance) {
  for (std::size_t along = 0; along < 2 && point.forms.crossing; ++along) {
    for (const int sign : {-1, 1}) {
      auto port = Branch(pair, point, along, sign).port(tolerance);
      if (!port) {
        return false;
      }
      point.ports.push_back(std::move(*port));
    }
  }
  return true;
}

}  // namespace exsect::filter

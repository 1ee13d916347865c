#include "filter/ports.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/port_point.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

constexpr double kLeastPort = 0x1p-20;
constexpr int kMostChords = 64;
/// Times the total error of a patch: errors of derivatives by t on an arc, where |r|, |s| <= 2 reach <= 1.
constexpr double kErrorsAlong = 16;

/// The coefficients of y, moved so that y is about zero at the centre; and the errors of derivatives by t.
template <class K>
struct MovedPatch {
  CoefficientsOf<K> c;
  double error;

  MovedPatch(const PairOf<K>& pair, double h, double k) : c(expand(pair.y, h, k)) {
    if constexpr (K::weighted) {
      const Vec3 centre = affine(c[0]);
      for (Row<K>& row : c)
        for (std::size_t i = 0; i < 3; ++i) row[i] -= centre[i] * row[3];
      error = kSlack * 2 * (1 + largest(centre)) * kErrorsAlong * pair.y_total_error;
    } else {
      error = kErrorsAlong * pair.total_error;
    }
  }
};

template <class K>
double length_in_space(const Row<K>& row) {
  return std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2] + kTiny);
}

/// One of the four arcs of a crossing.
template <class K>
class Branch {
 public:
  /// That on which coordinate `along` of t has the sign.
  Branch(const PairOf<K>& pair, const DoublePointOf<K>& point, std::size_t along, int sign)
      : pair_(pair), point_(point), along_(along), sign_(sign) {
    const LocalFormsOf<K>& f = point.forms;
    direction_ = {f.bs[0][along], f.bs[1][along], f.s[0][along], f.s[1][along]};
    across_ = {f.bs[0][1 - along], f.bs[1][1 - along], f.s[0][1 - along], f.s[1][1 - along]};
  }

  /// Strictly monotone in all parameters at sides, as far as the region goes, (14.72).
  bool leaves_sides() const {
    const auto slope = slope_bound(point_.reach);
    if (!slope) return false;
    for (std::size_t j = 0; j < 4; ++j) {
      if (point_.on[j] != 0 && !moves(j, *slope)) return false;
    }
    return true;
  }
  /// Away from all of these sides to the inside.
  bool enters() const {
    for (std::size_t j = 0; j < 4; ++j) {
      if (point_.on[j] != 0 && (sign_ * direction_[j] > 0) == (point_.on[j] > 0)) return false;
    }
    return true;
  }

  /// As far from the centre as a few chords allow: tracing from close to it is slow.
  std::optional<PortOf<K>> port(double tolerance) const {
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
    const auto bounds = local_bounds<K>(point_.forms, reach);
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

  bool moves(std::size_t j, const Slope& slope) const {
    const double turn = j < 2 ? slope.turn[j] : 0;
    return std::fabs(direction_[j]) > kSlack * (std::fabs(across_[j]) * slope.across + turn);
  }
  bool is_monotone(const Slope& slope) const {
    return moves(0, slope) && moves(1, slope) && moves(2, slope) && moves(3, slope);
  }

  /// How far the derivative of the point of space on the arc is from a constant at most. The derivative of
  /// r^i s^j is at most (i + j) |S|^(i+j) reach^(i+j-1). Of weighted patches (14.46).
  double turn_bound(double reach, double across) const {
    const MovedPatch<K> y(pair_, point_.centre[2], point_.centre[3]);
    const double s0 = std::fabs(direction_[2]) + std::fabs(across_[2]);
    const double s1 = std::fabs(direction_[3]) + std::fabs(across_[3]);
    Row<K> change{};  // of the derivative of each coordinate
    for (std::size_t i = 1; i < K::count; ++i) {
      const auto order = static_cast<double>(i / K::side + i % K::side);
      const double weight =
          order * std::pow(s0, i / K::side) * std::pow(s1, i % K::side) * std::pow(reach, order - 1);
      const double first = i == kFirst<K> ? across_[2] : across_[3];
      for (std::size_t k = 0; k < K::rows; ++k) {
        change[k] += std::fabs(y.c[i][k]) * (order > 1 ? weight : std::fabs(first) * across);
      }
    }
    const double turn = length_in_space<K>(change) + y.error;
    if constexpr (K::weighted) {
      const Row<K> start = direction_[2] * y.c[kFirst<K>] + direction_[3] * y.c[kSecond];
      const double rate = kSlack * (std::fabs(start[3]) + change[3] + y.error);
      const double fastest = length_in_space<K>(start) + turn;
      const double least = y.c[0][3] - kSlack * (rate * reach + y.error);
      if (!(least > kLeastWeight)) return HUGE_VAL;
      return kSlack * (turn + rate * (2 * fastest * reach + y.error) / least) / least;
    } else {
      return kSlack * turn;
    }
  }

  /// A proved point of the curve on this arc.
  struct ArcPoint {
    BallOf<K> ball;
    double t;  // t_along, times the sign
    double error;
  };

  std::optional<ArcPoint> point_at(double t, double reach) const {
    const std::size_t axis = steepest(direction_);
    Vec4 place = point_.centre;
    for (std::size_t j = 0; j < 4; ++j) {
      place[j] += sign_ * t * direction_[j];
    }
    const auto ball = point_of_curve(pair_, place, axis);
    if (!ball) {
      return std::nullopt;
    }
    const LocalPlace at =
        local_place(point_, parameters_of(*ball), {ball->radius, ball->radius, ball->radius, ball->radius});
    const ArcPoint result = {*ball, sign_ * at.t[along_], at.error[along_]};
    return is_on(result, at, reach) ? std::optional(result) : std::nullopt;
  }

  /// (14.23).
  std::optional<PortOf<K>> port_at(double reach, double rate, double tolerance) const {
    PortOf<K> port{{}, steepest(direction_), 0, {}, 0, 0};
    port.side = sign_ * direction_[port.parameter] > 0 ? -0.5 : 0.5;
    const double end = 0.95 * reach;
    if (!(rate * end * end < 2 * kMostChords * tolerance)) {
      return std::nullopt;
    }
    port.vertex_error = vertex_error(pair_, point_.centre, 0);
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
      port.approach.push_back(parameters_of(point->ball));
      port.vertex_error =
          larger_bound(port.vertex_error, vertex_error(pair_, port.approach.back(), point->ball.radius));
      port.ball = point->ball;
      last = point->t - point->error;
    }
    port.approach.pop_back();
    return has_room(port.ball) && port.vertex_error < HUGE_VAL ? std::optional(std::move(port))
                                                               : std::nullopt;
  }

  /// All of the ball, and of its hull with the centre, is inside the domain and in this arc's part of the
  /// region.
  bool is_on(const ArcPoint& p, const LocalPlace& at, double reach) const {
    const Vec4 middle = parameters_of(p.ball);
    const bool inside = std::all_of(middle.begin(), middle.end(),
                                    [&](double w) { return std::fabs(w) + p.ball.radius < 0.5; });
    return inside && at.has_width && p.t - p.error > 0 && p.t + p.error <= reach &&
           std::fabs(at.t[1 - along_]) + at.error[1 - along_] < 0.5 * (p.t - p.error);
  }

  const PairOf<K>& pair_;
  const DoublePointOf<K>& point_;
  std::size_t along_;
  int sign_;
  Vec4 direction_;  // of the arc in the centre, and the other one, by t
  Vec4 across_;
};

/// The region meets no sides but those that the point is on.
template <class K>
bool is_away_from_others(const DoublePointOf<K>& point) {
  for (std::size_t j = 0; j < 4; ++j) {
    const double s = j < 2 ? 0 : std::fabs(point.forms.s[j - 2][0]) + std::fabs(point.forms.s[j - 2][1]);
    const double far = kSlack * ((j < 2 ? point.width[j] : s * point.reach) + kPlaceRounding);
    const double room = point.on[j] != 0 ? 1 : 0.5 - std::fabs(point.centre[j]);
    if (!(far < room)) return false;
  }
  return true;
}

}  // namespace

template <class K>
bool leaves_sides(const PairOf<K>& pair, const DoublePointOf<K>& point) {
  if (!point.forms.crossing || !is_on_side(point)) return true;
  const auto leaves = [&](std::size_t along) { return Branch<K>(pair, point, along, 1).leaves_sides(); };
  return is_away_from_others(point) && leaves(0) && leaves(1);
}

template <class K>
bool add_ports(const PairOf<K>& pair, DoublePointOf<K>& point, double tolerance) {
  for (std::size_t along = 0; along < 2 && point.forms.crossing; ++along) {
    for (const int sign : {-1, 1}) {
      const Branch<K> branch(pair, point, along, sign);
      if (!branch.enters()) continue;
      auto port = branch.port(tolerance);
      if (!port) {
        return false;
      }
      point.ports.push_back(std::move(*port));
    }
  }
  return true;
}

#define EXSECT_INSTANTIATE(K)                                               \
  template bool leaves_sides<K>(const PairOf<K>&, const DoublePointOf<K>&); \
  template bool add_ports<K>(const PairOf<K>&, DoublePointOf<K>&, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

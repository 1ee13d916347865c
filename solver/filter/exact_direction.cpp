#include "filter/exact_direction.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/homogeneous.h"
#include "filter/tube_columns.h"

namespace exsect::filter {

namespace {

constexpr int kNewtonSteps = 3;
/// Parameters as far beyond sides, and so much more, are in [-1/16,17/16], where sums of Bernstein
/// polynomials are at most (9/8)^n: (9/8)^(4 n) <= kSecondGrowth, n <= 3.
constexpr double kBeyondSides = 0x1p-5;
constexpr long kSecondGrowth = 5;

using Vector3 = std::array<Rational, 3>;

/// g_i = (X_i Y_4 - Y_i X_4)/n, i = 1, 2, 3, and its derivatives by u, v, r, s.
struct AffineDifference {
  Vector3 value;
  std::array<Vector3, 4> column;
};

Vector3 cross_ratio(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  return {minor(a, b, 0, 3), minor(a, b, 1, 3), minor(a, b, 2, 3)};
}

template <class K>
AffineDifference difference_at(const ExactPatch<K>& x, const ExactPatch<K>& y,
                               const std::array<Rational, 4>& w) {
  const FirstOrder<K> a(x, w[0], w[1]);
  const FirstOrder<K> b(y, w[2], w[3]);
  AffineDifference result;
  result.value = cross_ratio(a.value, b.value);
  for (Rational& g : result.value) g /= static_cast<long>(K::degree);
  for (std::size_t j = 0; j < 2; ++j) {
    result.column[j] = cross_ratio(a.derivative[j], b.value);
    result.column[2 + j] = cross_ratio(a.value, b.derivative[j]);
  }
  return result;
}

Rational greatest_size(const Vector3& v) { return std::max({abs(v[0]), abs(v[1]), abs(v[2])}); }

/// About the origin of the frame, in its unit.
template <class K>
ExactPatch<K> in_frame(const ExactPatch<K>& patch, const ModelFrame& frame) {
  ExactPatch<K> result = patch;
  const Rational unit = power_of_two(-frame.exponent);
  for (std::size_t k = 0; k < K::count; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      result.points[k][c] = unit * (patch.points[k][c] - patch.weights[k] * from_double(frame.origin[c]));
    }
  }
  return result;
}

template <class K>
Rational greatest_coordinate(const ExactPatch<K>& patch) {
  Rational most = 0;
  for (std::size_t k = 0; k < K::count; ++k) {
    for (const Rational& c : homogeneous<K>(patch, k)) most = std::max(most, Rational(abs(c)));
  }
  return most;
}

template <class K>
class ExactDirections {
 public:
  ExactDirections(const ExactPatch<K>& x, const ExactPatch<K>& y, const ModelFrame& frame)
      : x_(in_frame<K>(x, frame)),
        y_(in_frame<K>(y, frame)),
        second_(8 * static_cast<long>(K::degree) * kSecondGrowth * greatest_coordinate<K>(x_) *
                greatest_coordinate<K>(y_)) {}

  Direction<K> at(const TubeOf<K>& tube, double tau) const {
    const Direction<K> rounded = direction_at(tube, tau);
    auto point = point_of(tube, tau);
    if (!point || !approach(*point)) return rounded;
    Direction<K> result = rounded;
    for (int step = 0; step < kNewtonSteps; ++step) {
      const Vector3 rest = rest_of(*point, result.middle);
      for (std::size_t row = 0; row < 3; ++row) {
        double& d = result.middle[point->others[row]];
        d = to_double(from_double(d) - rest[row]);
      }
    }
    Rational size = 0;
    for (std::size_t j = 0; j < 4; ++j) size += abs(from_double(result.middle[j]));
    const Rational error =
        greatest_size(rest_of(*point, result.middle)) + point->norm * size * 4 * point->distance * second_;
    result.radius = kSlack * to_double(error / (1 - point->contraction)) + kTiny;
    return result.radius < rounded.radius ? result : rounded;
  }

 private:
  /// A point near the curve's, with the same parameter along the axis.
  struct Point4 {
    std::array<Rational, 4> w;
    std::array<std::size_t, 3> others;
    std::array<Vector3, 3> c;  // the rows of C
    Rational norm;             // the greatest row sum of |C|
    Rational radius;           // within which, about w, the curve's point is at first
    AffineDifference at;
    Rational contraction = 1;
    Rational distance = 0;  // bound of that from the curve's point
  };

  std::optional<Point4> point_of(const TubeOf<K>& tube, double tau) const {
    const BallOf<K> ball = point_at(tube, tau);
    Point4 point;
    for (std::size_t j = 0; j < 4; ++j) point.w[j] = from_double(ball.middle[j]) + Rational(1, 2);
    point.w[tube.axis] = from_double(tube.centre[tube.axis]) + from_double(tau) + Rational(1, 2);
    const bool is_near = std::all_of(ball.middle.begin(), ball.middle.begin() + 4,
                                     [](double t) { return std::fabs(t) < 0.5 + kBeyondSides; });
    if (!is_near || !(ball.radius < 0.5 * kBeyondSides)) return std::nullopt;
    point.radius = from_double(ball.radius);
    std::copy_n(kOthers<Biquadratic>[tube.axis].begin(), 3, point.others.begin());
    point.at = difference_at<K>(x_, y_, point.w);
    std::array<Vec3, 3> columns;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& column = point.at.column[point.others[k]];
      columns[k] = {to_double(column[0]), to_double(column[1]), to_double(column[2])};
    }
    std::array<Vec3, 3> rows;
    if (!invert(columns, rows)) return std::nullopt;
    point.norm = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) point.c[row][k] = from_double(rows[row][k]);
      const Rational sum = abs(point.c[row][0]) + abs(point.c[row][1]) + abs(point.c[row][2]);
      point.norm = std::max(point.norm, sum);
    }
    return point;
  }

  static Vector3 times_c(const Point4& point, const Vector3& v) {
    Vector3 result;
    for (std::size_t row = 0; row < 3; ++row) {
      const Vector3& c = point.c[row];
      result[row] = c[0] * v[0] + c[1] * v[1] + c[2] * v[2];
    }
    return result;
  }

  /// Newton's method with C, and the bounds: (14.8) on the ball of twice the radius.
  bool approach(Point4& point) const {
    const std::array<Rational, 4> start = point.w;
    for (int step = 0; step < kNewtonSteps; ++step) {
      const Vector3 v = times_c(point, point.at.value);
      for (std::size_t row = 0; row < 3; ++row) {
        Rational& w = point.w[point.others[row]];
        w -= from_double(to_double(v[row]));
        if (abs(Rational(w - start[point.others[row]])) > point.radius) return false;
      }
      point.at = difference_at<K>(x_, y_, point.w);
    }
    // Within the ball columns change by 4 * 2 radius * second_ at most.
    point.contraction = 3 * point.norm * 8 * point.radius * second_;
    Rational most = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      Rational sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 column = times_c(point, point.at.column[point.others[k]]);
        sum += abs(Rational(column[row] - (row == k ? 1 : 0)));
      }
      most = std::max(most, sum);
    }
    point.contraction += most;
    if (!(point.contraction < Rational(1, 2))) return false;
    point.distance = greatest_size(times_c(point, point.at.value)) / (1 - point.contraction);
    return true;
  }

  /// The sum of C g_j d_j.
  Vector3 rest_of(const Point4& point, const Unknowns<K>& d) const {
    Vector3 sum = {0, 0, 0};
    for (std::size_t j = 0; j < 4; ++j) {
      const Rational t = from_double(d[j]);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += t * point.at.column[j][k];
    }
    return times_c(point, sum);
  }

  ExactPatch<K> x_;
  ExactPatch<K> y_;
  /// Bound of all second derivatives of g_1, g_2, g_3: 8 n times products of coordinates, each
  /// with a factor (9/8)^(2 n).
  Rational second_;
};

}  // namespace

template <class K>
DirectionSource<K> exact_directions(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair) {
  const ExactDirections<K> directions(x, y, pair.frame);
  return [directions](const TubeOf<K>& tube, double tau) { return directions.at(tube, tau); };
}

#define EXSECT_INSTANTIATE(K)                                                                 \
  template DirectionSource<K> exact_directions<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                  const PairOf<K>&);
EXSECT_INSTANTIATE(Bicubic)
EXSECT_INSTANTIATE(WeightedBiquadratic)
EXSECT_INSTANTIATE(WeightedBicubic)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

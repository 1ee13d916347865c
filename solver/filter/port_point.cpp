#include "filter/port_point.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

/// Of the radius of a boundary point's ball.
constexpr double kRadiusShare = 0.75;
/// Control points of size 1 in each coordinate: |X_u|, |X_v| <= 2 n sqrt 3 in the square; for their sum.
template <std::size_t Degree>
constexpr double kFastest = 7 * Degree;

/// The only solution on tau = 0 in the tube's region is the only one in the ball.
template <class K>
bool holds(const TubeOf<K>& tube, const BallOf<K>& ball) {
  return std::all_of(tube.others.begin(), tube.others.end(), [&](std::size_t j) {
    const double distance = std::fabs(ball.middle[j] - tube.centre[j]) + ball.radius;
    return kSlack * in_tube(tube, j, distance) <= tube.halfwidth[j];
  });
}

}  // namespace

template <class K>
std::optional<BallOf<K>> point_of_curve(const PairOf<K>& pair, const Vec4& place, std::size_t axis) {
  Unknowns<K> guess = with_scale(pair, place);
  TubeOf<K> tube;
  if (!improve(pair, guess, axis, 6) || !prepare(pair, guess, axis, tube)) {
    return std::nullopt;
  }
  const Row<K> residual = residual_bound(pair, tube, 0);
  if (!certify(pair, tube, 0, 0, halfwidths<K>(4.0 * residual, 0x1p-36), residual)) {
    return std::nullopt;
  }
  const BallOf<K> ball = point_at(tube, 0);
  return holds(tube, ball) ? std::optional(ball) : std::nullopt;
}

// Between the middle and such a point the weight is at least `least`, so that |x_u| <= (|X_u| + |X_u4| |x|) /
// X_4 and |x| <= sqrt 3 / least.
template <class K>
double vertex_error(const PairOf<K>& pair, const Vec4& middle, double radius) {
  const double reach = radius + kPlaceRounding;
  const double change = kFastest<K::degree> * reach;
  if constexpr (K::weighted) {
    const double weight = expand(pair.x, middle[0], middle[1])[0][3];
    const double least = weight - kSlack * (change + pair.x_total_error);
    if (!(least > kLeastWeight)) return HUGE_VAL;
    const double far = 1 + 1 / least;
    return kSlack * (change * far + kDiagonal * (pair.x_total_error * far + 4 * kUnit)) / least;
  } else {
    return kSlack * change;
  }
}

template <class K>
bool has_room(const BallOf<K>& ball) {
  return ball.radius < kRadiusShare * 0.25 * kEndMargin<K::width>;
}

#define EXSECT_INSTANTIATE(K)                                                                      \
  template std::optional<BallOf<K>> point_of_curve<K>(const PairOf<K>&, const Vec4&, std::size_t); \
  template double vertex_error<K>(const PairOf<K>&, const Vec4&, double);                          \
  template bool has_room<K>(const BallOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

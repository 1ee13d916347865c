#include "filter/space_bounds.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

/// At least |v| but for roundings: kTiny for squares that underflow.
double length(const Vec3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + kTiny); }

/// (14.10) with w', w'' in slope +- slope_error, second +- second_error: X'' at the centre, a vector sum, and
/// how far it can be from that. The errors of the coefficients have weights of at most |u''| + |v''| + 12
/// |w'|² in all, times 1 + i + j.
template <class K>
SpaceBounds polynomial_bounds(const PairOf<K>& pair, const TubeOf<K>& tube) {
  const CoefficientsOf<K>& c = tube.space;
  const Unknowns<K>& d = tube.slope;
  const double u2 = std::fabs(tube.second[0]) + tube.second_error[0];
  const double v2 = std::fabs(tube.second[1]) + tube.second_error[1];
  const double steep =
      larger_bound(std::fabs(d[0]) + tube.slope_error[0], std::fabs(d[1]) + tube.slope_error[1]);
  const double error = (u2 + v2 + kSecondWeight<K::degree> * steep * steep) * pair.total_error;
  const Row<K> deviation = quadratic_deviation<K>(c, &d[0], &tube.slope_error[0], &tube.offset[0]);
  const Row<K> form = form_of_order<K, 2>(c, powers<K>(d[0]), powers<K>(d[1]));
  const Variation<K> change = variation<K>(c, tube.offset[0], tube.offset[1]);
  Vec3 speed;
  Vec3 second;
  for (std::size_t i = 0; i < 3; ++i) {
    const double first_u = c[kFirst<K>][i];
    const double first_v = c[kSecond][i];
    const double at_centre = first_u * tube.second[0] + first_v * tube.second[1] + 2 * form[i];
    speed[i] =
        std::fabs(first_u) + change.first[i] + std::fabs(first_v) + change.second[i] + 2 * pair.total_error;
    second[i] = std::fabs(at_centre) + change.first[i] * u2 + std::fabs(first_u) * tube.second_error[0] +
                change.second[i] * v2 + std::fabs(first_v) * tube.second_error[1] + deviation[i] + error;
  }
  return {kSlack * length(speed), kSlack * length(second)};
}

/// (14.29) for x = X/w, with X - x(0) w in place of X, so that x is small near the centre. Coordinates of x
/// in the square are at most the inverse of the least weight.
template <class K>
SpaceBounds weighted_bounds(const PairOf<K>& pair, const TubeOf<K>& tube) {
  const CoefficientsOf<K>& c = tube.space;
  const Vec3 centre = affine(c[0]);
  const double far = 1 + largest(centre);
  CoefficientsOf<K> moved;
  for (std::size_t k = 0; k < K::count; ++k) {
    for (std::size_t i = 0; i < 3; ++i) moved[k][i] = k == 0 ? 0 : c[k][i] - centre[i] * c[k][3];
    moved[k][3] = c[k][3];
  }
  const Unknowns<K>& d = tube.slope;
  const double u1 = std::fabs(d[0]) + tube.slope_error[0];
  const double v1 = std::fabs(d[1]) + tube.slope_error[1];
  const double u2 = std::fabs(tube.second[0]) + tube.second_error[0];
  const double v2 = std::fabs(tube.second[1]) + tube.second_error[1];
  const double steep = larger_bound(u1, v1);
  const double total = 2 * far * pair.x_total_error;  // of the moved coefficients as well
  const double error = (u2 + v2 + kSecondWeight<K::degree> * steep * steep) * total;
  const Row<K> deviation = quadratic_deviation<K>(moved, &d[0], &tube.slope_error[0], &tube.offset[0]);
  const Row<K> form = form_of_order<K, 2>(moved, powers<K>(d[0]), powers<K>(d[1]));
  const Variation<K> change = variation<K>(moved, tube.offset[0], tube.offset[1]);
  const Row<K> value = value_variation<K>(moved, tube.offset[0], tube.offset[1]);
  Row<K> speed;   // of X_u and X_v
  Row<K> along;   // |X'|
  Row<K> second;  // |X''|
  for (std::size_t i = 0; i < K::rows; ++i) {
    const double first_u = moved[kFirst<K>][i];
    const double first_v = moved[kSecond][i];
    const double at_centre = first_u * tube.second[0] + first_v * tube.second[1] + 2 * form[i];
    const double most_u = std::fabs(first_u) + change.first[i] + total;
    const double most_v = std::fabs(first_v) + change.second[i] + total;
    speed[i] = most_u + most_v;
    along[i] = most_u * u1 + most_v * v1;
    second[i] = std::fabs(at_centre) + change.first[i] * u2 + std::fabs(first_u) * tube.second_error[0] +
                change.second[i] * v2 + std::fabs(first_v) * tube.second_error[1] + deviation[i] + error;
  }
  const auto space = [](const Row<K>& row) { return length({row[0], row[1], row[2]}); };
  const double weight = moved[0][3] - kSlack * (value[3] + total);
  if (!(weight > kLeastWeight)) {
    return {HUGE_VAL, HUGE_VAL, kLeastWeight};
  }
  const double most = kSlack * (space(value) + 2 * total) / weight;  // |x - x(0)|
  const double fast = kSlack * (space(speed) + speed[3] * most) / weight;
  const double rate = kSlack * (space(along) + along[3] * most) / weight;
  const double bend = kSlack * (space(second) + 2 * along[3] * rate + second[3] * most) / weight;
  return {fast, bend, weight};
}

}  // namespace

template <class K>
SpaceBounds space_bounds(const PairOf<K>& pair, const TubeOf<K>& tube) {
  if constexpr (K::weighted) {
    return weighted_bounds(pair, tube);
  } else {
    return polynomial_bounds(pair, tube);
  }
}

#define EXSECT_INSTANTIATE(K) template SpaceBounds space_bounds<K>(const PairOf<K>&, const TubeOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "filter/tube_derivatives.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/tube_columns.h"

namespace exsect::filter {

namespace {

/// Bounds x, by rows, of any nonnegative t with t <= b + E t, E the deviations of the columns other than the
/// axis: at first t <= b + rho/(1 - rho) max b, then twice the right side for what is known of t.
template <class K>
Row<K> solved(const TubeOf<K>& tube, const Row<K>& b) {
  const double most = kSlack * tube.contraction / (1 - tube.contraction) * largest(b);
  Row<K> x = b;
  for (double& bound : x) bound += most;
  for (int round = 0; round < 2; ++round) {
    Row<K> next = b + x[0] * tube.deviation[tube.others[0]];
    for (std::size_t row = 1; row < K::rows; ++row) {
      next = next + x[row] * tube.deviation[tube.others[row]];
    }
    x = kSlack * next;
  }
  return x;
}

/// What the change of the scale adds to half the second derivative at the centre, and to the deviation of the
/// whole from it: (1 + e) h'' + 2 e' h'.
template <class K>
void add_scale_terms(const PairOf<K>& pair, const TubeOf<K>& tube, double steep, Row<K>& form,
                     Row<K>& deviation) {
  const Unknowns<K>& d = tube.slope;
  const auto& delta = tube.slope_error;
  const double change = relative_change(tube);
  const Row<K> own = form_of_order<K, 2>(tube.h, powers<K>(d[2]), powers<K>(d[3]));
  const Row<K> own_deviation = quadratic_deviation<K>(tube.h, &d[2], &delta[2], &tube.offset[2]);
  const Variation<K> varied = variation<K>(tube.h, tube.offset[2], tube.offset[3]);
  const Row<K>& hr = tube.h[kFirst<K>];
  const Row<K>& hs = tube.h[kSecond];
  const double fast = std::fabs(d[4]) + delta[4];
  const double of_r = delta[4] * (std::fabs(d[2]) + delta[2]) + std::fabs(d[4]) * delta[2];
  const double of_s = delta[4] * (std::fabs(d[3]) + delta[3]) + std::fabs(d[4]) * delta[3];
  for (std::size_t row = 0; row < K::rows; ++row) {
    form[row] += d[4] * (hr[row] * d[2] + hs[row] * d[3]);
    deviation[row] += change * (2 * std::fabs(own[row]) + own_deviation[row]) +
                      2 * (fast * (varied.first[row] * (std::fabs(d[2]) + delta[2]) +
                                   varied.second[row] * (std::fabs(d[3]) + delta[3])) +
                           std::fabs(hr[row]) * of_r + std::fabs(hs[row]) * of_s) +
                      4 * kScaleUnit * tube.centre[4] * fast * steep * pair.y_total_error * tube.norm[row];
  }
}

/// Pair::total_error at the tube's scale, as order_error.
template <class K>
double total_error(const PairOf<K>& pair, const TubeOf<K>& tube) {
  if constexpr (K::weighted) {
    return kSlack * (pair.x_total_error + 2 * kScaleUnit * tube.centre[4] * pair.y_total_error);
  } else {
    return pair.total_error;
  }
}

}  // namespace

// (14.6), (14.7).
template <class K>
void bound_derivatives(const PairOf<K>& pair, TubeOf<K>& tube) {
  Row<K> first{};
  for (std::size_t j = 0; j < K::unknowns; ++j) {
    first = first + std::fabs(tube.slope[j]) * tube.deviation[j];
  }
  first = solved(tube, first);
  tube.slope_error[tube.axis] = 0;
  for (std::size_t row = 0; row < K::rows; ++row) {
    tube.slope_error[tube.others[row]] = first[row];
  }
  double steep = 1;
  for (std::size_t j = 0; j < 4; ++j) {
    steep = larger_bound(steep, std::fabs(tube.slope[j]) + tube.slope_error[j]);
  }
  const Unknowns<K>& d = tube.slope;
  Row<K> form = form_of_order<K, 2>(tube.g, powers<K>(d[0]), powers<K>(d[1])) +
                form_of_order<K, 2>(tube.h, powers<K>(d[2]), powers<K>(d[3]));
  Row<K> deviation = quadratic_deviation<K>(tube.g, &d[0], &tube.slope_error[0], &tube.offset[0]) +
                     quadratic_deviation<K>(tube.h, &d[2], &tube.slope_error[2], &tube.offset[2]);
  deviation = deviation + (kSecondWeight<K::degree> * steep * steep * total_error(pair, tube)) * tube.norm;
  if constexpr (K::weighted) {
    add_scale_terms(pair, tube, steep, form, deviation);
  }
  // |w'' + 2 F2| <= deviation + E |w''|, and |w''| <= 2 |F2| + |w'' + 2 F2|.
  Row<K> rest = deviation;
  for (std::size_t row = 0; row < K::rows; ++row) {
    rest = rest + (2 * std::fabs(form[row])) * tube.deviation[tube.others[row]];
  }
  rest = solved(tube, rest);
  tube.second[tube.axis] = tube.second_error[tube.axis] = 0;
  for (std::size_t row = 0; row < K::rows; ++row) {
    tube.second[tube.others[row]] = -2 * form[row];
    tube.second_error[tube.others[row]] = rest[row];
  }
}

#define EXSECT_INSTANTIATE(K) template void bound_derivatives<K>(const PairOf<K>&, TubeOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "filter/tube_direction.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "filter/series.h"

namespace exsect::filter {

namespace {

/// Bound of the change of any C F_j, row by row, per unit of distance in the region. The errors of the
/// coefficients, times the distance, are below column_error, which is added once more.
template <class K>
double steepest_change(const TubeOf<K>& tube) {
  const double x = second_derivatives<K>(tube.g, tube.offset[0], tube.offset[1]);
  double y = second_derivatives<K>(tube.h, tube.offset[2], tube.offset[3]);
  if constexpr (K::weighted) {
    // (1 + e) h_rr and so on, e <= 1/2; h_r in the columns of r and of the scale.
    const Variation<K> v = variation<K>(tube.h, tube.offset[2], tube.offset[3]);
    double slope = 0;
    for (std::size_t row = 0; row < K::rows; ++row) {
      slope = larger_bound(slope, std::fabs(tube.h[kFirst<K>][row]) + v.first[row] +
                                      std::fabs(tube.h[kSecond][row]) + v.second[row]);
    }
    y = 1.5 * y + slope;
  }
  return kSlack * larger_bound(x, y);
}

/// C F_j at an offset, approximately.
template <class K>
std::array<Row<K>, K::unknowns> columns_at(const TubeOf<K>& tube, const Unknowns<K>& o) {
  std::array<Row<K>, K::unknowns> column;
  derivatives<K>(tube.g, o[0], o[1], column[0], column[1]);
  derivatives<K>(tube.h, o[2], o[3], column[2], column[3]);
  if constexpr (K::weighted) {
    const double scale = 1 + o[4];
    column[2] = scale * column[2];
    column[3] = scale * column[3];
    column[4] = value_at<K>(tube.h, o[2], o[3]);
  }
  return column;
}

}  // namespace

/// (14.9): for d near w', d_axis = 1, |w' - d| <= |sum C F_j d_j| / (1 - rho), C F_j at the true point.
template <class K>
Direction<K> direction_at(const TubeOf<K>& tube, double tau) {
  Unknowns<K> o;
  const BallOf<K> ball = point_at(tube, tau, &o);
  const std::array<Row<K>, K::unknowns> column = columns_at(tube, o);
  Direction<K> d;
  d.middle = arc_slope(tube, tau);
  double least = HUGE_VAL;
  Unknowns<K> next = d.middle;
  for (int step = 0; step < 30; ++step) {
    Row<K> rest{};
    for (std::size_t j = 0; j < K::unknowns; ++j) {
      rest = rest + next[j] * column[j];
    }
    if (!(largest(rest) < 0.75 * least)) {
      break;
    }
    least = largest(rest);
    d.middle = next;
    if (least <= 0.125 * tube.column_error) {
      break;
    }
    for (std::size_t row = 0; row < K::rows; ++row) {
      next[tube.others[row]] -= rest[row];
    }
  }
  double size = 0;
  for (const double t : d.middle) {
    size += std::fabs(t);
  }
  // |C F_j| < 2 in the region but for the axis, where it is |slope|.
  const double column_error =
      steepest_change(tube) * ball.radius + 2 * tube.column_error +
      kDirectionRounding *
          (2 + largest<3>({tube.slope[0], tube.slope[1], 0}) +
           largest<3>({tube.slope[2], tube.slope[3], K::weighted ? tube.slope[K::unknowns - 1] : 0}));
  d.radius = kSlack * (least + size * column_error) / (1 - tube.contraction);
  return d;
}

#define EXSECT_INSTANTIATE(K) template Direction<K> direction_at<K>(const TubeOf<K>&, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "filter/tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "filter/series.h"
#include "filter/tube_columns.h"

namespace exsect::filter {

namespace {

/// Pair::order_error and total_error at the tube's scale; those of y are counted twice, as the scale changes
/// by a half of itself at most on both sides and |1 + e_4| <= 2.
template <class K>
auto order_error(const PairOf<K>& pair, [[maybe_unused]] const TubeOf<K>& tube)
    -> std::conditional_t<K::weighted, std::array<double, K::orders>, const std::array<double, K::orders>&> {
  if constexpr (K::weighted) {
    std::array<double, K::orders> error;
    for (std::size_t k = 0; k < K::orders; ++k) {
      error[k] = kSlack * (pair.x_order_error[k] + 2 * kScaleUnit * tube.centre[4] * pair.y_order_error[k]);
    }
    return error;
  } else {
    return pair.order_error;
  }
}

}  // namespace

template <class K>
RationalInterval interval(const BallOf<K>& ball, std::size_t parameter) {
  const Rational middle = from_double(ball.middle[parameter]) + Rational(1, 2);
  const Rational radius = from_double(ball.radius);
  return {middle - radius, middle + radius};
}

ParameterBox box_around(const Vec4& place, double radius) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) {
    const double t = place[j] + 0.5;
    box[j] = {from_double(std::clamp(t - radius, 0.0, 1.0)), from_double(std::clamp(t + radius, 0.0, 1.0))};
  }
  return box;
}

template <class K>
bool prepare(const PairOf<K>& pair, const Unknowns<K>& centre, std::size_t axis, TubeOf<K>& tube) {
  if (!within_reach<K>(centre)) {
    return false;
  }
  tube.centre = centre;
  tube.axis = axis;
  tube.others = kOthers<K>[axis];
  tube.space = expand(pair.x, centre[0], centre[1]);
  const CoefficientsOf<K> y = expand(pair.y, centre[2], centre[3]);
  auto column =
      columns_of<K>(tube.space[kFirst<K>], tube.space[kSecond], y[0], y[kFirst<K>], y[kSecond], centre);
  if constexpr (K::weighted) column[4] = centre[4] * column[4];
  std::array<Row<K>, K::rows> c;
  if (!invert_others<K>(column, axis, c)) {
    return false;
  }
  double scale = 1;
  if constexpr (K::weighted) scale = kScaleUnit * centre[4];
  for (std::size_t i = 0; i < K::count; ++i) {
    tube.g[i] = product(c, tube.space[i]);
    tube.h[i] = -scale * product(c, y[i]);
  }
  for (std::size_t row = 0; row < K::rows; ++row) {
    tube.norm[row] = kSlack * size1(c[row]);
  }
  const CoefficientsOf<K>& along = axis < 2 ? tube.g : tube.h;
  tube.second = {};
  tube.further = {};
  tube.slope[axis] = 1;
  for (std::size_t row = 0; row < K::rows; ++row) {
    tube.slope[tube.others[row]] = -along[first_order<K>(axis)][row];
  }
  return true;
}

// (14.4): F along the line is a polynomial in tau; its coefficients are sums of Taylor coefficients times
// products of slopes, so that Patch::error, times the row sum of |C|, bounds their errors.
template <class K>
Row<K> residual_bound(const PairOf<K>& pair, const TubeOf<K>& tube, double reach) {
  const Unknowns<K>& d = tube.slope;
  const Vec<K::side> u = powers<K>(d[0]);
  const Vec<K::side> v = powers<K>(d[1]);
  const Vec<K::side> r = powers<K>(d[2]);
  const Vec<K::side> s = powers<K>(d[3]);
  const double steep = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2]), std::fabs(d[3])});
  const double error = power_sum(order_error(pair, tube), reach * steep);
  Row<K> sum{};
  [[maybe_unused]] double rate = 0;  // of the scale: a term d_4 tau h
  if constexpr (K::weighted) {
    rate = d[4];
    const Row<K> last = rate * form_of_order<K, K::orders - 1>(tube.h, r, s);
    for (std::size_t row = 0; row < K::rows; ++row) sum[row] = std::fabs(last[row]);
  }
  for_each_index<K::orders>([&](auto down) EXSECT_INLINE {
    constexpr std::size_t order = K::orders - 1 - down;
    Row<K> term = form_of_order<K, order>(tube.g, u, v) + form_of_order<K, order>(tube.h, r, s);
    if constexpr (K::weighted && order > 0) {
      term = term + rate * form_of_order<K, order - 1>(tube.h, r, s);
    }
    for (std::size_t row = 0; row < K::rows; ++row) {
      sum[row] = std::fabs(term[row]) + reach * sum[row];
    }
  });
  Row<K> bound;
  for (std::size_t row = 0; row < K::rows; ++row) {
    bound[row] = kSlack * (sum[row] + tube.norm[row] * error) + kTiny;
  }
  return bound;
}

template <class K>
bool certify(const PairOf<K>& pair, TubeOf<K>& tube, double lower, double upper,
             const Unknowns<K>& halfwidth) {
  return certify<K>(pair, tube, lower, upper, halfwidth,
                    residual_bound(pair, tube, std::max(std::fabs(lower), std::fabs(upper))));
}

// Underflow: where this holds, every row of |C| has a sum of at least 2^-12, because a column of DF is at
// most 2^8, and times C at least 1/10 in its own row. So every bound here and below has a term |C_row|_1
// Patch::error >= 2^-64, and kSlack times it covers all products that underflow, with C, offsets and slopes
// as later factors.
template <class K>
bool certify(const PairOf<K>& pair, TubeOf<K>& tube, double lower, double upper, const Unknowns<K>& halfwidth,
             const Row<K>& f) {
  const double reach = std::max(std::fabs(lower), std::fabs(upper));
  double farthest = 0;
  for (std::size_t j = 0; j < K::unknowns; ++j) {
    tube.halfwidth[j] = j == tube.axis ? 0 : halfwidth[j];
    tube.offset[j] = kSlack * (std::fabs(tube.slope[j]) * reach + tube.halfwidth[j]);
    if (!(tube.offset[j] <= 1)) {
      return false;
    }
    if (j < 4) {
      farthest = larger_bound(farthest, tube.offset[j]);
    }
  }
  [[maybe_unused]] const double change = relative_change(tube);
  if (!(change <= 0.5)) {
    return false;
  }
  const Variation<K> vx = variation<K>(tube.g, tube.offset[0], tube.offset[1]);
  const Variation<K> vy = variation<K>(tube.h, tube.offset[2], tube.offset[3]);
  const auto& errors = order_error(pair, tube);
  double column_error = derivative_power_sum(errors, farthest);
  if constexpr (K::weighted) {
    column_error =
        larger_bound(column_error, kScaleUnit * tube.centre[4] * power_sum(pair.y_order_error, farthest));
  }
  const std::array<const Row<K>*, 4> varied = {&vx.first, &vx.second, &vy.first, &vy.second};
  for (std::size_t j = 0; j < 4; ++j) {
    const Row<K>& at_centre = (j < 2 ? tube.g : tube.h)[first_order<K>(j)];
    for (std::size_t row = 0; row < K::rows; ++row) {
      const double ideal = j == tube.axis ? -tube.slope[tube.others[row]] : tube.others[row] == j ? 1 : 0;
      tube.deviation[j][row] =
          kSlack * (std::fabs(at_centre[row] - ideal) + (*varied[j])[row] + tube.norm[row] * column_error);
      if constexpr (K::weighted) {
        if (j >= 2) {
          tube.deviation[j][row] += kSlack * change * (std::fabs(at_centre[row]) + (*varied[j])[row]);
        }
      }
    }
  }
  if constexpr (K::weighted) {
    const Row<K> varied_value = value_variation<K>(tube.h, tube.offset[2], tube.offset[3]);
    for (std::size_t row = 0; row < K::rows; ++row) {
      const double ideal = tube.others[row] == 4 ? 1 : 0;
      tube.deviation[4][row] =
          kSlack * (std::fabs(tube.h[0][row] - ideal) + varied_value[row] + tube.norm[row] * column_error);
    }
  }
  tube.contraction = 0;
  tube.inner[tube.axis] = 0;
  for (std::size_t row = 0; row < K::rows; ++row) {
    double sum = 0;
    double image = f[row];
    for (const std::size_t j : tube.others) {
      sum += tube.deviation[j][row];
      image += tube.deviation[j][row] * tube.halfwidth[j];
    }
    const std::size_t i = tube.others[row];
    tube.inner[i] = kSlack * image;
    if (!(tube.inner[i] < tube.halfwidth[i])) {  // (14.5)
      return false;
    }
    tube.contraction = larger_bound(tube.contraction, kSlack * sum);
  }
  tube.lower = lower;
  tube.upper = upper;
  tube.value_error = kSlack * largest(tube.norm) * power_sum(errors, farthest);
  tube.column_error = kSlack * largest(tube.norm) * column_error;
  return tube.contraction < 0.9;
}

template <class K>
Row<K> premultiplied_value(const TubeOf<K>& tube, const Unknowns<K>& o) {
  if constexpr (K::weighted) {
    return value_at<K>(tube.g, o[0], o[1]) + (1 + o[4]) * value_at<K>(tube.h, o[2], o[3]);
  } else {
    return value_at<K>(tube.g, o[0], o[1]) + value_at<K>(tube.h, o[2], o[3]);
  }
}

// (14.8): |w - w*| <= |C F(w)| / (1 - rho) for every w in the region.
template <class K>
BallOf<K> point_at(const TubeOf<K>& tube, double tau, Unknowns<K>* offset) {
  Unknowns<K> o = arc_offset(tube, tau);
  Unknowns<K> best = o;
  double least = HUGE_VAL;
  for (int step = 0; step < 40; ++step) {
    const Row<K> value = premultiplied_value<K>(tube, o);
    if (!(largest(value) < 0.75 * least)) {
      break;
    }
    bool inside = true;
    for (const std::size_t j : tube.others) {
      inside = inside && kSlack * (std::fabs(o[j] - tau * tube.slope[j]) + kSumRounding) <= tube.halfwidth[j];
    }
    if (!inside) {
      break;
    }
    best = o;
    least = largest(value);
    if (least <= 0.125 * tube.value_error) {
      break;
    }
    for (std::size_t row = 0; row < K::rows; ++row) {
      o[tube.others[row]] -= value[row];
    }
  }
  if (offset != nullptr) {
    *offset = best;
  }
  // The scale is at most 1, so that a relative distance is none too short.
  return {place_at(tube, best), kSlack * (least + tube.value_error) / (1 - tube.contraction) + kSumRounding};
}

namespace {

/// |w_j - centre_j - tau slope_j| at the middle of the ball, in the tube's unknowns, and how much more or
/// less it is in the ball. Where the first is above 2, kSlack covers its relative error.
template <class K>
double from_line(const TubeOf<K>& tube, const BallOf<K>& ball, std::size_t j, double tau) {
  return std::fabs(in_tube(tube, j, ball.middle[j] - tube.centre[j]) - tau * tube.slope[j]);
}
template <class K>
double radius_across(const TubeOf<K>& tube, const BallOf<K>& ball, std::size_t j) {
  return in_tube(tube, j, ball.radius) + ball.radius * std::fabs(tube.slope[j]);
}

}  // namespace

template <class K>
bool contains(const TubeOf<K>& tube, const BallOf<K>& ball) {
  const double tau = ball.middle[tube.axis] - tube.centre[tube.axis];
  if (!(tau - ball.radius - kPlacing >= tube.lower && tau + ball.radius + kPlacing <= tube.upper)) {
    return false;
  }
  return std::all_of(tube.others.begin(), tube.others.end(), [&](std::size_t j) {
    return kSlack * (from_line(tube, ball, j, tau) + radius_across(tube, ball, j) + kPlacing) <=
           tube.halfwidth[j];
  });
}

template <class K>
bool excludes(const TubeOf<K>& tube, const BallOf<K>& ball) {
  const double tau = ball.middle[tube.axis] - tube.centre[tube.axis];
  if (tau + ball.radius + kPlacing < tube.lower || tau - ball.radius - kPlacing > tube.upper) {
    return true;
  }
  return std::any_of(tube.others.begin(), tube.others.end(), [&](std::size_t j) {
    return from_line(tube, ball, j, tau) > kSlack * (tube.inner[j] + radius_across(tube, ball, j) + kPlacing);
  });
}

#define EXSECT_INSTANTIATE(K)                                                                                \
  template RationalInterval interval<K>(const BallOf<K>&, std::size_t);                                      \
  template bool prepare<K>(const PairOf<K>&, const Unknowns<K>&, std::size_t, TubeOf<K>&);                   \
  template Row<K> residual_bound<K>(const PairOf<K>&, const TubeOf<K>&, double);                             \
  template bool certify<K>(const PairOf<K>&, TubeOf<K>&, double, double, const Unknowns<K>&);                \
  template bool certify<K>(const PairOf<K>&, TubeOf<K>&, double, double, const Unknowns<K>&, const Row<K>&); \
  template Row<K> premultiplied_value<K>(const TubeOf<K>&, const Unknowns<K>&);                              \
  template BallOf<K> point_at<K>(const TubeOf<K>&, double, Unknowns<K>*);                                    \
  template bool contains<K>(const TubeOf<K>&, const BallOf<K>&);                                             \
  template bool excludes<K>(const TubeOf<K>&, const BallOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

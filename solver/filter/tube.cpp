#include "filter/tube.h"

#include <algorithm>
#include <cmath>

#include "filter/series.h"

namespace exsect::filter {

namespace {

constexpr std::array<std::array<std::size_t, 3>, 4> kOthers = {{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
/// The Taylor coefficient that is column j of DF.
template <class K>
constexpr std::size_t first_order(std::size_t j) {
  return j % 2 == 0 ? kFirst<K> : kSecond;
}

bool within_reach(const Vec4& p) {
  return std::all_of(p.begin(), p.end(), [](double t) { return std::fabs(t) <= kReach; });
}

/// Rows of the inverse of the matrix with these columns, in plain doubles: any matrix is a legal C.
bool invert(const Vec3& a, const Vec3& b, const Vec3& c, std::array<Vec3, 3>& rows) {
  rows = {cross(b, c), cross(c, a), cross(a, b)};
  const double inverse = 1 / dot(a, rows[0]);
  if (!(std::fabs(inverse) < kGreatestInverse)) {
    return false;
  }
  for (Vec3& row : rows) {
    row = inverse * row;
  }
  return true;
}

inline Vec3 product(const std::array<Vec3, 3>& rows, const Vec3& v) {
  return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
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
Linearisation<K> linearise(const PairOf<K>& pair, const Unknowns<K>& w) {
  const CoefficientsOf<K> x = expand(pair.x, w[0], w[1]);
  const CoefficientsOf<K> y = expand(pair.y, w[2], w[3]);
  Linearisation<K> at;
  at.value = x[0] - y[0];
  const Row<K>&xu = x[kFirst<K>], &xv = x[kSecond], &yr = y[kFirst<K>], &ys = y[kSecond];
  at.column = {xu, xv, -1.0 * yr, -1.0 * ys};
  const Vec3 nx = cross(xu, xv);
  const Vec3 ny = cross(yr, ys);
  at.tangent = {dot(xv, ny), -dot(xu, ny), -dot(ys, nx), dot(yr, nx)};
  return at;
}

std::size_t steepest(const Vec4& tangent, const Vec4& weight) {
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 4; ++j) {
    if (std::fabs(tangent[j]) * weight[axis] > std::fabs(tangent[axis]) * weight[j]) {
      axis = j;
    }
  }
  return axis;
}

template <class K>
bool prepare(const PairOf<K>& pair, const Unknowns<K>& centre, std::size_t axis, TubeOf<K>& tube) {
  if (!within_reach(centre)) {
    return false;
  }
  tube.centre = centre;
  tube.axis = axis;
  tube.others = kOthers[axis];
  tube.space = expand(pair.x, centre[0], centre[1]);
  const CoefficientsOf<K> y = expand(pair.y, centre[2], centre[3]);
  const std::array<Row<K>, 4> column = {tube.space[kFirst<K>], tube.space[kSecond], -1.0 * y[kFirst<K>],
                                        -1.0 * y[kSecond]};
  std::array<Row<K>, K::rows> c;
  if (!invert(column[tube.others[0]], column[tube.others[1]], column[tube.others[2]], c)) {
    return false;
  }
  for (std::size_t i = 0; i < K::count; ++i) {
    tube.g[i] = product(c, tube.space[i]);
    tube.h[i] = -1.0 * product(c, y[i]);
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
  const double error = power_sum(pair.order_error, reach * steep);
  Row<K> sum{};
  for_each_index<K::orders>([&](auto down) EXSECT_INLINE {
    constexpr std::size_t order = K::orders - 1 - down;
    const Row<K> term = form_of_order<K, order>(tube.g, u, v) + form_of_order<K, order>(tube.h, r, s);
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
  for (std::size_t j = 0; j < 4; ++j) {
    tube.halfwidth[j] = j == tube.axis ? 0 : halfwidth[j];
    tube.offset[j] = kSlack * (std::fabs(tube.slope[j]) * reach + tube.halfwidth[j]);
    if (!(tube.offset[j] <= 1)) {
      return false;
    }
    farthest = std::max(farthest, tube.offset[j]);
  }
  const Variation<K> vx = variation<K>(tube.g, tube.offset[0], tube.offset[1]);
  const Variation<K> vy = variation<K>(tube.h, tube.offset[2], tube.offset[3]);
  const double column_error = derivative_power_sum(pair.order_error, farthest);
  const std::array<const Row<K>*, 4> varied = {&vx.first, &vx.second, &vy.first, &vy.second};
  for (std::size_t j = 0; j < 4; ++j) {
    const Row<K>& at_centre = (j < 2 ? tube.g : tube.h)[first_order<K>(j)];
    for (std::size_t row = 0; row < K::rows; ++row) {
      const double ideal = j == tube.axis ? -tube.slope[tube.others[row]] : tube.others[row] == j ? 1 : 0;
      tube.deviation[j][row] =
          kSlack * (std::fabs(at_centre[row] - ideal) + (*varied[j])[row] + tube.norm[row] * column_error);
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
    tube.contraction = std::max(tube.contraction, kSlack * sum);
  }
  tube.lower = lower;
  tube.upper = upper;
  tube.value_error = kSlack * largest(tube.norm) * power_sum(pair.order_error, farthest);
  tube.column_error = kSlack * largest(tube.norm) * column_error;
  return tube.contraction < 0.9;
}

namespace {

/// Bounds x, by rows, of any nonnegative t with t <= b + E t, E the deviations of the columns other than the
/// axis: at first t <= b + rho/(1 - rho) max b, then twice the right side for what is known of t.
template <class K>
Vec3 solved(const TubeOf<K>& tube, const Vec3& b) {
  const double most = kSlack * tube.contraction / (1 - tube.contraction) * largest(b);
  Vec3 x = {b[0] + most, b[1] + most, b[2] + most};
  for (int round = 0; round < 2; ++round) {
    const Vec3 next = b + x[0] * tube.deviation[tube.others[0]] + x[1] * tube.deviation[tube.others[1]] +
                      x[2] * tube.deviation[tube.others[2]];
    x = kSlack * next;
  }
  return x;
}

}  // namespace

// (14.6), (14.7).
template <class K>
void bound_derivatives(const PairOf<K>& pair, TubeOf<K>& tube) {
  Vec3 first{};
  for (std::size_t j = 0; j < 4; ++j) {
    first = first + std::fabs(tube.slope[j]) * tube.deviation[j];
  }
  first = solved(tube, first);
  tube.slope_error[tube.axis] = 0;
  for (std::size_t row = 0; row < K::rows; ++row) {
    tube.slope_error[tube.others[row]] = first[row];
  }
  double steep = 1;
  for (std::size_t j = 0; j < 4; ++j) {
    steep = std::max(steep, std::fabs(tube.slope[j]) + tube.slope_error[j]);
  }
  const Vec4& d = tube.slope;
  const Vec3 form = form_of_order<K, 2>(tube.g, powers<K>(d[0]), powers<K>(d[1])) +
                    form_of_order<K, 2>(tube.h, powers<K>(d[2]), powers<K>(d[3]));
  Vec3 deviation = quadratic_deviation<K>(tube.g, &d[0], &tube.slope_error[0], &tube.offset[0]) +
                   quadratic_deviation<K>(tube.h, &d[2], &tube.slope_error[2], &tube.offset[2]);
  deviation = deviation + (kSecondWeight<K::degree> * steep * steep * pair.total_error) * tube.norm;
  // |w'' + 2 F2| <= deviation + E |w''|, and |w''| <= 2 |F2| + |w'' + 2 F2|.
  Vec3 rest = deviation;
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

template <class K>
Row<K> premultiplied_value(const TubeOf<K>& tube, const Unknowns<K>& o) {
  return value_at<K>(tube.g, o[0], o[1]) + value_at<K>(tube.h, o[2], o[3]);
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
  BallOf<K> result;
  for (std::size_t j = 0; j < K::unknowns; ++j) {
    result.middle[j] = tube.centre[j] + best[j];
  }
  result.radius = kSlack * (least + tube.value_error) / (1 - tube.contraction) + kSumRounding;
  return result;
}

template <class K>
bool contains(const TubeOf<K>& tube, const BallOf<K>& ball) {
  const double tau = ball.middle[tube.axis] - tube.centre[tube.axis];
  if (!(tau - ball.radius - kPlacing >= tube.lower && tau + ball.radius + kPlacing <= tube.upper)) {
    return false;
  }
  return std::all_of(tube.others.begin(), tube.others.end(), [&](std::size_t j) {
    const double from_line = std::fabs(ball.middle[j] - tube.centre[j] - tau * tube.slope[j]);
    return kSlack * (from_line + ball.radius * (1 + std::fabs(tube.slope[j])) + kPlacing) <=
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
    const double from_line = std::fabs(ball.middle[j] - tube.centre[j] - tau * tube.slope[j]);
    return from_line > kSlack * (tube.inner[j] + ball.radius * (1 + std::fabs(tube.slope[j])) + kPlacing);
  });
}

namespace {

template <class K>
struct FirstOrder {
  Row<K> value;
  Row<K> first;
  Row<K> second;
};

/// A patch and its derivatives at (h,k), approximately.
template <class K>
FirstOrder<K> first_order_at(const PatchOf<K>& patch, double h, double k) {
  FirstOrder<K> at;
  at.value = value_at<K>(patch.power, h, k);
  derivatives<K>(patch.power, h, k, at.first, at.second);
  return at;
}

}  // namespace

template <class K>
bool improve(const PairOf<K>& pair, Unknowns<K>& point, std::size_t axis, int steps) {
  const auto& others = kOthers[axis];
  for (int step = 0; step < steps; ++step) {
    const FirstOrder<K> x = first_order_at(pair.x, point[0], point[1]);
    const FirstOrder<K> y = first_order_at(pair.y, point[2], point[3]);
    const std::array<Vec3, 4> column = {x.first, x.second, -1.0 * y.first, -1.0 * y.second};
    std::array<Vec3, 3> c;
    if (!invert(column[others[0]], column[others[1]], column[others[2]], c)) {
      return false;
    }
    const Vec3 correction = product(c, x.value - y.value);
    for (std::size_t row = 0; row < K::rows; ++row) {
      point[others[row]] -= correction[row];
    }
    if (!within_reach(point)) {
      return false;
    }
    if (largest(correction) < 0x1p-16) {
      break;
    }
  }
  return true;
}

#define EXSECT_INSTANTIATE(K)                                                                                \
  template RationalInterval interval<K>(const BallOf<K>&, std::size_t);                                      \
  template Linearisation<K> linearise<K>(const PairOf<K>&, const Unknowns<K>&);                              \
  template bool prepare<K>(const PairOf<K>&, const Unknowns<K>&, std::size_t, TubeOf<K>&);                   \
  template Row<K> residual_bound<K>(const PairOf<K>&, const TubeOf<K>&, double);                             \
  template bool certify<K>(const PairOf<K>&, TubeOf<K>&, double, double, const Unknowns<K>&);                \
  template bool certify<K>(const PairOf<K>&, TubeOf<K>&, double, double, const Unknowns<K>&, const Row<K>&); \
  template void bound_derivatives<K>(const PairOf<K>&, TubeOf<K>&);                                          \
  template Row<K> premultiplied_value<K>(const TubeOf<K>&, const Unknowns<K>&);                              \
  template BallOf<K> point_at<K>(const TubeOf<K>&, double, Unknowns<K>*);                                    \
  template bool contains<K>(const TubeOf<K>&, const BallOf<K>&);                                             \
  template bool excludes<K>(const TubeOf<K>&, const BallOf<K>&);                                             \
  template bool improve<K>(const PairOf<K>&, Unknowns<K>&, std::size_t, int);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

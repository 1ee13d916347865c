#include "filter/tube.h"

#include <algorithm>
#include <cmath>

#include "filter/series.h"

namespace exsect::filter {

namespace {

constexpr std::array<std::array<std::size_t, 3>, 4> kOthers = {{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
/// The Taylor coefficient that is column j of DF.
constexpr std::size_t first_order(std::size_t j) { return j % 2 == 0 ? 3 : 1; }

Vec3 absolute(const Vec3& a) { return {std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])}; }

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

Vec3 product(const std::array<Vec3, 3>& rows, const Vec3& v) {
  return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

/// Bounds of |p_a(a,b) - p_a(0,0)|, |p_b(a,b) - p_b(0,0)| over |a| <= ha, |b| <= hb.
struct Variation {
  Vec3 first;
  Vec3 second;
};
Variation variation(const Coefficients& c, double ha, double hb) {
  Variation v{};
  const double ab = ha * hb;
  for (std::size_t i = 0; i < 3; ++i) {
    const double c11 = std::fabs(c[4][i]);
    const double c12 = std::fabs(c[5][i]);
    const double c21 = std::fabs(c[7][i]);
    const double c22 = 2 * std::fabs(c[8][i]) * ab;
    v.first[i] = 2 * std::fabs(c[6][i]) * ha + c11 * hb + 2 * c21 * ab + c12 * hb * hb + c22 * hb;
    v.second[i] = 2 * std::fabs(c[2][i]) * hb + c11 * ha + 2 * c12 * ab + c21 * ha * ha + c22 * ha;
  }
  return v;
}

/// Coefficients of tau², tau³, tau⁴ of p(tau a, tau b).
Vec3 second_order(const Coefficients& c, double a, double b) {
  return (a * a) * c[6] + (a * b) * c[4] + (b * b) * c[2];
}
Vec3 third_order(const Coefficients& c, double a, double b) {
  return (a * a * b) * c[7] + (a * b * b) * c[5];
}
Vec3 fourth_order(const Coefficients& c, double a, double b) { return (a * a * b * b) * c[8]; }

double power_sum(const std::array<double, 5>& e, double t) {
  return e[0] + t * (e[1] + t * (e[2] + t * (e[3] + t * e[4])));
}

/// The same for derivatives: the coefficient of a^i b^j appears in them max(i,j) times at most.
double derivative_power_sum(const std::array<double, 5>& e, double t) {
  return e[1] + t * (2 * e[2] + t * (3 * e[3] + t * 4 * e[4]));
}

}  // namespace

RationalInterval interval(const Ball& ball, std::size_t parameter) {
  const Rational middle = from_double(ball.middle[parameter]) + Rational(1, 2);
  const Rational radius = from_double(ball.radius);
  return {middle - radius, middle + radius};
}

Linearisation linearise(const Coefficients& x, const Coefficients& y) {
  Linearisation at;
  at.value = x[0] - y[0];
  at.column = {x[3], x[1], -1.0 * y[3], -1.0 * y[1]};
  const Vec3 nx = cross(x[3], x[1]);
  const Vec3 ny = cross(y[3], y[1]);
  at.tangent = {dot(x[1], ny), -dot(x[3], ny), -dot(y[1], nx), dot(y[3], nx)};
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

bool prepare(const Pair& pair, const Vec4& centre, std::size_t axis, Tube& tube) {
  if (!within_reach(centre)) {
    return false;
  }
  tube.centre = centre;
  tube.axis = axis;
  tube.others = kOthers[axis];
  tube.space = expand(pair.x, centre[0], centre[1]);
  const Coefficients y = expand(pair.y, centre[2], centre[3]);
  const std::array<Vec3, 4> column = {tube.space[3], tube.space[1], -1.0 * y[3], -1.0 * y[1]};
  std::array<Vec3, 3> c;
  if (!invert(column[tube.others[0]], column[tube.others[1]], column[tube.others[2]], c)) {
    return false;
  }
  for (std::size_t i = 0; i < 9; ++i) {
    tube.g[i] = product(c, tube.space[i]);
    tube.h[i] = -1.0 * product(c, y[i]);
  }
  for (std::size_t row = 0; row < 3; ++row) {
    tube.norm[row] = kSlack * (std::fabs(c[row][0]) + std::fabs(c[row][1]) + std::fabs(c[row][2]));
  }
  const Coefficients& along = axis < 2 ? tube.g : tube.h;
  tube.second = {};
  tube.further = {};
  tube.slope[axis] = 1;
  for (std::size_t row = 0; row < 3; ++row) {
    tube.slope[tube.others[row]] = -along[first_order(axis)][row];
  }
  return true;
}

// (14.4): |F| along the line is a quartic in tau; its coefficients are sums of Taylor coefficients times
// products of slopes, so that Patch::error, times the row sum of |C|, bounds their errors.
Vec3 residual_bound(const Pair& pair, const Tube& tube, double reach) {
  const Vec4& d = tube.slope;
  const Vec3 constant = tube.g[0] + tube.h[0];
  const Vec3 linear = d[0] * tube.g[3] + d[1] * tube.g[1] + d[2] * tube.h[3] + d[3] * tube.h[1];
  const Vec3 quadratic = second_order(tube.g, d[0], d[1]) + second_order(tube.h, d[2], d[3]);
  const Vec3 cubic = third_order(tube.g, d[0], d[1]) + third_order(tube.h, d[2], d[3]);
  const Vec3 quartic = fourth_order(tube.g, d[0], d[1]) + fourth_order(tube.h, d[2], d[3]);
  const double steep = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2]), std::fabs(d[3])});
  const double error = power_sum(pair.order_error, reach * steep);
  Vec3 bound;
  for (std::size_t row = 0; row < 3; ++row) {
    const double sum = std::fabs(constant[row]) +
                       reach * (std::fabs(linear[row]) +
                                reach * (std::fabs(quadratic[row]) +
                                         reach * (std::fabs(cubic[row]) + reach * std::fabs(quartic[row]))));
    bound[row] = kSlack * (sum + tube.norm[row] * error) + kTiny;
  }
  return bound;
}

bool certify(const Pair& pair, Tube& tube, double lower, double upper, const Vec4& halfwidth) {
  return certify(pair, tube, lower, upper, halfwidth,
                 residual_bound(pair, tube, std::max(std::fabs(lower), std::fabs(upper))));
}

// Underflow: where this holds, every row of |C| has a sum of at least 2^-10, because a column of DF is at
// most 2^7, and times C at least 1/10 in its own row. So every bound here and below has a term |C_row|_1
// Patch::error >= 2^-62, and kSlack times it covers all products that underflow, with C, offsets and slopes
// as later factors.
bool certify(const Pair& pair, Tube& tube, double lower, double upper, const Vec4& halfwidth, const Vec3& f) {
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
  const Variation vx = variation(tube.g, tube.offset[0], tube.offset[1]);
  const Variation vy = variation(tube.h, tube.offset[2], tube.offset[3]);
  const double column_error = derivative_power_sum(pair.order_error, farthest);
  const std::array<const Vec3*, 4> varied = {&vx.first, &vx.second, &vy.first, &vy.second};
  for (std::size_t j = 0; j < 4; ++j) {
    const Vec3& at_centre = (j < 2 ? tube.g : tube.h)[first_order(j)];
    for (std::size_t row = 0; row < 3; ++row) {
      const double ideal = j == tube.axis ? -tube.slope[tube.others[row]] : tube.others[row] == j ? 1 : 0;
      tube.deviation[j][row] =
          kSlack * (std::fabs(at_centre[row] - ideal) + (*varied[j])[row] + tube.norm[row] * column_error);
    }
  }
  tube.contraction = 0;
  tube.inner[tube.axis] = 0;
  for (std::size_t row = 0; row < 3; ++row) {
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

Vec3 quadratic_deviation(const Coefficients& c, const double* d, const double* delta, const double* h) {
  const double a0 = std::fabs(d[0]) + delta[0];
  const double a1 = std::fabs(d[1]) + delta[1];
  const double d0 = std::fabs(d[0]);
  const double d1 = std::fabs(d[1]);
  const Vec3 at_centre = (2 * delta[0] * (a0 + d0)) * absolute(c[6]) +
                         (2 * (delta[0] * d1 + a0 * delta[1])) * absolute(c[4]) +
                         (2 * delta[1] * (a1 + d1)) * absolute(c[2]);
  const double c7 = 2 * h[1] * a0 * a0 + 4 * h[0] * a0 * a1;
  const double c5 = 4 * h[1] * a0 * a1 + 2 * h[0] * a1 * a1;
  const double c8 = 2 * h[1] * h[1] * a0 * a0 + 8 * h[0] * h[1] * a0 * a1 + 2 * h[0] * h[0] * a1 * a1;
  return at_centre + c7 * absolute(c[7]) + c5 * absolute(c[5]) + c8 * absolute(c[8]);
}

namespace {

/// Bounds x, by rows, of any nonnegative t with t <= b + E t, E the deviations of the columns other than the
/// axis: at first t <= b + rho/(1 - rho) max b, then twice the right side for what is known of t.
Vec3 solved(const Tube& tube, const Vec3& b) {
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
void bound_derivatives(const Pair& pair, Tube& tube) {
  Vec3 first{};
  for (std::size_t j = 0; j < 4; ++j) {
    first = first + std::fabs(tube.slope[j]) * tube.deviation[j];
  }
  first = solved(tube, first);
  tube.slope_error[tube.axis] = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    tube.slope_error[tube.others[row]] = first[row];
  }
  double steep = 1;
  for (std::size_t j = 0; j < 4; ++j) {
    steep = std::max(steep, std::fabs(tube.slope[j]) + tube.slope_error[j]);
  }
  const Vec4& d = tube.slope;
  const Vec3 form = second_order(tube.g, d[0], d[1]) + second_order(tube.h, d[2], d[3]);
  Vec3 deviation = quadratic_deviation(tube.g, &d[0], &tube.slope_error[0], &tube.offset[0]) +
                   quadratic_deviation(tube.h, &d[2], &tube.slope_error[2], &tube.offset[2]);
  deviation = deviation + (kSecondWeight * steep * steep * pair.total_error) * tube.norm;
  // |w'' + 2 F2| <= deviation + E |w''|, and |w''| <= 2 |F2| + |w'' + 2 F2|.
  Vec3 rest = deviation;
  for (std::size_t row = 0; row < 3; ++row) {
    rest = rest + (2 * std::fabs(form[row])) * tube.deviation[tube.others[row]];
  }
  rest = solved(tube, rest);
  tube.second[tube.axis] = tube.second_error[tube.axis] = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    tube.second[tube.others[row]] = -2 * form[row];
    tube.second_error[tube.others[row]] = rest[row];
  }
}

Vec3 value_at(const Coefficients& c, double a, double b) {
  Vec3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = (c[0][i] + b * (c[1][i] + b * c[2][i])) +
                a * ((c[3][i] + b * (c[4][i] + b * c[5][i])) + a * (c[6][i] + b * (c[7][i] + b * c[8][i])));
  }
  return result;
}

Vec3 premultiplied_value(const Tube& tube, const Vec4& o) {
  return value_at(tube.g, o[0], o[1]) + value_at(tube.h, o[2], o[3]);
}

// (14.8): |w - w*| <= |C F(w)| / (1 - rho) for every w in the region.
Ball point_at(const Tube& tube, double tau, Vec4* offset) {
  Vec4 o = arc_offset(tube, tau);
  Vec4 best = o;
  double least = HUGE_VAL;
  for (int step = 0; step < 40; ++step) {
    const Vec3 value = premultiplied_value(tube, o);
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
    for (std::size_t row = 0; row < 3; ++row) {
      o[tube.others[row]] -= value[row];
    }
  }
  if (offset != nullptr) {
    *offset = best;
  }
  Ball result;
  for (std::size_t j = 0; j < 4; ++j) {
    result.middle[j] = tube.centre[j] + best[j];
  }
  result.radius = kSlack * (least + tube.value_error) / (1 - tube.contraction) + kSumRounding;
  return result;
}

bool contains(const Tube& tube, const Ball& ball) {
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

bool excludes(const Tube& tube, const Ball& ball) {
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

struct FirstOrder {
  Vec3 value;
  Vec3 first;
  Vec3 second;
};

/// A patch and its derivatives at (h,k), approximately.
FirstOrder first_order_at(const Patch& patch, double h, double k) {
  const Coefficients& c = patch.power;
  FirstOrder at;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a0 = c[0][i] + k * (c[1][i] + k * c[2][i]);
    const double a1 = c[3][i] + k * (c[4][i] + k * c[5][i]);
    const double a2 = c[6][i] + k * (c[7][i] + k * c[8][i]);
    at.value[i] = a0 + h * (a1 + h * a2);
    at.first[i] = a1 + 2 * h * a2;
    at.second[i] =
        (c[1][i] + 2 * k * c[2][i]) + h * ((c[4][i] + 2 * k * c[5][i]) + h * (c[7][i] + 2 * k * c[8][i]));
  }
  return at;
}

}  // namespace

bool improve(const Pair& pair, Vec4& point, std::size_t axis, int steps) {
  const auto& others = kOthers[axis];
  for (int step = 0; step < steps; ++step) {
    const FirstOrder x = first_order_at(pair.x, point[0], point[1]);
    const FirstOrder y = first_order_at(pair.y, point[2], point[3]);
    const std::array<Vec3, 4> column = {x.first, x.second, -1.0 * y.first, -1.0 * y.second};
    std::array<Vec3, 3> c;
    if (!invert(column[others[0]], column[others[1]], column[others[2]], c)) {
      return false;
    }
    const Vec3 correction = product(c, x.value - y.value);
    for (std::size_t row = 0; row < 3; ++row) {
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

}  // namespace exsect::filter

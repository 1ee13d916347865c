#include "filter/curve_series.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <cmath>

#include "filter/error_bounds.h"
#include "filter/exact_taylor.h"

namespace exsect::filter {

namespace {

template <class Number>
using Terms = CurveSeries::Terms<Number>;
template <class Number>
using Taylor = CurveSeries::Taylor<Number>;
template <class Number>
using Triple = std::array<Number, 3>;
template <class Number>
using Coordinates = std::array<Terms<Number>, 4>;

constexpr long kEnclosedBits = 60;
DoubleBall ball_around_number(const FieldNumber& a) {
  return a.is_rational() ? DoubleBall::enclosing(a.rational())
                         : DoubleBall::enclosing(enclosure(a, kEnclosedBits));
}

template <class Number>
Terms<Number> constant_terms(int value, std::size_t most) {
  Terms<Number> result(most + 1, Number(0));
  result[0] = Number(value);
  return result;
}

/// Up to tau^most.
template <class Number>
Terms<Number> series_product(const Terms<Number>& a, const Terms<Number>& b, std::size_t most) {
  Terms<Number> result = constant_terms<Number>(0, most);
  for (std::size_t i = 0; i <= most && i < a.size(); ++i)
    for (std::size_t j = 0; i + j <= most && j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

/// A patch along the curve h(tau), k(tau), which have no constant terms.
template <class Number>
Coordinates<Number> patch_along(const Taylor<Number>& c, std::size_t side, const Terms<Number>& h,
                                const Terms<Number>& k, std::size_t most) {
  Coordinates<Number> result;
  result.fill(constant_terms<Number>(0, most));
  Terms<Number> in_h = constant_terms<Number>(1, most);
  for (std::size_t i = 0; i < side; ++i, in_h = series_product(in_h, h, most)) {
    Terms<Number> power = in_h;
    for (std::size_t j = 0; j < side; ++j, power = series_product(power, k, most)) {
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t t = 0; t <= most; ++t) result[row][t] += c[side * i + j][row] * power[t];
    }
  }
  return result;
}

/// G = X Y_4 - Y X_4, three coordinates, and its derivatives by u, v, r, s.
template <class Number>
Triple<Number> difference(const std::array<Number, 4>& x, const std::array<Number, 4>& y) {
  return {x[0] * y[3] - y[0] * x[3], x[1] * y[3] - y[1] * x[3], x[2] * y[3] - y[2] * x[3]};
}
template <class Number>
std::array<Triple<Number>, 4> columns_at_zero(const Taylor<Number>& x, const Taylor<Number>& y,
                                              std::size_t side) {
  return {difference(x[side], y[0]), difference(x[1], y[0]), difference(x[0], y[side]),
          difference(x[0], y[1])};
}

/// The coefficients of G along a curve.
template <class Number>
Triple<Terms<Number>> difference_along(const Taylor<Number>& x, const Taylor<Number>& y, std::size_t side,
                                       const std::array<Terms<Number>, 4>& w, std::size_t most) {
  const Coordinates<Number> a = patch_along(x, side, w[0], w[1], most),
                            b = patch_along(y, side, w[2], w[3], most);
  Triple<Terms<Number>> g;
  for (std::size_t k = 0; k < 3; ++k) {
    g[k] = series_product(a[k], b[3], most);
    const Terms<Number> other = series_product(b[k], a[3], most);
    for (std::size_t t = 0; t <= most; ++t) g[k][t] -= other[t];
  }
  return g;
}

/// Homogeneous, about the point of space that the patch has at (u,v).
template <class K>
Taylor<FieldNumber> about_own_point(const ExactPatch<K>& patch, const FieldNumber& u, const FieldNumber& v) {
  const auto taylor = exact_taylor<K, FieldNumber>(patch, u, v);
  Taylor<FieldNumber> result(K::count);
  for (std::size_t k = 0; k < K::count; ++k) {
    result[k][3] = k == 0 ? 1 : 0;
    std::copy(taylor[k].begin(), taylor[k].end(), result[k].begin());
  }
  for (std::size_t row = 0; row < 3; ++row) {
    const FieldNumber coordinate = result[0][row] / result[0][3];
    for (auto& c : result) c[row] -= coordinate * c[3];
  }
  return result;
}

Taylor<DoubleBall> enclosed(const Taylor<FieldNumber>& exact) {
  Taylor<DoubleBall> c(exact.size());
  for (std::size_t k = 0; k < c.size(); ++k)
    for (std::size_t row = 0; row < 4; ++row) c[k][row] = ball_around_number(exact[k][row]);
  return c;
}

/// About all places with |h| <= room_h, |k| <= room_k at once, by repeated synthetic division.
Taylor<DoubleBall> shifted(const Taylor<FieldNumber>& exact, std::size_t side, double room_h, double room_k) {
  Taylor<DoubleBall> c = enclosed(exact);
  const auto shift = [&](std::size_t first, std::size_t step, const DoubleBall& t) {
    for (std::size_t level = 0; level + 1 < side; ++level)
      for (std::size_t i = side - 1; i > level; --i)
        for (std::size_t row = 0; row < 4; ++row)
          c[first + step * (i - 1)][row] += t * c[first + step * i][row];
  };
  for (std::size_t i = 0; i < side; ++i) shift(side * i, 1, DoubleBall(0, room_k));
  for (std::size_t j = 0; j < side; ++j) shift(j, side, DoubleBall(0, room_h));
  return c;
}

/// Rows that are dual to the columns other than that of the axis; false if there are none.
bool invert_exactly(const std::array<Triple<FieldNumber>, 4>& all, std::size_t axis,
                    std::array<Triple<FieldNumber>, 3>& rows) {
  const auto column = [&](std::size_t i) -> const Triple<FieldNumber>& {
    return all[i % 3 < axis ? i % 3 : i % 3 + 1];
  };
  for (std::size_t i = 0; i < 3; ++i) rows[i] = cross_over(column(i + 1), column(i + 2));
  const FieldNumber determinant = dot_over(rows[0], column(0));
  if (determinant.is_zero()) return false;
  for (Triple<FieldNumber>& row : rows)
    for (FieldNumber& c : row) c /= determinant;
  return true;
}

/// Bounds for all points of a box: C DG, without the column of the axis, is within `contraction` of 1 by sums
/// over rows, and of C D²G all sums over rows are at most `bend`.
struct BoxBounds {
  double contraction = 0;
  double bend = 0;
};

BoxBounds bounds_in(const Taylor<DoubleBall>& x, const Taylor<DoubleBall>& y, std::size_t side,
                    const std::array<Triple<FieldNumber>, 3>& inverse, std::size_t axis) {
  const auto times = [&](std::size_t row, const Triple<DoubleBall>& v) {
    DoubleBall sum(0);
    for (std::size_t k = 0; k < 3; ++k) sum += ball_around_number(inverse[row][k]) * v[k];
    return sum;
  };
  const auto first = columns_at_zero(x, y, side);
  const std::array<Triple<DoubleBall>, 6> squares = {
      difference(x[2 * side], y[0]), difference(x[side + 1], y[0]), difference(x[2], y[0]),
      difference(x[0], y[2 * side]), difference(x[0], y[side + 1]), difference(x[0], y[2])};
  const std::array<Triple<DoubleBall>, 4> mixed = {difference(x[side], y[side]), difference(x[side], y[1]),
                                                   difference(x[1], y[side]), difference(x[1], y[1])};
  BoxBounds result;
  for (std::size_t row = 0; row < 3; ++row) {
    double far = 0, bend = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const DoubleBall entry = times(row, first[i < axis ? i : i + 1]);
      far += (entry - DoubleBall(i == row ? 1 : 0)).upper_magnitude();
    }
    for (const Triple<DoubleBall>& v : squares) bend += 2 * times(row, v).upper_magnitude();
    for (const Triple<DoubleBall>& v : mixed) bend += 2 * times(row, v).upper_magnitude();
    result.contraction = larger_bound(result.contraction, kSlack * far);
    result.bend = larger_bound(result.bend, kSlack * bend);
  }
  return result;
}

double size_of_term(const FieldNumber& q) { return ball_around_number(q).upper_magnitude(); }

}  // namespace

template <class K>
std::optional<CurveSeries> CurveSeries::about(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                              const std::array<FieldNumber, 4>& p, std::size_t axis) {
  CurveSeries series;
  series.axis_ = axis;
  series.side_ = K::side;
  series.x_ = about_own_point<K>(x, p[0], p[1]);
  series.y_ = about_own_point<K>(y, p[2], p[3]);
  if (!invert_exactly(columns_at_zero(series.x_, series.y_, K::side), axis, series.inverse_))
    return std::nullopt;
  series.terms_.fill({0});
  for (std::size_t m = 1; m <= kMostSeriesOrder && (m < 4 || !series.is_complete()); ++m) {
    for (std::size_t j = 0; j < 4; ++j) series.terms_[j].push_back(m == 1 && j == axis ? 1 : 0);
    const auto g = difference_along(series.x_, series.y_, K::side, series.terms_, m);
    for (std::size_t k = 0; k < 3; ++k)
      series.terms_[k < axis ? k : k + 1][m] = -dot_over(series.inverse_[k], {g[0][m], g[1][m], g[2][m]});
  }
  series.bound_rest();
  return series;
}

bool CurveSeries::is_complete() const {
  return order(0) != 0 && order(1) != 0 && order(2) != 0 && order(3) != 0;
}

/// Lower coefficients are zero.
void CurveSeries::bound_rest() {
  std::array<Terms<DoubleBall>, 4> w;
  for (std::size_t j = 0; j < 4; ++j)
    for (const FieldNumber& c : terms_[j]) w[j].push_back(ball_around_number(c));
  const std::size_t known = terms_[0].size(), most = 4 * (side_ - 1) * (known - 1);
  const auto g = difference_along(enclosed(x_), enclosed(y_), side_, w, most);
  for (std::size_t m = known; m <= most; ++m) {
    double size = 0;
    for (const Triple<FieldNumber>& row : inverse_) {
      DoubleBall sum(0);
      for (std::size_t k = 0; k < 3; ++k) sum += ball_around_number(row[k]) * g[k][m];
      size = larger_bound(size, sum.upper_magnitude());
    }
    rest_.push_back(size);
  }
}

std::size_t CurveSeries::order(std::size_t j) const {
  const Terms<FieldNumber>& w = terms_[j];
  const auto first = std::find_if(w.begin() + 1, w.end(), [](const FieldNumber& c) { return !c.is_zero(); });
  return first == w.end() ? 0 : static_cast<std::size_t>(first - w.begin());
}

/// Bound of the derivative of the terms from a power on, divided by tau^(from - 1).
double CurveSeries::size_of_change(std::size_t j, double reach, std::size_t from) const {
  double sum = 0;
  for (std::size_t m = terms_[j].size(); m-- > from;)
    sum = kSlack * (sum * reach + static_cast<double>(m) * size_of_term(terms_[j][m]));
  return sum;
}

// (14.120).
int CurveSeries::sign_beside(const std::array<double, 4>& room, double reach, std::size_t j) const {
  const std::size_t m = order(j);
  if (m == 0) return 0;
  const BoxBounds box = bounds_in(shifted(x_, side_, room[0], room[1]), shifted(y_, side_, room[2], room[3]),
                                  side_, inverse_, axis_);
  double speed = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double change = size_of_change(i, reach, 1);
    if (!(kSlack * reach * change <= room[i])) return 0;
    speed = larger_bound(speed, change);
  }
  // Of the rest and its derivative, divided by tau^(m - 1); powers of tau are at most those of reach.
  double value = 0, slope = 0;
  for (std::size_t k = 0; k < rest_.size(); ++k) {
    const std::size_t power = terms_[0].size() + k;
    const double of_reach = std::max(std::pow(reach, static_cast<double>(power - m)), kTiny);
    const double size = kSlack * rest_[k] * of_reach;
    value += kSlack * reach * size;
    slope += static_cast<double>(power) * size;
  }
  const double factor = kSlack / (1 - box.contraction);
  const double error = kSlack * factor * (slope + box.bend * factor * value * speed);
  const DoubleBall first = DoubleBall(static_cast<double>(m)) * ball_around_number(terms_[j][m]);
  const double others = kSlack * (reach * size_of_change(j, reach, m + 1) + error) + kTiny;
  return box.contraction < 1 ? first.widened(others).certain_sign() : 0;
}

#define EXSECT_INSTANTIATE(K)                                                                           \
  template std::optional<CurveSeries> CurveSeries::about<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                            const std::array<FieldNumber, 4>&, std::size_t);
EXSECT_INSTANTIATE(Bicubic)
EXSECT_INSTANTIATE(WeightedBiquadratic)
EXSECT_INSTANTIATE(WeightedBicubic)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "filter/local_forms.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

using exsect::operator-;
using exsect::operator*;
using exsect::cross;
using exsect::dot;

using Net = std::array<Point, 9>;
using FormTable = std::array<Rational, 9>;

/// Coefficients of (h,k) -> patch(u + h, v + k).
Net taylor(const BezierPatch& patch, const Rational& u, const Rational& v) {
  const ControlNet power = patch.power_basis();
  Net c;
  for (std::size_t i = 0; i < 9; ++i) c[i] = power[i / 3][i % 3];
  const auto shift = [](Point& c0, Point& c1, const Point& c2, const Rational& t) {
    const Point second = t * c2;
    const Point half = exsect::operator+(c1, second);
    c0 = exsect::operator+(c0, t* half);
    c1 = exsect::operator+(half, second);
  };
  for (std::size_t i = 0; i < 9; i += 3) shift(c[i], c[i + 1], c[i + 2], v);
  for (std::size_t j = 0; j < 3; ++j) shift(c[j], c[3 + j], c[6 + j], u);
  return c;
}

FormTable along(const Point& form, const Net& c) {
  FormTable table;
  for (std::size_t i = 1; i < 9; ++i) table[i] = dot(form, c[i]);
  return table;
}

ScalarTable rounded_table(const FormTable& table) {
  ScalarTable result{};
  for (std::size_t i = 1; i < 9; ++i) result[i] = to_double(table[i]);
  return result;
}
ScalarTable rounded_table(FormTable table, const Rational& factor) {
  for (Rational& c : table) c *= factor;
  return rounded_table(table);
}

bool is_moderate(const ScalarTable& table) {
  return std::all_of(table.begin(), table.end(),
                     [](double c) { return std::fabs(c) < kGreatestCoefficient; });
}

/// 2^k with 1/4 < 2^k |q| < 4 for the largest coefficient of a form that is not zero.
Rational to_size_one(const std::array<Rational, 3>& form) {
  const Rational largest = std::max({Rational(abs(form[0])), Rational(abs(form[1])), Rational(abs(form[2]))});
  return power_of_two(static_cast<long>(msb(denominator(largest))) -
                      static_cast<long>(msb(numerator(largest))));
}

/// f_0 r² + f_1 r s + f_2 s²
template <class Number>
using Form = std::array<Number, 3>;

/// The quadratic terms of normal_x, at c = B a, less those of normal_y.
Form<Rational> leading_form(const FormTable& nx, const FormTable& ny, const std::array<FormTable, 2>& b) {
  const Rational &u1 = b[0][3], &u2 = b[0][1], &v1 = b[1][3], &v2 = b[1][1];
  return {nx[6] * u1 * u1 + nx[4] * u1 * v1 + nx[2] * v1 * v1 - ny[6],
          2 * nx[6] * u1 * u2 + nx[4] * (u1 * v2 + u2 * v1) + 2 * nx[2] * v1 * v2 - ny[4],
          nx[6] * u2 * u2 + nx[4] * u2 * v2 + nx[2] * v2 * v2 - ny[2]};
}

std::array<double, 2> of_size_one(double r, double s) {
  const double size = std::max(std::fabs(r), std::fabs(s));
  return {r / size, s / size};
}

/// The two directions in which the form vanishes, as columns.
Matrix2 null_directions(const Form<double>& f, double discriminant) {
  const double w = -0.5 * (f[1] + std::copysign(std::sqrt(discriminant), f[1]));
  const auto first = of_size_one(w, f[0]);
  const auto second = of_size_one(f[2], w);
  return {{{first[0], second[0]}, {first[1], second[1]}}};
}

/// Conjugate directions, in which the form has the same value: as columns, the larger one of size one.
Matrix2 conjugate_directions(const Form<double>& f, double discriminant) {
  const bool first = std::fabs(f[0]) >= std::fabs(f[2]);
  const double larger = std::fabs(first ? f[0] : f[2]);
  const double other = -discriminant / (4 * larger);  // the value at (-f1/(2 f0), 1)
  const double scale = 1 / std::sqrt(larger);
  const double across = 1 / std::sqrt(std::fabs(other));
  const double along = -0.5 * f[1] / (first ? f[0] : f[2]) * across;
  const double size = std::max({scale, across, std::fabs(along)});
  Matrix2 s = {{{scale / size, along / size}, {0, across / size}}};
  if (!first) std::swap(s[0], s[1]);
  return s;
}

double value(const Form<double>& f, const Matrix2& s, std::size_t i, std::size_t j) {
  return f[0] * s[0][i] * s[0][j] + 0.5 * f[1] * (s[0][i] * s[1][j] + s[1][i] * s[0][j]) +
         f[2] * s[1][i] * s[1][j];
}

double magnitude(const ScalarTable& table, std::size_t i, double p, double q) {
  double product = std::fabs(table[i]) + kTiny;
  for (std::size_t n = 0; n < i / 3; ++n) product *= p;
  for (std::size_t n = 0; n < i % 3; ++n) product *= q;
  return product;
}

/// A bound, but for roundings, of the terms of orders `least` to 4, divided by |t|^least, for parameters of
/// sizes p |t| and q |t|, |t| <= reach: p, q >= 2^-11 and reach >= 2^-20, so that no product underflows.
double bound(const ScalarTable& table, std::size_t least, double p, double q, double reach) {
  double sum = 0;
  for (std::size_t i = 1; i < 9; ++i) {
    const std::size_t order = i / 3 + i % 3;
    if (order >= least) {
      sum += magnitude(table, i, p, q) * std::pow(reach, static_cast<double>(order - least));
    }
  }
  return sum;
}

}  // namespace

std::optional<LocalForms> local_forms(const BezierPatch& x, const BezierPatch& y,
                                      const std::array<Rational, 4>& p) {
  const Net cx = taylor(x, p[0], p[1]);
  const Net cy = taylor(y, p[2], p[3]);
  const Point n = cross(cx[3], cx[1]);
  const Rational nn = dot(n, n);
  if (!(cx[0] == cy[0]) || nn == 0 || dot(n, cy[3]) != 0 || dot(n, cy[1]) != 0) return std::nullopt;
  const Rational inverse = 1 / nn;
  const std::array<Point, 2> dual = {inverse * cross(cx[1], n), inverse * cross(n, cx[3])};
  const std::array<FormTable, 2> y_across = {along(dual[0], cy), along(dual[1], cy)};
  const FormTable nx = along(n, cx);
  const FormTable ny = along(n, cy);
  Form<Rational> q = leading_form(nx, ny, y_across);
  if (q[0] == 0 && q[1] == 0 && q[2] == 0) return std::nullopt;
  const Rational scale = to_size_one(q);
  for (Rational& c : q) c *= scale;
  const Rational discriminant = q[1] * q[1] - 4 * q[0] * q[2];
  if (discriminant == 0) return std::nullopt;
  LocalForms f;
  f.crossing = discriminant > 0;
  const Form<double> form = {to_double(q[0]), to_double(q[1]), to_double(q[2])};
  f.s = (f.crossing ? null_directions : conjugate_directions)(form, to_double(discriminant));
  const double factor = 1 / (f.crossing ? 2 * value(form, f.s, 0, 1) : value(form, f.s, 0, 0));
  if (!(std::fabs(factor) < kGreatestCoefficient)) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i) {
    f.x[i] = rounded_table(along(dual[i], cx));
    f.y[i] = rounded_table(y_across[i]);
    for (std::size_t j = 0; j < 2; ++j) f.bs[i][j] = f.y[i][3] * f.s[0][j] + f.y[i][1] * f.s[1][j];
    f.bs_error[i] = kLocalError * (std::fabs(f.y[i][3]) + std::fabs(f.y[i][1])) + kTiny;
  }
  f.normal_x = rounded_table(nx, scale * from_double(factor));
  f.normal_y = rounded_table(ny, scale * from_double(factor));
  for (const ScalarTable* table : {&f.x[0], &f.x[1], &f.y[0], &f.y[1], &f.normal_x, &f.normal_y}) {
    if (!is_moderate(*table)) return std::nullopt;
  }
  const double size = std::fabs(factor) * (std::fabs(form[0]) + std::fabs(form[1]) + std::fabs(form[2]));
  const double first = factor * value(form, f.s, 0, 0) - (f.crossing ? 0 : 1);
  const double mixed = 2 * factor * value(form, f.s, 0, 1) - (f.crossing ? 1 : 0);
  const double last = factor * value(form, f.s, 1, 1) - (f.crossing ? 0 : 1);
  f.rest = kSlack * (std::fabs(first) + std::fabs(mixed) + std::fabs(last) + kFormError * size);
  const double determinant = f.s[0][0] * f.s[1][1] - f.s[0][1] * f.s[1][0];
  return std::fabs(determinant) > kLeastDeterminant && f.rest < 0x1p-10 ? std::optional(f) : std::nullopt;
}

std::optional<LocalBounds> local_bounds(const LocalForms& f, double reach) {
  const std::array<double, 2> s = {std::fabs(f.s[0][0]) + std::fabs(f.s[0][1]),
                                   std::fabs(f.s[1][0]) + std::fabs(f.s[1][1])};
  std::array<double, 2> b;
  for (std::size_t i = 0; i < 2; ++i) {
    b[i] = kSlack * (std::fabs(f.bs[i][0]) + std::fabs(f.bs[i][1]) + 2 * f.bs_error[i]);
  }
  LocalBounds r;
  const double margin = 0.125 * (b[0] + b[1]) + 0x1p-10;
  r.k = {1.25 * b[0] + margin, 1.25 * b[1] + margin};
  const auto& k = r.k;
  std::array<double, 2> chi;  // |X_i(c)| <= chi |t|² for |c| <= k |t|, |Y_i(a)| <= eta |t|²
  std::array<double, 2> eta;
  double steepness = 0;
  double contraction = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    chi[i] = kSlack * bound(f.x[i], 2, k[0], k[1], reach);
    eta[i] = kSlack * bound(f.y[i], 2, s[0], s[1], reach);
    if (!(b[i] + reach * (chi[i] + eta[i]) <= k[i])) return std::nullopt;  // (14.18)
    steepness = larger_bound(steepness, (b[i] + 4 * reach * eta[i]) / k[i]);
    contraction = larger_bound(contraction, 4 * reach * chi[i] / k[i]);
  }
  if (!(contraction < 0.5)) return std::nullopt;
  const double z = kSlack * steepness / (1 - contraction);             // |c_t| <= z k
  const std::array<double, 2> e = {chi[0] + eta[0], chi[1] + eta[1]};  // |c - B S t| <= e |t|²
  r.turn = {kSlack * 4 * (chi[0] * z + eta[0]), kSlack * 4 * (chi[1] * z + eta[1])};
  const auto& d = r.turn;
  const double uu = std::fabs(f.normal_x[6]) + kTiny;
  const double uv = std::fabs(f.normal_x[4]) + kTiny;
  const double vv = std::fabs(f.normal_x[2]) + kTiny;
  const double high_x = bound(f.normal_x, 3, k[0], k[1], reach);
  const double high_y = bound(f.normal_y, 3, s[0], s[1], reach);
  r.value = kSlack * (uu * e[0] * (k[0] + b[0]) + uv * (e[0] * k[1] + b[0] * e[1]) +
                      vv * e[1] * (k[1] + b[1]) + high_x + high_y);  // (14.19)
  r.slope = kSlack *
            (2 * uu * (e[0] * z * k[0] + b[0] * d[0]) + 2 * vv * (e[1] * z * k[1] + b[1] * d[1]) +
             uv * (d[0] * k[1] + b[0] * e[1] + e[0] * z * k[1] + b[0] * d[1]) + 4 * z * high_x + 4 * high_y);
  return r;
}

}  // namespace exsect::filter

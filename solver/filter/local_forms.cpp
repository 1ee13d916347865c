#include "filter/local_forms.h"

#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <cmath>

#include "filter/exact_taylor.h"

namespace exsect::filter {

namespace {

template <class K>
using FormTable = std::array<FieldNumber, K::count>;
template <class K>
using FieldTaylor = ExactTaylorOf<K, FieldNumber>;

using FieldVector = std::array<FieldNumber, 3>;
FieldVector operator*(const FieldNumber& t, const FieldVector& a) { return {t * a[0], t * a[1], t * a[2]}; }

/// Of a net about its point, in space.
template <class K>
FieldVector coefficient(const FieldTaylor<K>& c, std::size_t i) {
  return {c[i][0], c[i][1], c[i][2]};
}
template <class K>
FormTable<K> along(const FieldVector& form, const FieldTaylor<K>& c) {
  FormTable<K> table;
  for (std::size_t i = 1; i < K::count; ++i) table[i] = dot_over(form, coefficient<K>(c, i));
  return table;
}

/// Taylor coefficients with the point itself as origin and, of weighted patches, weight 1 there.
template <class K>
FieldTaylor<K> about_its_point(FieldTaylor<K> c) {
  if constexpr (K::weighted) {
    const FieldNumber inverse = 1 / c[0][3];
    for (auto& row : c)
      for (FieldNumber& a : row) a *= inverse;
    const auto point = c[0];
    for (auto& row : c)
      for (std::size_t k = 0; k < 3; ++k) row[k] -= row[3] * point[k];
  }
  return c;
}
template <class K>
bool is_one_point(const FieldTaylor<K>& a, const FieldTaylor<K>& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if constexpr (K::weighted) {
      if (!(a[0][k] * b[0][3] == b[0][k] * a[0][3])) return false;
    } else {
      if (!(a[0][k] == b[0][k])) return false;
    }
  }
  return true;
}

/// (14.17), (14.43)
template <class K>
struct ExactForms {
  std::array<FormTable<K>, 2> x;
  std::array<FormTable<K>, 2> y;
  FormTable<K> normal_x;
  FormTable<K> normal_y;
  FormTable<K> weight_x = {};
  FormTable<K> weight_y = {};
};

/// Empty if there is no singular solution in which x is regular.
template <class K>
std::optional<ExactForms<K>> exact_forms(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                         const std::array<FieldNumber, 4>& p) {
  FieldTaylor<K> cx = exact_taylor<K>(x, p[0], p[1]);
  FieldTaylor<K> cy = exact_taylor<K>(y, p[2], p[3]);
  if (!is_one_point<K>(cx, cy)) return std::nullopt;
  cx = about_its_point<K>(std::move(cx));
  cy = about_its_point<K>(std::move(cy));
  const std::array<FieldVector, 2> tangent = {coefficient<K>(cx, kFirst<K>), coefficient<K>(cx, kSecond)};
  const FieldVector n = cross_over(tangent[0], tangent[1]);
  const FieldNumber nn = dot_over(n, n);
  if (nn.is_zero()) return std::nullopt;
  ExactForms<K> f;
  f.normal_y = along<K>(n, cy);
  if (!f.normal_y[kFirst<K>].is_zero() || !f.normal_y[kSecond].is_zero()) return std::nullopt;
  f.normal_x = along<K>(n, cx);
  const FieldNumber inverse = 1 / nn;
  const std::array<FieldVector, 2> dual = {inverse * cross_over(tangent[1], n),
                                           inverse * cross_over(n, tangent[0])};
  for (std::size_t i = 0; i < 2; ++i) {
    f.x[i] = along<K>(dual[i], cx);
    f.y[i] = along<K>(dual[i], cy);
  }
  if constexpr (K::weighted) {
    for (std::size_t i = 1; i < K::count; ++i) {
      f.weight_x[i] = cx[i][3] - cx[kFirst<K>][3] * f.x[0][i] - cx[kSecond][3] * f.x[1][i];
      f.weight_y[i] = cy[i][3] - cx[kFirst<K>][3] * f.y[0][i] - cx[kSecond][3] * f.y[1][i];
    }
  }
  return f;
}

template <class K>
ScalarTableOf<K> rounded_table(const FormTable<K>& table, const Rational& factor = 1) {
  ScalarTableOf<K> result{};
  for (std::size_t i = 1; i < K::count; ++i)
    result[i] = to_double(factor == 1 ? table[i] : factor * table[i]);
  return result;
}

template <class Table>
bool is_moderate(const Table& table) {
  return std::all_of(table.begin(), table.end(),
                     [](double c) { return std::fabs(c) < kGreatestCoefficient; });
}

/// 2^k with 1/8 < 2^k |q| < 8 for the largest coefficient of a form that is not zero.
Rational to_size_one(const std::array<FieldNumber, 3>& form) {
  Rational largest = 0;
  for (const FieldNumber& c : form) largest = std::max<Rational>(largest, abs(enclosure(c, 2).midpoint()));
  return power_of_two(static_cast<long>(msb(denominator(largest))) -
                      static_cast<long>(msb(numerator(largest))));
}

/// f_0 r² + f_1 r s + f_2 s²
template <class Number>
using Form = std::array<Number, 3>;

/// The quadratic terms of normal_x, at c = B a, less those of normal_y.
template <class K>
Form<FieldNumber> leading_form(const ExactForms<K>& f) {
  const auto& [uu, uv, vv] = kQuadratic<K>;
  const FormTable<K>& nx = f.normal_x;
  const FormTable<K>& ny = f.normal_y;
  const FieldNumber &u1 = f.y[0][kFirst<K>], &u2 = f.y[0][kSecond];
  const FieldNumber &v1 = f.y[1][kFirst<K>], &v2 = f.y[1][kSecond];
  return {nx[uu] * u1 * u1 + nx[uv] * u1 * v1 + nx[vv] * v1 * v1 - ny[uu],
          2 * nx[uu] * u1 * u2 + nx[uv] * (u1 * v2 + u2 * v1) + 2 * nx[vv] * v1 * v2 - ny[uv],
          nx[uu] * u2 * u2 + nx[uv] * u2 * v2 + nx[vv] * v2 * v2 - ny[vv]};
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

/// The tables, S and B S, from the exact ones and the form; `factor` makes q that of LocalForms.
template <class K>
void round_tables(const ExactForms<K>& exact, const Rational& factor, LocalFormsOf<K>& f) {
  for (std::size_t i = 0; i < 2; ++i) {
    f.x[i] = rounded_table<K>(exact.x[i]);
    f.y[i] = rounded_table<K>(exact.y[i]);
    const double first = f.y[i][kFirst<K>];
    const double second = f.y[i][kSecond];
    for (std::size_t j = 0; j < 2; ++j) f.bs[i][j] = first * f.s[0][j] + second * f.s[1][j];
    f.bs_error[i] = kLocalError * (std::fabs(first) + std::fabs(second)) + kTiny;
  }
  f.normal_x = rounded_table<K>(exact.normal_x, factor);
  f.normal_y = rounded_table<K>(exact.normal_y, factor);
  if constexpr (K::weighted) {
    f.weight_x = rounded_table<K>(exact.weight_x);
    f.weight_y = rounded_table<K>(exact.weight_y);
  }
}

template <class K>
bool are_moderate(const LocalFormsOf<K>& f) {
  return is_moderate(f.x[0]) && is_moderate(f.x[1]) && is_moderate(f.y[0]) && is_moderate(f.y[1]) &&
         is_moderate(f.normal_x) && is_moderate(f.normal_y) && is_moderate(f.weight_x) &&
         is_moderate(f.weight_y);
}

}  // namespace

template <class K>
std::optional<LocalFormsOf<K>> local_forms(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                           const std::array<FieldNumber, 4>& p) {
  const auto exact = exact_forms<K>(x, y, p);
  if (!exact) return std::nullopt;
  Form<FieldNumber> q = leading_form<K>(*exact);
  if (q[0].is_zero() && q[1].is_zero() && q[2].is_zero()) return std::nullopt;
  const Rational scale = to_size_one(q);
  for (FieldNumber& c : q) c *= scale;
  const FieldNumber discriminant = q[1] * q[1] - 4 * q[0] * q[2];
  if (discriminant.is_zero()) return std::nullopt;
  LocalFormsOf<K> f;
  f.crossing = sign(discriminant) > 0;
  const Form<double> form = {to_double(q[0]), to_double(q[1]), to_double(q[2])};
  f.s = (f.crossing ? null_directions : conjugate_directions)(form, to_double(discriminant));
  const double factor = 1 / (f.crossing ? 2 * value(form, f.s, 0, 1) : value(form, f.s, 0, 0));
  if (!(std::fabs(factor) < kGreatestCoefficient)) return std::nullopt;
  round_tables<K>(*exact, scale * from_double(factor), f);
  if (!are_moderate<K>(f)) return std::nullopt;
  const double size = std::fabs(factor) * (std::fabs(form[0]) + std::fabs(form[1]) + std::fabs(form[2]));
  const double first = factor * value(form, f.s, 0, 0) - (f.crossing ? 0 : 1);
  const double mixed = 2 * factor * value(form, f.s, 0, 1) - (f.crossing ? 1 : 0);
  const double last = factor * value(form, f.s, 1, 1) - (f.crossing ? 0 : 1);
  f.rest = kSlack * (std::fabs(first) + std::fabs(mixed) + std::fabs(last) + kFormError * size);
  const double determinant = f.s[0][0] * f.s[1][1] - f.s[0][1] * f.s[1][0];
  return std::fabs(determinant) > kLeastDeterminant && f.rest < 0x1p-10 ? std::optional(f) : std::nullopt;
}

#define EXSECT_INSTANTIATE(K)                                                                        \
  template std::optional<LocalFormsOf<K>> local_forms<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                         const std::array<FieldNumber, 4>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "support/oracle_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace exsect::oracle {
namespace {

constexpr std::size_t n3 = 3;

/// Rows of a 4x4 system, eliminated with partial pivoting. Empty if a pivot vanishes.
std::optional<Vector4> solve(std::array<Vector4, 4> m, Vector4 b) {
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 4; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    if (std::abs(m[pivot][k]) < 1e-14) return std::nullopt;
    std::swap(m[k], m[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < 4; ++i) {
      const double f = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 4; ++j) m[i][j] -= f * m[k][j];
      b[i] -= f * b[k];
    }
  }
  for (std::size_t k = 4; k-- > 0;) {
    for (std::size_t j = k + 1; j < 4; ++j) b[k] -= m[k][j] * b[j];
    b[k] /= m[k][k];
  }
  return b;
}

double power(double a, std::size_t n) { return n == 0 ? 1 : n == 1 ? a : n == 2 ? a * a : a * a * a; }
long binomial(std::size_t n, std::size_t k) {
  return k == 0 || k == n ? 1 : static_cast<long>(n);  // n <= 3
}

}  // namespace

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector4& a, const Vector4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Vector4 along(const Vector4& a, double t, const Vector4& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2], a[3] + t * b[3]};
}

double distance(const Vector4& a, const Vector4& b) {
  double result = 0;
  for (std::size_t i = 0; i < 4; ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

Vector4 axis(std::size_t i) {
  Vector4 result{};
  result[i] = 1;
  return result;
}

std::optional<Matrix3> inverse_of_columns(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double det = dot(a, cross(b, c));
  const double scale = std::sqrt(dot(a, a) * dot(b, b) * dot(c, c));
  if (!(std::abs(det) > 1e-12 * scale)) return std::nullopt;
  Matrix3 rows = {cross(b, c), cross(c, a), cross(a, b)};
  for (Vector3& row : rows) {
    for (double& entry : row) entry /= det;
  }
  return rows;
}

Vector3 Expansion::remainder(const Vector4& w) const {
  Vector3 result{};
  for (std::size_t patch = 0; patch < 2; ++patch) {
    for (std::size_t i = 0; i <= degrees_[patch][0]; ++i) {
      for (std::size_t j = 0; j <= degrees_[patch][1]; ++j) {
        if (i + j < 2) continue;
        const double f = power(w[2 * patch], i) * power(w[2 * patch + 1], j);
        for (std::size_t k = 0; k < n3; ++k) result[k] += f * std::abs(taylor_[patch][i][j][k]);
      }
    }
  }
  return result;
}

Vector3 Expansion::deviation(std::size_t column_index, const Vector4& w) const {
  const std::size_t patch = column_index / 2;
  const std::size_t first = column_index % 2 == 0 ? 1 : 0;  // derivative orders
  const std::size_t second = 1 - first;
  Vector3 result{};
  for (std::size_t i = first; i <= degrees_[patch][0]; ++i) {
    for (std::size_t j = second; j <= degrees_[patch][1]; ++j) {
      if (i == first && j == second) continue;
      const double factor = static_cast<double>(first == 1 ? i : j);
      const double f = factor * power(w[2 * patch], i - first) * power(w[2 * patch + 1], j - second);
      for (std::size_t k = 0; k < n3; ++k) result[k] += f * std::abs(taylor_[patch][i][j][k]);
    }
  }
  return result;
}

/// The coefficient of u^i v^j is a sum of differences of the control points.
System::System(const RationalPatch& x, const RationalPatch& y) {
  for (std::size_t patch = 0; patch < 2; ++patch) {
    const RationalPatch& p = (patch == 0 ? x : y).reduced();
    const auto m = static_cast<std::size_t>(p.degree_u());
    const auto n = static_cast<std::size_t>(p.degree_v());
    degrees_[patch] = {m, n};
    for (std::size_t i = 0; i <= m; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        Point sum = {0, 0, 0};
        for (std::size_t a = 0; a <= i; ++a) {
          for (std::size_t b = 0; b <= j; ++b) {
            const long sign = (i - a + j - b) % 2 == 0 ? 1 : -1;
            sum = sum + Rational(sign * binomial(i, a) * binomial(j, b)) *
                            p.point(static_cast<int>(a), static_cast<int>(b));
          }
        }
        for (std::size_t k = 0; k < n3; ++k) {
          power_[patch][i][j][k] = to_double(Rational(binomial(m, i) * binomial(n, j)) * sum[k]);
          size_ = std::max(size_, std::abs(to_double(p.point(static_cast<int>(i), static_cast<int>(j))[k])));
        }
      }
    }
  }
}

Expansion System::at(const Vector4& z) const {
  Expansion e;
  e.taylor_ = {};
  e.degrees_ = degrees_;
  for (std::size_t patch = 0; patch < 2; ++patch) {
    const double a = z[2 * patch];
    const double b = z[2 * patch + 1];
    const auto [last_m, last_n] = degrees_[patch];
    for (std::size_t i = 0; i <= last_m; ++i) {
      for (std::size_t j = 0; j <= last_n; ++j) {
        Vector3& t = e.taylor_[patch][i][j];
        for (std::size_t m = i; m <= last_m; ++m) {
          for (std::size_t n = j; n <= last_n; ++n) {
            const double f =
                static_cast<double>(binomial(m, i) * binomial(n, j)) * power(a, m - i) * power(b, n - j);
            for (std::size_t k = 0; k < n3; ++k) t[k] += f * power_[patch][m][n][k];
          }
        }
      }
    }
  }
  for (std::size_t k = 0; k < n3; ++k) {
    e.value[k] = e.taylor_[0][0][0][k] - e.taylor_[1][0][0][k];
    e.column[0][k] = e.taylor_[0][1][0][k];
    e.column[1][k] = e.taylor_[0][0][1][k];
    e.column[2][k] = -e.taylor_[1][1][0][k];
    e.column[3][k] = -e.taylor_[1][0][1][k];
  }
  return e;
}

std::optional<Vector4> System::tangent(const Vector4& z) const {
  const auto c = at(z).column;
  Vector4 t = {dot(c[1], cross(c[2], c[3])), -dot(c[0], cross(c[2], c[3])), dot(c[0], cross(c[1], c[3])),
               -dot(c[0], cross(c[1], c[2]))};
  const double length = std::sqrt(dot(t, t));
  if (!(length > 1e-10 * size_ * size_ * size_)) return std::nullopt;
  for (double& entry : t) entry /= length;
  return t;
}

std::optional<Vector4> System::newton(const Vector4& start, const Vector4& normal) const {
  Vector4 z = start;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Expansion e = at(z);
    std::array<Vector4, 4> rows;
    Vector4 right;
    for (std::size_t k = 0; k < n3; ++k) {
      for (std::size_t i = 0; i < 4; ++i) rows[k][i] = e.column[i][k] / size_;
      right[k] = -e.value[k] / size_;
    }
    rows[3] = normal;
    right[3] = dot(normal, start) - dot(normal, z);
    const auto step = solve(rows, right);
    if (!step) return std::nullopt;
    z = along(z, 1, *step);
    if (distance(z, start) > 10) return std::nullopt;
    if (distance(*step, {}) < 1e-12) return z;
  }
  return std::nullopt;
}

}  // namespace exsect::oracle

#include "filter/injectivity.h"

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

/// Vectors c_i with c_i.a_j = 1 for i = j and 0 otherwise, but for rounding: (A^T A)^-1 A^T.
template <std::size_t N>
std::array<Vec<N>, 3> dual_rows(const std::array<Vec<N>, 3>& a) {
  std::array<Vec3, 3> gram;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) gram[i][j] = dot(a[i], a[j]);
  }
  const double inverse = 1 / dot(gram[0], cross(gram[1], gram[2]));
  std::array<Vec<N>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 c = inverse * cross(gram[(i + 1) % 3], gram[(i + 2) % 3]);
    rows[i] = c[0] * a[0] + (c[1] * a[1] + c[2] * a[2]);
  }
  return rows;
}

/// How far a mean is from 1, or from 0, with the errors of the coefficients.
template <std::size_t Rows>
double off(const MeanDerivative& mean, const Vec<Rows>& row, double error, bool is_one) {
  return std::fabs(mean.middle - (is_one ? 1 : 0)) + mean.deviation + size1(row) * error;
}

/// A z = (z_0, z_1, 1) for which the first two rows of p z are a little less than z, if there is one that
/// is positive: a guess.
Vec3 nearly_fixed(const std::array<Vec3, 3>& p) {
  constexpr double kMore = 1 + 0x1p-6;
  const double determinant = (1 - p[0][0]) * (1 - p[1][1]) - p[0][1] * p[1][0];
  const double first = kMore * (p[0][2] + kTiny) / determinant;
  const double second = kMore * (p[1][2] + kTiny) / determinant;
  return {(1 - p[1][1]) * first + p[0][1] * second, p[1][0] * first + (1 - p[0][0]) * second, 1};
}

/// x_2 - x_1 = du a + dv b along the segment between two points of the rectangle, a and b means of x_u and
/// x_v. In coordinates of the tangent plane in the middle a is within d_u of (1,0), and b within d_v of
/// (0,1): (14.24).
template <class K>
requires(!K::weighted) bool are_independent(const RectangleExpansionOf<K>& x, double error) {
  const CoefficientsOf<K>& c = x.at_middle;
  const Vec3 n = cross(c[kFirst<K>], c[kSecond]);
  const double inverse = 1 / dot(n, n);
  const std::array<Vec3, 2> rows = {inverse * cross(c[kSecond], n), inverse * cross(n, c[kFirst<K>])};
  std::array<double, 2> du;
  std::array<double, 2> dv;
  for (std::size_t i = 0; i < 2; ++i) {
    du[i] = off(mean_first<K>(x, rows[i]), rows[i], error, i == 0);
    dv[i] = off(mean_second<K>(x, rows[i]), rows[i], error, i == 1);
  }
  return kSlack * du[0] < 1 && kSlack * dv[1] < 1 &&
         kSlack * du[1] * dv[0] < (1 - kSlack * du[0]) * (1 - kSlack * dv[1]);
}

/// X_2 - l X_1 = du a + dv b - (l - 1) X_1 with means a and b of X_u and X_v: the three vectors are
/// independent if they are near the unit vectors in coordinates in which X_u, X_v and X in the middle of
/// the rectangle are these, (14.41).
template <class K>
requires K::weighted bool are_independent(const RectangleExpansionOf<K>& x, double error) {
  const CoefficientsOf<K>& c = x.at_middle;
  const auto rows = dual_rows<4>({c[kFirst<K>], c[kSecond], c[0]});
  std::array<Vec3, 3> p;  // |M - 1|
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = {off(mean_first<K>(x, rows[i]), rows[i], error, i == 0),
            off(mean_second<K>(x, rows[i]), rows[i], error, i == 1),
            off(mean_value<K>(x, rows[i]), rows[i], error, i == 2)};
  }
  const Vec3 z = nearly_fixed(p);
  return z[0] > 0 && z[1] > 0 && std::ranges::equal(p, z, [&](const Vec3& row, double bound) {
           return kSlack * (row[0] * z[0] + row[1] * z[1] + row[2]) < bound;
         });
}

}  // namespace

template <class K>
bool is_injective(const PatchOf<K>& patch, double error, const Rectangle& where) {
  const auto expansion = expand(patch, where);
  return expansion && are_independent<K>(*expansion, error);
}

#define EXSECT_INSTANTIATE(K) template bool is_injective<K>(const PatchOf<K>&, double, const Rectangle&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

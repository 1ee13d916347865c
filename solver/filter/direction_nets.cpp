#include "filter/direction_nets.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace exsect::filter {

namespace {

template <std::size_t Rows>
Vec<Rows> mean_rows(const Vec<Rows>& a, const Vec<Rows>& b) {
  return 0.5 * (a + b);
}

template <std::size_t Rows>
double largest_of(const Vec<Rows>* begin, std::size_t count) {
  double result = 0;
  for (std::size_t i = 0; i < count; ++i) {
    result = larger_bound(result, largest(begin[i]));
  }
  return result;
}

/// Control point j, 0 <= j <= n, of a curve of degree n - 1 with n points, `step` apart, elevated; t = j / n.
template <std::size_t Degree, std::size_t Rows>
Vec<Rows> elevated(const Vec<Rows>* points, std::size_t j) {
  if (j == 0) return points[0];
  if (j == Degree) return points[Degree - 1];
  if constexpr (Degree == 2) {
    return mean_rows(points[0], points[1]);
  } else {
    const double t = static_cast<double>(j) / static_cast<double>(Degree);
    return t * points[j - 1] + (1 - t) * points[j];
  }
}

template <std::size_t Degree>
constexpr std::array<double, Degree + 1> binomials() {
  std::array<double, Degree + 1> b{};
  b[0] = 1;
  for (std::size_t k = 1; k <= Degree; ++k)
    b[k] = b[k - 1] * static_cast<double>(Degree + 1 - k) / static_cast<double>(k);
  return b;
}

}  // namespace

template <class K>
DirectionNetOf<K> direction_net(const SubPatchOf<K>& x, const std::array<double, 2>& c, double net_error) {
  constexpr std::size_t n = K::degree;
  DirectionNetOf<K> d;
  std::array<Row<K>, n> steps;
  for (std::size_t i = 0; i <= n; ++i) {
    const Row<K>* p = &x.net[K::side * i];
    for (std::size_t j = 0; j < n; ++j) steps[j] = p[j + 1] - p[j];
    for (std::size_t j = 0; j <= n; ++j) d.vectors[K::side * i + j] = c[0] * elevated<n>(steps.data(), j);
  }
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i < n; ++i) steps[i] = x.net[K::side * (i + 1) + j] - x.net[K::side * i + j];
    for (std::size_t i = 0; i <= n; ++i) {
      Row<K>& sum = d.vectors[K::side * i + j];
      sum = sum - c[1] * elevated<n>(steps.data(), i);
    }
  }
  enclose(d.vectors, d.lower, d.upper);
  d.error = kDirectionError * net_error;
  d.size = largest_of(d.vectors.data(), d.vectors.size()) + d.error;
  return d;
}

namespace {

/// The least and the greatest of numbers none of which is NaN, four by four.
template <std::size_t Count>
std::pair<double, double> least_and_greatest(const std::array<double, Count>& numbers) {
  static_assert(Count % 4 == 0);
  std::array<double, 4> least, greatest;
  std::copy_n(numbers.begin(), 4, least.begin());
  greatest = least;
  for (std::size_t k = 4; k < Count; k += 4) {
    for (std::size_t l = 0; l < 4; ++l) {
      const double t = numbers[k + l];
      least[l] = t < least[l] ? t : least[l];
      greatest[l] = t > greatest[l] ? t : greatest[l];
    }
  }
  return {*std::min_element(least.begin(), least.end()), *std::max_element(greatest.begin(), greatest.end())};
}

/// y_r x y_s, bidegree (2n-1,2n-1): the coordinates of the control vectors.
template <class K>
void fill_normals(const SubPatchOf<K>& y, double net_error, NormalNetOf<K>& result) {
  constexpr std::size_t n = K::degree;
  constexpr std::size_t m = n + 1;
  std::array<Row<K>, n * m> a;  // y_r: index m i + j, i < n
  std::array<Row<K>, n * m> b;  // y_s: index n i + j, j < n
  for (std::size_t k = 0; k < n * m; ++k) {
    a[k] = y.net[k + m] - y.net[k];
    b[k] = y.net[m * (k / n) + k % n + 1] - y.net[m * (k / n) + k % n];
  }
  constexpr auto low = binomials<n - 1>();
  constexpr auto high = binomials<n>();
  constexpr auto both = binomials<2 * n - 1>();
  std::array<Vec3, 4 * n * n> vectors{};
  for (std::size_t p = 0; p < n * m; ++p) {
    for (std::size_t q = 0; q < n * m; ++q) {
      const std::size_t i = p / m + q / n;
      const std::size_t j = p % m + q % n;
      const double weight =
          (low[p / m] * high[q / n]) * (high[p % m] * low[q % n]) * ((1 / both[i]) * (1 / both[j]));
      Vec3& sum = vectors[2 * n * i + j];
      sum = sum + weight * cross(a[p], b[q]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < vectors.size(); ++k) result.coordinate[c][k] = vectors[k][c];
  const double size_a = largest_of(a.data(), a.size());
  const double size_b = largest_of(b.data(), b.size());
  result.error = kNormalError * net_error * (size_a + size_b + 3 * net_error) +
                 kNormalRounding<n> * kUnit * size_a * size_b + kTiny;
}

/// The bivectors of (14.31a), bidegree (2n-2,2n-1), times the binomials of both degrees, by coordinates, from
/// the net of Y and that of Y_r.
template <class K>
using Bivectors = std::array<std::array<double, 2 * K::degree*(2 * K::degree - 1)>, 6>;
template <class K>
Bivectors<K> bivectors(const CoefficientsOf<K>& y, const Row<K>* yr) {
  constexpr std::size_t n = K::degree;
  constexpr auto low = binomials<n - 1>();
  Bivectors<K> result{};
  for (std::size_t p = 0; p < n * K::side; ++p) {
    for (std::size_t q = 0; q < n * K::side; ++q) {
      const std::size_t j = p % K::side, l = q % K::side;
      const std::size_t at = 2 * n * (p / K::side + q / K::side) + j + l;
      const Vec<6> b = wedge(y[p], yr[q]);
      const double weight = low[p / K::side] * low[q / K::side];
      if (j < n && l < n) {
        for (std::size_t c = 0; c < 6; ++c) result[c][at] += weight * low[j] * low[l] * b[c];
      }
      if (j > 0 && l > 0) {
        for (std::size_t c = 0; c < 6; ++c) result[c][at - 1] += weight * low[j - 1] * low[l - 1] * b[c];
      }
    }
  }
  return result;
}

/// (14.31a), bidegree (3n-2,3n-2), coordinate by coordinate: rows of 2n numbers go through vector registers.
template <class K>
void fill_normals(const SubPatchOf<K>& y, double net_error, NormalNetOf<K>& result) requires K::weighted {
  constexpr std::size_t n = K::degree;
  constexpr std::size_t row = 2 * n;
  constexpr std::size_t side = 3 * n - 1;
  constexpr auto low = binomials<n - 1>();
  constexpr auto high = binomials<n>();
  constexpr auto all = binomials<3 * n - 2>();
  std::array<Row<K>, n * K::side> yr;  // index (n+1) i + j, i < n
  std::array<Row<K>, n * K::side> ys;  // index n i + j, j < n
  for (std::size_t k = 0; k < yr.size(); ++k) {
    yr[k] = y.net[k + K::side] - y.net[k];
    ys[k] = y.net[K::side * (k / n) + k % n + 1] - y.net[K::side * (k / n) + k % n];
  }
  const Bivectors<K> b = bivectors<K>(y.net, yr.data());
  std::array<std::array<double, side * side>, 4> sums{};
  for (std::size_t p = 0; p < ys.size(); ++p) {
    const Row<K> d = high[p / n] * low[p % n] * ys[p];
    for (std::size_t i = 0; i < row - 1; ++i) {
      const std::size_t first = side * (p / n + i) + p % n;
      for (std::size_t j = 0; j < row; ++j) {
        const std::size_t q = row * i + j;
        sums[0][first + j] += d[1] * b[5][q] - d[2] * b[4][q] + d[3] * b[3][q];
        sums[1][first + j] -= d[0] * b[5][q] - d[2] * b[2][q] + d[3] * b[1][q];
        sums[2][first + j] += d[0] * b[4][q] - d[1] * b[2][q] + d[3] * b[0][q];
        sums[3][first + j] -= d[0] * b[3][q] - d[1] * b[1][q] + d[2] * b[0][q];
      }
    }
  }
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t k = 0; k < side * side; ++k)
      result.coordinate[c][k] = sums[c][k] * (1 / (all[k / side] * all[k % side]));
  }
  const double size_r = largest_of(yr.data(), yr.size());
  const double size_s = largest_of(ys.data(), ys.size());
  const double error =
      kNormalError * net_error * (1 + size_r + 3 * net_error) + kNormalRounding<n> * kUnit * size_r + kTiny;
  result.error = kSlack * (3 * (size_s * error + kDifferenceError * net_error * (2 * size_r + error)) +
                           2 * kCovectorRounding * kUnit * size_r * size_s) +
                 kTiny;
}

}  // namespace

template <class K>
NormalNetOf<K> normal_net(const SubPatchOf<K>& y, double net_error) {
  NormalNetOf<K> result;
  fill_normals<K>(y, net_error, result);
  double size = 0;
  for (std::size_t c = 0; c < K::rows; ++c) {
    auto& numbers = result.coordinate[c];
    std::fill(numbers.begin() + NormalNetOf<K>::count, numbers.end(), numbers[0]);
    const auto [least, greatest] = least_and_greatest(numbers);
    result.lower[c] = least;
    result.upper[c] = greatest;
    size = larger_bound(size, std::fabs(least), std::fabs(greatest));
  }
  result.size = size + result.error;
  return result;
}

template <class K>
std::array<Row<K>, 4> corner_normals(const SubPatchOf<K>& y) {
  constexpr std::size_t n = K::degree;
  std::array<Row<K>, 4> result;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const bool far_r = corner > 1, far_s = corner % 2 == 1;
    const std::size_t at = (far_r ? K::side * n : 0) + (far_s ? n : 0);
    const Row<K>& p = y.net[at];
    const Row<K>& along_r = y.net[far_r ? at - K::side : at + K::side];
    const Row<K>& along_s = y.net[far_s ? at - 1 : at + 1];
    const double sign = far_r == far_s ? 1 : -1;
    if constexpr (K::weighted) {
      result[corner] = sign * join(p, wedge(along_r, along_s));
    } else {
      result[corner] = sign * cross(along_r - p, along_s - p);
    }
  }
  return result;
}

template <class K>
bool changes_sign(const DirectionNetOf<K>& d, const std::array<Row<K>, 4>& normals) {
  constexpr std::size_t n = K::degree;
  constexpr std::array<std::size_t, 4> corners = {0, n, K::side * n, K::count - 1};
  const bool positive = dot(d.vectors[0], normals[0]) > 0;
  for (const std::size_t corner : corners) {
    for (const Row<K>& normal : normals) {
      if ((dot(d.vectors[corner], normal) > 0) != positive) return true;
    }
  }
  return false;
}

namespace {

/// The least product of a vector with those of the net, four by four.
template <std::size_t Rows, std::size_t Padded>
double least_product(const Vec<Rows>& a, const std::array<std::array<double, Padded>, Rows>& b) {
  std::array<double, 4> least;
  least.fill(HUGE_VAL);
  for (std::size_t k = 0; k < Padded; k += 4) {
    for (std::size_t l = 0; l < 4; ++l) {
      double t = a[0] * b[0][k + l] + a[1] * b[1][k + l] + a[2] * b[2][k + l];
      if constexpr (Rows == 4) t += a[3] * b[3][k + l];
      least[l] = t < least[l] ? t : least[l];
    }
  }
  return *std::min_element(least.begin(), least.end());
}

}  // namespace

// d.n = sum B_i(u,v) B_j(r,s) d_i.n_j, so the signs of the d_i.n_j decide.
template <class K>
bool never_orthogonal(const DirectionNetOf<K>& d, const NormalNetOf<K>& n) {
  constexpr std::size_t rows = K::rows;
  const double error = kSlack * (rows * (d.size * n.error + n.size * d.error) +
                                 kProductRounding<rows> * kUnit * d.size * n.size) +
                       kTiny;
  if (!(error < HUGE_VAL)) return false;  // else no coordinate is NaN, and no product
  double lower = 0;
  double upper = 0;
  for (std::size_t c = 0; c < rows; ++c) {
    const auto range = std::minmax(
        {d.lower[c] * n.lower[c], d.lower[c] * n.upper[c], d.upper[c] * n.lower[c], d.upper[c] * n.upper[c]});
    lower += range.first;
    upper += range.second;
  }
  if (lower > error || upper < -error) {
    return true;
  }
  const double sign = dot(d.vectors[K::count / 2], n.vector(NormalNetOf<K>::count / 3)) > 0 ? 1 : -1;
  return std::all_of(d.vectors.begin(), d.vectors.end(),
                     [&](const Row<K>& a) { return least_product<rows>(sign * a, n.coordinate) > error; });
}

#define EXSECT_INSTANTIATE(K)                                                                              \
  template DirectionNetOf<K> direction_net<K>(const SubPatchOf<K>&, const std::array<double, 2>&, double); \
  template NormalNetOf<K> normal_net<K>(const SubPatchOf<K>&, double);                                     \
  template std::array<Row<K>, 4> corner_normals<K>(const SubPatchOf<K>&);                                  \
  template bool changes_sign<K>(const DirectionNetOf<K>&, const std::array<Row<K>, 4>&);                   \
  template bool never_orthogonal<K>(const DirectionNetOf<K>&, const NormalNetOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

#include "filter/direction_nets.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

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

void add(Vec3& sum, double weight, const Vec3& v) { sum = sum + weight * v; }
void add(Vec<6>& sum, double weight, const Vec<6>& v) {
  for (std::size_t i = 0; i < 6; ++i) sum[i] += weight * v[i];
}
double size_of(const Vec<6>& v) {
  return std::accumulate(v.begin(), v.end(), 0.0,
                         [](double most, double t) { return larger_bound(most, std::fabs(t)); });
}

/// y_r ^ y_s, bidegree (2n-1,2n-1), with a bound of the error of each coordinate.
template <class K>
struct TangentNet {
  using Wedge = std::conditional_t<K::weighted, Vec<6>, Vec3>;
  std::array<Wedge, 4 * K::degree * K::degree> vectors;
  double error;
};
template <class K>
TangentNet<K> tangent_net(const SubPatchOf<K>& y, double net_error) {
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
  TangentNet<K> result;
  result.vectors.fill({});
  for (std::size_t p = 0; p < n * m; ++p) {
    for (std::size_t q = 0; q < n * m; ++q) {
      const std::size_t i = p / m + q / n;
      const std::size_t j = p % m + q % n;
      const double weight =
          (low[p / m] * high[q / n]) * (high[p % m] * low[q % n]) * ((1 / both[i]) * (1 / both[j]));
      add(result.vectors[2 * n * i + j], weight, wedge(a[p], b[q]));
    }
  }
  const double size_a = largest_of(a.data(), a.size());
  const double size_b = largest_of(b.data(), b.size());
  result.error = kNormalError * net_error * (size_a + size_b + 3 * net_error) +
                 kNormalRounding<n> * kUnit * size_a * size_b + kTiny;
  return result;
}

/// The vectors of Y ^ (Y_r ^ Y_s), bidegree (3n-1,3n-1), as covectors d -> [d y b]: coordinate by coordinate,
/// whose rows of 2n numbers go through vector registers. Each is rounded 7 + (n+1)^2 times.
template <class K>
std::array<Row<K>, 9 * K::degree * K::degree> covectors(const CoefficientsOf<K>& net,
                                                        const TangentNet<K>& tangents) {
  constexpr std::size_t n = K::degree;
  constexpr std::size_t row = 2 * n;
  constexpr auto low = binomials<n>();
  constexpr auto high = binomials<2 * n - 1>();
  constexpr auto both = binomials<3 * n - 1>();
  std::array<std::array<double, row * row>, 6> b;
  for (std::size_t q = 0; q < row * row; ++q)
    for (std::size_t c = 0; c < 6; ++c) b[c][q] = high[q / row] * high[q % row] * tangents.vectors[q][c];
  std::array<std::array<double, 9 * n * n>, 4> sums{};
  for (std::size_t p = 0; p < K::count; ++p) {
    const Row<K> y = low[p / K::side] * low[p % K::side] * net[p];
    for (std::size_t i = 0; i < row; ++i) {
      const std::size_t first = 3 * n * (p / K::side + i) + p % K::side;
      for (std::size_t j = 0; j < row; ++j) {
        const std::size_t q = row * i + j;
        sums[0][first + j] += y[1] * b[5][q] - y[2] * b[4][q] + y[3] * b[3][q];
        sums[1][first + j] -= y[0] * b[5][q] - y[2] * b[2][q] + y[3] * b[1][q];
        sums[2][first + j] += y[0] * b[4][q] - y[1] * b[2][q] + y[3] * b[0][q];
        sums[3][first + j] -= y[0] * b[3][q] - y[1] * b[1][q] + y[2] * b[0][q];
      }
    }
  }
  std::array<Row<K>, 9 * n * n> vectors;
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    const double share = 1 / (both[k / (3 * n)] * both[k % (3 * n)]);
    for (std::size_t l = 0; l < 4; ++l) vectors[k][l] = share * sums[l][k];
  }
  return vectors;
}

}  // namespace

template <class K>
NormalNetOf<K> normal_net(const SubPatchOf<K>& y, double net_error) {
  const TangentNet<K> tangents = tangent_net(y, net_error);
  NormalNetOf<K> result;
  if constexpr (K::weighted) {
    result.vectors = covectors<K>(y.net, tangents);
    double size = 0;
    for (const auto& vector : tangents.vectors) size = larger_bound(size, size_of(vector));
    result.error = kSlack * (3 * (tangents.error + net_error * (size + tangents.error)) +
                             kCovectorRounding * kUnit * size) +
                   kTiny;
  } else {
    result.vectors = tangents.vectors;
    result.error = tangents.error;
  }
  enclose(result.vectors, result.lower, result.upper);
  result.size = largest_of(result.vectors.data(), result.vectors.size()) + result.error;
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

// d.n = sum B_i(u,v) B_j(r,s) d_i.n_j, so the signs of the d_i.n_j decide.
template <std::size_t M, std::size_t N, std::size_t Rows>
bool never_orthogonal(const VectorNet<M, Rows>& d, const VectorNet<N, Rows>& n) {
  const double error = kSlack * (Rows * (d.size * n.error + n.size * d.error) +
                                 kProductRounding<Rows> * kUnit * d.size * n.size) +
                       kTiny;
  double lower = 0;
  double upper = 0;
  for (std::size_t c = 0; c < Rows; ++c) {
    const auto range = std::minmax(
        {d.lower[c] * n.lower[c], d.lower[c] * n.upper[c], d.upper[c] * n.lower[c], d.upper[c] * n.upper[c]});
    lower += range.first;
    upper += range.second;
  }
  if (lower > error || upper < -error) {
    return true;
  }
  const bool positive = dot(d.vectors[M / 2], n.vectors[N / 3]) > 0;
  for (const Vec<Rows>& a : d.vectors) {
    for (const Vec<Rows>& b : n.vectors) {
      const double t = dot(a, b);
      if (!(positive ? t > error : t < -error)) {
        return false;
      }
    }
  }
  return true;
}

#define EXSECT_INSTANTIATE(K)                                                                              \
  template DirectionNetOf<K> direction_net<K>(const SubPatchOf<K>&, const std::array<double, 2>&, double); \
  template NormalNetOf<K> normal_net<K>(const SubPatchOf<K>&, double);                                     \
  template std::array<Row<K>, 4> corner_normals<K>(const SubPatchOf<K>&);                                  \
  template bool changes_sign<K>(const DirectionNetOf<K>&, const std::array<Row<K>, 4>&);                   \
  template bool never_orthogonal(const DirectionNetOf<K>&, const NormalNetOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

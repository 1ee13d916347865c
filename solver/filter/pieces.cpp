#include "filter/pieces.h"

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

template <std::size_t N>
void enclose(const std::array<Vec3, N>& points, Vec3& lower, Vec3& upper) {
  lower = upper = points[0];
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      lower[c] = std::min(lower[c], points[i][c]);
      upper[c] = std::max(upper[c], points[i][c]);
    }
  }
}

template <std::size_t N>
void project(const std::array<Vec3, N>& points, const Vec3& normal, double& lower, double& upper) {
  lower = upper = dot(points[0], normal);
  for (std::size_t i = 1; i < N; ++i) {
    const double t = dot(points[i], normal);
    lower = std::min(lower, t);
    upper = std::max(upper, t);
  }
}

Vec3 mean(const Vec3& a, const Vec3& b) { return 0.5 * (a + b); }

/// The 2 n + 1 points of a curve of degree n divided in the middle.
template <std::size_t Points>
std::array<Vec3, 2 * Points - 1> divided(std::array<Vec3, Points> p) {
  constexpr std::size_t n = Points - 1;
  std::array<Vec3, 2 * Points - 1> result;
  result[0] = p[0];
  result[2 * n] = p[n];
#pragma GCC unroll 4
  for (std::size_t level = 1; level <= n; ++level) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i + level <= n; ++i) p[i] = mean(p[i], p[i + 1]);
    result[level] = p[0];
    result[2 * n - level] = p[n - level];
  }
  return result;
}

template <class K>
void fill(SubPatchOf<K>& p) {
  constexpr std::size_t n = K::degree;
  enclose(p.net, p.lower, p.upper);
  p.normal = cross(p.net[K::count - 1] - p.net[0], p.net[K::side * n] - p.net[n]);
  p.normal_size = kSlack * (size1(p.normal) + kTiny);
  project(p.net, p.normal, p.normal_lower, p.normal_upper);
  p.children = 0;
}

/// (14.2) for a gap between values of a linear form n.P, size >= |n|_1 + kTiny, or of a coordinate, size 1.
bool apart(double gap, double size, double net_error) { return gap > kSeparation * net_error * size; }

bool boxes_apart(const Vec3& lower_a, const Vec3& upper_a, const Vec3& lower_b, const Vec3& upper_b,
                 double net_error) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (apart(std::max(lower_a[c] - upper_b[c], lower_b[c] - upper_a[c]), 1, net_error)) {
      return true;
    }
  }
  return false;
}

template <class K, std::size_t N>
bool apart_along_normal(const SubPatchOf<K>& patch, const std::array<Vec3, N>& points, double net_error) {
  double lower = 0;
  double upper = 0;
  project(points, patch.normal, lower, upper);
  return apart(std::max(patch.normal_lower - upper, lower - patch.normal_upper), patch.normal_size,
               net_error);
}

double largest_of(const Vec3* begin, std::size_t count) {
  double result = 0;
  for (std::size_t i = 0; i < count; ++i) {
    result = std::max(result, largest(begin[i]));
  }
  return result;
}

}  // namespace

template <class K>
PatchTreeOf<K>::PatchTreeOf(const PatchOf<K>& patch) {
  nodes_.reserve(128);
  SubPatchOf<K> root;
  root.net = patch.net;
  root.first = root.second = -0.5;
  root.width = 1;
  root.level = 0;
  fill(root);
  nodes_.push_back(root);
}

template <class K>
std::size_t PatchTreeOf<K>::split(std::size_t i) {
  constexpr std::size_t n = K::degree;
  if (nodes_[i].children != 0) {
    return nodes_[i].children;
  }
  const std::size_t begin = nodes_.size();
  nodes_.resize(begin + 4);
  SubPatchOf<K>& parent = nodes_[i];
  parent.children = begin;
  std::array<std::array<Row<K>, 2 * n + 1>, n + 1> rows;
  for (std::size_t row = 0; row <= n; ++row) {
    std::array<Row<K>, n + 1> points;
    std::copy_n(&parent.net[K::side * row], n + 1, points.begin());
    rows[row] = divided(points);
  }
  std::array<std::array<Row<K>, 2 * n + 1>, 2 * n + 1> grid;  // by columns
  for (std::size_t column = 0; column <= 2 * n; ++column) {
    std::array<Row<K>, n + 1> points;
    for (std::size_t row = 0; row <= n; ++row) points[row] = rows[row][column];
    grid[column] = divided(points);
  }
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const std::size_t row = quarter / 2;
    const std::size_t column = quarter % 2;
    SubPatchOf<K>& child = nodes_[begin + quarter];
    for (std::size_t k = 0; k < K::count; ++k) {
      child.net[k] = grid[n * column + k % K::side][n * row + k / K::side];
    }
    child.width = 0.5 * parent.width;
    child.first = parent.first + static_cast<double>(row) * child.width;
    child.second = parent.second + static_cast<double>(column) * child.width;
    child.level = parent.level + 1;
    fill(child);
  }
  return begin;
}

template <class K>
void TreesOf<K>::split_larger(const PiecePair& pair, std::vector<PiecePair>& pairs) {
  const SubPatchOf<K>& a = x[pair.x];
  const SubPatchOf<K>& b = y[pair.y];
  const bool first = extent(a.lower, a.upper) > extent(b.lower, b.upper);
  const std::size_t children = first ? x.split(pair.x) : y.split(pair.y);
  for (std::size_t k = 0; k < 4; ++k) {
    pairs.push_back(first ? PiecePair{children + k, pair.y} : PiecePair{pair.x, children + k});
  }
}

template <class K>
SubCurveOf<K> make_curve(const std::array<Row<K>, K::side>& net, double from, double width, int level) {
  SubCurveOf<K> curve{net, {}, {}, from, width, level};
  enclose(curve.net, curve.lower, curve.upper);
  return curve;
}

template <class K>
std::array<SubCurveOf<K>, 2> halves(const SubCurveOf<K>& curve) {
  const auto p = divided(curve.net);
  std::array<Row<K>, K::side> left;
  std::array<Row<K>, K::side> right;
  std::copy_n(p.begin(), K::side, left.begin());
  std::copy_n(p.begin() + K::degree, K::side, right.begin());
  const double width = 0.5 * curve.width;
  return {make_curve<K>(left, curve.from, width, curve.level + 1),
          make_curve<K>(right, curve.from + width, width, curve.level + 1)};
}

template <class K>
bool separated(const SubPatchOf<K>& x, const SubPatchOf<K>& y, double net_error) {
  return boxes_apart(x.lower, x.upper, y.lower, y.upper, net_error) ||
         apart_along_normal(x, y.net, net_error) || apart_along_normal(y, x.net, net_error);
}

template <class K>
bool separated(const SubCurveOf<K>& curve, const SubPatchOf<K>& patch, double net_error) {
  return boxes_apart(curve.lower, curve.upper, patch.lower, patch.upper, net_error) ||
         apart_along_normal(patch, curve.net, net_error);
}

namespace {

/// Control point j, 0 <= j <= n, of a curve of degree n - 1 with n points, `step` apart, elevated; t = j / n.
template <std::size_t Degree>
Vec3 elevated(const Vec3* points, std::size_t j) {
  if (j == 0) return points[0];
  if (j == Degree) return points[Degree - 1];
  if constexpr (Degree == 2) {
    return mean(points[0], points[1]);
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
  std::array<Vec3, n> steps;
  for (std::size_t i = 0; i <= n; ++i) {
    const Vec3* p = &x.net[K::side * i];
    for (std::size_t j = 0; j < n; ++j) steps[j] = p[j + 1] - p[j];
    for (std::size_t j = 0; j <= n; ++j) d.vectors[K::side * i + j] = c[0] * elevated<n>(steps.data(), j);
  }
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i < n; ++i) steps[i] = x.net[K::side * (i + 1) + j] - x.net[K::side * i + j];
    for (std::size_t i = 0; i <= n; ++i) {
      Vec3& sum = d.vectors[K::side * i + j];
      sum = sum - c[1] * elevated<n>(steps.data(), i);
    }
  }
  enclose(d.vectors, d.lower, d.upper);
  d.error = kDirectionError * net_error;
  d.size = largest_of(d.vectors.data(), d.vectors.size()) + d.error;
  return d;
}

template <class K>
NormalNetOf<K> normal_net(const SubPatchOf<K>& y, double net_error) {
  constexpr std::size_t n = K::degree;
  constexpr std::size_t m = n + 1;
  std::array<Vec3, n * m> a;  // y_r: index m i + j, i < n
  std::array<Vec3, n * m> b;  // y_s: index n i + j, j < n
  for (std::size_t k = 0; k < n * m; ++k) {
    a[k] = y.net[k + m] - y.net[k];
    b[k] = y.net[m * (k / n) + k % n + 1] - y.net[m * (k / n) + k % n];
  }
  constexpr auto low = binomials<n - 1>();
  constexpr auto high = binomials<n>();
  constexpr auto both = binomials<2 * n - 1>();
  NormalNetOf<K> result;
  result.vectors.fill(Vec3{0, 0, 0});
  for (std::size_t p = 0; p < n * m; ++p) {
    for (std::size_t q = 0; q < n * m; ++q) {
      const std::size_t i = p / m + q / n;
      const std::size_t j = p % m + q % n;
      const double weight =
          (low[p / m] * high[q / n]) * (high[p % m] * low[q % n]) * ((1 / both[i]) * (1 / both[j]));
      Vec3& sum = result.vectors[2 * n * i + j];
      sum = sum + weight * cross(a[p], b[q]);
    }
  }
  const double size_a = largest_of(a.data(), a.size());
  const double size_b = largest_of(b.data(), b.size());
  enclose(result.vectors, result.lower, result.upper);
  result.error = kNormalError * net_error * (size_a + size_b + 3 * net_error) +
                 kNormalRounding<n> * kUnit * size_a * size_b + kTiny;
  result.size = largest_of(result.vectors.data(), result.vectors.size()) + result.error;
  return result;
}

// d.n = sum B_i(u,v) B_j(r,s) d_i.n_j, so the signs of the d_i.n_j decide.
template <std::size_t M, std::size_t N>
bool never_orthogonal(const VectorNet<M>& d, const VectorNet<N>& n) {
  const double error = kSlack * (kProducts * (d.size * n.error + n.size * d.error) +
                                 kProductRounding * kUnit * d.size * n.size) +
                       kTiny;
  double lower = 0;
  double upper = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto range = std::minmax(
        {d.lower[c] * n.lower[c], d.lower[c] * n.upper[c], d.upper[c] * n.lower[c], d.upper[c] * n.upper[c]});
    lower += range.first;
    upper += range.second;
  }
  if (lower > error || upper < -error) {
    return true;
  }
  const bool positive = dot(d.vectors[M / 2], n.vectors[N / 3]) > 0;
  for (const Vec3& a : d.vectors) {
    for (const Vec3& b : n.vectors) {
      const double t = dot(a, b);
      if (!(positive ? t > error : t < -error)) {
        return false;
      }
    }
  }
  return true;
}

#define EXSECT_INSTANTIATE(K)                                                                              \
  template class PatchTreeOf<K>;                                                                           \
  template struct TreesOf<K>;                                                                              \
  template SubCurveOf<K> make_curve<K>(const std::array<Row<K>, K::side>&, double, double, int);           \
  template std::array<SubCurveOf<K>, 2> halves<K>(const SubCurveOf<K>&);                                   \
  template bool separated<K>(const SubPatchOf<K>&, const SubPatchOf<K>&, double);                          \
  template bool separated<K>(const SubCurveOf<K>&, const SubPatchOf<K>&, double);                          \
  template DirectionNetOf<K> direction_net<K>(const SubPatchOf<K>&, const std::array<double, 2>&, double); \
  template NormalNetOf<K> normal_net<K>(const SubPatchOf<K>&, double);                                     \
  template bool never_orthogonal(const DirectionNetOf<K>&, const NormalNetOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

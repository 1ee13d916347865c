#include "filter/pieces.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

template <std::size_t N>
void project(const std::array<Vec3, N>& points, const Vec3& normal, double& lower, double& upper) {
  lower = upper = dot(points[0], normal);
  for (std::size_t i = 1; i < N; ++i) {
    const double t = dot(points[i], normal);
    lower = std::min(lower, t);
    upper = std::max(upper, t);
  }
}

template <std::size_t Rows>
Vec<Rows> mean(const Vec<Rows>& a, const Vec<Rows>& b) {
  return 0.5 * (a + b);
}

/// The 2 n + 1 points of a curve of degree n divided in the middle.
template <std::size_t Points, std::size_t Rows>
std::array<Vec<Rows>, 2 * Points - 1> divided(std::array<Vec<Rows>, Points> p) {
  constexpr std::size_t n = Points - 1;
  std::array<Vec<Rows>, 2 * Points - 1> result;
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

/// (14.28): with weights of at least w > 0, a quotient of two numbers that err by e is off by e (1 + |x|) /
/// w, and computed as the product with 1/w, rounded twice, by less than 3 u |x|. The bound is also above 160
/// u |x|, as (14.2) needs for points beyond size 1.
template <class K, std::size_t Count>
void fill_affine([[maybe_unused]] AffineNet<K, Count>& p,
                 [[maybe_unused]] const std::array<Row<K>, Count>& net, [[maybe_unused]] double net_error) {
  if constexpr (K::weighted) {
    double least = HUGE_VAL;
    double greatest = 0;
    for (const Row<K>& point : net) {
      least = std::min(least, point[3]);
      greatest = std::max(greatest, point[3]);
    }
    p.least_weight = least - kSlack * net_error - kUnit;
    p.greatest_weight = kSlack * (greatest + net_error);
    if (!(p.least_weight > kLeastWeight)) {
      for (std::size_t i = 0; i < Count; ++i)
        p.affine[i] = {4.0 * (i % 2 == 0 ? 1 : -1), 4, i == 0 ? -4.0 : 4.0};
      p.affine_error = HUGE_VAL;
      p.least_weight = 0;
      return;
    }
    double size = 0;
    for (std::size_t i = 0; i < Count; ++i) {
      const double inverse = 1 / net[i][3];
      p.affine[i] = {inverse * net[i][0], inverse * net[i][1], inverse * net[i][2]};
      size = larger_bound(size, largest(p.affine[i]));
    }
    p.affine_error = kSlack * (net_error * (1 + size) / p.least_weight + 3 * kUnit * size);
  }
}

template <class K>
void fill_bounds(SubPatchOf<K>& p, double net_error) {
  constexpr std::size_t n = K::degree;
  fill_affine<K, K::count>(p, p.net, net_error);
  const auto& points = p.points();
  enclose(points, p.lower, p.upper);
  p.normal = cross(points[K::count - 1] - points[0], points[K::side * n] - points[n]);
  p.normal_size = kSlack * (size1(p.normal) + kTiny);
  project(points, p.normal, p.normal_lower, p.normal_upper);
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

}  // namespace

template <class K>
PatchTreeOf<K>::PatchTreeOf(const PatchOf<K>& patch, double net_error) : net_error_(net_error) {
  SubPatchOf<K>& root = at(four_more());
  root.net = patch.net;
  root.first = root.second = -0.5;
  root.width = 1;
  root.level = 0;
  fill_bounds(root, net_error_);
}

template <class K>
std::size_t PatchTreeOf<K>::four_more() {
  static_assert(kChunk % 4 == 0);
  if (size_ % kChunk == 0) chunks_.push_back(std::make_unique_for_overwrite<Chunk>());
  size_ += 4;
  return size_ - 4;
}

template <class K>
std::size_t PatchTreeOf<K>::split(std::size_t i) {
  constexpr std::size_t n = K::degree;
  SubPatchOf<K>& parent = at(i);
  if (parent.children != 0) {
    return parent.children;
  }
  const std::size_t begin = four_more();
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
    SubPatchOf<K>& child = at(begin + quarter);
    for (std::size_t k = 0; k < K::count; ++k) {
      child.net[k] = grid[n * column + k % K::side][n * row + k / K::side];
    }
    child.width = 0.5 * parent.width;
    child.first = parent.first + static_cast<double>(row) * child.width;
    child.second = parent.second + static_cast<double>(column) * child.width;
    child.level = parent.level + 1;
    fill_bounds(child, net_error_);
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
SubCurveOf<K> make_curve(const std::array<Row<K>, K::side>& net, double from, double width, int level,
                         double net_error) {
  SubCurveOf<K> curve{{}, net, {}, {}, from, width, level};
  fill_affine<K, K::side>(curve, net, net_error);
  enclose(curve.points(), curve.lower, curve.upper);
  return curve;
}

template <class K>
std::array<SubCurveOf<K>, 2> halves(const SubCurveOf<K>& curve, double net_error) {
  const auto p = divided(curve.net);
  std::array<Row<K>, K::side> left;
  std::array<Row<K>, K::side> right;
  std::copy_n(p.begin(), K::side, left.begin());
  std::copy_n(p.begin() + K::degree, K::side, right.begin());
  const double width = 0.5 * curve.width;
  return {make_curve<K>(left, curve.from, width, curve.level + 1, net_error),
          make_curve<K>(right, curve.from + width, width, curve.level + 1, net_error)};
}

template <class K>
bool separated(const SubPatchOf<K>& x, const SubPatchOf<K>& y, double net_error) {
  const double error = larger_bound(x.error(net_error), y.error(net_error));
  return boxes_apart(x.lower, x.upper, y.lower, y.upper, error) || apart_along_normal(x, y.points(), error) ||
         apart_along_normal(y, x.points(), error);
}

template <class K>
bool separated(const SubCurveOf<K>& curve, const SubPatchOf<K>& patch, double net_error) {
  const double error = larger_bound(curve.error(net_error), patch.error(net_error));
  return boxes_apart(curve.lower, curve.upper, patch.lower, patch.upper, error) ||
         apart_along_normal(patch, curve.points(), error);
}

#define EXSECT_INSTANTIATE(K)                                                                            \
  template class PatchTreeOf<K>;                                                                         \
  template struct TreesOf<K>;                                                                            \
  template SubCurveOf<K> make_curve<K>(const std::array<Row<K>, K::side>&, double, double, int, double); \
  template std::array<SubCurveOf<K>, 2> halves<K>(const SubCurveOf<K>&, double);                         \
  template bool separated<K>(const SubPatchOf<K>&, const SubPatchOf<K>&, double);                        \
  template bool separated<K>(const SubCurveOf<K>&, const SubPatchOf<K>&, double);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter

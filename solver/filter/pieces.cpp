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

/// The five points of a quadratic curve divided in the middle.
std::array<Vec3, 5> divided(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 left = mean(a, b);
  const Vec3 right = mean(b, c);
  return {a, left, mean(left, right), right, c};
}

void fill(SubPatch& p) {
  enclose(p.net, p.lower, p.upper);
  p.normal = cross(p.net[8] - p.net[0], p.net[6] - p.net[2]);
  p.normal_size = kSlack * (std::fabs(p.normal[0]) + std::fabs(p.normal[1]) + std::fabs(p.normal[2]) + kTiny);
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

template <std::size_t N>
bool apart_along_normal(const SubPatch& patch, const std::array<Vec3, N>& points, double net_error) {
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

PatchTree::PatchTree(const Patch& patch) {
  nodes_.reserve(128);
  SubPatch root;
  root.net = patch.net;
  root.first = root.second = -0.5;
  root.width = 1;
  root.level = 0;
  fill(root);
  nodes_.push_back(root);
}

std::size_t PatchTree::split(std::size_t i) {
  if (nodes_[i].children != 0) {
    return nodes_[i].children;
  }
  const std::size_t begin = nodes_.size();
  nodes_.resize(begin + 4);
  SubPatch& parent = nodes_[i];
  parent.children = begin;
  std::array<std::array<Vec3, 5>, 3> rows;
  for (std::size_t row = 0; row < 3; ++row) {
    rows[row] = divided(parent.net[3 * row], parent.net[3 * row + 1], parent.net[3 * row + 2]);
  }
  std::array<std::array<Vec3, 5>, 5> grid;  // by columns
  for (std::size_t column = 0; column < 5; ++column) {
    grid[column] = divided(rows[0][column], rows[1][column], rows[2][column]);
  }
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const std::size_t row = quarter / 2;
    const std::size_t column = quarter % 2;
    SubPatch& child = nodes_[begin + quarter];
    for (std::size_t k = 0; k < 9; ++k) {
      child.net[k] = grid[2 * column + k % 3][2 * row + k / 3];
    }
    child.width = 0.5 * parent.width;
    child.first = parent.first + static_cast<double>(row) * child.width;
    child.second = parent.second + static_cast<double>(column) * child.width;
    child.level = parent.level + 1;
    fill(child);
  }
  return begin;
}

void Trees::split_larger(const PiecePair& pair, std::vector<PiecePair>& pairs) {
  const SubPatch& a = x[pair.x];
  const SubPatch& b = y[pair.y];
  const bool first = extent(a.lower, a.upper) > extent(b.lower, b.upper);
  const std::size_t children = first ? x.split(pair.x) : y.split(pair.y);
  for (std::size_t k = 0; k < 4; ++k) {
    pairs.push_back(first ? PiecePair{children + k, pair.y} : PiecePair{pair.x, children + k});
  }
}

SubCurve make_curve(const std::array<Vec3, 3>& net, double from, double width, int level) {
  SubCurve curve{net, {}, {}, from, width, level};
  enclose(curve.net, curve.lower, curve.upper);
  return curve;
}

std::array<SubCurve, 2> halves(const SubCurve& curve) {
  const std::array<Vec3, 5> p = divided(curve.net[0], curve.net[1], curve.net[2]);
  const double width = 0.5 * curve.width;
  return {make_curve({p[0], p[1], p[2]}, curve.from, width, curve.level + 1),
          make_curve({p[2], p[3], p[4]}, curve.from + width, width, curve.level + 1)};
}

bool separated(const SubPatch& x, const SubPatch& y, double net_error) {
  return boxes_apart(x.lower, x.upper, y.lower, y.upper, net_error) ||
         apart_along_normal(x, y.net, net_error) || apart_along_normal(y, x.net, net_error);
}

bool separated(const SubCurve& curve, const SubPatch& patch, double net_error) {
  return boxes_apart(curve.lower, curve.upper, patch.lower, patch.upper, net_error) ||
         apart_along_normal(patch, curve.net, net_error);
}

DirectionNet direction_net(const SubPatch& x, const std::array<double, 2>& c, double net_error) {
  DirectionNet d;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3* p = &x.net[3 * i];
    const Vec3 first = p[1] - p[0];
    const Vec3 last = p[2] - p[1];
    d.vectors[3 * i] = c[0] * first;
    d.vectors[3 * i + 1] = c[0] * mean(first, last);
    d.vectors[3 * i + 2] = c[0] * last;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3 first = x.net[3 + j] - x.net[j];
    const Vec3 last = x.net[6 + j] - x.net[3 + j];
    d.vectors[j] = d.vectors[j] - c[1] * first;
    d.vectors[3 + j] = d.vectors[3 + j] - c[1] * mean(first, last);
    d.vectors[6 + j] = d.vectors[6 + j] - c[1] * last;
  }
  enclose(d.vectors, d.lower, d.upper);
  d.error = kDirectionError * net_error;
  d.size = largest_of(d.vectors.data(), 9) + d.error;
  return d;
}

NormalNet normal_net(const SubPatch& y, double net_error) {
  std::array<Vec3, 6> a;  // y_r: index 3 i + j, i < 2
  std::array<Vec3, 6> b;  // y_s: index 2 i + j, j < 2
  for (std::size_t k = 0; k < 6; ++k) {
    a[k] = y.net[k + 3] - y.net[k];
    b[k] = y.net[3 * (k / 2) + k % 2 + 1] - y.net[3 * (k / 2) + k % 2];
  }
  constexpr std::array<double, 3> binomial = {1, 2, 1};
  constexpr std::array<double, 4> third = {1, 1.0 / 3, 1.0 / 3, 1};
  NormalNet n;
  n.vectors.fill(Vec3{0, 0, 0});
  for (std::size_t p = 0; p < 6; ++p) {
    for (std::size_t q = 0; q < 6; ++q) {
      const std::size_t i = p / 3 + q / 2;
      const std::size_t j = p % 3 + q % 2;
      const double weight = binomial[q / 2] * binomial[p % 3] * (third[i] * third[j]);
      Vec3& sum = n.vectors[4 * i + j];
      sum = sum + weight * cross(a[p], b[q]);
    }
  }
  const double size_a = largest_of(a.data(), 6);
  const double size_b = largest_of(b.data(), 6);
  enclose(n.vectors, n.lower, n.upper);
  n.error = kNormalError * net_error * (size_a + size_b + 3 * net_error) +
            kNormalRounding * kUnit * size_a * size_b + kTiny;
  n.size = largest_of(n.vectors.data(), 16) + n.error;
  return n;
}

// d.n = sum B_i(u,v) B_j(r,s) d_i.n_j, so the signs of the d_i.n_j decide.
bool never_orthogonal(const DirectionNet& d, const NormalNet& n) {
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
  const bool positive = dot(d.vectors[4], n.vectors[5]) > 0;
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

}  // namespace exsect::filter

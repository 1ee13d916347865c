// Control nets of patches of bidegree (m,n), 1 <= m, n <= 3, one parameter at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "enclosure.h"

namespace exsect::checker {

inline int binomial(std::size_t m, std::size_t k) {
  int result = 1;
  for (std::size_t i = 0; i < k; ++i) result = result * static_cast<int>(m - i) / static_cast<int>(i + 1);
  return result;
}

/// Vectors [i][j] of numbers, 0 <= i <= m and 0 <= j <= n, m and n from 0 to `most`: coefficients of
/// Bernstein polynomials or of u^i v^j. The first parameter is p = 0, the second one p = 1.
template <class N, std::size_t dimension, std::size_t most = 3>
class Grid {
 public:
  using Entry = std::array<N, dimension>;

  Grid() = default;  // of bidegree (0,0)
  Grid(std::size_t m, std::size_t n) : degrees_{m, n} {}

  std::size_t degree(std::size_t p) const { return degrees_[p]; }
  std::array<Entry, most + 1>& operator[](std::size_t i) { return entries_[i]; }
  const std::array<Entry, most + 1>& operator[](std::size_t i) const { return entries_[i]; }
  /// Entry k in the direction of p, of the line with the number i.
  Entry& along(std::size_t p, std::size_t k, std::size_t i) {
    return p == 0 ? entries_[k][i] : entries_[i][k];
  }
  const Entry& along(std::size_t p, std::size_t k, std::size_t i) const {
    return p == 0 ? entries_[k][i] : entries_[i][k];
  }

  /// use(i, j) for each entry, row by row.
  template <class Use>
  void each(const Use& use) const {
    for (std::size_t i = 0; i <= degrees_[0]; ++i)
      for (std::size_t j = 0; j <= degrees_[1]; ++j) use(i, j);
  }
  /// use(at), where at(k) is a number in the place k, for each line in the direction of p.
  template <class Use>
  void each_line(std::size_t p, const Use& use) {
    for (std::size_t i = 0; i <= degrees_[1 - p]; ++i)
      for (std::size_t d = 0; d < dimension; ++d) use([&](std::size_t k) -> N& { return along(p, k, i)[d]; });
  }

  /// Becomes that on the half 1/2 <= t <= 1 of p and returns that on 0 <= t <= 1/2, by de Casteljau's
  /// algorithm.
  Grid split(std::size_t p) {
    Grid lower = *this;
    for (std::size_t i = 0; i <= degrees_[1 - p]; ++i) {
      for (std::size_t level = 1; level <= degrees_[p]; ++level) {
        for (std::size_t k = 0; k + level <= degrees_[p]; ++k)
          for (std::size_t d = 0; d < dimension; ++d)
            along(p, k, i)[d] = half(N(along(p, k, i)[d] + along(p, k + 1, i)[d]));
        lower.along(p, level, i) = along(p, 0, i);
      }
    }
    return lower;
  }
  /// That where p is t: of degree 0 in p.
  void restrict_to(std::size_t p, const N& t) {
    each_line(p, [&](const auto& at) {
      for (std::size_t level = degrees_[p]; level > 0; --level)
        for (std::size_t k = 0; k < level; ++k) at(k) = (1 - t) * at(k) + t * at(k + 1);
    });
    degrees_[p] = 0;
  }
  /// From Bernstein polynomials to powers: the coefficient of t^k is binomial(m, k) times the k-th
  /// difference.
  void to_powers() {
    for (const std::size_t p : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t m = degrees_[p];
      each_line(p, [&](const auto& at) {
        for (std::size_t level = 1; level <= m; ++level)
          for (std::size_t k = m; k >= level; --k) at(k) = at(k) - at(k - 1);
        for (std::size_t k = 0; k <= m; ++k) at(k) = N(binomial(m, k)) * at(k);
      });
    }
  }
  /// The opposite way.
  void from_powers() {
    for (const std::size_t p : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t m = degrees_[p];
      each_line(p, [&](const auto& at) {
        for (std::size_t k = 0; k <= m; ++k) at(k) = at(k) / N(binomial(m, k));
        for (std::size_t level = m; level >= 1; --level)
          for (std::size_t k = level; k <= m; ++k) at(k) = at(k) + at(k - 1);
      });
    }
  }
  /// With its parameters exchanged.
  Grid exchanged() const {
    Grid result(degrees_[1], degrees_[0]);
    each([&](std::size_t i, std::size_t j) { result[j][i] = entries_[i][j]; });
    return result;
  }

 private:
  std::array<std::size_t, 2> degrees_ = {};
  std::array<std::array<Entry, most + 1>, most + 1> entries_ = {};
};

/// Control points, or vector coefficients.
template <class N>
using Net = Grid<N, 3>;

/// The polynomial 1.
template <class N>
Grid<N, 1> one() {
  Grid<N, 1> result;
  result[0][0][0] = N(1);
  return result;
}

/// The patch points / weights: w (x, y, z) and w for each control point, or coefficients. Without weights
/// these are one number, 1.
template <class N>
struct WeightedNet {
  Net<N> points;
  Grid<N, 1> weights = one<N>();

  bool has_weights() const { return weights.degree(0) + weights.degree(1) > 0; }
  const N& weight(std::size_t i, std::size_t j) const {
    return weights[std::min(i, weights.degree(0))][std::min(j, weights.degree(1))][0];
  }
  /// As of a grid.
  WeightedNet split(std::size_t p) { return {points.split(p), weights.split(p)}; }
  void restrict_to(std::size_t p, const N& t) {
    points.restrict_to(p, t);
    weights.restrict_to(p, t);
  }
  void to_powers() {
    points.to_powers();
    weights.to_powers();
  }
  WeightedNet exchanged() const { return {points.exchanged(), weights.exchanged()}; }
  /// Of control points: the patch less the vector.
  void move_by_minus(const std::array<N, 3>& vector) {
    points.each([&](std::size_t i, std::size_t j) {
      for (std::size_t d = 0; d < 3; ++d) points[i][j][d] = points[i][j][d] - weight(i, j) * vector[d];
    });
  }
};

}  // namespace exsect::checker

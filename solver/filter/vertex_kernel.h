// The code of filter/vertex_lanes.h, with internal linkage: all points of a block at once, in vectors that
// the compiler maps to the registers there are. No contraction: every operation rounds on its own.
#pragma once

#include <cstring>

#include "filter/vertex_lanes.h"

namespace exsect::filter::kernel {

/// One number for each point; handed over by reference, as how vectors are handed over by value depends on
/// the options.
using Lanes = double __attribute__((vector_size(kVertexBlock * sizeof(double))));

/// sum c[side i + j][row] a^i b^j, by Horner's rule.
template <int Degree, int Rows>
static inline void patch_value(const double (&c)[(Degree + 1) * (Degree + 1)][Rows], int row, const Lanes& a,
                               const Lanes& b, Lanes& sum) {
  constexpr int n = Degree;
#pragma GCC unroll 4
  for (int i = n; i >= 0; --i) {
    Lanes inner = c[(n + 1) * i + n - 1][row] + b * c[(n + 1) * i + n][row];
#pragma GCC unroll 4
    for (int j = n - 2; j >= 0; --j) inner = c[(n + 1) * i + j][row] + b * inner;
    sum = i == n ? inner : inner + a * sum;
  }
}

template <int Degree, int Rows>
static inline void polynomial(const VertexFormsOf<Degree, Rows>& forms, int j, const Lanes& tau, Lanes& sum) {
  sum = forms.series[kSeriesDegree - 2][j] + tau * forms.series[kSeriesDegree - 1][j];
  for (int k = kSeriesDegree - 3; k >= 0; --k) sum = forms.series[k][j] + tau * sum;
  sum *= tau;
}

/// Comparisons are such that a value that is no number counts as beyond its limit. Four at once: of longer
/// vectors GCC 12 compares one number after the other.
static inline void mark_beyond(const Lanes& value, double limit, double (&doubt)[kVertexBlock]) {
  using Part = double __attribute__((vector_size(4 * sizeof(double))));
  Part parts[kVertexBlock / 4], doubts[kVertexBlock / 4];
  std::memcpy(parts, &value, sizeof parts);
  std::memcpy(doubts, doubt, sizeof doubts);
  for (int i = 0; i < kVertexBlock / 4; ++i)
    doubts[i] = (parts[i] <= limit) & (-parts[i] <= limit) ? doubts[i] : 1.0;
  std::memcpy(doubt, doubts, sizeof doubts);
}

template <int Degree, int Rows>
static inline void evaluate_vertices(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block) {
  Lanes tau;
  std::memcpy(&tau, block.tau, sizeof tau);
  Lanes offset[Rows + 1];
  for (int j = 0; j <= Rows; ++j) polynomial(forms, j, tau, offset[j]);
  for (double& doubt : block.doubt) doubt = 0;
  Lanes value[Rows];
  for (int row = 0; row < Rows; ++row) {
    Lanes part;
    patch_value<Degree, Rows>(forms.g, row, offset[0], offset[1], value[row]);
    patch_value<Degree, Rows>(forms.h, row, offset[2], offset[3], part);
    if constexpr (Rows == 4) part *= 1 + offset[4];
    value[row] += part;
    mark_beyond(value[row], forms.greatest, block.doubt);
  }
  for (int row = 0; row < Rows; ++row) {
    const int j = forms.others[row];
    mark_beyond(offset[j] - tau * forms.series[0][j], forms.farthest[row], block.doubt);
    offset[j] -= value[row];
  }
  for (int j = 0; j < 4; ++j) {
    const Lanes parameter = (forms.centre[j] + offset[j]) + 0.5;
    std::memcpy(block.parameters[j], &parameter, sizeof parameter);
  }
  [[maybe_unused]] Lanes weight;
  if constexpr (Rows == 4) patch_value<Degree, Rows>(forms.space, 3, offset[0], offset[1], weight);
  for (int c = 0; c < 3; ++c) {
    Lanes point;
    patch_value<Degree, Rows>(forms.space, c, offset[0], offset[1], point);
    if constexpr (Rows == 4) point /= weight;
    point = forms.origin[c] + forms.scale * point;
    std::memcpy(block.point[c], &point, sizeof point);
  }
}

}  // namespace exsect::filter::kernel

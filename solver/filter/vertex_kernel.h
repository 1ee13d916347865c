// The code of filter/vertex_lanes.h, with internal linkage: loops over the points of a block are for the
// compiler to turn into vector code. No contraction: every operation rounds on its own.
#pragma once

#include "filter/vertex_lanes.h"

namespace exsect::filter::kernel {

using Lanes = double[kVertexBlock];

/// sum c[side i + j][row] a^i b^j, by Horner's rule.
template <int Degree, int Rows>
static inline void patch_value(const double (&c)[(Degree + 1) * (Degree + 1)][Rows], int row, const Lanes& a,
                               const Lanes& b, Lanes& result) {
  constexpr int n = Degree;
  for (int l = 0; l < kVertexBlock; ++l) {
    double sum = 0;
#pragma GCC unroll 4
    for (int i = n; i >= 0; --i) {
      double inner = c[(n + 1) * i + n][row];
#pragma GCC unroll 4
      for (int j = n - 1; j >= 0; --j) inner = c[(n + 1) * i + j][row] + b[l] * inner;
      sum = i == n ? inner : inner + a[l] * sum;
    }
    result[l] = sum;
  }
}

template <int Degree, int Rows>
static inline void polynomial(const VertexFormsOf<Degree, Rows>& forms, int j, const Lanes& tau,
                              Lanes& result) {
  for (int l = 0; l < kVertexBlock; ++l) {
    double sum = forms.series[kSeriesDegree - 1][j];
    for (int k = kSeriesDegree - 2; k >= 0; --k) sum = forms.series[k][j] + tau[l] * sum;
    result[l] = tau[l] * sum;
  }
}

/// Comparisons are such that a value that is no number counts as beyond its limit.
static inline void mark_beyond(const Lanes& value, double limit, Lanes& doubt) {
  for (int l = 0; l < kVertexBlock; ++l) {
    const double size = value[l] < 0 ? -value[l] : value[l];
    doubt[l] = size <= limit ? doubt[l] : 1.0;
  }
}

template <int Degree, int Rows>
static inline void evaluate_vertices(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block) {
  Lanes offset[Rows + 1];
  for (int j = 0; j <= Rows; ++j) polynomial(forms, j, block.tau, offset[j]);
  for (double& doubt : block.doubt) doubt = 0;
  Lanes value[Rows];
  for (int row = 0; row < Rows; ++row) {
    Lanes part;
    patch_value<Degree, Rows>(forms.g, row, offset[0], offset[1], value[row]);
    patch_value<Degree, Rows>(forms.h, row, offset[2], offset[3], part);
    if constexpr (Rows == 4) {
      for (int l = 0; l < kVertexBlock; ++l) part[l] *= 1 + forms.per_scale * offset[4][l];
    }
    for (int l = 0; l < kVertexBlock; ++l) value[row][l] += part[l];
    mark_beyond(value[row], forms.greatest, block.doubt);
  }
  for (int row = 0; row < Rows; ++row) {
    const int j = forms.others[row];
    const double slope = forms.series[0][j];
    Lanes from_line;
    for (int l = 0; l < kVertexBlock; ++l) {
      from_line[l] = offset[j][l] - block.tau[l] * slope;
      offset[j][l] -= value[row][l];
    }
    mark_beyond(from_line, forms.farthest[row], block.doubt);
  }
  for (int j = 0; j < 4; ++j) {
    for (int l = 0; l < kVertexBlock; ++l) block.parameters[j][l] = (forms.centre[j] + offset[j][l]) + 0.5;
  }
  [[maybe_unused]] Lanes weight;
  if constexpr (Rows == 4) patch_value<Degree, Rows>(forms.space, 3, offset[0], offset[1], weight);
  for (int c = 0; c < 3; ++c) {
    patch_value<Degree, Rows>(forms.space, c, offset[0], offset[1], block.point[c]);
    if constexpr (Rows == 4) {
      for (int l = 0; l < kVertexBlock; ++l) block.point[c][l] /= weight[l];
    }
    for (int l = 0; l < kVertexBlock; ++l) {
      block.point[c][l] = forms.origin[c] + forms.scale * block.point[c][l];
    }
  }
}

}  // namespace exsect::filter::kernel

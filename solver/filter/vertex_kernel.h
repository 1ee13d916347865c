// The code of filter_vertex_lanes.h, with internal linkage: loops over the points of a block are for the
// compiler to turn into vector code. No contraction: every operation rounds on its own.
#pragma once

#include "filter/vertex_lanes.h"

namespace exsect::filter::kernel {

using Lanes = double[kVertexBlock];

/// sum c[3 i + j][row] a^i b^j.
static inline void biquadratic(const double (&c)[9][3], int row, const Lanes& a, const Lanes& b,
                               Lanes& result) {
  const double c0 = c[0][row], c1 = c[1][row], c2 = c[2][row], c3 = c[3][row], c4 = c[4][row], c5 = c[5][row],
               c6 = c[6][row], c7 = c[7][row], c8 = c[8][row];
  for (int l = 0; l < kVertexBlock; ++l) {
    result[l] = (c0 + b[l] * (c1 + b[l] * c2)) +
                a[l] * ((c3 + b[l] * (c4 + b[l] * c5)) + a[l] * (c6 + b[l] * (c7 + b[l] * c8)));
  }
}

static inline void polynomial(const VertexForms& forms, int j, const Lanes& tau, Lanes& result) {
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

static inline void evaluate_vertices(const VertexForms& forms, VertexBlock& block) {
  Lanes offset[4];
  for (int j = 0; j < 4; ++j) polynomial(forms, j, block.tau, offset[j]);
  for (double& doubt : block.doubt) doubt = 0;
  Lanes value[3];
  for (int row = 0; row < 3; ++row) {
    Lanes part;
    biquadratic(forms.g, row, offset[0], offset[1], value[row]);
    biquadratic(forms.h, row, offset[2], offset[3], part);
    for (int l = 0; l < kVertexBlock; ++l) value[row][l] += part[l];
    mark_beyond(value[row], forms.greatest, block.doubt);
  }
  for (int row = 0; row < 3; ++row) {
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
  for (int c = 0; c < 3; ++c) {
    biquadratic(forms.space, c, offset[0], offset[1], block.point[c]);
    for (int l = 0; l < kVertexBlock; ++l) {
      block.point[c][l] = forms.origin[c] + forms.scale * block.point[c][l];
    }
  }
}

}  // namespace exsect::filter::kernel

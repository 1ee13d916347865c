// Points of a tube's arc from its Taylor polynomial, several at once. Plain arrays only: two files with
// different compiler options contain the same code. Internal to solver/; docs/method-doubles.md,
// section 14.6.
#pragma once

namespace exsect::filter {

inline constexpr int kSeriesDegree = 8;
inline constexpr int kVertexBlock = 8;

/// What the points of one tube have in common; see Tube.
template <int Degree, int Rows>
struct VertexFormsOf {
  double g[(Degree + 1) * (Degree + 1)][Rows];
  double h[(Degree + 1) * (Degree + 1)][Rows];
  double space[(Degree + 1) * (Degree + 1)][Rows];
  double series[kSeriesDegree]
               [Rows + 1];  // w - centre is about the sum of series[k] tau^(k+1); 1, 0, 0, ... at axis
  double centre[Rows + 1];
  double origin[3];  // space point = origin + scale * scaled point
  double scale;
  int others[Rows];
  double farthest[Rows];  // of |w_i - centre_i - tau slope_i|, by rows
  double greatest;        // of |C F(w)|, by rows, before the last step
};
using VertexForms = VertexFormsOf<2, 3>;

/// In: offsets tau. Out: parameters in [0,1]^4 and points of space after a step w - C F(w) from the
/// polynomial's value w. doubt is 0 where w and C F(w), as computed, keep within the limits of the forms, and
/// 1 elsewhere.
struct VertexBlock {
  double tau[kVertexBlock];
  double parameters[4][kVertexBlock];
  double point[3][kVertexBlock];
  double doubt[kVertexBlock];
};

/// The same operations, and so the same results, in AVX2 registers. Exists only for x86-64 (__x86_64__).
template <int Degree, int Rows>
void evaluate_vertices_lanes(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block);

}  // namespace exsect::filter

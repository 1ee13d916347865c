// Taylor polynomials of the arcs of tubes: guesses and no more, which a step of (14.8) or (14.9) improves and
// bounds. Internal to solver/; docs/method-doubles.md, section 14.2.
#pragma once

#include "filter/tube.h"
#include "filter/vertex_lanes.h"

namespace exsect::filter {

/// Fills in tube.further, after `bound_derivatives`.
template <class K>
void expand_arc(TubeOf<K>& tube);

/// About w(tau) - centre; tau itself at the axis.
template <class K>
Unknowns<K> arc_offset(const TubeOf<K>& tube, double tau);
/// About w'(tau); 1 at the axis.
template <class K>
Unknowns<K> arc_slope(const TubeOf<K>& tube, double tau);
/// About w_i''(tau), i not the axis.
template <class K>
double arc_second(const TubeOf<K>& tube, double tau, std::size_t i);

/// For points of this tube's arc, `greatest` as there.
template <class K>
VertexFormsOf<K::degree, K::rows> vertex_forms(const PairOf<K>& pair, const TubeOf<K>& tube, double greatest);

/// evaluate_vertices_lanes where the processor has them, else evaluate_vertices_scalar.
template <int Degree, int Rows>
void evaluate_vertices(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block);
bool has_vertex_lanes();

}  // namespace exsect::filter

// Taylor polynomials of the arcs of tubes: guesses and no more, which a step of (14.8) or (14.9) improves and
// bounds. Internal to solver/; docs/method.md, section 14.2.
#pragma once

#include "filter/tube.h"
#include "filter/vertex_lanes.h"

namespace exsect::filter {

/// Fills in tube.further, after `bound_derivatives`.
void expand_arc(Tube& tube);

/// About w(tau) - centre; tau itself at the axis.
Vec4 arc_offset(const Tube& tube, double tau);
/// About w'(tau); 1 at the axis.
Vec4 arc_slope(const Tube& tube, double tau);
/// About w_i''(tau), i not the axis.
double arc_second(const Tube& tube, double tau, std::size_t i);

/// For points of this tube's arc, `greatest` as there.
VertexForms vertex_forms(const Pair& pair, const Tube& tube, double greatest);

/// evaluate_vertices_lanes where the processor has them, else evaluate_vertices_scalar.
void evaluate_vertices(const VertexForms& forms, VertexBlock& block);
bool has_vertex_lanes();

}  // namespace exsect::filter

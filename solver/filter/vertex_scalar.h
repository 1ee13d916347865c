// Vertices of polylines, one after the other. Internal to solver/.
#pragma once

#include "filter/vertex_lanes.h"

namespace exsect::filter {

template <int Degree, int Rows>
void evaluate_vertices_scalar(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block);

}  // namespace exsect::filter

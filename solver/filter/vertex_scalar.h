// Vertices of polylines, one after the other. Internal to solver/.
#pragma once

#include "filter/vertex_lanes.h"

namespace exsect::filter {

template <int Degree>
void evaluate_vertices_scalar(const VertexFormsOf<Degree>& forms, VertexBlock& block);

}  // namespace exsect::filter

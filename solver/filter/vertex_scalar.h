// Vertices of polylines, one after the other. Internal to solver/.
#pragma once

#include "filter/vertex_lanes.h"

namespace exsect::filter {

void evaluate_vertices_scalar(const VertexForms& forms, VertexBlock& block);

}  // namespace exsect::filter

// Compiled for AVX2: only code with internal linkage, because the linker could choose this copy of a shared
// inline function for all files.
#ifdef __x86_64__

#include "filter/vertex_kernel.h"

namespace exsect::filter {

template <int Degree, int Rows>
void evaluate_vertices_lanes(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block) {
  kernel::evaluate_vertices(forms, block);
}

template void evaluate_vertices_lanes<2, 3>(const VertexFormsOf<2, 3>&, VertexBlock&);
template void evaluate_vertices_lanes<2, 4>(const VertexFormsOf<2, 4>&, VertexBlock&);
template void evaluate_vertices_lanes<3, 3>(const VertexFormsOf<3, 3>&, VertexBlock&);
template void evaluate_vertices_lanes<3, 4>(const VertexFormsOf<3, 4>&, VertexBlock&);

}  // namespace exsect::filter

#endif

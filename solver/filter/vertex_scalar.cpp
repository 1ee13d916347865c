#include "filter/vertex_scalar.h"

#include "filter/vertex_kernel.h"

namespace exsect::filter {

template <int Degree, int Rows>
void evaluate_vertices_scalar(const VertexFormsOf<Degree, Rows>& forms, VertexBlock& block) {
  kernel::evaluate_vertices(forms, block);
}

template void evaluate_vertices_scalar<2, 3>(const VertexFormsOf<2, 3>&, VertexBlock&);
template void evaluate_vertices_scalar<2, 4>(const VertexFormsOf<2, 4>&, VertexBlock&);
template void evaluate_vertices_scalar<3, 3>(const VertexFormsOf<3, 3>&, VertexBlock&);
template void evaluate_vertices_scalar<3, 4>(const VertexFormsOf<3, 4>&, VertexBlock&);

}  // namespace exsect::filter

#include "filter/vertex_scalar.h"

#include "filter/vertex_kernel.h"

namespace exsect::filter {

template <int Degree>
void evaluate_vertices_scalar(const VertexFormsOf<Degree>& forms, VertexBlock& block) {
  kernel::evaluate_vertices(forms, block);
}

template void evaluate_vertices_scalar<2>(const VertexFormsOf<2>&, VertexBlock&);
template void evaluate_vertices_scalar<3>(const VertexFormsOf<3>&, VertexBlock&);

}  // namespace exsect::filter

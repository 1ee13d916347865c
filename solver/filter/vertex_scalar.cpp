#include "filter/vertex_scalar.h"

#include "filter/vertex_kernel.h"

namespace exsect::filter {

void evaluate_vertices_scalar(const VertexForms& forms, VertexBlock& block) {
  kernel::evaluate_vertices(forms, block);
}

}  // namespace exsect::filter

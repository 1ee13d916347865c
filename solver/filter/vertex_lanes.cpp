// Compiled for AVX2: only code with internal linkage, because the linker could choose this copy of a shared
// inline function for all files.
#ifdef __x86_64__

#include "filter/vertex_kernel.h"

namespace exsect::filter {

void evaluate_vertices_lanes(const VertexForms& forms, VertexBlock& block) {
  kernel::evaluate_vertices(forms, block);
}

}  // namespace exsect::filter

#endif

// What the module computes, with the forms in which it is handed over.
#pragma once

#include <pybind11/pybind11.h>

namespace exsect::python {

/// Adds intersect, self_intersect and line with their results.
void add_intersections(pybind11::module_& module);
/// Adds Surface, intersect_equation and intersect_surfaces with their results, and ray.
void add_surfaces(pybind11::module_& module);
/// Adds verify, compare and check with their results.
void add_verifications(pybind11::module_& module);
/// Adds implicitize and revolve with their results.
void add_implicitizations(pybind11::module_& module);

}  // namespace exsect::python

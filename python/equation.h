// A surface given by its equation, as Python holds it.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <string>

namespace exsect::python {

/// With the entry of a patch file that says which.
struct Equation {
  std::string entry;
  ImplicitSurface surface;
};

}  // namespace exsect::python

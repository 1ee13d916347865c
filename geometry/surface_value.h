// One surface given by its equation in a file. Internal to geometry/.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include "json_value.h"

namespace exsect {

/// The surface of {"name": ..., "type": "cylinder", ...}; the name is not looked at. Throws InputError.
ImplicitSurface read_implicit_surface(const JsonValue& value, NumberReader read);

}  // namespace exsect

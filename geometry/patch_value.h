// One patch of a file as JSON. Internal to geometry/.
#pragma once

#include "json_value.h"
#include "rational_patch_file.h"

namespace exsect {

/// {"name": "x", "degree": [2,2], "points": [...], "weights": [...]}; InputError with file, path and reason
/// for anything else.
NamedRationalPatch read_named_patch(const JsonValue& value, NumberReader read);

}  // namespace exsect

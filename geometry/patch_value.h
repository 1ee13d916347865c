// One patch of a file as JSON. Internal to geometry/.
#pragma once

#include "json_value.h"
#include "patch_file.h"

namespace exsect {

/// {"name": "x", "degree": [2,2], "points": [...]}; InputError with file, path and reason for anything else.
NamedPatch read_named_patch(const JsonValue& value, NumberReader read);

}  // namespace exsect

// One patch of a file as JSON. Internal to geometry/.
#pragma once

#include "json_value.h"
#include "rational_patch_file.h"

namespace exsect {

inline constexpr const char* patches_version = "patches/1";

/// The member "name" of an entry; InputError unless it is a string of 1 to max_name_bytes bytes.
const std::string& read_name(const JsonValue& value);
/// {"name": "x", "degree": [2,2], "points": [...], "weights": [...]}; InputError with file, path and reason
/// for anything else.
NamedRationalPatch read_named_patch(const JsonValue& value, NumberReader read);

}  // namespace exsect

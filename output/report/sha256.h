// The hash that names an input file in a report.
#pragma once

#include <string>
#include <string_view>

namespace exsect::cli {

/// SHA-256 (FIPS 180-4) of the bytes, as 64 lower-case hexadecimal digits: what sha256sum prints.
std::string sha256(std::string_view bytes);

}  // namespace exsect::cli

// The hash that names an input file in a report. Own code, since no library that exsect needs anyhow has it:
// Boost has SHA-1 and checksums only, and liblzma and FLINT keep theirs to themselves. libmd, the smallest in
// Debian, would be one more shared library to find, to install and to load for these eighty lines.
#pragma once

#include <string>
#include <string_view>

namespace exsect::cli {

/// SHA-256 (FIPS 180-4) of the bytes, as 64 lower-case hexadecimal digits: what sha256sum prints.
std::string sha256(std::string_view bytes);

}  // namespace exsect::cli

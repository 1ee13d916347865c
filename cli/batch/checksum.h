// Checksums of what a batch reads and writes.
#pragma once

#include <string>
#include <string_view>

namespace exsect::cli {

/// CRC-64/XZ of the bytes, 16 hexadecimal digits.
std::string checksum(std::string_view bytes);
/// The same of a file's content; of as much as can be read.
std::string file_checksum(const std::string& path);

}  // namespace exsect::cli

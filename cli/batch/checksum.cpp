#include "cli/batch/checksum.h"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <fstream>
#include <vector>

namespace exsect::cli {
namespace {

using Crc64 = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true>;

std::string hexadecimal(const Crc64& crc) { return fmt::format("{:016x}", crc.checksum()); }

}  // namespace

std::string checksum(std::string_view bytes) {
  Crc64 crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return hexadecimal(crc);
}

std::string file_checksum(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Crc64 crc;
  std::vector<char> chunk(std::size_t{1} << 18);
  while (file.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || file.gcount() > 0)
    crc.process_bytes(chunk.data(), static_cast<std::size_t>(file.gcount()));
  return hexadecimal(crc);
}

}  // namespace exsect::cli

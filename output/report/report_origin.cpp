#include "output/report/report_origin.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "output/report/sha256.h"

namespace exsect::cli {
namespace {

std::string hash_of(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return "";
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return stream.good() || stream.eof() ? sha256(bytes) : "";
}

}  // namespace

ReportOrigin origin_of(const std::string& title, const std::string& command,
                       const std::vector<std::string>& inputs) {
  ReportOrigin origin{title, inputs.front(), command, {}};
  for (const std::string& file : inputs) origin.inputs.push_back({file, hash_of(file)});
  return origin;
}

}  // namespace exsect::cli

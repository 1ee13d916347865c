#include "output/options/output_files.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

namespace exsect::cli {
namespace {

namespace fs = std::filesystem;

/// The path with links resolved as far as it exists.
fs::path resolved(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::path(path) : canonical;
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return resolved(a) == resolved(b) || fs::equivalent(a, b, error);
}

void check_writable(const std::string& option, const std::string& path) {
  const auto refuse = [&](const std::string& reason) {
    throw UsageError(option + ": " + path + ": cannot be written: " + reason);
  };
  std::error_code error;
  const fs::path target = resolved(path);
  if (fs::is_directory(target, error)) refuse("it is a directory");
  if (fs::exists(target, error)) {
    if (access(target.c_str(), W_OK) != 0) refuse(std::generic_category().message(errno));
    if (!fs::is_regular_file(target, error)) return;  // a device or a pipe is written where it is
  }
  if (!fs::is_directory(target.parent_path(), error)) refuse("there is no such directory");
  if (access(target.parent_path().c_str(), W_OK) != 0) refuse(std::generic_category().message(errno));
}

void check_one(const std::string& option, const std::string& path, const std::string& input) {
  check_writable(option, path);
  if (same_file(path, input)) throw UsageError(option + ": " + path + ": is the input file");
}

}  // namespace

void check(const OutputFiles& files, const std::string& input) {
  const ExportFiles& exports = files.exports;
  const std::array<std::pair<const char*, const std::string&>, 8> named = {
      {{"--json", files.json},
       {"--svg", files.svg},
       {"--report", files.report},
       {"--certificate", files.certificate},
       {"--obj", exports.obj},
       {"--ply", exports.ply},
       {"--vtp", exports.vtp},
       {"--csv", exports.csv}}};
  for (auto file = named.begin(); file != named.end(); ++file) {
    const auto& [option, path] = *file;
    if (path.empty() || (&path == &files.json && files.json_to_stdout())) continue;
    if (path == "-")
      throw UsageError(std::string(option) + ": needs a file; only --json can go to the standard output");
    for (auto before = named.begin(); before != file; ++before) {
      if (!before->second.empty() && same_file(before->second, path))
        throw UsageError(std::string(before->first) + " and " + option + ": both name " + path);
    }
    check_one(option, path, input);
  }
}

void check_output(const std::string& option, const std::string& path,
                  const std::vector<std::string>& inputs) {
  std::error_code error;
  if (path == "-" ||
      (fs::exists(path, error) && !fs::is_regular_file(path, error) && !fs::is_directory(path, error)))
    throw UsageError(option + ": " + path +
                     ": needs a regular file; without it lines go to the standard output");
  for (const std::string& input : inputs) check_one(option, path, input);
}

}  // namespace exsect::cli

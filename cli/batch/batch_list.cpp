#include <exsect/geometry/bpt_file.h>
#include <exsect/geometry/text_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "cli/batch/batch_input.h"
#include "cli/batch/checksum.h"
#include "cli/patch_choice.h"

namespace exsect::cli {
namespace {

constexpr std::size_t max_list_bytes = std::size_t{1} << 30;

class List : public BatchInput {
 public:
  List(std::vector<std::string> files, bool self, const Shard& shard)
      : files_(std::move(files)), lines_of_a_file_(self ? 3 : 1), shard_(shard) {}

  std::uint64_t size() const override { return shard_.size(lines()); }
  Json header() const override {
    std::string paths;
    for (const std::string& file : files_) paths += file + '\n';
    return {{"list", {{"files", files_.size()}, {"checksum", checksum(paths)}}}, {"lines", lines()}};
  }
  Json names(std::uint64_t local) const override {
    Json json = {{"file", file(local)}};
    if (self(local))
      json["patch"] = nullptr;
    else
      json["first"] = json["second"] = nullptr;
    return json;
  }
  bool self(std::uint64_t local) const override { return lines_of_a_file_ == 3 && part(local) != 1; }
  bool pairs_meet() const override { return false; }
  Subject load(std::uint64_t local) const override {
    const RationalPair pair = read_rational_pair(file(local), "", "");
    if (!self(local)) return {pair.x, pair.y, false};
    const NamedRationalPatch& patch = part(local) == 0 ? pair.x : pair.y;
    return {patch, patch, true};
  }
  std::uint64_t apart() const override { return 0; }

 private:
  std::uint64_t lines() const { return files_.size() * lines_of_a_file_; }
  const std::string& file(std::uint64_t local) const {
    return files_.at(shard_.global(local) / lines_of_a_file_);
  }
  std::uint64_t part(std::uint64_t local) const { return shard_.global(local) % lines_of_a_file_; }

  std::vector<std::string> files_;
  std::uint64_t lines_of_a_file_;
  Shard shard_;
};

}  // namespace

std::unique_ptr<BatchInput> list_of_pairs(std::vector<std::string> files, bool self, const Shard& shard) {
  return std::make_unique<List>(std::move(files), self, shard);
}

std::vector<std::string> read_list(const std::string& path) {
  namespace fs = std::filesystem;
  std::istringstream text(read_text_file(path, max_list_bytes));
  std::vector<std::string> files;
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    if (line.find('\0') != std::string::npos)
      throw InputError(path + ":" + std::to_string(number), "", "a path must not hold a NUL");
    files.push_back((fs::path(path).parent_path() / line).string());
  }
  if (files.empty()) throw InputError(path, "", "must name at least one file");
  return files;
}

bool holds_patches(const std::string& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, ignored)) {
    read_text_file(path, 0);  // says why
    return false;
  }
  if (is_bpt(path)) return true;
  char first = ' ';
  file >> std::ws;
  return file.get(first) && first == '{';
}

}  // namespace exsect::cli

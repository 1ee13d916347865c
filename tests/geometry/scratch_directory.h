// A directory of its own for one test, removed afterwards.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>

namespace exsect {

class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::random_device random;
    do {
      directory_ = std::filesystem::temp_directory_path() / ("exsect-test-" + std::to_string(random()));
    } while (!std::filesystem::create_directory(directory_));
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  std::string path(const std::string& name) const { return (directory_ / name).string(); }

  std::ptrdiff_t number_of_files() const {
    return std::distance(std::filesystem::directory_iterator(directory_),
                         std::filesystem::directory_iterator());
  }

 private:
  std::filesystem::path directory_;
};

}  // namespace exsect

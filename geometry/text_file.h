// Whole text files: read with a size limit, written so that nothing half-written is ever seen.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace exsect {

/// Bad input: which file, where in it, and which statement is violated. what() is "file: where: reason".
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& where, const std::string& reason)
      : std::runtime_error(file + ": " + (where.empty() ? "" : where + ": ") + reason),
        file_(file),
        where_(where),
        reason_(reason) {}

  const std::string& file() const { return file_; }
  /// JSON path such as $.patches[0].points[1][2][0]; empty if the file as a whole is meant.
  const std::string& where() const { return where_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string file_;
  std::string where_;
  std::string reason_;
};

/// A file that cannot be written. what() names its path.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of the file. Throws InputError if it is missing, a directory, unreadable or longer than
/// max_bytes.
std::string read_text_file(const std::string& path, std::size_t max_bytes);

/// Writes the text under a temporary name in the same directory and renames it to `path`: a reader sees the
/// old file or the new one. A path that names a device or a pipe is written directly. Throws OutputError, and
/// leaves no temporary file, if the directory is missing, `path` is a directory, or it cannot be written.
void write_file_atomically(const std::string& path, const std::string& text);

}  // namespace exsect

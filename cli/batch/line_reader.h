// The lines of an open file, at any place, in long pieces.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace exsect::cli {

class LineReader {
 public:
  /// Of an open file, which must outlive it; `name` is for messages.
  LineReader(int file, std::string name, std::uint64_t offset = 0)
      : file_(file), name_(std::move(name)), offset_(offset) {}

  /// The next line with its line feed, valid until the next call; nothing at the end of the file and for a
  /// last line without a line feed. Throws InputError if the file cannot be read.
  std::string_view next();
  /// The bytes [offset, offset + length); as next().
  std::string_view at(std::uint64_t offset, std::uint64_t length);
  /// Where the next line begins.
  std::uint64_t offset() const { return offset_ + used_; }

 private:
  bool read_more(std::size_t wanted);

  int file_;
  std::string name_;
  std::uint64_t offset_;  // of text_ in the file
  std::string text_;
  std::size_t used_ = 0;
};

}  // namespace exsect::cli

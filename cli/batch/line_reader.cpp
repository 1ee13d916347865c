#include "cli/batch/line_reader.h"

#include <exsect/geometry/text_file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace exsect::cli {

bool LineReader::read_more(std::size_t wanted) {
  constexpr std::size_t piece = std::size_t{1} << 18;
  const std::size_t had = text_.size();
  text_.resize(had + std::max(wanted, piece));
  ssize_t got = 0;
  do {
    got = pread(file_, text_.data() + had, text_.size() - had, static_cast<off_t>(offset_ + had));
  } while (got < 0 && errno == EINTR);
  text_.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  if (got < 0) throw InputError(name_, "", "cannot be read: " + std::generic_category().message(errno));
  return got > 0;
}

std::string_view LineReader::next() {
  std::size_t searched = used_;
  std::size_t end = text_.find('\n', searched);
  while (end == std::string::npos) {
    text_.erase(0, used_);
    offset_ += used_;
    used_ = 0;
    searched = text_.size();
    if (!read_more(0)) return {};
    end = text_.find('\n', searched);
  }
  const std::string_view line(text_.data() + used_, end + 1 - used_);
  used_ = end + 1;
  return line;
}

std::string_view LineReader::at(std::uint64_t offset, std::uint64_t length) {
  if (offset < offset_ || offset + length > offset_ + text_.size()) {
    offset_ = offset;
    text_.clear();
    while (text_.size() < length) {
      if (!read_more(length - text_.size())) throw InputError(name_, "", "is shorter than it was");
    }
  }
  used_ = static_cast<std::size_t>(offset + length - offset_);
  return std::string_view(text_).substr(static_cast<std::size_t>(offset - offset_),
                                        static_cast<std::size_t>(length));
}

}  // namespace exsect::cli

#include "cli/batch/batch_output.h"

#include <exsect/geometry/text_file.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "cli/batch/checksum.h"
#include "cli/batch/line_reader.h"

namespace exsect::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const std::string& path) {
  throw OutputError(path + ": cannot be written: " + std::generic_category().message(errno));
}

void write_all(int file, std::string_view text, const std::string& path) {
  while (!text.empty()) {
    const ssize_t put = write(file, text.data(), text.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) fail_to_write(path);
    text.remove_prefix(static_cast<std::size_t>(put));
  }
}

/// A file that has no name and is gone when it is closed.
FileDescriptor unnamed_file(const fs::path& directory) {
  std::string name = (directory / "exsect-XXXXXX").string();
  FileDescriptor file(mkostemp(name.data(), O_CLOEXEC));
  if (file.get() < 0) fail_to_write(name);
  unlink(name.c_str());
  return file;
}

/// What follows a line in the journal, up to its line feed.
std::string checksum_mark(std::string_view line) { return "\t" + checksum(line) + "\n"; }

/// The line of a batch, without its line feed, in a line of the journal. Throws std::invalid_argument if it
/// is damaged.
std::string_view checked(std::string_view journal_line) {
  const std::size_t tab = journal_line.find('\t');
  const std::string_view line = journal_line.substr(0, tab);
  if (tab == std::string_view::npos || journal_line.substr(tab) != checksum_mark(line))
    throw std::invalid_argument(
        "does not fit its checksum: it is damaged; without this line --resume solves its pair again");
  return line;
}

[[noreturn]] void refuse_other_header(const std::string& path) {
  throw InputError(
      path, "line 1",
      "is of another batch: input, options or version differ; choose another output or remove it");
}

}  // namespace

BatchOutput::BatchOutput(std::string path, std::string header, Journal journal)
    : path_(std::move(path)), journal_(path_ + ".partial"), header_(std::move(header)) {
  const bool resume = journal == Journal::resume;
  if (path_.empty() || journal == Journal::none) {
    journal_ = "temporary file";
    file_ = unnamed_file(path_.empty() ? fs::temp_directory_path() : fs::absolute(path_).parent_path());
    write_journal(header_);
    return;
  }
  keeps_journal_ = true;
  if (resume && !fs::exists(journal_) && fs::exists(path_)) {
    file_ = FileDescriptor(open(path_.c_str(), O_RDONLY | O_CLOEXEC));
    LineReader reader(file_.get(), path_);
    if (reader.next() != header_) refuse_other_header(path_);
    finished_ = true;
    return;
  }
  open_journal(resume);
}

void BatchOutput::open_journal(bool resume) {
  lock_journal();
  LineReader reader(file_.get(), journal_);
  const std::string_view first = reader.next();
  struct stat status = {};
  if (first.empty()) {  // new, or torn within its header
    if (ftruncate(file_.get(), 0) != 0) fail_to_write(journal_);
    write_journal(header_);
    return;
  }
  if (!resume)
    throw InputError(journal_, "", "is an interrupted batch: continue it with --resume, or remove the file");
  if (first != header_) refuse_other_header(journal_);
  end_ = header_.size();
  if (fstat(file_.get(), &status) != 0) fail_to_write(journal_);
}

/// Opens the journal so that no other process has it open for a batch.
void BatchOutput::lock_journal() {
  for (;;) {
    // Somebody else may have put a link there, to have another file overwritten.
    file_ = FileDescriptor(
        open(journal_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666));
    if (file_.get() < 0 && errno == ELOOP)
      throw OutputError(journal_ + ": cannot be written: it is a symbolic link");
    if (file_.get() < 0) fail_to_write(journal_);
    if (flock(file_.get(), LOCK_EX | LOCK_NB) != 0)
      throw OutputError(journal_ + ": cannot be written: another run writes it");
    // The run that had it may have finished and removed it in between.
    struct stat mine = {};
    struct stat named = {};
    if (fstat(file_.get(), &mine) == 0 && !S_ISREG(mine.st_mode))
      throw OutputError(journal_ + ": cannot be written: it is no regular file");
    if (fstat(file_.get(), &mine) == 0 && lstat(journal_.c_str(), &named) == 0 &&
        mine.st_ino == named.st_ino && mine.st_dev == named.st_dev)
      return;
  }
}

void BatchOutput::write_journal(std::string_view text) {
  write_all(file_.get(), text, journal_);
  end_ += text.size();
}

void BatchOutput::flush() {
  write_all(file_.get(), waiting_, journal_);
  waiting_.clear();
}

void BatchOutput::read_earlier(std::uint64_t lines,
                               const std::function<std::uint64_t(std::string_view)>& line) {
  places_.resize(lines);
  LineReader reader(file_.get(), finished_ ? path_ : journal_, header_.size());
  std::uint64_t number = 1;
  const auto refuse = [&](const std::string& reason) {
    throw InputError(finished_ ? path_ : journal_, "line " + std::to_string(number), reason);
  };
  std::uint64_t end = header_.size();
  for (std::string_view text = reader.next(); !text.empty(); text = reader.next()) {
    ++number;
    std::uint64_t place = lines;
    std::size_t length = text.size() - 1;
    try {
      const std::string_view content = finished_ ? text.substr(0, length) : checked(text);
      length = content.size();
      place = line(content);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
    if (place >= lines) refuse("is not a line of this batch");
    if (done(place)) refuse("is there twice");
    if (finished_ && place != number - 2) refuse("is not in its place");
    places_[place] = {end, length};
    end = reader.offset();
  }
  if (finished_) {
    if (number != lines + 1) refuse("lines are missing after it");
    return;
  }
  // What follows the last line feed was torn.
  if (ftruncate(file_.get(), static_cast<off_t>(end)) != 0) fail_to_write(journal_);
  end_ = end;
}

void BatchOutput::add(std::uint64_t place, std::string_view line) {
  line.remove_suffix(1);  // the line feed
  places_[place] = {end_, line.size()};
  const std::size_t waited = waiting_.size();
  waiting_ += line;
  waiting_ += checksum_mark(line);
  end_ += waiting_.size() - waited;
  if (waiting_.size() > (std::size_t{1} << 18)) flush();
}

void BatchOutput::finish(std::ostream& out) {
  flush();
  LineReader reader(file_.get(), journal_);
  const bool named = !path_.empty();
  const std::string temporary = path_ + "." + std::to_string(getpid()) + ".tmp";
  if (named) std::remove(temporary.c_str());  // of a run that was killed and had this number
  FileDescriptor target(named ? open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)
                              : dup(file_.get()));
  if (target.get() < 0) fail_to_write(path_);
  try {
    std::string waiting = header_;
    const auto send = [&] {
      if (named)
        write_all(target.get(), waiting, path_);
      else
        out << waiting;
      waiting.clear();
    };
    for (const Place& place : places_) {
      waiting += reader.at(place.offset, place.length);
      waiting += '\n';
      if (waiting.size() > (std::size_t{1} << 20)) send();
    }
    send();
    if (!named) return;
    if (fsync(target.get()) != 0 || std::rename(temporary.c_str(), path_.c_str()) != 0) fail_to_write(path_);
  } catch (...) {
    if (named) std::remove(temporary.c_str());
    throw;
  }
  if (keeps_journal_) std::remove(journal_.c_str());
}

}  // namespace exsect::cli

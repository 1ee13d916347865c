// The file of a batch: a journal of lines as they come, in the end written whole and in order.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/batch/worker_process.h"

namespace exsect::cli {

/// While a batch runs its lines are in `<path>.partial`: the header, then whole lines in the order in which
/// they came, each followed by a tab and its checksum. finish() writes `path` under a temporary name in the
/// order of the lines, without checksums, renames it and removes the journal. Without a path, and where
/// nothing is kept for a later run, the journal is a file without a name; without a path finish() writes to a
/// stream.
///
/// Invariant: a line that is in the journal up to its line feed is done; what follows the last line feed is
/// torn and counts for nothing. One process at a time holds the journal (flock).
class BatchOutput {
 public:
  /// What a run does with the journal: begins one, which must not be there; goes on with the one that an
  /// earlier run left, if any; leaves none behind however it ends.
  enum class Journal { begin, resume, none };

  /// Throws OutputError if the journal cannot be written, is no regular file, or another process holds it,
  /// InputError if it, or with `resume` a finished file, belongs to a batch with another header, or with
  /// `begin` there is a journal.
  BatchOutput(std::string path, std::string header, Journal journal);

  /// `path` has been written by an earlier run that finished, and nothing is to be done.
  bool finished() const { return finished_; }

  /// Calls `line` with each line that is there from an earlier run and has it tell its place, below `lines`:
  /// the number in this file. Throws InputError for a line without a place, one that is there twice, in a
  /// journal one that its checksum does not fit, and, if finished(), for missing or misplaced lines.
  void read_earlier(std::uint64_t lines, const std::function<std::uint64_t(std::string_view)>& line);

  bool done(std::uint64_t place) const { return places_[place].length != 0; }
  /// Adds the line of a place; it is in the journal after the next flush(), at the latest. Throws
  /// OutputError.
  void add(std::uint64_t place, std::string_view line);
  /// Writes the lines that were added. Throws OutputError.
  void flush();

  /// All lines are there: the file, or the stream, gets header and lines in order. Throws OutputError.
  void finish(std::ostream& out);

  const std::string& journal() const { return journal_; }

 private:
  struct Place {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
  };

  void open_journal(bool resume);
  void lock_journal();
  void write_journal(std::string_view text);

  std::string path_;
  std::string journal_;
  std::string header_;
  FileDescriptor file_;
  std::string waiting_;    // lines that were added
  std::uint64_t end_ = 0;  // of the journal with them
  std::vector<Place> places_;
  bool keeps_journal_ = false;
  bool finished_ = false;
};

}  // namespace exsect::cli

// The lines of a batch (docs/formats.md, batch/1 and batch-line/1).
#pragma once

#include <exsect/solver/intersect.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "cli/batch/batch_input.h"

namespace exsect::cli {

/// What is done with each pair.
struct LineOptions {
  IntersectOptions solver;
  bool full = false;  // lines hold whole results
};

/// What is counted over the lines of a batch.
struct Tally {
  std::uint64_t lines = 0;
  std::uint64_t selves = 0;  // of these: patches with themselves
  std::uint64_t complete = 0;
  std::uint64_t incomplete = 0;
  std::uint64_t failed = 0;
  std::uint64_t by_boxes = 0;  // of the complete ones
  std::uint64_t by_doubles = 0;
  std::uint64_t by_exact = 0;
  std::uint64_t meeting = 0;  // complete or incomplete, with a curve, a point or an overlap
  std::uint64_t open = 0;
  std::uint64_t closed = 0;
  std::uint64_t branched = 0;
  std::uint64_t isolated = 0;
  std::uint64_t overlaps = 0;
};

Tally& operator+=(Tally& sum, const Tally& more);

/// A line, with its line feed, and what it counts.
struct BatchLine {
  std::string text;
  Tally tally;
};

/// Solves line `local`. Input that cannot be read, and nothing else, makes a line with the status failed;
/// std::bad_alloc and whatever else is unexpected leaves it.
BatchLine solved_line(const BatchInput& input, const Shard& shard, std::uint64_t local,
                      const LineOptions& options);

/// The line of a pair without a result, and why.
BatchLine failed_line(const BatchInput& input, const Shard& shard, std::uint64_t local,
                      const std::string& why);

/// A line as bytes on its way from a worker, and back: the same program writes and reads them.
std::string packed(const BatchLine& line);
BatchLine unpacked(std::string_view bytes);

/// Counts the line and returns its number in the whole batch. Throws std::invalid_argument if it is not a
/// line of a batch.
std::uint64_t count_line(std::string_view line, Tally& tally);

}  // namespace exsect::cli

// The lines of a batch (docs/formats.md, batch/1 and batch-line/1).
#pragma once

#include <exsect/solver/intersect.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "cli/batch/batch_input.h"
#include "cli/batch/tally.h"

namespace exsect::cli {

/// What is done with each pair.
struct LineOptions {
  IntersectOptions solver;
  bool full = false;  // lines hold whole results
};

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

}  // namespace exsect::cli

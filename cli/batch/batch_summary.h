// The table at the end of a batch.
#pragma once

#include <string>

#include "cli/batch/batch_line.h"

namespace exsect::cli {

/// What the run that ends here did itself, for the table.
struct BatchEffort {
  std::uint64_t lines = 0;  // that it solved
  double seconds = 0;
  unsigned workers = 0;
  long peak_kib = 0;  // of the largest worker
};

/// Lines of the form "  pairs  1234".
std::string batch_summary(const Tally& tally, std::uint64_t apart, const BatchEffort& effort);

}  // namespace exsect::cli

// exsect batch INPUT...
#pragma once

#include <string>
#include <vector>

#include "cli/exit_status.h"
#include "cli/streams.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct BatchCommand {
  std::vector<std::string> inputs;
  std::string output;
  std::string turning = "u,v,r,s";
  std::string tolerance = "1e-6";
  std::string max_seconds;
  std::string max_memory;
  std::string jobs;
  std::string shard = "1/1";
  bool exact = false;
  bool self = false;
  bool full = false;
  bool resume = false;
  bool quiet = false;
};

/// complete; incomplete if a line is incomplete or failed; interrupted by a signal. Throws UsageError,
/// InputError or OutputError.
ExitStatus run(const BatchCommand& command, const Streams& streams);

/// exsect batch-merge SHARD...
struct BatchMergeCommand {
  std::vector<std::string> shards;
  std::string output;
  bool quiet = false;
};

/// complete, or incomplete if a line is incomplete or failed. Throws UsageError, InputError or OutputError.
ExitStatus run(const BatchMergeCommand& command, const Streams& streams);

}  // namespace exsect::cli

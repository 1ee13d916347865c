// exsect verify CANDIDATE FILE
#pragma once

#include <string>

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/output_files.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct VerifyCommand {
  std::string candidate;
  std::string file;
  std::string first;
  std::string second;
  std::string tolerance = "1e-6";
  std::string max_seconds;
  OutputFiles output;
  bool quiet = false;
};

/// complete: agrees. negative: disagrees. incomplete: not decided. Throws UsageError, InputError or
/// OutputError before anything is written to `out`.
ExitStatus run(const VerifyCommand& command, const Streams& streams);

}  // namespace exsect::cli

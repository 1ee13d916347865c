// exsect intersect FILE
#pragma once

#include <string>

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/output_files.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct IntersectCommand {
  std::string file;
  std::string first;
  std::string second;
  std::string turning = "u,v,r,s";
  std::string tolerance = "1e-6";
  std::string max_seconds;
  bool exact = false;
  OutputFiles output;
  bool quiet = false;
  bool verbose = false;
};

/// complete or incomplete. Throws UsageError, InputError or OutputError before anything is written to `out`.
ExitStatus run(const IntersectCommand& command, const Streams& streams);

}  // namespace exsect::cli

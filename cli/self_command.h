// exsect self FILE
#pragma once

#include <string>

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/output_files.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct SelfCommand {
  std::string file;
  std::string patch;
  std::string turning = "u1,v1,u2,v2";
  std::string tolerance = "1e-6";
  std::string max_seconds;
  OutputFiles output;
  bool quiet = false;
  bool verbose = false;
};

/// complete or incomplete. Throws UsageError, InputError or OutputError before anything is written to `out`.
ExitStatus run(const SelfCommand& command, const Streams& streams);

}  // namespace exsect::cli

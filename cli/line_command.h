// exsect line FILE
#pragma once

#include <array>
#include <string>

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/output_files.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct LineCommand {
  std::string file;
  std::string first;
  std::string second;
  std::array<std::string, 4> fixed;  // values of --u, --v, --r, --s; exactly one is given
  OutputFiles output;
  bool quiet = false;
  bool verbose = false;
};

/// complete or incomplete. Throws UsageError, InputError or OutputError before anything is written to `out`.
ExitStatus run(const LineCommand& command, const Streams& streams);

}  // namespace exsect::cli

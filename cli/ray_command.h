// exsect ray FILE
#pragma once

#include <string>

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/output_files.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct RayCommand {
  std::string file;
  std::string origin;
  std::string direction;
  std::string surface;
  OutputFiles output;
  bool quiet = false;
  bool verbose = false;
};

/// complete or incomplete. Throws UsageError, InputError or OutputError before anything is written to `out`.
ExitStatus run(const RayCommand& command, const Streams& streams);

}  // namespace exsect::cli
